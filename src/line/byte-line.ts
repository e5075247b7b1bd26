import type { Clock } from './clock.js';

/** Bits on the wire for each byte at 8N1: a start bit, eight bits of data, a stop bit. */
export const BITS_PER_BYTE = 10;

/**
 * Milliseconds that `bytes` bytes take at `baudRate` bits a second; none at rate 0, which stands for a line without a
 * speed.
 */
export function wireTime(bytes: number, baudRate: number): number {
  return baudRate > 0 ? (bytes * BITS_PER_BYTE * 1000) / baudRate : 0;
}

export interface ByteLineOptions {
  readonly clock: Clock;
  /** Bits a second. 0, the default: the line takes no time. */
  readonly baudRate?: number;
  /** Milliseconds from the end of a byte on the wire to its arrival. Default 0. */
  readonly latency?: number;
  /**
   * Sizes of the pieces that arrive together, used in turn and again from the first. Default: all that was sent at
   * once.
   */
  readonly chunks?: readonly number[];
  /**
   * What arrives in place of a byte: `[byte]` as it is, `[]` lost, another value flipped, two values doubled.
   * `index` counts all bytes ever sent on this line, from 0.
   */
  readonly fault?: (byte: number, index: number) => readonly number[];
}

/**
 * One direction of a serial line: what is sent at one end arrives at the other, in order, no faster than the line's
 * speed, cut into pieces, with the faults that a test asks for. It never calls back before `send` has returned.
 */
export class ByteLine {
  /** Bits a second; may be changed between sends, as opening a port at another rate does. */
  baudRate: number;
  readonly #clock: Clock;
  readonly #latency: number;
  readonly #chunks: readonly number[];
  readonly #fault: ByteLineOptions['fault'];
  readonly #deliver: (bytes: Uint8Array) => void;
  /**
   * What is under way, in order. Each appointment delivers the first of it, not its own: a real clock may keep two
   * appointments of nearly one time the wrong way round.
   */
  readonly #underWay: Uint8Array[] = [];
  readonly #appointments = new Set<() => void>();
  #freeAt = Number.NEGATIVE_INFINITY;
  #sent = 0;
  #chunk = 0;
  #chunkFilled = 0;
  #cut = false;

  /** @param deliver is handed each piece as it arrives; the array is its own to keep. */
  constructor(deliver: (bytes: Uint8Array) => void, options: ByteLineOptions) {
    this.#deliver = deliver;
    this.#clock = options.clock;
    this.baudRate = options.baudRate ?? 0;
    this.#latency = options.latency ?? 0;
    this.#chunks = options.chunks?.some((size) => size > 0) ? options.chunks.filter((size) => size > 0) : [];
    this.#fault = options.fault;
  }

  /**
   * Puts bytes on the line behind those already there.
   * @returns the clock's time at which the last of them will have left the sender.
   */
  send(bytes: Uint8Array): number {
    const begin = Math.max(this.#clock.now(), this.#freeAt);
    this.#freeAt = begin + wireTime(bytes.length, this.baudRate);
    if (this.#cut) return this.#freeAt;
    let from = 0;
    while (from < bytes.length) {
      const to = Math.min(bytes.length, from + this.#roomInChunk());
      this.#arrive(bytes.subarray(from, to), begin + wireTime(to, this.baudRate));
      this.#fill(to - from);
      from = to;
    }
    return this.#freeAt;
  }

  /** Cuts the line: nothing that is still under way arrives, nor anything sent later. */
  cut(): void {
    this.#cut = true;
    this.clear();
  }

  /** Drops what is still under way, as a port does that discards its buffer. */
  clear(): void {
    for (const cancel of this.#appointments) cancel();
    this.#appointments.clear();
    this.#underWay.length = 0;
    this.#freeAt = Number.NEGATIVE_INFINITY;
  }

  #roomInChunk(): number {
    const size = this.#chunks[this.#chunk];
    return size === undefined ? Number.POSITIVE_INFINITY : size - this.#chunkFilled;
  }

  #fill(bytes: number): void {
    const size = this.#chunks[this.#chunk];
    if (size === undefined) return;
    this.#chunkFilled += bytes;
    if (this.#chunkFilled < size) return;
    this.#chunk = (this.#chunk + 1) % this.#chunks.length;
    this.#chunkFilled = 0;
  }

  #arrive(sent: Uint8Array, at: number): void {
    const fault = this.#fault;
    const first = this.#sent;
    this.#sent += sent.length;
    const bytes = fault
      ? Uint8Array.from([...sent].flatMap((byte, i) => fault(byte, first + i)))
      : new Uint8Array(sent);
    if (bytes.length === 0) return;
    this.#underWay.push(bytes);
    const cancel = this.#clock.after(at + this.#latency - this.#clock.now(), () => {
      this.#appointments.delete(cancel);
      this.#deliver(this.#underWay.shift() as Uint8Array);
    });
    this.#appointments.add(cancel);
  }
}
