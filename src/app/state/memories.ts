import { effect, type ReadonlySignal, signal } from '@preact/signals';
import type { MemoriesReport, Progress, TimerClient, TimerError } from '../../client/index.js';
import type { TimerProgram } from '../../program/index.js';
import type { CodecError, Identity } from '../../protocol/index.js';
import type { Backup } from '../storage/index.js';
import type { JobOptions, Session } from './session.js';

/** What is to be done with several memories, before it is done. */
export type Plan =
  | { readonly kind: 'back-up' }
  /** The content of a memory, by its last reading, into another one. */
  | { readonly kind: 'copy'; readonly from: number; readonly to: number }
  | { readonly kind: 'restore'; readonly backups: readonly Backup[] };

/** What became of a job over several memories. */
export interface MemoriesOutcome {
  /** How many memories were read and kept. */
  readonly saved: number;
  /** What became of each memory that was written. */
  readonly written: MemoriesReport['memories'];
  /** What stopped it; null when nothing did. */
  readonly stopped: TimerError | CodecError | null;
  /** Positions were not kept, perhaps because the servos did not move. */
  readonly unkept: boolean;
}

/** The steps of a job over several memories. */
export type MemoriesStep =
  | { readonly step: 'review'; readonly plan: Plan }
  | {
      readonly step: 'running';
      readonly plan: Plan;
      readonly progress: Progress | null;
      readonly stop: AbortController;
    }
  | {
      readonly step: 'done';
      readonly plan: Plan;
      readonly outcome: MemoriesOutcome;
      /** Whether the browser has kept the backups. */
      readonly kept: boolean;
    };

/** Back up all memories, copy one to another, restore several: only when the pilot asks for it. */
export class Memories {
  readonly current = signal<MemoriesStep | null>(null, { name: 'memories' });
  /** What each memory of the timer that is connected held when all were read, by its number; empty before that. */
  readonly contents: ReadonlySignal<ReadonlyMap<number, TimerProgram>>;
  readonly #contents = signal<ReadonlyMap<number, TimerProgram>>(new Map(), { name: 'contents' });
  readonly #session: Session;
  #kept = true;

  constructor(session: Session) {
    this.#session = session;
    this.contents = this.#contents;
    effect(() => {
      // Whatever is read or acknowledged since stands for its memory, also when another one is current later.
      const held = session.editor.baseline.value;
      const contents = this.#contents.peek();
      if (!held || held.memory === null || contents.size === 0) return;
      this.#contents.value = new Map(contents).set(held.memory, held);
    });
    session.connection.subscribe(() => {
      this.#contents.value = new Map();
    });
  }

  /** Shows what is about to be done. */
  open(plan: Plan): void {
    if (!this.#session.connection.value || this.#session.busy.value) return;
    this.#session.servoMoves.ask();
    this.current.value = { step: 'review', plan };
  }

  /** Leaves the dialog; while bytes move, asks the job to stop instead. */
  dismiss(): void {
    const { value } = this.current;
    if (value?.step === 'running') {
      value.stop.abort();
      this.current.value = { ...value };
    } else {
      this.current.value = null;
    }
  }

  async start(): Promise<void> {
    const { value } = this.current;
    if (value?.step !== 'review') return;
    const { plan } = value;
    this.#kept = true;
    let outcome: MemoriesOutcome = { saved: 0, written: [], stopped: null, unkept: false };
    await this.#session.run('memories', null, async ({ client, identity }, options) => {
      // Others are selected on the way; what is read at the end says which one is current.
      this.#session.memoryOpen.value = true;
      const told = { ...options, onProgress: (progress: Progress) => this.#follow(plan, progress, options) };
      if (plan.kind === 'back-up') outcome = { ...outcome, saved: await this.#backUp(client, identity, told) };
      else
        outcome = {
          ...outcome,
          ...(await this.#write(client, identity, await this.#goals(client, identity, plan, told), told)),
        };
      if (outcome.stopped) throw outcome.stopped;
    });
    // What stopped a backup stands in the notice of the page.
    this.current.value =
      plan.kind === 'back-up' && outcome.saved === 0 ? null : { step: 'done', plan, outcome, kept: this.#kept };
    if (!this.#session.connection.value) return;
    const { notice } = this.#session;
    const said = notice.value;
    await this.#session.read();
    // A reading that has nothing to say does not take back what stopped the job.
    notice.value ??= said;
  }

  async #backUp(client: TimerClient, identity: Identity, options: JobOptions): Promise<number> {
    const { backups, simulated } = this.#session;
    const programs = await this.#read(client, identity, options);
    this.#remember(programs);
    const savedAt = Date.now();
    for (const program of programs) {
      await backups.add(program, 'memories', simulated.value, savedAt).catch(() => {
        this.#kept = false;
      });
    }
    return programs.length;
  }

  /** Reads some memories, or all; the one that was current is so again. */
  async #read(
    client: TimerClient,
    identity: Identity,
    options: JobOptions & { readonly memories?: readonly number[] },
  ): Promise<readonly TimerProgram[]> {
    const onHome = (home: number): Promise<void> => this.#leave(identity, home);
    const { programs } = await client.readMemories({ ...options, onHome }).catch(async (error: unknown) => {
      await this.#home(identity, error);
      throw error;
    });
    await this.#home(identity, null);
    return programs;
  }

  async #write(
    client: TimerClient,
    identity: Identity,
    goals: readonly TimerProgram[],
    options: JobOptions,
  ): Promise<Pick<MemoriesOutcome, 'written' | 'stopped' | 'unkept'>> {
    const { knowledge, recovery, simulated, servoMoves } = this.#session;
    const moveServos = servoMoves.take();
    const { memories, stopped } = await client.writeMemories(goals, {
      ...options,
      moveServos,
      onHome: (home) => this.#leave(identity, home),
      // The goal and a backup are kept before the first byte, as for any write.
      onMemory: async (read, goal) => {
        if (!(await recovery.begin(read, goal, simulated.value))) this.#kept = false;
      },
    });
    for (const { before, report } of memories) {
      if (report.held && !report.stopped) await knowledge.ended(before);
    }
    if (this.#contents.value.size > 0) this.#remember(memories.flatMap(({ report }) => report.held ?? []));
    await this.#home(identity, stopped);
    const reports = memories.map(({ report }) => report);
    return { written: memories, stopped, unkept: servoMoves.wanted(moveServos, reports) };
  }

  #remember(programs: readonly TimerProgram[]): void {
    const read = programs.flatMap((program): [number, TimerProgram][] =>
      program.memory === null ? [] : [[program.memory, program]],
    );
    this.#contents.value = new Map([...this.#contents.value, ...read]);
  }

  async #leave(identity: Identity, home: number): Promise<void> {
    const { recovery, simulated } = this.#session;
    if (!(await recovery.leave(identity, home, simulated.value))) this.#kept = false;
  }

  /** The memory that was current is so again, unless the job ended with the very word that it is not. */
  async #home(identity: Identity, stopped: unknown): Promise<void> {
    const { recovery, simulated } = this.#session;
    const isLeft = stopped instanceof Error && 'code' in stopped && stopped.code === 'memory-left';
    if (!isLeft) await recovery.cameHome(identity, simulated.value);
  }

  #follow(plan: Plan, progress: Progress, { onProgress }: JobOptions): void {
    onProgress(progress);
    const stop = this.#session.job.value?.stop;
    if (stop) this.current.value = { step: 'running', plan, progress, stop };
  }

  /** What the memories shall hold: a memory that is copied is read for that. */
  async #goals(
    client: TimerClient,
    identity: Identity,
    plan: Exclude<Plan, { kind: 'back-up' }>,
    options: JobOptions,
  ): Promise<TimerProgram[]> {
    if (plan.kind === 'restore') return plan.backups.map(({ program }) => program);
    const sources = await this.#read(client, identity, { ...options, memories: [plan.from] });
    // Whether the idle throttle belongs to a memory is not known: it is left as it is.
    return sources.map((source) => ({ ...source, memory: plan.to, idleThrottle: null }));
  }
}
