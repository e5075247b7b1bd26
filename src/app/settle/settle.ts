import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { type TimerClient, TimerError } from '../../client/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { Bench } from '../bench/bench.js';
import type { Answers } from '../storage/records.js';
import type { JobContext } from '../timer/job-runner.js';
import { kindKey } from '../timer/record-keys.js';
import type { Session } from '../work/session.js';
import { conclude, joined, type Said, type Seen, swapped } from './conclusions.js';
import { observed } from './observed.js';
import { type Act, STEPS, type Step } from './steps.js';
import { cellOf, tryPosition } from './try-position.js';

/** How often the timer is asked with four zeros. */
const ASKED = 3;

/** A walk through the open questions with one kind of timer. */
interface Walk {
  /** The kind of timer: see `kindKey`. */
  readonly kind: string;
  readonly simulated: boolean;
  /** What was settled of this kind before. */
  readonly before: Answers;
  readonly seen: Seen;
  readonly said: Said;
}

/**
 * Leads through the open questions of docs/protocol.md with a real timer. Only a press of the person sends something.
 * It outlasts its view, and a timer that sleeps in the meantime.
 */
export class Settle {
  readonly #walk = signal<Walk | null>(null);
  readonly #done = signal<ReadonlySet<Step['name']>>(new Set());
  /** The connection on which the person has said that no propeller can turn. */
  readonly #safeOn = signal<TimerConnection | null>(null);
  /** The steps for this timer. Before it was read, all of them. */
  readonly steps: ReadonlySignal<readonly Step[]> = computed(() => {
    const seen = this.seen.value;
    return STEPS.filter(({ isFor }) => !seen || !isFor || isFor(seen));
  });
  readonly step: ReadonlySignal<Step> = computed(() => this.steps.value[this.at.value] as Step);
  /** The number of the step, from 0. Only this model writes it. */
  readonly at = signal(0);
  /** What the line has shown; null before the timer was read. */
  readonly seen: ReadonlySignal<Seen | null> = computed(() => this.#walk.value?.seen ?? null);
  /** What the person has answered. */
  readonly said: ReadonlySignal<Said> = computed(() => this.#walk.value?.said ?? {});
  /** Whether what this step does on the wire is done, so that its question can be answered. */
  readonly isDone = computed(() => !this.step.value.act || this.#done.value.has(this.step.value.name));
  /** What is settled with this timer by now. */
  readonly answers: ReadonlySignal<Answers> = computed(() => {
    const walk = this.#walk.value;
    return walk ? joined(walk.before, conclude(walk.seen, walk.said)) : {};
  });
  readonly isSafe = computed(() => {
    const { safety, connection } = this.#session;
    const safeOn = this.#safeOn.value;
    return safety.confirmed.value && safeOn !== null && safeOn === connection.value;
  });
  /** Whether something else has to come to its end first. */
  readonly isBlocked = computed(() => {
    const { unfinished, trials } = this.#session;
    return unfinished.value.length > 0 || trials.current.value !== null;
  });
  /** Whether a step may send something. */
  readonly ready = computed(() => {
    const { runner } = this.#session;
    return runner.ready.value && !runner.claimed.value && this.isSafe.value && !this.isBlocked.value;
  });
  readonly bench: Bench;
  readonly #session: Session;
  /** The newest entry of the line that was taken in. */
  #newest = 0;

  constructor(session: Session, bench: Bench) {
    const { connection, link } = session;
    this.#session = session;
    this.bench = bench;
    connection.subscribe((now) => {
      const kind = this.#walk.peek()?.kind;
      if (now && kind && kindKey(now.identity, link.simulated.peek()) !== kind) this.again();
    });
  }

  /** The person says that no propeller can turn, or no longer says so. */
  saySafe(isSafe: boolean): void {
    const { safety, connection } = this.#session;
    this.#safeOn.value = isSafe ? connection.value : null;
    if (isSafe) safety.confirm();
    else safety.withdraw();
  }

  /** Begins with the first step. What was settled stays. */
  again(): void {
    batch(() => {
      this.at.value = 0;
      this.#walk.value = null;
      this.#done.value = new Set();
    });
  }

  back(): void {
    this.at.value--;
  }

  next(): void {
    this.at.value++;
  }

  /** Takes the answer to the question of this step; null where the person does not know it. */
  answer<Name extends keyof Said>(name: Name, answer: Said[Name] | null): void {
    const walk = this.#walk.value;
    if (!walk) return;
    const { [name]: _, ...others } = walk.said;
    this.#keep({ ...walk, said: answer === null ? others : { ...others, [name]: answer } });
    this.next();
  }

  /** The slot to which the servos are moved before a position is tried; null in any other step. */
  get slot(): number | null {
    const held = this.#session.editor.baseline.value;
    const cell = held && cellOf(held);
    if (!cell || this.step.value.act !== 'try') return null;
    return this.step.value.name === 'away' ? held.identity.functions : cell.field.slot;
  }

  /** Does what this step does on the wire, and goes on unless there is a question. */
  async act(): Promise<void> {
    const { act, asks, name } = this.step.value;
    if (!act || !this.ready.value) return;
    const acts: Record<Act, () => Promise<boolean>> = {
      read: () => this.#read(),
      try: () => this.#try(name === 'away' ? 'away' : 'there'),
      zeros: () => this.#askZeros(),
      unlock: () => this.#unlock(),
    };
    if (!(await acts[act]()) || this.step.value.name !== name) return;
    this.#done.value = new Set(this.#done.value).add(name);
    if (!asks) this.next();
  }

  /** Reads twice: what a timer says once may be a slip of the line. */
  async #read(): Promise<boolean> {
    const { reader, editor, backups, connection, settled, link, log, notices } = this.#session;
    const { value: bound } = connection;
    const simulated = link.simulated.value;
    this.#newest = log.newest.value;
    if (!(await reader.read()) || !(await reader.read())) return false;
    const held = editor.baseline.value;
    if (!held || !bound) return false;
    if (!(await backups.add(held, 'write', simulated))) notices.say('not-backed-up');
    if (connection.value !== bound) return false;
    const { identity } = held;
    const nothing = { indices: [], delays: [], away: null, there: null, zeros: null, unlock: null };
    this.#walk.value = {
      kind: kindKey(identity, simulated),
      simulated,
      before: settled.of(identity, simulated),
      seen: {
        ...nothing,
        identity,
        times: bound.client.quirksAssumed.bigEndianTimes ? held.times.map(swapped) : held.times,
      },
      said: {},
    };
    this.#done.value = new Set();
    await this.#note({});
    return true;
  }

  async #try(which: 'away' | 'there'): Promise<boolean> {
    const { reader, editor, connection, runner, notices } = this.#session;
    const bound = connection.value;
    const at = this.bench.stand.at.value;
    if (!bound || !(await reader.read()) || connection.value !== bound || !this.ready.value) return false;
    const before = editor.baseline.value;
    const cell = before && editor.fresh.value ? cellOf(before) : null;
    if (!before || !cell) return false;
    const { layout } = this.answers.value;
    const isServoFirst = bound.client.quirksAssumed.servoFirst === true;
    // What the first position has shown decides in which order the next one goes out.
    if (layout && isServoFirst !== (layout === 'servo-first')) bound.client.assume({ servoFirst: !isServoFirst });
    const isBack = await runner.run('write', async (on, options) => {
      if (on !== bound) throw new TimerError('closed', 'the connection is another by now');
      const isClean = this.#watch();
      const tried = await tryPosition(this.#session, on, options, { before, cell, at });
      // On a line with damage an acknowledgement may belong to another request.
      await this.#note({ [which]: tried.end !== 'unchanged' || isClean() ? tried : { ...tried, end: 'unclear' } });
    });
    // Whatever came of it, the screen shows what the timer holds.
    if (!isBack && connection.value === bound) await notices.keepThrough(() => reader.read());
    return isBack;
  }

  async #askZeros(): Promise<boolean> {
    return await this.#session.runner.run('read', async ({ client }, options) => {
      const isClean = this.#watch();
      const isUsual = await isAnswered(client, options);
      let answered = 0;
      client.assume({ fourZeros: true });
      try {
        for (let i = 0; i < ASKED; i++) if (await isAnswered(client, options)) answered++;
      } finally {
        client.assume({ fourZeros: false });
      }
      const isThere = isUsual && (await isAnswered(client, options));
      const zeros = answered === ASKED ? 'answered' : answered === 0 && isThere ? 'unanswered' : null;
      await this.#note({ zeros: isClean() ? zeros : null });
    });
  }

  async #unlock(): Promise<boolean> {
    const isClean = this.#watch();
    if (!(await this.bench.unlock())) return false;
    const is6A = this.#session.connection.value?.client.quirksFound.has('unlock-reply-6a');
    await this.#note({ unlock: isClean() ? (is6A ? '6A' : '6E') : null });
    return true;
  }

  /** @returns a function that says whether nothing was damaged or unasked since now. */
  #watch(): () => boolean {
    const { log, connection } = this.#session;
    const figures = (): string => {
      const { damaged, errors } = log.counts.value;
      return [damaged, errors, connection.value?.client.strays].join();
    };
    const before = figures();
    return () => figures() === before;
  }

  /** Takes in what the line has shown since the last time, and what a step has found. */
  async #note(found: Partial<Seen>): Promise<void> {
    const { log } = this.#session;
    // The log tells of new entries at the end of a turn.
    await Promise.resolve();
    const walk = this.#walk.value;
    if (!walk) return;
    const { indices, delays } = observed(log.entries.value.filter(({ number }) => number > this.#newest));
    this.#newest = log.newest.value;
    const more = { indices: [...walk.seen.indices, ...indices], delays: [...walk.seen.delays, ...delays] };
    this.#keep({ ...walk, seen: { ...walk.seen, ...more, ...found } });
  }

  #keep(walk: Walk): void {
    this.#walk.value = walk;
    this.#session.settled.keep(walk.seen.identity, walk.simulated, this.answers.value);
  }
}

/** Whether the timer answers the harmless question what it is, at once. */
async function isAnswered(client: TimerClient, { signal }: JobContext): Promise<boolean> {
  try {
    await client.identify({ tries: 1, signal });
    return true;
  } catch (error) {
    if (error instanceof TimerError && error.code === 'no-answer') return false;
    throw error;
  }
}

const made = new WeakMap<Session, Settle>();

/** The walk of a page. Built on first use: few need it. */
export function settleOf(session: Session, bench: Bench): Settle {
  const settle = made.get(session) ?? new Settle(session, bench);
  made.set(session, settle);
  return settle;
}
