import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { type Progress, TimerError, type TimerErrorCode } from '../../client/index.js';
import { type Change, differences, sameKind, type TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { JobOptions } from '../session/job-runner.js';
import type { Known } from '../session/knowledge.js';
import type { Session } from '../session/session.js';
import type { Backup } from '../storage/index.js';
import { MemoryWalk } from './memory-walk.js';

/** What is to be done with several memories, before it is done. */
export type Plan =
  | { readonly kind: 'back-up' }
  /** The content of a memory, as it is read for that, into another one. */
  | { readonly kind: 'copy'; readonly from: number; readonly to: number }
  | { readonly kind: 'restore'; readonly backups: readonly Backup[] };

/** What is to be written into one memory, as the dialog shows it. */
export interface MemoryChange {
  /** Counted from 0. */
  readonly memory: number;
  /** What it holds, by the reading for the dialog. */
  readonly before: TimerProgram;
  readonly goal: TimerProgram;
  readonly changes: readonly Change[];
}

/** What one memory holds at the end of a job, by what is known of it then. */
export interface MemoryEnd {
  /** Counted from 0. */
  readonly memory: number;
  /** `untouched`: nothing was written into it. `differs`: it was read back and holds something else. `unknown`: nobody has read it since. */
  readonly state: 'verified' | 'untouched' | 'differs' | 'unknown';
  readonly known: Known;
  /** Null when it was not even compared. */
  readonly change: MemoryChange | null;
}

/** What became of a job over several memories. */
export interface MemoriesOutcome {
  /** How many memories were read and kept. */
  readonly saved: number;
  /** Each memory that was to be written. */
  readonly ends: readonly MemoryEnd[];
  /** What stopped it; null when nothing did. */
  readonly stopped: TimerErrorCode | 'unexpected' | null;
  /** Positions were not kept, perhaps because the servos did not move. */
  readonly unkept: boolean;
}

/** The steps of a job over several memories. */
export type MemoriesStep =
  | {
      readonly step: 'review';
      readonly plan: Plan;
      /** On this connection, or not at all. */
      readonly connection: TimerConnection;
      readonly changes: readonly MemoryChange[];
    }
  | {
      readonly step: 'running';
      readonly plan: Plan;
      readonly progress: Progress | null;
      /** The pilot has asked to stop. */
      readonly stopping: boolean;
    }
  /** The browser does not keep a copy of what a memory holds: nothing is written into it before the pilot has answered. */
  | { readonly step: 'unkept'; readonly plan: Plan; readonly answer: (goOn: boolean) => void }
  | {
      readonly step: 'done';
      readonly plan: Plan;
      readonly outcome: MemoriesOutcome;
      /** Whether the browser has kept the backups. */
      readonly kept: boolean;
    };

const NOTHING: MemoriesOutcome = { saved: 0, ends: [], stopped: null, unkept: false };

/** Look at a memory, back up all of them, copy one to another, restore several: only when the pilot asks for it. */
export class Memories {
  readonly current = signal<MemoriesStep | null>(null, { name: 'memories' });
  /** A memory that is not the current one and that the pilot looks at, by what was last read of it; null: none. */
  readonly looking: ReadonlySignal<number | null> = computed(() => {
    const { nextFlight, editor } = this.#session;
    const current = nextFlight.open.value ? null : (editor.baseline.value?.memory ?? null);
    return this.#picked.value === current ? null : this.#picked.value;
  });
  readonly #picked = signal<number | null>(null, { name: 'picked' });
  readonly #session: Session;
  readonly #walk: MemoryWalk;
  #kept = true;

  constructor(session: Session) {
    this.#session = session;
    this.#walk = new MemoryWalk(session);
    effect(() => {
      const connection = session.connection.value;
      const current = this.current.peek();
      // The next timer may be another one.
      this.#picked.value = null;
      if (current?.step === 'review' && current.connection !== connection) this.current.value = null;
      if (current?.step === 'unkept') current.answer(false);
    });
  }

  /** Shows what was last read of a memory, and sends nothing; of the current one the program itself. */
  show(memory: number): void {
    this.#picked.value = memory;
  }

  /** Reads a memory and makes the one current again that was. */
  async look(memory: number): Promise<void> {
    this.#picked.value = memory;
    const work = async (connection: TimerConnection, options: JobOptions): Promise<void> => {
      await this.#walk.read(connection, { ...options, memories: [memory] });
    };
    await this.#session.runner.run('look', work, memory);
    await this.#session.readIfOpen();
  }

  /** Makes a memory the one that flies next, and shows it. Edits of the one that is left are kept. */
  async fly(memory: number): Promise<boolean> {
    const good = await this.#session.selectMemory(memory);
    this.#picked.value = null;
    return good;
  }

  /** Shows what is about to be done: what a copy or a restoring changes is read for that. */
  async open(plan: Plan): Promise<void> {
    const { connection, runner, servoMoves } = this.#session;
    if (!connection.value || runner.busy.value) return;
    servoMoves.ask();
    if (plan.kind === 'back-up') {
      this.current.value = { step: 'review', plan, connection: connection.value, changes: [] };
      return;
    }
    let changes: readonly MemoryChange[] = [];
    const end = await this.#run(plan, async (on, options) => {
      changes = await this.#compare(plan, on, options);
    });
    if (end.stopped === null) this.current.value = { step: 'review', plan, connection: end.connection, changes };
    else if (end.stopped === 'aborted') this.#nothingWritten();
    else {
      const ends = targetsOf(plan).map((memory) => this.#endOf(memory, null));
      this.current.value = { step: 'done', plan, outcome: { ...NOTHING, ends, stopped: end.stopped }, kept: true };
    }
    await this.#session.readIfOpen();
  }

  /** The browser keeps no copy: writes without one, or not at all. */
  answer(goOn: boolean): void {
    if (this.current.value?.step === 'unkept') this.current.value.answer(goOn);
  }

  /** Whether the dialog has to stay open whatever key is pressed. */
  get held(): boolean {
    const { value } = this.current;
    return value?.step === 'running' || (value?.step === 'done' && !isGood(value.outcome));
  }

  /** Escape was pressed: leaves the dialog where it may be left; while bytes move, asks the job to stop. */
  escape(): void {
    if (this.current.value?.step === 'running' || !this.held) this.dismiss();
  }

  /** Leaves the dialog; while bytes move, asks the job to stop instead. */
  dismiss(): void {
    const { value } = this.current;
    if (value?.step === 'running') {
      void this.#session.runner.stop();
      this.current.value = { ...value, stopping: true };
    } else if (value?.step === 'unkept') value.answer(false);
    else this.current.value = null;
  }

  /** Does what was shown, on the connection where it was shown. */
  async start(): Promise<void> {
    const { value } = this.current;
    if (value?.step !== 'review') return;
    const { plan, connection, changes } = value;
    this.#kept = true;
    const begun = new Set<number>();
    let saved = 0;
    let unkept = false;
    const { stopped } = await this.#run(plan, async (on, options) => {
      if (on !== connection) throw new TimerError('closed', 'it was shown for another connection');
      if (plan.kind === 'back-up') saved = await this.#backUp(on, options);
      else unkept = await this.#write(changes, on, options, begun);
    });
    const ends = changes.map((change) => this.#endOf(change.memory, begun.has(change.memory) ? change : null, change));
    const outcome: MemoriesOutcome = { saved, ends, stopped, unkept };
    if (plan.kind === 'back-up') {
      // What stopped a backup stands in the notice of the page.
      this.current.value = saved === 0 ? null : { step: 'done', plan, outcome, kept: this.#kept };
    } else if (stopped === 'aborted' && begun.size === 0) this.#nothingWritten();
    else this.current.value = { step: 'done', plan, outcome, kept: this.#kept };
    // What was written may be what is on the screen.
    if (begun.size > 0) this.#session.nextFlight.doubt();
    await this.#session.readIfOpen();
  }

  /** Runs a job and says by code what stopped it. */
  async #run(
    plan: Plan,
    work: (connection: TimerConnection, options: JobOptions) => Promise<void>,
  ): Promise<{ connection: TimerConnection; stopped: null } | { stopped: NonNullable<MemoriesOutcome['stopped']> }> {
    const session = this.#session;
    const connection = session.connection.value;
    let failure: unknown = new TimerError('closed', 'there is no connection, or another job has it');
    let asked = false;
    this.#walk.kept = true;
    const running = (progress: Progress | null): void => {
      this.current.value = {
        step: 'running',
        plan,
        progress,
        stopping: session.runner.job.value?.stopping ?? false,
      };
    };
    running(null);
    const good = await session.runner.run('memories', async (on, options) => {
      const onProgress = (progress: Progress): void => {
        options.onProgress(progress);
        running(progress);
      };
      try {
        await work(on, { ...options, onProgress });
      } catch (error) {
        failure = error;
        asked = session.connection.value === on;
        throw error;
      }
    });
    if (!this.#walk.kept) this.#kept = false;
    if (good && connection && session.connection.value === connection) return { connection, stopped: null };
    if (!(failure instanceof TimerError)) return { stopped: 'unexpected' };
    // A job is stopped by a lost connection too: nobody has asked for that.
    return { stopped: failure.code === 'aborted' && !asked ? 'port-lost' : failure.code };
  }

  /** What the plan would change, by a fresh reading of all that is part of it. */
  async #compare(
    plan: Exclude<Plan, { kind: 'back-up' }>,
    connection: TimerConnection,
    options: JobOptions,
  ): Promise<readonly MemoryChange[]> {
    const targets = targetsOf(plan);
    const programs = await this.#walk.read(connection, {
      ...options,
      memories: plan.kind === 'copy' ? [...targets, plan.from] : targets,
    });
    return targets.map((memory, index) => {
      const before = programs[index] as TimerProgram;
      const goal =
        plan.kind === 'copy'
          ? // Whether the idle throttle belongs to a memory is not known: it is left as it is.
            { ...(programs.at(-1) as TimerProgram), memory, idleThrottle: null }
          : (plan.backups.find(({ program }) => program.memory === memory) as Backup).program;
      if (!sameKind(before.identity, goal.identity)) throw new TimerError('other-timer', 'a backup is of another kind');
      return { memory, before, goal, changes: differences(before, goal).filter(({ to }) => to !== null) };
    });
  }

  async #backUp(connection: TimerConnection, options: JobOptions): Promise<number> {
    const { backups, simulated } = this.#session;
    const programs = await this.#walk.read(connection, options);
    const savedAt = Date.now();
    for (const program of programs) {
      await backups.add(program, 'memories', simulated.value, savedAt).catch(() => {
        this.#kept = false;
      });
    }
    return programs.length;
  }

  /** @returns whether positions were not kept, perhaps for want of a movement. @throws what stopped it. */
  async #write(
    shown: readonly MemoryChange[],
    { client, identity }: TimerConnection,
    options: JobOptions,
    begun: Set<number>,
  ): Promise<boolean> {
    const { knowledge, recovery, simulated, servoMoves } = this.#session;
    const moveServos = servoMoves.take();
    let asked = false;
    const { memories, stopped, original } = await client.writeMemories(
      shown.map(({ goal }) => goal),
      {
        ...options,
        baselines: shown.map(({ before }) => before),
        moveServos,
        onOriginal: (original) => this.#walk.leave(identity, original),
        // The goal and a backup are kept before the first byte, as for any write.
        onMemory: async (read, goal) => {
          options.stillOn();
          const change = shown.find(({ memory }) => memory === goal.memory);
          if (!change) throw new TimerError('closed', 'it was not shown');
          const kept = change.changes.length === 0 || (await recovery.begin(read, goal, simulated.value));
          if (!kept) {
            this.#kept = false;
            asked ||= await this.#agreed();
            if (!asked) {
              await knowledge.ended(read);
              throw new TimerError('aborted', 'not without a copy');
            }
          }
          options.stillOn();
          begun.add(change.memory);
        },
      },
    );
    for (const { before, report } of memories) {
      if (report.held && !report.stopped) await knowledge.ended(before);
      if (report.held) knowledge.read(report.held, Date.now(), report.result === 'verified');
    }
    // Where the write did not even begin, nothing was sent.
    for (const { memory, before } of shown) {
      if (!begun.has(memory) || memories.some((each) => each.memory === memory)) continue;
      begun.delete(memory);
      await knowledge.ended(before);
    }
    await this.#walk.wasRestored(identity, original, stopped);
    if (stopped) throw stopped;
    return servoMoves.wanted(
      moveServos,
      memories.map(({ report }) => report),
    );
  }

  /** Asks whether to go on without a copy. */
  #agreed(): Promise<boolean> {
    const plan = this.current.value?.plan;
    if (!plan || !this.#session.connection.value) return Promise.resolve(false);
    return new Promise((resolve) => {
      this.current.value = {
        step: 'unkept',
        plan,
        answer: (goOn) => {
          this.current.value = { step: 'running', plan, progress: null, stopping: !goOn };
          resolve(goOn);
        },
      };
    });
  }

  #nothingWritten(): void {
    this.current.value = null;
    this.#session.notices.sayIfSilent('nothing-written');
  }

  /** @param begun what was shown of a memory in which the write began; null where it did not. */
  #endOf(memory: number, begun: MemoryChange | null, change: MemoryChange | null = null): MemoryEnd {
    const known = this.#session.knowledge.of(memory);
    return { memory, known, change, state: begun ? stateOf(known, begun) : 'untouched' };
  }
}

/** Whether there is nothing to be said but that it was done. */
export function isGood({ stopped, ends }: MemoriesOutcome): boolean {
  return stopped === null && ends.every(({ state }) => state === 'verified');
}

function stateOf(known: Known, { before }: MemoryChange): MemoryEnd['state'] {
  if (known.state !== 'read') return 'unknown';
  if (known.verified) return 'verified';
  return differences(before, known.program).length === 0 ? 'untouched' : 'differs';
}

/** The memories into which a plan writes. */
function targetsOf(plan: Plan): readonly number[] {
  if (plan.kind === 'copy') return [plan.to];
  const programs = plan.kind === 'restore' ? plan.backups.map(({ program }) => program) : [];
  return programs.flatMap(({ memory }) => (memory === null ? [] : [memory]));
}
