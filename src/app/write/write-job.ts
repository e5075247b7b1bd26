import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { TimerError } from '../../client/index.js';
import { checkProgram, differences, type Finding, type TimerProgram } from '../../program/index.js';
import { sameCrossing, sameModel } from '../records/crossing.js';
import { type JobEnd, stoppedBy } from '../timer/job-runner.js';
import type { Session } from '../work/session.js';
import { NotedRoundTrip } from './noted-round-trip.js';
import {
  changeOf,
  changesBy,
  type Done,
  type EditsPlan,
  goalOf,
  isGood,
  isOfScreen,
  isOwn,
  isPart,
  type MemoriesPlan,
  type MemoryEnd,
  memoriesOf,
  type Outcome,
  type Plan,
  type Review,
  targetsOf,
  tripOf,
  type WriteStep,
} from './plan.js';
import { Sending, type SendingParts } from './sending.js';
import type { Tick } from './start-buttons.js';

type WriteParts = SendingParts & Pick<Session, 'connection' | 'notices' | 'origin' | 'runner' | 'safety'>;

const EDITS: EditsPlan = { kind: 'edits' };

/**
 * Everything that changes what memories hold: writes what is on the screen, copies a memory to another one, restores
 * backups. Shows the difference, writes it, and shows the result. Meanwhile nothing else is sent to the timer.
 */
export class WriteJob {
  // Only this model writes these.
  /** Null while its dialog is closed. */
  readonly current = signal<WriteStep | null>(null, { name: 'write' });
  /**
   * What the pilot has ticked for this write: `model`, to write values of one model into the timer of another;
   * `warnings`, that the serious findings are read.
   */
  readonly ticked = signal<ReadonlySet<Tick>>(new Set(), { name: 'ticked' });
  /** Of what is on the screen. What is copied or restored was in a memory before. */
  readonly serious: ReadonlySignal<readonly Finding[]> = computed(() => {
    const { value } = this.current;
    const { editor } = this.#parts;
    const [part] = value?.step === 'review' && isPart(value.plan) ? value.changes : [];
    const findings = part
      ? checkProgram(part.goal, { baseline: part.before, shortDt: editor.shortDt.value })
      : editor.findings.value;
    return findings.filter(({ severity }) => severity === 'serious');
  });
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
    const isNeeded = {
      model: value.crossing !== null,
      warnings: isOfScreen(value.plan) && this.serious.value.length > 0,
      safety: !this.#parts.safety.confirmed.value,
    };
    return (['model', 'warnings', 'safety'] as const).filter((tick) => isNeeded[tick] && !this.ticked.value.has(tick));
  });
  /** Whether the write may begin. */
  readonly ready: ReadonlySignal<boolean> = computed(() => {
    const { value } = this.current;
    return value?.step === 'review' && !isRefused(value) && this.unticked.value.length === 0;
  });
  readonly #parts: WriteParts;
  /** Answers what the dialog asks: whether to go on, or another plan to show in its place. */
  #answer: (said: boolean | Plan) => void = () => {};

  constructor(parts: WriteParts) {
    this.#parts = parts;
    effect(() => {
      const connection = parts.connection.value;
      const shown = this.current.peek();
      // The notice says why it is gone.
      if (shown?.step === 'review' && shown.connection !== connection) this.dismiss();
    });
    effect(() => {
      const { value } = this.current;
      const end = value?.step === 'done' && isOwn(value.plan) ? value.ends[0] : null;
      const written = end?.state === 'verified' ? end.change?.changes : null;
      parts.editor.confirm((written ?? []).map(({ field }) => field));
    });
  }

  /**
   * Shows what would change, by a fresh reading. Writes it when the pilot agrees, and says what came of it. Settles
   * when the pilot has left it.
   */
  async open(plan: Plan = this.#into(this.#parts.editor.working.peek()?.memory ?? null)): Promise<void> {
    // Edits of a memory that does not fly next need a round trip.
    const isLost = plan.kind === 'edits' && this.#parts.onScreen.apart.peek();
    if (this.current.value || !this.#parts.runner.ready.value || isLost) return;
    let step = await this.#compare(plan, null);
    while (step) {
      const said = await this.#ask(step);
      if (said === false) return;
      if (said === true && step.step === 'review') step = this.#movedSince(step) ?? (await this.#run(step));
      else {
        const next = said === true ? step.plan : said;
        this.#show(step.step === 'done' ? null : { step: 'running', plan: next });
        step = await this.#compare(next, null);
      }
    }
    this.#show(null);
  }

  /** The pilot goes on: writes what is shown, or after the result shows what still differs. */
  goOn(): void {
    if (this.current.value?.step === 'done' || this.ready.value) this.#answer(true);
  }

  /** The pilot wants what is on the screen in this memory, counted from 0: shows what would change there. */
  writeTo(memory: number): void {
    this.#answer(this.#into(memory));
  }

  /** Into the memory that flies next its own changes go as they are; into any other one by a round trip. */
  #into(memory: number | null): Plan {
    const { editor, onScreen } = this.#parts;
    const program = editor.working.peek();
    const isEdits = memory === null || !program || (memory === program.memory && !onScreen.apart.peek());
    return isEdits ? EDITS : { kind: 'screen', to: memory, own: memory === program.memory };
  }

  /** Whether the dialog has to stay open, whatever key is pressed. */
  get held(): boolean {
    const { value } = this.current;
    if (value?.step === 'running') return !this.#parts.runner.job.value?.asking;
    return value?.step === 'done' && value.stays;
  }

  /** Leaves it. During a job, asks the job to stop instead. */
  dismiss(): void {
    if (this.current.value?.step === 'running') void this.#parts.runner.stop();
    else {
      this.#show(null);
      this.#answer(false);
    }
  }

  /** The pilot ticks it, or takes that back. Safety has its own tick, which lasts as long as the connection. */
  tick(what: Exclude<Tick, 'safety'>, isTicked: boolean): void {
    const others = [...this.ticked.peek()].filter((each) => each !== what);
    this.ticked.value = new Set(isTicked ? [...others, what] : others);
  }

  /** Shows it, and waits for what the pilot says. */
  #ask(step: Review | Done): Promise<boolean | Plan> {
    batch(() => {
      this.ticked.value = new Set();
      this.#parts.servoMoves.ask();
      this.#show(step);
    });
    return new Promise((resolve) => {
      this.#answer = resolve;
    });
  }

  /** What a plan would change, by a fresh reading; null when nothing is to be shown. */
  async #compare(plan: Plan, moved: Review['moved']): Promise<Review | Done | null> {
    const { editor, reader } = this.#parts;
    if (plan.kind === 'screen' && editor.blocked.value) return null;
    if (plan.kind !== 'edits') return await this.#compareMemories(plan, moved);
    const memory = editor.working.value?.memory;
    if (editor.blocked.value || !(await reader.read()) || editor.blocked.value) return null;
    // Another memory may be current now. The edits are kept, and the pilot was told.
    return editor.working.value?.memory === memory ? this.#edits(plan, null) : null;
  }

  /** The edits as they are now. */
  #edits(plan: EditsPlan, moved: Review['moved']): Review | null {
    const { editor } = this.#parts;
    const connection = this.#parts.connection.value;
    const before = editor.baseline.value;
    const working = editor.working.value;
    if (!connection || !before || !working) return null;
    const changes = [changeOf(before, goalOf(plan, before, working))];
    return { step: 'review', plan, connection, changes, ...this.#whose(plan), moved };
  }

  async #compareMemories(plan: MemoriesPlan, moved: Review['moved']): Promise<Review | Done | null> {
    const { runner, connection, reader, editor } = this.#parts;
    const began = connection.value;
    const memory = editor.working.value?.memory;
    this.#show({ step: 'running', plan });
    const trip = new NotedRoundTrip(this.#parts, tripOf(plan));
    const end = await runner.perform('memories', async (on, options) => {
      const read = await trip.read(on, { ...options, memories: memoriesOf(plan) });
      // That reading is on the screen by now, below the edits.
      const working = editor.working.peek();
      const changes = working && changesBy(plan, read, working);
      if (!changes) throw new TimerError('other-timer', 'a backup is of another kind');
      return changes;
    });
    if (!end.good) {
      const ends = targetsOf(plan).map(
        (memory): MemoryEnd => ({ memory, state: 'untouched', change: null, report: null }),
      );
      return await this.#result(plan, null, end, { ends, notHeld: false, strayed: null }, false);
    }
    await reader.readIfOpen();
    if (!began || connection.value !== began) return null;
    // The screen shows another memory by now. The edits are kept, and the pilot was told.
    if (plan.kind === 'screen' && editor.working.value?.memory !== memory) return null;
    return { step: 'review', plan, connection: began, changes: end.value, ...this.#whose(plan), moved };
  }

  /** What is to be shown again, because it is no longer as it was shown; null when it is. */
  #movedSince(review: Review): Review | null {
    const { editor } = this.#parts;
    const { plan } = review;
    const [shown] = review.changes;
    const working = editor.working.value;
    const now = { ...review, ...this.#whose(plan) };
    if (isOfScreen(plan) && shown && working) {
      const before = (plan.kind === 'edits' ? editor.baseline.value : null) ?? shown.before;
      const change = changeOf(before, goalOf(plan, before, working));
      const isAsShown = before === shown.before && differences(change.goal, shown.goal).length === 0;
      if (!isAsShown || editor.blocked.value) return { ...now, changes: [change], moved: 'edits' };
    }
    const isSame = sameModel(now.model, review.model) && sameCrossing(now.crossing, review.crossing);
    return isSame ? null : { ...now, moved: 'model' };
  }

  /** Writes what was shown. @returns what is to be shown next; null for nothing. */
  async #run(review: Review): Promise<Review | Done | null> {
    const { runner, knowledge, editor } = this.#parts;
    const { plan, model } = review;
    const sending = new Sending(this.#parts, review, this.serious.value);
    this.#show({ step: 'running', plan });
    const kind = plan.kind === 'edits' ? 'write' : 'memories';
    const end = await runner.perform(kind, (connection, options) => sending.run(connection, options));
    // Another job has the wire: the pilot can try again.
    if (!end.good && end.error === null && !end.lost) return review;
    const error = !end.good && !end.lost && end.error instanceof TimerError ? end.error : null;
    if (error?.code === 'stale' && isUntouched(sending.outcome)) {
      const { held } = error.details;
      if (plan.kind !== 'edits' || !held) return await this.#compare(plan, 'timer');
      editor.rebase(held);
      knowledge.read(held);
      return this.#edits(plan, 'timer');
    }
    return await this.#result(plan, model, end, sending.outcome, sending.isStopping);
  }

  /** What came of it; null where nothing is to be said, or a notice says it. */
  async #result(
    plan: Plan,
    model: Review['model'],
    end: JobEnd<unknown>,
    done: Omit<Outcome, 'stopped'>,
    stopping: boolean,
  ): Promise<Done | null> {
    const { runner, notices, nextFlight, reader } = this.#parts;
    const stopped = end.good
      ? null
      : { code: stoppedBy(end), details: end.error instanceof TimerError ? end.error.details : {} };
    // The result says it, too. But only a notice outlasts the connection, and the link has to wait for a silent timer.
    if (!end.good && (end.lost || stopped?.code === 'no-answer')) runner.report(end);
    if (stopped?.code === 'other-memory' || (plan.kind !== 'edits' && !isUntouched(done))) nextFlight.doubt();
    // One of the written memories may be the one on the screen.
    if (plan.kind !== 'edits') await reader.readIfOpen();
    if (stopped?.code === 'aborted' && isUntouched(done)) notices.sayIfSilent('nothing-written');
    if (isUntouched(done) && stopped && ['aborted', 'port-lost', 'closed'].includes(stopped.code)) return null;
    const outcome: Outcome = { ...done, stopped };
    return { step: 'done', plan, model, at: Date.now(), stays: !isGood(outcome) || stopping, ...outcome };
  }

  /** The model of the timer, for a write of what is on the screen, and whether the values are of another one. */
  #whose(plan: Plan): Pick<Review, 'model' | 'crossing'> {
    const { origin } = this.#parts;
    if (isOfScreen(plan)) return { model: origin.timer.value, crossing: isPart(plan) ? null : origin.crossing.value };
    const of = plan.kind === 'restore' ? plan.backups.find(({ model }) => model !== undefined)?.model : undefined;
    return { model: null, crossing: origin.crossingFrom(of ?? null) };
  }

  /** Shows a step, or closes the dialog. */
  #show(step: WriteStep | null): void {
    batch(() => {
      this.current.value = step;
      this.#parts.runner.claim(step !== null);
    });
  }
}

/** Whether nothing was written at all. */
function isUntouched({ ends }: Pick<Outcome, 'ends'>): boolean {
  return ends.every(({ state }) => state === 'untouched');
}

/** Whether one of the memories cannot be written at all. */
function isRefused({ changes }: Review): boolean {
  return changes.some(({ refusals }) => refusals.length > 0);
}
