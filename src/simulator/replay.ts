import { type Clock, realClock } from '../line/index.js';
import { type Bytes, type CaptureEntry, FrameDecoder } from '../protocol/index.js';
import { FarEnd } from './far-end.js';
import { RequestReader, SILENCE } from './request-reader.js';

/** How a recorded timer is made. */
export interface ReplayTimerOptions {
  /** Default: the real clock. */
  readonly clock?: Clock;
}

/**
 * Bytes that a recorded timer sent together. `after`: how many milliseconds after the request, or after the beginning.
 */
interface Piece {
  readonly after: number;
  readonly bytes: Bytes;
}

interface Exchange {
  /** The request from its length byte on. How many zeros came before it makes no difference. */
  readonly request: string;
  readonly pieces: Piece[];
  /**
   * When the last frame of the answer is whole, counted like {@link Piece.after}.
   * Anything later is noise and delays nothing.
   */
  answered: number;
}

/**
 * A timer that gives the answers of a recording, at the far end of a pair of byte streams.
 *
 * It looks for each request in the recording, first after the last match, then from the beginning. It answers with the
 * bytes that followed there, up to the next request: in the same pieces, after the same time, with the same damage. A
 * request without a reply in the recording gets none, and neither does one that the recording does not hold. Bytes from
 * before the first request are sent without a request.
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
  /** The bytes that the timer sends. */
  readonly readable: ReadableStream<Bytes>;
  /** Takes the bytes for the timer. */
  readonly writable: WritableStream<Uint8Array>;
  readonly #clock: Clock;
  readonly #exchanges: readonly Exchange[];
  readonly #end: FarEnd;
  readonly #reader: RequestReader;
  /** The recorded request to try first. */
  #next = 0;
  /** When the current reply will be complete: a timer answers one request after the other. */
  #busyUntil = Number.NEGATIVE_INFINITY;

  /**
   * @param entries as `parseCapture` gives them. They are copied.
   * @param options the clock that times the answers.
   */
  constructor(entries: readonly CaptureEntry<Uint8Array>[], { clock = realClock }: ReplayTimerOptions = {}) {
    this.#clock = clock;
    const { unasked, exchanges } = sorted(entries);
    this.#exchanges = exchanges;
    const decoder = requestDecoder((request) => this.#answer(request));
    this.#reader = new RequestReader(decoder, clock);
    this.#end = new FarEnd((bytes) => this.#reader.push(bytes));
    this.readable = this.#end.readable;
    this.writable = this.#end.writable;
    this.#send(unasked, clock.now());
  }

  #answer(request: string): void {
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
  }

  #send(pieces: readonly Piece[], begin: number): void {
    for (const { after, bytes } of pieces) {
      this.#clock.after(begin + after - this.#clock.now(), () => this.#end.send(bytes.slice()));
    }
  }
}

/** Finds requests, also those with a bare checksum, and reports each from its length byte on. */
function requestDecoder(tell: (request: string) => void): FrameDecoder {
  const everyLetter = Array.from({ length: 256 }, (_, letter) => letter);
  return new FrameDecoder({
    quirks: { bareChecksum: everyLetter },
    onFrame: (_, wire) => tell(wire.subarray(wire.findIndex((byte) => byte !== 0)).join(' ')),
  });
}

/** The recording as a list of requests, each with the bytes that followed it. */
function sorted(entries: readonly CaptureEntry<Uint8Array>[]): { unasked: Piece[]; exchanges: Exchange[] } {
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
