import type { Clock } from '../line/index.js';
import {
  COMMANDS,
  type CommandName,
  type Identity,
  type Reply,
  type ReplyOf,
  type Request,
} from '../protocol/index.js';
import { TimerError, throwIfAborted } from './errors.js';
import type { Wire } from './wire.js';

/** How often a request goes out at most, repeats and fences together. */
const TRIES = 3;
/** How often a reading is repeated at most to find two that agree. */
const READS = 6;
/**
 * Milliseconds after which an unanswered request can no longer be answered. It is the bound of the law that a late reply is never
 * taken for a later request's: a timer that answers later than this breaks it.
 */
const LATEST_REPLY = 3000;
/** Harmless requests, in the order in which they are tried as a fence. */
const FENCES = ['GETSWVER', 'GETMEMORY', 'GETTIMERS', 'GETSERVOPOS'] as const;

/**
 * Asks one request after another, each to its end. What timed out is asked again only where the table of commands says that this
 * does no harm, and only behind a fence: a harmless request of another letter, whose reply shows that all older ones have passed.
 */
export class Exchange {
  readonly #wire: Wire;
  readonly #clock: Clock;
  /** Letters that went out and may still be answered. */
  readonly #outstanding = new Set<CommandName>();
  #lastSent = Number.NEGATIVE_INFINITY;
  #repeats = 0;
  #closed = false;
  #underWay: Promise<unknown> = Promise.resolve();

  /** What the timer said of itself: the layout of all that follows. Null until it has. */
  identity: Identity | null = null;

  constructor(wire: Wire, clock: Clock) {
    this.#wire = wire;
    this.#clock = clock;
  }

  /** How many requests went out again, fences included. */
  get repeats(): number {
    return this.#repeats;
  }

  /** Whether damage was seen on the line, so that a single read is no longer believed. */
  get damaged(): boolean {
    return this.#wire.damage > 0;
  }

  /**
   * Asks until the reply comes. One call at a time: whoever holds an Exchange waits for the last one.
   * @throws TimerError `no-answer`, `bad-reply`, `port-lost`, `closed`, or `aborted` before the request went out.
   */
  async ask<R extends Request>(request: R, signal?: AbortSignal): Promise<ReplyOf<R['name']>> {
    return (await this.#askUntilAnswered(request, signal)) as ReplyOf<R['name']>;
  }

  /**
   * Asks a question and believes the answer: once damage was seen on the line, only when two in a row agree.
   * @param before an answer got before, to count as the first of the two.
   * @returns the answer, and whether two agreed on it.
   * @throws TimerError `unstable`, or as {@link ask}.
   */
  async read<R extends Request>(
    request: R,
    signal?: AbortSignal,
    before?: ReplyOf<R['name']>,
  ): Promise<{ reply: ReplyOf<R['name']>; agreed: boolean }> {
    let previous = before === undefined ? undefined : JSON.stringify(before);
    for (let i = 0; i < READS; i++) {
      const reply = await this.ask(request, signal);
      const text = JSON.stringify(reply);
      if (text === previous) return { reply, agreed: true };
      if (!this.damaged) return { reply, agreed: false };
      previous = text;
    }
    throw new TimerError('unstable', `no two of ${READS} replies agreed`, { request: request.name });
  }

  /** Lets the request that is under way come to its end, and refuses all others with `closed`. */
  async close(): Promise<void> {
    this.#closed = true;
    await this.#underWay;
  }

  async #askUntilAnswered(request: Request, signal: AbortSignal | undefined): Promise<Reply> {
    const { name } = request;
    let sent = 0;
    let badReply: unknown;
    for (let left = TRIES; left > 0; left--) {
      throwIfAborted(signal);
      if (this.#outstanding.size > 0 && !(await this.#fence(signal))) continue;
      throwIfAborted(signal);
      if (sent > 0) this.#repeats++;
      sent++;
      const reply = await this.#once(request);
      if (reply) return reply;
      badReply = this.#wire.badReply ?? badReply;
      if (!COMMANDS[name].repeatable) break;
    }
    if (badReply !== undefined) {
      throw new TimerError('bad-reply', `the reply to ${name} cannot be right`, { request: name, sent }, badReply);
    }
    throw new TimerError('no-answer', `no reply to ${name}`, { request: name, sent });
  }

  async #once(request: Request): Promise<Reply | undefined> {
    if (this.#closed) throw new TimerError('closed', 'this client was closed', { request: request.name });
    this.#lastSent = this.#clock.now();
    const asking = this.#wire.ask(request, this.identity, this.#outstanding.size === 0);
    this.#underWay = asking.catch(() => {});
    const reply = await asking;
    if (!reply) this.#outstanding.add(request.name);
    return reply;
  }

  /**
   * Waits for the line to fall silent, then asks something harmless that is not outstanding itself; not needed once the latest reply
   * is overdue.
   * @returns whether all older requests can no longer be answered.
   */
  async #fence(signal: AbortSignal | undefined): Promise<boolean> {
    await this.#wire.silence(signal);
    throwIfAborted(signal);
    const name = FENCES.find((fence) => !this.#outstanding.has(fence));
    const tooLate = this.#lastSent + LATEST_REPLY - this.#clock.now();
    if (!name || tooLate <= 0) {
      if (tooLate > 0) await this.#wire.pause(tooLate, signal);
      throwIfAborted(signal);
      this.#outstanding.clear();
      return true;
    }
    this.#repeats++;
    if (!(await this.#once({ name }))) return false;
    this.#outstanding.clear();
    return true;
  }
}
