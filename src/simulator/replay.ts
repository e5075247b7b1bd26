import { type Clock, realClock } from '../line/index.js';
import { type CaptureEntry, FrameDecoder } from '../protocol/index.js';

export interface ReplayTimerOptions {
  /** Default: the real clock. */
  readonly clock?: Clock;
}

/** Bytes that a recorded timer sent together, and how many milliseconds after the request, or after the beginning. */
interface Piece {
  readonly after: number;
  readonly bytes: Uint8Array;
}

interface Exchange {
  /** The request from its length byte on: how many zeros came before it makes no difference. */
  readonly request: string;
  readonly pieces: Piece[];
  /**
   * When the last frame among them is whole, as {@link Piece.after}; what comes later is noise, which holds up nothing.
   */
  answered: number;
}

/** Milliseconds of silence after which a request that is not whole is given up. */
const SILENCE = 100;

/**
 * A timer that answers as another one did while its line was recorded, at the far end of a pair of byte streams.
 *
 * A request is looked for in the recording, from the last match on and then from the beginning. The answer is what
 * followed it there, up to the next request: in the same pieces, as long after the request, damage and all. A request
 * that got no reply in the recording gets none, nor does one that the recording does not know. What was recorded before
 * the first request comes by itself.
 *
 * @example
 * ```ts
 * import { TimerClient } from 'sidus-timer/client';
 * import { parseCapture } from 'sidus-timer/protocol';
 * import { ReplayTimer } from 'sidus-timer/simulator';
 *
 * const text = `# Sidus capture 1
 * 0.000 > 00 00 00 00 00 03 6b 6b 45
 * 0.052 < 00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45
 * `;
 * const timer = new TimerClient(new ReplayTimer(parseCapture(text)));
 * console.log((await timer.identify()).firmware); // 536
 * await timer.close();
 * ```
 */
export class ReplayTimer {
  readonly readable: ReadableStream<Uint8Array>;
  readonly writable: WritableStream<Uint8Array>;
  /** The requests that the recording does not know, as they came but with five zeros at most, oldest first. */
  readonly unknown: Uint8Array[] = [];
  readonly #clock: Clock;
  readonly #exchanges: readonly Exchange[];
  readonly #decoder: FrameDecoder;
  /** The recorded request to be looked at first. */
  #next = 0;
  /** When the reply under way will have been sent: a timer answers one request after the other. */
  #busyUntil = Number.NEGATIVE_INFINITY;
  readonly #due = new Set<() => void>();
  #cancelSilence: () => void = () => {};
  #controller: ReadableStreamDefaultController<Uint8Array> | undefined;
  #cut = false;

  /**
   * @param entries as `parseCapture` gives them; they are copied.
   * @param options the clock by which it answers.
   */
  constructor(entries: readonly CaptureEntry[], { clock = realClock }: ReplayTimerOptions = {}) {
    this.#clock = clock;
    const { unasked, exchanges } = sorted(entries);
    this.#exchanges = exchanges;
    this.#decoder = requestDecoder((request, wire) => this.#answer(request, wire));
    this.readable = new ReadableStream<Uint8Array>({
      start: (controller) => {
        this.#controller = controller;
      },
      cancel: () => {
        this.#controller = undefined;
      },
    });
    this.writable = new WritableStream<Uint8Array>({
      write: (bytes) => {
        if (this.#cut) throw new Error('The line to the recorded timer is cut.');
        this.#receive(bytes);
      },
    });
    this.#send(unasked, clock.now());
  }

  /**
   * Cuts the line as a pulled cable does: reading and writing fail from now on, and nothing that is under way arrives.
   */
  cut(reason: unknown = new Error('The line to the recorded timer is cut.')): void {
    this.#cut = true;
    this.#cancelSilence();
    for (const cancel of this.#due) cancel();
    this.#due.clear();
    this.#controller?.error(reason);
    this.#controller = undefined;
  }

  #receive(bytes: Uint8Array): void {
    this.#decoder.push(bytes);
    this.#cancelSilence();
    if (this.#decoder.waiting) this.#cancelSilence = this.#clock.after(SILENCE, () => void this.#decoder.idle());
  }

  #answer(request: string, wire: Uint8Array): void {
    const { length } = this.#exchanges;
    for (let step = 0; step < length; step++) {
      const index = (this.#next + step) % length;
      const exchange = this.#exchanges[index] as Exchange;
      if (exchange.request !== request) continue;
      this.#next = index + 1;
      const begin = Math.max(this.#busyUntil, this.#clock.now());
      this.#busyUntil = begin + exchange.answered;
      this.#send(exchange.pieces, begin);
      return;
    }
    this.unknown.push(wire);
  }

  #send(pieces: readonly Piece[], begin: number): void {
    for (const { after, bytes } of pieces) {
      const cancel = this.#clock.after(begin + after - this.#clock.now(), () => {
        this.#due.delete(cancel);
        this.#controller?.enqueue(bytes.slice());
      });
      this.#due.add(cancel);
    }
  }
}

/** Finds requests, those with a bare checksum too, each from its length byte on. */
function requestDecoder(tell: (request: string, wire: Uint8Array) => void): FrameDecoder {
  const everyLetter = Array.from({ length: 256 }, (_, letter) => letter);
  return new FrameDecoder({
    quirks: { bareChecksum: everyLetter },
    onFrame: (_, wire) => tell(wire.subarray(wire.findIndex((byte) => byte !== 0)).join(' '), wire),
  });
}

/** The recording as requests, each with what came after it. */
function sorted(entries: readonly CaptureEntry[]): { unasked: Piece[]; exchanges: Exchange[] } {
  const unasked: Piece[] = [];
  const exchanges: Exchange[] = [];
  let asked = entries[0]?.time ?? 0;
  let sent = asked;
  let replies = new FrameDecoder();
  const requests = requestDecoder((request) => {
    exchanges.push({ request, pieces: [], answered: 0 });
    replies = new FrameDecoder();
    asked = sent;
  });
  for (const { time, direction, bytes } of entries) {
    if (direction === 'out') {
      if (time - sent > SILENCE) requests.idle();
      sent = time;
      requests.push(bytes);
      continue;
    }
    const exchange = exchanges.at(-1);
    const after = time - asked;
    (exchange?.pieces ?? unasked).push({ after, bytes: bytes.slice() });
    if (exchange && replies.push(bytes).length > 0) exchange.answered = after;
  }
  return { unasked, exchanges };
}
