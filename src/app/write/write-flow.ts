import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { TimerError, type WriteReport } from '../../client/index.js';
import {
  type Change,
  differences,
  type Finding,
  type FindingCode,
  type Model,
  type TimerProgram,
} from '../../program/index.js';
import { CodecError } from '../../protocol/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { type Crossing, sameCrossing, sameModel } from '../session/crossing.js';
import type { JobContext, JobEnd } from '../session/job-runner.js';
import type { Session } from '../session/session.js';
import { JobDialog } from './job-dialog.js';
import type { Tick } from './start-buttons.js';
import { strayed } from './strayed.js';

/** What the dialog has shown: exactly this is written, or nothing. */
export interface Shown {
  readonly connection: TimerConnection;
  /** What the timer holds, by the reading for this dialog. */
  readonly baseline: TimerProgram;
  readonly goal: TimerProgram;
  readonly changes: readonly Change[];
  /** The model that the timer belongs to; null when it is not known. */
  readonly model: Model | null;
  /** Set when the values are of another model. */
  readonly crossing: Crossing | null;
}

/** The steps of a write, from the difference to the result. */
export type WriteStep =
  | {
      readonly step: 'review';
      readonly shown: Shown;
      /** Why the difference is shown again: the timer, the edits or the model have changed since. Nothing was sent. */
      readonly moved: 'timer' | 'edits' | 'model' | null;
    }
  /** Where the browser cannot keep a copy of the timer's content, the job asks the pilot before anything is sent. */
  | { readonly step: 'running' }
  | {
      readonly step: 'done';
      readonly report: WriteReport;
      /** What was written, as the dialog has shown it. */
      readonly shown: Shown;
      /** Milliseconds since 1970. */
      readonly at: number;
      /**
       * Whether only its button closes the result, because the pilot has to see it: an Escape may be meant for
       * something else.
       */
      readonly stays: boolean;
      /** Whether positions were not kept, perhaps because the servos did not move. */
      readonly notHeld: boolean;
    }
  | { readonly step: 'refused'; readonly error: TimerError };

/** Shows the difference, writes it, and shows the result. */
export class WriteFlow extends JobDialog<WriteStep> {
  readonly #acknowledged = signal(false, { name: 'acknowledged' });
  readonly #crossed = signal(false, { name: 'crossed' });
  /** Whether the pilot agrees to write values of one model into the timer of another. */
  readonly crossed: ReadonlySignal<boolean> = this.#crossed;
  /** Whether the pilot has read the serious findings. */
  readonly acknowledged: ReadonlySignal<boolean> = this.#acknowledged;
  readonly serious: ReadonlySignal<readonly Finding[]> = computed(() =>
    this.#session.editor.findings.value.filter(({ severity }) => severity === 'serious'),
  );
  /** Whether DT is short: good for a trimming flight, so it needs no tick. */
  readonly short: ReadonlySignal<boolean> = computed(() =>
    this.#session.editor.findings.value.some(({ code }) => code === 'dt-short'),
  );
  /** The shown result, when it is verified. */
  readonly verified: ReadonlySignal<Extract<WriteStep, { step: 'done' }> | null> = computed(() => {
    const step = this.current.value;
    return step?.step === 'done' && step.report.result === 'verified' ? step : null;
  });
  /** What the pilot has to tick before the write may begin. */
  readonly unticked: ReadonlySignal<readonly Tick[]> = computed(() => [
    ...(this.#crossing.value && !this.crossed.value ? (['model'] as const) : []),
    ...(this.serious.value.length > 0 && !this.acknowledged.value ? (['warnings'] as const) : []),
    ...(this.#session.safety.confirmed.value ? [] : (['safety'] as const)),
  ]);
  /** Whether the write may begin. */
  readonly ready: ReadonlySignal<boolean> = computed(() => this.unticked.value.length === 0);
  /** Set when the shown values would go into the timer of another model. */
  readonly #crossing = computed(() => {
    const step = this.current.value;
    return step?.step === 'review' ? step.shown.crossing : null;
  });
  readonly #session: Session;

  constructor(session: Session) {
    super(session);
    this.#session = session;
    effect(() => session.editor.confirm(this.verified.value?.shown.changes.map(({ field }) => field) ?? []));
  }

  /** Reads the timer afresh and shows the difference from what it holds now. */
  async open(): Promise<void> {
    const { editor } = this.#session;
    const memory = editor.working.value?.memory;
    if (editor.blocked.value || !(await this.#session.reader.read()) || editor.blocked.value) return;
    // Another memory is current now. The edits are kept, and the pilot was told.
    if (editor.working.value?.memory !== memory) return;
    this.#review(null);
  }

  /** The pilot has read the serious findings, or takes that back. */
  acknowledge(read: boolean): void {
    this.#acknowledged.value = read;
  }

  /** The pilot agrees to write values of one model into the timer of another, or no longer agrees. */
  cross(wanted: boolean): void {
    this.#crossed.value = wanted;
  }

  /**
   * Writes what was shown, on the connection on which it was shown.
   * If something has changed since, shows it again instead.
   */
  async start(): Promise<void> {
    const { editor, knowledge } = this.#session;
    const current = this.current.value;
    if (current?.step !== 'review' || !this.ready.value) return;
    const { shown } = current;
    const isAsShown = editor.baseline.value === shown.baseline && editor.working.value === shown.goal;
    if (!isAsShown || editor.blocked.value) return this.#review('edits');
    const { origin } = this.#session;
    const isModelAsShown = sameModel(origin.timer.value, shown.model);
    if (!isModelAsShown || !sameCrossing(origin.crossing.value, shown.crossing)) return this.#review('model');
    const despite = this.serious.value.map(({ code }) => code);
    const end = await this.#session.runner.perform('write', async (connection, options) => {
      try {
        await this.#write(shown, despite, connection, options);
      } catch (error) {
        // These errors come before the first byte. After any other, nobody knows what was sent.
        if (error instanceof TimerError || error instanceof CodecError) await knowledge.ended(shown.baseline);
        throw error;
      }
    });
    const { value } = this.current;
    if (end.good) {
      if (value?.step === 'done' && value.report.stopped?.code === 'no-answer') {
        this.#session.notices.report(value.report.stopped);
      }
      return;
    }
    this.#refused(end);
  }

  /** Leaves the result and shows what still differs. */
  async again(): Promise<void> {
    this.dismiss();
    await this.open();
  }

  protected connectionOf(step: WriteStep): TimerConnection | null {
    return step.step === 'review' ? step.shown.connection : null;
  }

  protected stays(step: WriteStep): boolean {
    return step.step === 'done' && step.stays;
  }

  #review(moved: 'timer' | 'edits' | 'model' | null): void {
    const { editor, connection: link, servoMoves, origin } = this.#session;
    const connection = link.value;
    const baseline = editor.baseline.value;
    const goal = editor.working.value;
    batch(() => {
      this.#acknowledged.value = false;
      this.#crossed.value = false;
      servoMoves.ask();
      const shown = connection &&
        baseline &&
        goal && {
          connection,
          baseline,
          goal,
          changes: differences(baseline, goal),
          model: origin.timer.value,
          crossing: origin.crossing.value,
        };
      this.show(shown && { step: 'review', shown, moved });
    });
  }

  /** @param despite the serious findings that the pilot has read. */
  async #write(
    shown: Shown,
    despite: readonly FindingCode[],
    connection: TimerConnection,
    options: JobContext,
  ): Promise<void> {
    const { editor, knowledge, recovery, recognition, servoMoves, link } = this.#session;
    const { baseline, goal } = shown;
    if (connection !== shown.connection) throw new TimerError('closed', 'it was shown for another connection');
    const { signal, onProgress, stillOn, ask } = options;
    this.show({ step: 'running' });
    const isSimulated = link.simulated.value;
    // Goal and backup are kept before the first byte: whatever happens, the content of the timer can then be explained.
    const kept = shown.changes.length === 0 || (await recovery.begin(baseline, goal, isSimulated));
    stillOn();
    if (!kept) {
      if (!(await ask())) throw new TimerError('aborted', 'not without a copy');
      stillOn();
    }
    const moveServos = servoMoves.take();
    const report = await connection.client.writeProgram(goal, { baseline, despite, moveServos, signal, onProgress });
    const at = Date.now();
    batch(() => {
      if (report.held) {
        // A complete read back leaves nothing to find out later.
        if (!report.stopped) void knowledge.ended(baseline);
        knowledge.read(report.held, at, report.result === 'verified');
        if (report.stopped) recovery.wasRead(report.held, isSimulated);
        editor.wrote(report.held);
        if (report.result === 'verified') recognition.wrote(shown.model);
      }
      const other = strayed([report]);
      if (other !== null) knowledge.doubt(other);
      const stays = report.result !== 'verified' || signal.aborted;
      const notHeld = servoMoves.wanted(moveServos, [report]);
      this.show({ step: 'done', report, shown, at, stays, notHeld });
    });
  }

  /** Nothing was written, or nobody knows: says why. */
  #refused(end: Extract<JobEnd<void>, { good: false }>): void {
    const session = this.#session;
    const { error, lost } = end;
    // Another job has the wire: the pilot can try again.
    if (error === null && !lost) return;
    if (!(error instanceof TimerError)) {
      this.show(null);
      session.runner.report(end);
    } else if (error.code === 'stale' && error.details.held && !lost) {
      session.editor.rebase(error.details.held);
      session.knowledge.read(error.details.held);
      this.#review('timer');
    } else if (error.code === 'aborted') {
      this.show(null);
      session.notices.say('nothing-written');
    } else if (error.code === 'port-lost' || error.code === 'closed') {
      this.show(null);
    } else {
      if (error.code === 'other-memory') session.nextFlight.doubt();
      this.show({ step: 'refused', error });
    }
  }
}
