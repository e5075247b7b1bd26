import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { TimerError, type WriteReport } from '../../client/index.js';
import { checkProgram, differences, type Finding, type Model, type TimerProgram } from '../../program/index.js';
import { CodecError } from '../../protocol/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { type Crossing, sameCrossing, sameModel } from '../records/crossing.js';
import { type JobContext, type JobEnd, stoppedBy } from '../timer/job-runner.js';
import type { Session } from '../work/session.js';
import { NotedRoundTrip } from './noted-round-trip.js';
import {
  changesBy,
  isGood,
  type MemoriesPlan,
  type MemoryChange,
  type MemoryEnd,
  memoriesOf,
  type Outcome,
  type Plan,
  refusalsOf,
  targetsOf,
} from './plan.js';
import type { Tick } from './start-buttons.js';
import { strayed } from './strayed.js';

/** What is about to be written: exactly this, or nothing. */
export interface Review {
  readonly step: 'review';
  readonly plan: Plan;
  /** It is written on this connection, or not at all. */
  readonly connection: TimerConnection;
  readonly changes: readonly MemoryChange[];
  /** The model that the timer belongs to, for a write of what is on the screen; null when it is not known. */
  readonly model: Model | null;
  /** Set when the values are of another model. */
  readonly crossing: Crossing | null;
  /** Why the difference is shown again: the timer, the edits or the model have changed since. Nothing was sent. */
  readonly moved: 'timer' | 'edits' | 'model' | null;
}

/** What came of it. */
export interface Done extends Outcome {
  readonly step: 'done';
  readonly plan: Plan;
  /** As it was reviewed. */
  readonly model: Model | null;
  /** Milliseconds since 1970. */
  readonly at: number;
  /**
   * Whether only its button closes the result, because the pilot has to see it: an Escape may be meant for something
   * else.
   */
  readonly stays: boolean;
}

/** The steps of a write, from the difference to the result. */
export type WriteStep =
  | Review
  /** Where the browser cannot keep a copy of a memory, the job asks the pilot before anything is sent into it. */
  | { readonly step: 'running'; readonly plan: Plan }
  | Done;

/** What a write has done so far. */
interface Sent {
  /** The memories in which writing has begun. */
  readonly begun: Set<number | null>;
  readonly reports: Map<number | null, WriteReport>;
  /** Whether the pilot goes on without a backup. */
  agreed: boolean;
  /** Whether the pilot asked to stop, though it may have come to its end. */
  stopping: boolean;
  notHeld: boolean;
}

const EDITS: Plan = { kind: 'edits' };

/**
 * Everything that changes what memories hold: writes what is on the screen, copies a memory to another one, restores
 * backups. Shows the difference, writes it, and shows the result. Meanwhile nothing else is sent to the timer.
 */
export class WriteJob {
  readonly #current = signal<WriteStep | null>(null, { name: 'write' });
  readonly #acknowledged = signal(false, { name: 'acknowledged' });
  readonly #crossed = signal(false, { name: 'crossed' });
  /** Null while its dialog is closed. */
  readonly current: ReadonlySignal<WriteStep | null> = this.#current;
  /** Whether the pilot agrees to write values of one model into the timer of another. */
  readonly crossed: ReadonlySignal<boolean> = this.#crossed;
  /** Whether the pilot has read the serious findings. */
  readonly acknowledged: ReadonlySignal<boolean> = this.#acknowledged;
  /** Of what is on the screen. What is copied or restored was in a memory before. */
  readonly serious: ReadonlySignal<readonly Finding[]> = computed(() =>
    this.#session.editor.findings.value.filter(({ severity }) => severity === 'serious'),
  );
  /** What the current memory was verified to hold, while that is shown; null else. */
  readonly verified: ReadonlySignal<TimerProgram | null> = computed(() => {
    const { value } = this.current;
    const end = value?.step === 'done' && value.plan.kind === 'edits' ? value.ends[0] : null;
    return end?.state === 'verified' ? (end.report?.held ?? null) : null;
  });
  /** What the pilot has to tick before the write may begin. What no tick can allow is said above. */
  readonly unticked: ReadonlySignal<readonly Tick[]> = computed(() => {
    const { value } = this.current;
    if (value?.step !== 'review' || isRefused(value)) return [];
    const isRead = value.plan.kind !== 'edits' || this.serious.value.length === 0 || this.acknowledged.value;
    return [
      ...(value.crossing && !this.crossed.value ? (['model'] as const) : []),
      ...(isRead ? [] : (['warnings'] as const)),
      ...(this.#session.safety.confirmed.value ? [] : (['safety'] as const)),
    ];
  });
  /** Whether the write may begin. */
  readonly ready: ReadonlySignal<boolean> = computed(() => {
    const { value } = this.current;
    return value?.step === 'review' && !isRefused(value) && this.unticked.value.length === 0;
  });
  readonly #session: Session;
  /** Answers what the dialog asks. */
  #answer: (goOn: boolean) => void = () => {};

  constructor(session: Session) {
    this.#session = session;
    effect(() => {
      const connection = session.connection.value;
      const shown = this.#current.peek();
      // The notice says why it is gone.
      if (shown?.step === 'review' && shown.connection !== connection) this.dismiss();
    });
    effect(() => {
      const { value } = this.current;
      const written = this.verified.value && value?.step === 'done' ? value.ends[0]?.change?.changes : null;
      session.editor.confirm((written ?? []).map(({ field }) => field));
    });
  }

  /**
   * Shows what would change, by a fresh reading. Writes it when the pilot agrees, and says what came of it. Settles
   * when the pilot has left it.
   */
  async open(plan: Plan = EDITS): Promise<void> {
    if (this.#current.value || !this.#session.runner.ready.value) return;
    let step = await this.#compare(plan, null);
    while (step) {
      const { step: asked } = step;
      if (!(await this.#ask(step))) return;
      if (asked === 'done') this.#show(null);
      step =
        step.step === 'done' ? await this.#compare(plan, null) : (this.#movedSince(step) ?? (await this.#run(step)));
    }
    this.#show(null);
  }

  /** The pilot goes on: writes what is shown, or after the result shows what still differs. */
  goOn(): void {
    if (this.current.value?.step === 'done' || this.ready.value) this.#answer(true);
  }

  /** Whether the dialog has to stay open, whatever key is pressed. */
  get held(): boolean {
    const { value } = this.#current;
    if (value?.step === 'running') return !this.#session.runner.job.value?.asking;
    return value?.step === 'done' && value.stays;
  }

  /** Leaves it. During a job, asks the job to stop instead. */
  dismiss(): void {
    if (this.#current.value?.step === 'running') void this.#session.runner.stop();
    else {
      this.#show(null);
      this.#answer(false);
    }
  }

  /** The pilot has read the serious findings, or takes that back. */
  acknowledge(read: boolean): void {
    this.#acknowledged.value = read;
  }

  /** The pilot agrees to write values of one model into the timer of another, or no longer agrees. */
  cross(wanted: boolean): void {
    this.#crossed.value = wanted;
  }

  /** Shows it, and waits for what the pilot says. */
  #ask(step: Review | Done): Promise<boolean> {
    batch(() => {
      this.#acknowledged.value = false;
      this.#crossed.value = false;
      this.#session.servoMoves.ask();
      this.#show(step);
    });
    return new Promise((resolve) => {
      this.#answer = resolve;
    });
  }

  /** What a plan would change, by a fresh reading; null when nothing is to be shown. */
  async #compare(plan: Plan, moved: Review['moved']): Promise<Review | Done | null> {
    if (plan.kind !== 'edits') return await this.#compareMemories(plan, moved);
    const { editor, reader } = this.#session;
    const memory = editor.working.value?.memory;
    if (editor.blocked.value || !(await reader.read()) || editor.blocked.value) return null;
    // Another memory may be current now. The edits are kept, and the pilot was told.
    return editor.working.value?.memory === memory ? this.#edits(null) : null;
  }

  /** The edits as they are now. */
  #edits(moved: Review['moved']): Review | null {
    const { editor, connection: link, origin } = this.#session;
    const connection = link.value;
    const before = editor.baseline.value;
    const goal = editor.working.value;
    if (!connection || !before || !goal) return null;
    const changes = [{ memory: goal.memory, before, goal, changes: differences(before, goal) }];
    const model = origin.timer.value;
    return { step: 'review', plan: EDITS, connection, changes, model, crossing: origin.crossing.value, moved };
  }

  async #compareMemories(plan: MemoriesPlan, moved: Review['moved']): Promise<Review | Done | null> {
    const { runner, connection, reader } = this.#session;
    const began = connection.value;
    this.#show({ step: 'running', plan });
    const trip = new NotedRoundTrip(this.#session, { job: plan.kind, memory: null });
    const end = await runner.perform('memories', async (on, options) => {
      const changes = changesBy(plan, await trip.read(on, { ...options, memories: memoriesOf(plan) }));
      if (!changes) throw new TimerError('other-timer', 'a backup is of another kind');
      return changes;
    });
    if (!end.good) {
      const untouched = (memory: number): MemoryEnd => ({ memory, state: 'untouched', change: null, report: null });
      const ends = targetsOf(plan).map(untouched);
      return await this.#result(plan, null, end, { ends, notHeld: false, strayed: null }, false);
    }
    await reader.readIfOpen();
    if (!began || connection.value !== began) return null;
    const crossing = this.#crossingOf(plan);
    return { step: 'review', plan, connection: began, changes: end.value, model: null, crossing, moved };
  }

  /** What is to be shown again, because it is no longer as it was shown; null when it is. */
  #movedSince(review: Review): Review | null {
    const { editor, origin } = this.#session;
    const { plan } = review;
    if (plan.kind === 'edits') {
      const [shown] = review.changes;
      const isAsShown = editor.baseline.value === shown?.before && editor.working.value === shown?.goal;
      if (!isAsShown || editor.blocked.value) return this.#edits('edits');
    }
    const model = plan.kind === 'edits' ? origin.timer.value : null;
    const crossing = plan.kind === 'edits' ? origin.crossing.value : this.#crossingOf(plan);
    const isSame = sameModel(model, review.model) && sameCrossing(crossing, review.crossing);
    return isSame ? null : { ...review, model, crossing, moved: 'model' };
  }

  /** Writes what was shown. @returns what is to be shown next; null for nothing. */
  async #run(review: Review): Promise<Review | Done | null> {
    const { runner, knowledge, editor } = this.#session;
    const { plan, changes, model } = review;
    const sent: Sent = { begun: new Set(), reports: new Map(), agreed: false, stopping: false, notHeld: false };
    const { begun, reports } = sent;
    this.#show({ step: 'running', plan });
    const end = await runner.perform(plan.kind === 'edits' ? 'write' : 'memories', async (connection, options) => {
      if (connection !== review.connection) throw new TimerError('closed', 'it was shown for another connection');
      const writing =
        plan.kind === 'edits' ? this.#writeEdits(review, options, sent) : this.#writeMemories(review, options, sent);
      const stopped = await writing.catch((error: unknown) => {
        if (error instanceof TimerError || error instanceof CodecError) return error;
        // After any other error nobody knows what was sent.
        throw error;
      });
      for (const { memory, before } of changes) {
        // Where the write did not even begin, nothing was sent.
        if (begun.has(memory) && !reports.has(memory) && begun.delete(memory)) await knowledge.ended(before);
      }
      sent.stopping = options.signal.aborted;
      if (stopped) throw stopped;
    });
    // Another job has the wire: the pilot can try again.
    if (!end.good && end.error === null && !end.lost) return review;
    const stale =
      !end.good && !end.lost && end.error instanceof TimerError && end.error.code === 'stale' ? end.error : null;
    if (stale && begun.size === 0) {
      const { held } = stale.details;
      if (plan.kind !== 'edits' || !held) return await this.#compare(plan, 'timer');
      editor.rebase(held);
      knowledge.read(held);
      return this.#edits('timer');
    }
    const other = strayed([...reports.values()]);
    const ends = changes.map((change): MemoryEnd => {
      const { memory } = change;
      const report = reports.get(memory) ?? null;
      const state = memory === other ? 'unknown' : report ? report.result : begun.has(memory) ? 'unknown' : 'untouched';
      return { memory, state, change, report };
    });
    return await this.#result(plan, model, end, { ends, notHeld: sent.notHeld, strayed: other }, sent.stopping);
  }

  async #writeEdits({ connection, changes, model }: Review, options: JobContext, sent: Sent) {
    const { editor, knowledge, recovery, recognition, servoMoves, link } = this.#session;
    const [change] = changes as [MemoryChange];
    const { before, goal, memory } = change;
    const { signal, onProgress } = options;
    const isSimulated = link.simulated.value;
    await this.#begin(change, options, sent);
    const moveServos = servoMoves.take();
    const despite = this.serious.value.map(({ code }) => code);
    const report = await connection.client.writeProgram(goal, {
      baseline: before,
      despite,
      moveServos,
      signal,
      onProgress,
    });
    const { held, stopped, result } = report;
    sent.reports.set(memory, report);
    sent.notHeld = servoMoves.wanted(moveServos, [report]);
    batch(() => {
      if (held) {
        // A complete read back leaves nothing to find out later.
        if (!stopped) void knowledge.ended(before);
        knowledge.read(held, Date.now(), result === 'verified');
        if (stopped) recovery.wasRead(held, isSimulated);
        editor.wrote(held);
        if (result === 'verified') recognition.wrote(model);
      }
      this.#doubt([report]);
    });
    return stopped;
  }

  async #writeMemories({ connection, changes, plan }: Review, options: JobContext, sent: Sent) {
    const { knowledge, reader, servoMoves } = this.#session;
    const { client, identity } = connection;
    const trip = new NotedRoundTrip(this.#session, { job: (plan as MemoriesPlan).kind, memory: null });
    const goals = changes.map(({ goal }) => goal);
    const moveServos = servoMoves.take();
    const { memories, stopped, original } = await client.writeMemories(goals, {
      ...options,
      // What was in a memory or is kept is copied as it is; the pilot has seen each change.
      despite: goals.flatMap((goal) => checkProgram(goal).map(({ code }) => code)),
      baselines: changes.map(({ before }) => before),
      moveServos,
      onOriginal: (original) => trip.leave(identity, original),
      onMemory: async (read, goal) => {
        const change = changes.find(({ memory }) => memory === goal.memory);
        if (!change) throw new TimerError('closed', 'it was not shown');
        await this.#begin({ ...change, before: read }, options, sent);
      },
    });
    for (const { memory, before, report } of memories) {
      sent.reports.set(memory, report);
      // Nothing is waited for: another timer may be there when the storage answers.
      if (report.held && !report.stopped) void knowledge.ended(before);
      if (report.held) reader.took(report.held, report.result === 'verified');
    }
    const reports = memories.map(({ report }) => report);
    this.#doubt(reports);
    sent.notHeld = servoMoves.wanted(moveServos, reports);
    await trip.wasRestored(identity, original, stopped);
    return stopped;
  }

  /**
   * Goal and backup are kept before the first byte goes into a memory: whatever happens, its content can then be
   * explained. Where the browser does not keep them, the pilot is asked, once.
   */
  async #begin({ memory, before, goal, changes }: MemoryChange, options: JobContext, sent: Sent): Promise<void> {
    const { recovery, link } = this.#session;
    options.stillOn();
    sent.begun.add(memory);
    const kept = changes.length === 0 || (await recovery.begin(before, goal, link.simulated.value));
    options.stillOn();
    if (kept) return;
    sent.agreed ||= await options.ask();
    if (!sent.agreed) throw new TimerError('aborted', 'not without a copy');
    options.stillOn();
  }

  /** Of a memory that may have taken values of another one nothing is known. */
  #doubt(reports: readonly WriteReport[]): void {
    const other = strayed(reports);
    if (other !== null) this.#session.knowledge.doubt(other);
  }

  /** What came of it; null where nothing is to be said, or a notice says it. */
  async #result(
    plan: Plan,
    model: Model | null,
    end: JobEnd<unknown>,
    done: Omit<Outcome, 'stopped'>,
    stopping: boolean,
  ): Promise<Done | null> {
    const { runner, notices, nextFlight, reader } = this.#session;
    const stopped = end.good
      ? null
      : { code: stoppedBy(end), details: end.error instanceof TimerError ? end.error.details : {} };
    const isUntouched = done.ends.every(({ state }) => state === 'untouched');
    // The result says it, too. But only a notice outlasts the connection, and the link has to wait for a silent timer.
    if (!end.good && (end.lost || stopped?.code === 'no-answer')) runner.report(end);
    if (stopped?.code === 'other-memory' || (plan.kind !== 'edits' && !isUntouched)) nextFlight.doubt();
    // One of the written memories may be the one on the screen.
    if (plan.kind !== 'edits') await reader.readIfOpen();
    if (stopped?.code === 'aborted' && isUntouched) notices.sayIfSilent('nothing-written');
    if (isUntouched && stopped && ['aborted', 'port-lost', 'closed'].includes(stopped.code)) return null;
    const outcome: Outcome = { ...done, stopped };
    return { step: 'done', plan, model, at: Date.now(), stays: !isGood(outcome) || stopping, ...outcome };
  }

  #crossingOf(plan: MemoriesPlan): Crossing | null {
    if (plan.kind !== 'restore') return null;
    return this.#session.origin.crossingFrom(plan.backups.find(({ model }) => model !== undefined)?.model ?? null);
  }

  /** Shows a step, or closes the dialog. */
  #show(step: WriteStep | null): void {
    batch(() => {
      this.#current.value = step;
      this.#session.runner.claim(step !== null);
    });
  }
}

/** Whether one of the memories cannot be written at all. */
function isRefused({ changes }: Review): boolean {
  return changes.some((change) => refusalsOf(change).length > 0);
}
