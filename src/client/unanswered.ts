import { type Clock, wireTime } from '../line/index.js';
import { answers, commandOf, type Frame, frameSize, ZEROS_SENT } from '../protocol/index.js';
import type { LearnedTiming } from './line-timing.js';

/** Requests of one letter that got no answer in time. */
interface Unanswered {
  /** How many replies to them may still come. */
  readonly due: number;
  /** When the last of them went out, in milliseconds by the clock, and its size in bytes. */
  readonly sentAt: number;
  readonly size: number;
}

/** The requests, by letter, that got no answer in time but may still be answered. */
export class UnansweredRequests {
  readonly #clock: Clock;
  readonly #timing: LearnedTiming;
  readonly #requests = new Map<number, Unanswered>();

  constructor(clock: Clock, timing: LearnedTiming) {
    this.#clock = clock;
    this.#timing = timing;
  }

  get isEmpty(): boolean {
    return this.#requests.size === 0;
  }

  has(letter: number): boolean {
    return this.#requests.has(letter);
  }

  /** Whether only requests of this letter can still be answered. */
  hasOnly(letter: number): boolean {
    return [...this.#requests.keys()].every((other) => other === letter);
  }

  /** No older request can be answered any more. */
  settle(): void {
    this.#requests.clear();
  }

  /**
   * Notes a request that was answered, or whose time is up. With an earlier unanswered request of the same letter, the
   * reply may have belonged to that one.
   */
  note(bytes: Uint8Array, sentAt: number, isUnanswered: boolean): void {
    const letter = bytes[ZEROS_SENT + 1] as number;
    if (!isUnanswered && !this.#requests.has(letter)) return;
    const due = (this.#requests.get(letter)?.due ?? 0) + (isUnanswered ? 1 : 0);
    this.#requests.set(letter, { due, sentAt, size: bytes.length });
  }

  /**
   * Takes a frame as the late answer to one of them, and learns from it how slow the timer is.
   * @param inTime whether the frame has only just become whole, and did not hide behind a false header.
   * @returns whether it is a late answer.
   */
  take({ code, data }: Frame, inTime: boolean): boolean {
    for (const [letter, { due, sentAt, size }] of this.#requests) {
      const name = commandOf(letter)?.name;
      if (due === 0 || !(code === letter + 1 || (name && answers(code, name)))) continue;
      this.#requests.set(letter, { due: due - 1, sentAt, size });
      const onWire = wireTime(size + frameSize(data.length), this.#timing.baudRate);
      if (inTime) this.#timing.learn(this.#clock.now() - sentAt - onWire);
      return true;
    }
    return false;
  }
}
