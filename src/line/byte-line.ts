import type { Clock } from './clock.js';
import { requireNumber } from './require.js';

/** Bytes that arrive: those of `sidus-timer/protocol`, which this room does not know. */
export type Bytes = ReturnType<typeof Uint8Array.of>;

/** Bits on the wire for each byte at 8N1: one start bit, eight data bits, one stop bit. */
export const BITS_PER_BYTE = 10;

/**
 * Milliseconds that `bytes` bytes take at `baudRate` bits a second. Rate 0 stands for a line without a speed: no time.
 */
export function wireTime(bytes: number, baudRate: number): number {
  return baudRate > 0 ? (bytes * BITS_PER_BYTE * 1000) / baudRate : 0;
}

/** How one direction of a line is made. */
export interface ByteLineOptions {
  /** Tells when bytes arrive. */
  readonly clock: Clock;
  /** Bits a second. Default 0: the line takes no time. */
  readonly baudRate?: number;
  /** Milliseconds from the moment a byte leaves the sender to its arrival. Default 0. */
  readonly latency?: number;
  /**
   * How many bytes arrive together. The sizes are used in turn, then again from the first. Default:
   * each `send` arrives in one piece.
   */
  readonly chunks?: readonly number[];
  /**
   * What arrives in place of a byte: `[byte]` unchanged, `[]` lost, `[other]` flipped, `[byte, byte]` doubled. `index`
   * counts all bytes ever sent on this line, from 0.
   */
  readonly fault?: (byte: number, index: number) => readonly number[];
}

/**
 * One direction of a serial line. Bytes that are sent at one end arrive at the other: in order, no faster than the
 * line's speed, cut into pieces, with the faults that a test asks for. It never delivers before `send` has returned.
 */
export class ByteLine {
  /** Bits a second. May change between sends, as when a port is opened at another rate. */
  baudRate: number;
  readonly #clock: Clock;
  readonly #latency: number;
  readonly #chunks: readonly number[];
  readonly #fault: ByteLineOptions['fault'];
  readonly #deliver: (bytes: Bytes) => void;
  /**
   * Pieces on their way, oldest first. Each callback delivers the oldest piece, not the one that it was made for: a
   * real clock may swap two callbacks that are due at nearly the same time.
   */
  readonly #underWay: Bytes[] = [];
  readonly #appointments = new Set<() => void>();
  #freeAt = Number.NEGATIVE_INFINITY;
  #sent = 0;
  #chunk = 0;
  #chunkFilled = 0;
  #cut = false;

  /**
   * @param deliver is called with each piece as it arrives, and may keep the array.
   * @throws RangeError when a rate, a latency or a size is negative or no number.
   */
  constructor(deliver: (bytes: Bytes) => void, options: ByteLineOptions) {
    const { clock, baudRate = 0, latency = 0, chunks = [], fault } = options;
    requireNumber(baudRate, 'baudRate', 0);
    requireNumber(latency, 'latency', 0);
    for (const size of chunks) requireNumber(size, 'a size in chunks', 0);
    this.#deliver = deliver;
    this.#clock = clock;
    this.baudRate = baudRate;
    this.#latency = latency;
    this.#chunks = chunks.filter((size) => size > 0);
    this.#fault = fault;
  }

  /**
   * Puts bytes on the line after those already there.
   * @returns the time on the clock at which the last byte will have left the sender.
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

  /** Cuts the line. Bytes on their way never arrive, nor any that are sent later. */
  cut(): void {
    this.#cut = true;
    this.clear();
  }

  /** Drops the bytes on their way, as a port does when it discards its buffer. */
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
      this.#deliver(this.#underWay.shift() as Bytes);
    });
    this.#appointments.add(cancel);
  }
}
