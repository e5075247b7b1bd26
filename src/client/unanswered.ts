import { type Clock, wireTime } from '../line/index.js';
import { answers, commandOf, type Frame, frameSize, ZEROS_SENT } from '../protocol/index.js';
import type { LearnedTiming } from './line-timing.js';

/** Requests of one letter whose time is up. */
interface Unanswered {
  /** How many replies to them may still come. */
  readonly due: number;
  /** When the last of them went out, and in how many bytes. */
  readonly sentAt: number;
  readonly size: number;
}

/** The requests that got no answer in time and may still be answered, by their letters. */
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

  /** Whether none of another letter can still be answered. */
  hasOnly(letter: number): boolean {
    return [...this.#requests.keys()].every((other) => other === letter);
  }

  /** All that was asked before can no longer be answered. */
  settle(): void {
    this.#requests.clear();
  }

  /**
   * The time of a request is up, or it was answered. When an earlier one with its letter was not, that may have been
   * the answer to it.
   */
  note(bytes: Uint8Array, sentAt: number, isUnanswered: boolean): void {
    const letter = bytes[ZEROS_SENT + 1] as number;
    if (!isUnanswered && !this.#requests.has(letter)) return;
    const due = (this.#requests.get(letter)?.due ?? 0) + (isUnanswered ? 1 : 0);
    this.#requests.set(letter, { due, sentAt, size: bytes.length });
  }

  /**
   * Takes a frame for the late answer to one of them, and learns from it how slow the timer is.
   * @param inTime whether it was whole just now, and was not hidden behind a false header.
   * @returns whether it is one.
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
