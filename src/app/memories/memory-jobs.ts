import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { TimerError } from '../../client/index.js';
import { checkProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { type Crossing, sameCrossing } from '../session/crossing.js';
import { type JobContext, stoppedBy, type Work } from '../session/job-runner.js';
import type { Session } from '../session/session.js';
import { JobDialog } from '../write/job-dialog.js';
import type { Tick } from '../write/start-buttons.js';
import { strayed } from '../write/strayed.js';
import type { NotedRoundTrip } from './noted-round-trip.js';
import {
  changesBy,
  endOf,
  isGood,
  type MemoriesOutcome,
  type MemoryChange,
  memoriesOf,
  type Plan,
  refusalsOf,
  targetsOf,
  type WritingPlan,
} from './plan.js';

/** The steps of a job over several memories. */
export type MemoriesStep =
  | {
      readonly step: 'review';
      readonly plan: Plan;
      /** The job runs on this connection, or not at all. */
      readonly connection: TimerConnection;
      readonly changes: readonly MemoryChange[];
      /** Set when the backups to restore are of another model. */
      readonly crossing: Crossing | null;
    }
  /** Where the browser cannot keep a copy of a memory, the job asks the pilot before it writes into it. */
  | { readonly step: 'running'; readonly plan: Plan }
  | {
      readonly step: 'done';
      readonly plan: Plan;
      readonly outcome: MemoriesOutcome;
      /** Whether the browser has kept the backups. */
      readonly kept: boolean;
    };

type Review = Extract<MemoriesStep, { step: 'review' }>;

/** The end of a job: its result, or what stopped it. */
type Ended<T> = { readonly value: T; readonly stopped: null } | { readonly stopped: Stopped };
type Stopped = NonNullable<MemoriesOutcome['stopped']>;

/** What a job over several memories has done so far. */
interface Done {
  saved: number;
  notHeld: boolean;
  strayed: number | null;
  /** The memories in which writing has begun. */
  readonly begun: Set<number>;
}

/** Whether one of the memories cannot be written at all. */
const isRefused = (changes: readonly MemoryChange[]): boolean =>
  changes.some((change) => refusalsOf(change).length > 0);

/**
 * Backs up all memories, copies one to another, restores several: shows the difference, does it, reports the result.
 */
export class MemoryJobs extends JobDialog<MemoriesStep> {
  readonly #crossed = signal(false, { name: 'crossedMemories' });
  /** Whether the pilot agrees to put backups of one model into the timer of another. */
  readonly crossed: ReadonlySignal<boolean> = this.#crossed;
  /** What the pilot has to tick first. Only a write needs the word that the model is held: reading changes nothing. */
  readonly unticked: ReadonlySignal<readonly Tick[]> = computed(() => {
    const step = this.current.value;
    // What no tick can allow is said above.
    if (step?.step !== 'review' || isRefused(step.changes)) return [];
    const isSafe = step.plan.kind === 'back-up' || this.#session.safety.confirmed.value;
    const isAgreed = step.crossing === null || this.crossed.value;
    return [...(isAgreed ? [] : (['model'] as const)), ...(isSafe ? [] : (['safety'] as const))];
  });
  /** Whether the shown plan may begin. */
  readonly ready: ReadonlySignal<boolean> = computed(() => {
    const step = this.current.value;
    if (step?.step !== 'review' || this.unticked.value.length > 0) return false;
    return !isRefused(step.changes);
  });
  readonly #session: Session;
  readonly #roundTrip: NotedRoundTrip;
  /** Whether the browser has kept every copy of this job. */
  #kept = true;

  constructor(session: Session, roundTrip: NotedRoundTrip) {
    super(session);
    this.#session = session;
    this.#roundTrip = roundTrip;
  }

  /** Shows what is about to happen. Reads first what a copy or a restore would change. */
  async open(plan: Plan): Promise<void> {
    const { connection, runner, servoMoves } = this.#session;
    if (!connection.value || runner.busy.value) return;
    servoMoves.ask();
    if (plan.kind === 'back-up') {
      this.show({ step: 'review', plan, connection: connection.value, changes: [], crossing: null });
      return;
    }
    const end = await this.#run(plan, (on, options) => this.#compare(plan, on, options));
    if (end.stopped === null) this.show(end.value);
    else if (end.stopped === 'aborted') this.#nothingWritten();
    else {
      const ends = targetsOf(plan).map((memory) =>
        endOf(memory, this.#session.standings.of(memory).known, null, false),
      );
      this.show({
        step: 'done',
        plan,
        outcome: { saved: 0, ends, stopped: end.stopped, notHeld: false, strayed: null },
        kept: true,
      });
    }
    await this.#session.reader.readIfOpen();
  }

  /** The pilot agrees to put backups of one model into the timer of another, or no longer agrees. */
  cross(wanted: boolean): void {
    this.#crossed.value = wanted;
  }

  /** Does what was shown, on the connection on which it was shown. */
  async start(): Promise<void> {
    const { value: shown } = this.current;
    if (shown?.step !== 'review' || !this.ready.value) return;
    // The names have changed, or the model turned out to be another one: asks again.
    const crossing = this.#crossingOf(shown.plan);
    if (!sameCrossing(crossing, shown.crossing)) {
      this.#crossed.value = false;
      return this.show({ ...shown, crossing });
    }
    const { standings, nextFlight } = this.#session;
    const { plan, changes } = shown;
    this.#kept = true;
    const done: Done = { saved: 0, notHeld: false, strayed: null, begun: new Set() };
    const { stopped } = await this.#run(plan, async (on, options) => {
      if (on !== shown.connection) throw new TimerError('closed', 'it was shown for another connection');
      if (plan.kind === 'back-up') done.saved = await this.#backUp(on, options);
      else await this.#write(changes, on, options, done);
    });
    const { saved, notHeld, begun, strayed: other } = done;
    const ends = changes.map((change) => {
      const { memory } = change;
      return endOf(memory, standings.of(memory).known, change, begun.has(memory));
    });
    // The notice of the page says what stopped a backup.
    if (plan.kind === 'back-up' && saved === 0) this.show(null);
    else if (plan.kind !== 'back-up' && stopped === 'aborted' && begun.size === 0) this.#nothingWritten();
    else
      this.show({ step: 'done', plan, outcome: { saved, ends, stopped, notHeld, strayed: other }, kept: this.#kept });
    // One of the written memories may be the one on the screen.
    if (begun.size > 0) nextFlight.doubt();
    await this.#session.reader.readIfOpen();
  }

  protected connectionOf(step: MemoriesStep): TimerConnection | null {
    return step.step === 'review' ? step.connection : null;
  }

  protected stays(step: MemoriesStep): boolean {
    return step.step === 'done' && !isGood(step.outcome);
  }

  /** Runs a job. Gives the code of what stopped it. */
  async #run<T>(plan: Plan, work: Work<T>): Promise<Ended<T>> {
    const { runner, connection } = this.#session;
    const began = connection.value;
    this.#roundTrip.kept = true;
    this.#roundTrip.trip = { job: plan.kind, memory: null };
    this.show({ step: 'running', plan });
    const end = await runner.perform('memories', work);
    runner.report(end);
    if (!this.#roundTrip.kept) this.#kept = false;
    if (!end.good) return { stopped: stoppedBy(end) };
    return connection.value === began ? { value: end.value, stopped: null } : { stopped: 'closed' };
  }

  /** What the plan would change, by a fresh reading of its memories. */
  async #compare(plan: WritingPlan, connection: TimerConnection, options: JobContext): Promise<Review> {
    const programs = await this.#roundTrip.read(connection, { ...options, memories: memoriesOf(plan) });
    const changes = changesBy(plan, programs);
    if (!changes) throw new TimerError('other-timer', 'a backup is of another kind');
    this.#crossed.value = false;
    return { step: 'review', plan, connection, changes, crossing: this.#crossingOf(plan) };
  }

  /** @returns how many memories were read and kept. */
  async #backUp(connection: TimerConnection, options: JobContext): Promise<number> {
    const { backups, simulated } = this.#session;
    const programs = await this.#roundTrip.read(connection, options);
    const savedAt = Date.now();
    for (const program of programs) {
      if (!(await backups.add(program, 'memories', simulated.value, savedAt))) this.#kept = false;
    }
    return programs.length;
  }

  /** @throws what stopped it. */
  async #write(
    shown: readonly MemoryChange[],
    { client, identity }: TimerConnection,
    options: JobContext,
    done: Done,
  ): Promise<void> {
    const { knowledge, reader, recovery, simulated, servoMoves } = this.#session;
    const { begun } = done;
    const moveServos = servoMoves.take();
    let agreed = false;
    const goals = shown.map(({ goal }) => goal);
    const { memories, stopped, original } = await client.writeMemories(goals, {
      ...options,
      // What was in a memory or is kept is copied as it is; the pilot has seen each change.
      despite: goals.flatMap((goal) => checkProgram(goal).map(({ code }) => code)),
      baselines: shown.map(({ before }) => before),
      moveServos,
      onOriginal: (original) => this.#roundTrip.leave(identity, original),
      // The goal and a backup are kept before the first byte, as for any write.
      onMemory: async (read, goal) => {
        options.stillOn();
        const change = shown.find(({ memory }) => memory === goal.memory);
        if (!change) throw new TimerError('closed', 'it was not shown');
        const kept = change.changes.length === 0 || (await recovery.begin(read, goal, simulated.value));
        if (!kept) {
          this.#kept = false;
          agreed ||= await options.ask();
          if (!agreed) {
            await knowledge.ended(read);
            throw new TimerError('aborted', 'not without a copy');
          }
        }
        options.stillOn();
        begun.add(change.memory);
      },
    });
    for (const { before, report } of memories) {
      // Nothing is waited for: another timer may be there when the storage answers.
      if (report.held && !report.stopped) void knowledge.ended(before);
      if (report.held) reader.took(report.held, report.result === 'verified');
    }
    done.strayed = strayed(memories.map(({ report }) => report));
    if (done.strayed !== null) knowledge.doubt(done.strayed);
    // Where the write did not even begin, nothing was sent.
    for (const { memory, before } of shown) {
      if (!begun.has(memory) || memories.some((each) => each.memory === memory)) continue;
      begun.delete(memory);
      await knowledge.ended(before);
    }
    await this.#roundTrip.wasRestored(identity, original, stopped);
    if (stopped) throw stopped;
    const reports = memories.map(({ report }) => report);
    done.notHeld = servoMoves.wanted(moveServos, reports);
  }

  #crossingOf(plan: Plan): Crossing | null {
    if (plan.kind !== 'restore') return null;
    return this.#session.origin.crossingFrom(plan.backups.find(({ model }) => model !== undefined)?.model ?? null);
  }

  #nothingWritten(): void {
    this.show(null);
    this.#session.notices.sayIfSilent('nothing-written');
  }
}
