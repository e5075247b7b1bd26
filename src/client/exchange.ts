import type { Clock } from '../line/index.js';
import { sameKind } from '../program/index.js';
import {
  COMMANDS,
  type CommandName,
  type Frame,
  type Identity,
  type Reply,
  type ReplyOf,
  type Request,
} from '../protocol/index.js';
import { TimerError, throwIfAborted } from './errors.js';
import type { LearnedTiming } from './line-timing.js';
import { damagedReply, type Outcome } from './outcome.js';
import {
  ALIKE,
  BAD_REPLIES,
  type Belief,
  latestReply,
  longestExchange,
  longestFence,
  MISSES,
  READS,
  type RetryPolicy,
  SENDS,
  SILENT,
  SILENT_AT_FIRST,
  UNANSWERED,
} from './retry-policy.js';
import { type PlannedJob, Schedule } from './schedule.js';
import type { Wire } from './wire.js';

/** What went wrong on the line during some time. */
export interface Disturbance {
  /** How often damage was seen: bytes that belong to no frame, errors of the line, impossible replies. */
  readonly damage: number;
  /** How many frames came that nobody asked for. */
  readonly strays: number;
  /** How many requests were repeated, fences included. */
  readonly repeats: number;
}

/** Harmless requests that can serve as a fence, in the order in which they are tried. */
const FENCES = ['GETSWVER', 'GETMEMORY', 'GETTIMERS', 'GETSERVOPOS'] as const;

/**
 * Sends one request after another and stays with each until it has succeeded or failed. A request that got no answer in
 * time is repeated only where the table of commands allows it, and only after a fence: a harmless request with another
 * letter. The reply to the fence shows that no older reply can still come.
 */
export class Exchange {
  readonly #wire: Wire;
  readonly #clock: Clock;
  readonly #timing: LearnedTiming;
  #lastSent = Number.NEGATIVE_INFINITY;
  #closed = false;
  #underWay: Promise<unknown> = Promise.resolve();
  /**
   * For the request in progress: how many exchanges in a row got no answer, and how many of those got no byte at all.
   */
  #misses = 0;
  #silent = 0;
  /** When the first silent exchange went out. */
  #silentSince = Number.NEGATIVE_INFINITY;
  /** Whether the answering timer must be the one that was identified. */
  #isMet = true;
  /** How often this program had stood still before the job. */
  #standstills = 0;
  /** The request in progress, and how often it went out. */
  #details: { readonly request: CommandName; readonly sent: number } | undefined;
  /** What has gone wrong since the job began. */
  #seen: () => Disturbance;

  /** What the timer said about itself: it gives the layout of all further messages. Null before that. */
  identity: Identity | null = null;
  /** Whether the timer is there: it has answered, and has not fallen silent since. */
  awake = false;
  readonly schedule: Schedule;

  constructor(wire: Wire, clock: Clock, timing: LearnedTiming) {
    this.#wire = wire;
    this.#clock = clock;
    this.#timing = timing;
    this.schedule = new Schedule(clock, timing);
    this.#seen = this.watch();
  }

  /**
   * Whether there was damage on the line, or a frame that nobody asked for. A single read is then no longer believed.
   */
  get damaged(): boolean {
    return this.#wire.damage > 0 || this.#wire.strays > 0;
  }

  /** @returns a function that tells what has gone wrong from now until it is called. */
  watch(): () => Disturbance {
    const wire = this.#wire;
    const { damage, strays } = wire;
    const { repeats } = this.schedule;
    return () => ({
      damage: wire.damage - damage,
      strays: wire.strays - strays,
      repeats: this.schedule.repeats - repeats,
    });
  }

  /** Begins a job. From now on nothing is sent that could end later than such a job may take. */
  begin(job: Omit<PlannedJob, 'identity'>): void {
    this.schedule.begin({ ...job, identity: this.identity });
    this.#timing.begin();
    this.#seen = this.watch();
    this.#standstills = this.#wire.standstill.count;
  }

  /**
   * Sends a request until the reply comes. One call at a time: the caller waits for the one before.
   * @throws TimerError `no-answer`, `unstable`, `bad-reply`, `stood-still`, `too-slow`, `port-lost`, `closed`, or
   * `aborted` before the request went out.
   */
  async ask<R extends Request>(
    request: R,
    signal?: AbortSignal,
    policy: RetryPolicy = {},
  ): Promise<ReplyOf<R['name']>> {
    return (await this.#askUntilAnswered(request, signal, policy)) as ReplyOf<R['name']>;
  }

  /**
   * Asks until an answer can be believed. One answer is enough if nothing was known before, it has the usual form,
   * there was no damage on the line and no frame came that nobody asked for. Otherwise two in a row must agree.
   * @throws TimerError `unstable`, `crowded`, or as {@link ask}.
   */
  async read<R extends Request>(
    request: R,
    signal?: AbortSignal,
    { before, twice = before !== undefined, ...policy }: Belief<ReplyOf<R['name']>> = {},
  ): Promise<ReplyOf<R['name']>> {
    const seen = this.watch();
    let previous: string | undefined = JSON.stringify(before);
    for (let i = 0; i < READS; i++) {
      const reply = await this.ask(request, signal, policy);
      const text = JSON.stringify(reply);
      if (text === previous) return reply;
      if (!twice && !this.damaged && !this.#wire.quirks.isMisprintNew(request.name)) return reply;
      previous = text;
    }
    throw this.unbelievable(`no two of ${READS} replies agreed`, request.name, seen());
  }

  /**
   * The error when no two answers agreed: too much damage, or a second timer answers, too.
   * @param seen what went wrong in that time.
   */
  unbelievable(text: string, request: CommandName, { damage }: Disturbance): TimerError {
    const isCrowded = this.#seen().strays > 0 && damage === 0;
    return new TimerError(isCrowded ? 'crowded' : 'unstable', text, { request });
  }

  /** Asks the timer what it is, whatever it was before. */
  async identify(signal?: AbortSignal, policy: RetryPolicy = {}): Promise<ReplyOf<'GETSWVER'>> {
    this.#isMet = false;
    try {
      const reply = await this.read({ name: 'GETSWVER' }, signal, policy);
      this.identity = reply.identity;
      return reply;
    } finally {
      this.#isMet = true;
    }
  }

  /**
   * Makes sure that the answering timer still gives the same identity.
   * @param first a reply to GETSWVER that has come already. Default: asks for one.
   * @throws TimerError `other-timer` when two replies in a row agree on another identity; as {@link ask}.
   */
  async requireIdentity(signal?: AbortSignal, first?: ReplyOf<'GETSWVER'>): Promise<void> {
    const { identity } = this;
    if (!identity || !this.#isMet) return;
    let reply = first ?? (await this.ask({ name: 'GETSWVER' }, signal));
    if (sameKind(reply.identity, identity)) return;
    reply = await this.read({ name: 'GETSWVER' }, signal, { before: reply });
    if (!sameKind(reply.identity, identity)) {
      throw new TimerError('other-timer', 'another timer answers than the one that was identified', {
        identity: reply.identity,
      });
    }
    // As after damage, a single reply is no longer believed.
    this.#wire.damage++;
  }

  /**
   * Sends any frame once, whatever it may do. Sends a fence first if an older request can still be answered.
   * @returns the frame with the next letter, or null when none came in time.
   * @throws TimerError `port-lost`, `closed`, or `aborted` before it went out; CodecError when there is no such frame.
   */
  async send(code: number, data: ArrayLike<number>, signal?: AbortSignal): Promise<Frame | null> {
    throwIfAborted(signal);
    if (!this.#wire.unanswered.isEmpty && !(await this.#fence(signal))) await this.#outwait(signal);
    throwIfAborted(signal);
    const outcome = await this.#once(() => this.#wire.send(code, data, this.identity));
    return outcome.kind === 'answer' ? outcome.answer : null;
  }

  /**
   * @throws TimerError `stood-still` when this program stood still during the job, `too-slow` when the timer answers
   * too late for its replies to be told apart: nothing more is sent in it.
   */
  requireGoing(): void {
    if (this.#wire.standstill.count !== this.#standstills) {
      throw new TimerError('stood-still', 'this program stood still in the middle of the job', this.#details);
    }
    const { tooSlow } = this.#timing;
    if (tooSlow === null) return;
    const delay = Math.round(tooSlow);
    throw new TimerError('too-slow', `this timer answers after ${delay} ms`, { ...this.#details, delay });
  }

  /** Waits for the request in progress, and refuses all others with `closed`. */
  async close(): Promise<void> {
    this.#closed = true;
    await this.#underWay;
  }

  async #askUntilAnswered(
    request: Request,
    signal: AbortSignal | undefined,
    { tries = SENDS, unanswered = UNANSWERED, anyReply = false, strict = false, beforeRepeat }: RetryPolicy,
  ): Promise<Reply> {
    const { name } = request;
    const wire = this.#wire;
    const seen = this.watch();
    let sent = 0;
    this.#details = { request: name, sent };
    let silent = 0;
    let bad = 0;
    let badReply: unknown;
    let alike = 0;
    let damaged: string | null = null;
    let isChecked = true;
    let isDecided = false;
    const isIgnored = (): boolean => silent === sent && sent >= (wire.damage > 0 ? tries : unanswered);
    this.#misses = 0;
    this.#silent = 0;
    while (this.#mayGoOn(request, seen()) || (await this.#comesLate(request, seen, signal))) {
      throwIfAborted(signal);
      const mayBeLate = !wire.unanswered.isEmpty && !(anyReply && wire.unanswered.hasOnly(COMMANDS[name].request));
      if (mayBeLate && !(await this.#fence(signal))) {
        isChecked = false;
        // Where other replies are damaged, too, it is the line.
        alike = 0;
        continue;
      }
      if (beforeRepeat && !isChecked) {
        await beforeRepeat();
        isChecked = true;
        continue;
      }
      throwIfAborted(signal);
      if (sent > 0) this.schedule.repeated();
      this.requireGoing();
      sent++;
      this.#details = { request: name, sent };
      const misprints = strict ? 'known' : 'yes';
      const outcome = await this.#once(() => wire.ask({ request, identity: this.identity, misprints }));
      if (outcome.kind === 'answer') {
        this.schedule.answered(name);
        return outcome.answer;
      }
      isChecked = outcome.kind !== 'silent';
      if (outcome.kind === 'silent') silent++;
      if (outcome.kind === 'bad') {
        badReply = outcome.error;
        bad++;
      }
      if (outcome.kind === 'damaged') {
        const reply = damagedReply(outcome.bytes, name);
        alike = reply === null ? 0 : reply === damaged ? alike + 1 : 1;
        damaged = reply;
      }
      isDecided = !COMMANDS[name].repeatable || sent >= tries || bad >= BAD_REPLIES || alike >= ALIKE || isIgnored();
      if (isDecided) break;
    }
    this.requireGoing();
    const details = { request: name, sent };
    if (bad > 0 && (bad === sent || bad >= BAD_REPLIES)) {
      throw new TimerError('bad-reply', `the reply to ${name} cannot be right`, details, badReply);
    }
    if (alike >= ALIKE) {
      wire.quirks.noteAlike(name);
      throw new TimerError('bad-reply', `each reply to ${name} was damaged in the same way`, {
        ...details,
        alike: true,
      });
    }
    const isGone = this.#isSilent(request, seen());
    if (isGone) this.awake = false;
    const isSentOnce = sent > 0 && !COMMANDS[name].repeatable;
    // When time ran out before the request was sent often enough, damage from any part of the job counts.
    const { damage } = isDecided ? seen() : this.#seen();
    if (!isGone && !isSentOnce && !isIgnored() && damage > 0) {
      throw new TimerError('unstable', `too much damage to get a reply to ${name}`, details);
    }
    throw new TimerError('no-answer', `no reply to ${name}`, { ...details, answersOthers: this.awake });
  }

  /** Whether another attempt (fence and request) makes sense and ends in time. */
  #mayGoOn(request: Request, seen: Disturbance): boolean {
    if (this.#misses >= MISSES || this.#isSilent(request, seen)) return false;
    const fence = !this.#wire.unanswered.isEmpty ? longestFence(this.#timing) : 0;
    return this.schedule.hasTimeFor(fence + longestExchange(request.name, this.identity, this.#timing));
  }

  /**
   * The timer may only be slow. So before it counts as silent, this waits for the latest possible reply to the first
   * unanswered request. There is time for that: the last attempt had more time reserved than it used.
   * @returns whether something came and another attempt makes sense.
   */
  async #comesLate(request: Request, seen: () => Disturbance, signal: AbortSignal | undefined): Promise<boolean> {
    const left = this.#silentSince + latestReply(this.#timing) - this.#clock.now();
    if (!this.#isSilent(request, seen())) return false;
    const isHeard = await this.#wire.pause(left, signal, true);
    throwIfAborted(signal);
    if (!isHeard) return false;
    this.#silent = 0;
    return this.#mayGoOn(request, seen());
  }

  /**
   * Whether nothing at all has come for so long that no timer is there. A dangerous request is given up sooner: the
   * timer has to be there at once.
   */
  #isSilent({ name }: Request, { damage }: Disturbance): boolean {
    const isPatient = COMMANDS[name].repeatable && (this.awake || damage > 0);
    return this.#silent >= (isPatient ? SILENT : SILENT_AT_FIRST);
  }

  async #once<T>(send: () => Promise<Outcome<T>>): Promise<Outcome<T>> {
    if (this.#closed) throw new TimerError('closed', 'this client was closed');
    this.requireGoing();
    this.#lastSent = this.#clock.now();
    const asking = send();
    this.#underWay = asking.catch(() => {});
    const outcome = await asking;
    const isAnswered = outcome.kind === 'answer';
    if (isAnswered) this.awake = true;
    this.#misses = isAnswered ? 0 : this.#misses + 1;
    this.#silent = outcome.kind === 'silent' ? this.#silent + 1 : 0;
    if (this.#silent === 1) this.#silentSince = this.#lastSent;
    return outcome;
  }

  /**
   * Waits for silence on the line, then sends a harmless request of a letter that has no reply outstanding. Where no
   * such request is left, or the latest possible reply is overdue, it waits that time out instead.
   * @returns whether it is now certain that no older reply can come.
   */
  async #fence(signal: AbortSignal | undefined): Promise<boolean> {
    await this.#wire.silence(signal);
    throwIfAborted(signal);
    const name = FENCES.find((fence) => !this.#wire.unanswered.has(COMMANDS[fence].request) && this.#canDecode(fence));
    if (!name || this.#latestReply <= this.#clock.now()) {
      await this.#outwait(signal);
      return true;
    }
    this.schedule.repeated();
    const outcome = await this.#once(() => this.#wire.ask({ request: { name }, identity: this.identity }));
    if (outcome.kind !== 'answer') return false;
    this.#wire.unanswered.settle();
    if (outcome.answer.name === 'GETSWVER') await this.requireIdentity(signal, outcome.answer);
    return true;
  }

  /** Waits until no older request can be answered any more. */
  async #outwait(signal: AbortSignal | undefined): Promise<void> {
    await this.#wire.pause(this.#latestReply - this.#clock.now(), signal);
    throwIfAborted(signal);
    this.#wire.unanswered.settle();
  }

  get #latestReply(): number {
    return this.#lastSent + latestReply(this.#timing);
  }

  /** Positions cannot be read before the number of servos is known. */
  #canDecode(name: CommandName): boolean {
    return this.identity !== null || name !== 'GETSERVOPOS';
  }
}
