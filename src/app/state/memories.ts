import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { type MemoriesReport, type Progress, type TimerClient, TimerError } from '../../client/index.js';
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

/** Look at a memory, back up all of them, copy one to another, restore several: only when the pilot asks for it. */
export class Memories {
  readonly current = signal<MemoriesStep | null>(null, { name: 'memories' });
  /** A memory that is not the current one and that the pilot looks at, by what was last read of it; null: none. */
  readonly looking: ReadonlySignal<number | null> = computed(() => {
    const { memoryOpen, editor } = this.#session;
    const current = memoryOpen.value ? null : (editor.baseline.value?.memory ?? null);
    return this.#picked.value === current ? null : this.#picked.value;
  });
  readonly #picked = signal<number | null>(null, { name: 'picked' });
  readonly #session: Session;
  #kept = true;
  /** The memory to come back to, while a job has left it. */
  #home: number | null = null;

  constructor(session: Session) {
    this.#session = session;
    // The next timer may be another one.
    session.connection.subscribe(() => {
      this.#picked.value = null;
    });
  }

  /** Shows what was last read of a memory, and sends nothing; of the current one the program itself. */
  show(memory: number): void {
    this.#picked.value = memory;
  }

  /** Reads a memory and makes the one current again that was. */
  async look(memory: number): Promise<void> {
    this.#picked.value = memory;
    await this.#session.run('look', memory, async ({ client, identity }, options) => {
      await this.#read(client, identity, { ...options, memories: [memory] });
    });
    await this.#findCurrent();
  }

  /** Makes a memory the one that flies next, and shows it. Edits of the one that is left are kept. */
  async fly(memory: number): Promise<boolean> {
    const good = await this.#session.selectMemory(memory);
    this.#picked.value = null;
    return good;
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
    // What was written may be what is on the screen.
    if (plan.kind !== 'back-up') this.#session.memoryOpen.value = true;
    await this.#findCurrent();
  }

  /** Asks which memory is current where a job has left that open. */
  async #findCurrent(): Promise<void> {
    const { notice, memoryOpen, connection } = this.#session;
    if (!memoryOpen.value || !connection.value) return;
    const said = notice.value;
    await this.#session.read();
    // A reading that has nothing to say does not take back what stopped the job.
    notice.value ??= said;
  }

  async #backUp(client: TimerClient, identity: Identity, options: JobOptions): Promise<number> {
    const { backups, simulated } = this.#session;
    const programs = await this.#read(client, identity, options);
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
    const { programs, home } = await client.readMemories({ ...options, onHome }).catch(async (error: unknown) => {
      await this.#cameHome(identity, this.#home, error);
      throw error;
    });
    for (const program of programs) this.#session.knowledge.read(program);
    await this.#cameHome(identity, home, null);
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
    const { memories, stopped, home } = await client.writeMemories(goals, {
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
      if (report.held) knowledge.read(report.held, Date.now(), report.result === 'verified');
    }
    await this.#cameHome(identity, home, stopped);
    const reports = memories.map(({ report }) => report);
    return { written: memories, stopped, unkept: servoMoves.wanted(moveServos, reports) };
  }

  /** Another memory is about to be selected: the one to come back to is noted. */
  async #leave(identity: Identity, home: number): Promise<void> {
    const { recovery, simulated, memoryOpen, nextFlight } = this.#session;
    this.#home = home;
    // A job that has not come back before is remembered until its own home is current again.
    const isNoted = recovery.offer.value?.kind === 'memories';
    if (!isNoted && !(await recovery.leave(identity, home, simulated.value))) this.#kept = false;
    memoryOpen.value = true;
    nextFlight.leave(null);
  }

  /** The memory that was current is so again, by the timer's own word, unless the job ended with the very word that it is not. */
  async #cameHome(identity: Identity, home: number | null, stopped: unknown): Promise<void> {
    const { recovery, simulated, memoryOpen, nextFlight, editor } = this.#session;
    const wasLeft = this.#home !== null;
    this.#home = null;
    if (home === null || (stopped instanceof TimerError && stopped.code === 'memory-left')) return;
    nextFlight.found(home);
    memoryOpen.value = home !== editor.baseline.value?.memory;
    if (wasLeft && recovery.offer.value?.kind !== 'memories') await recovery.cameHome(identity, simulated.value);
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
