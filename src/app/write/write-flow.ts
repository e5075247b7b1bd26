import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { type Progress, TimerError, type WriteReport } from '../../client/index.js';
import { type Change, differences, type Finding, type TimerProgram } from '../../program/index.js';
import { CodecError } from '../../protocol/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { JobOptions } from '../session/job-runner.js';
import type { Session } from '../session/session.js';

/** What the dialog has shown: this is written, or nothing is. */
export interface Shown {
  readonly connection: TimerConnection;
  /** What the timer holds, by the reading for this dialog. */
  readonly baseline: TimerProgram;
  readonly goal: TimerProgram;
  readonly changes: readonly Change[];
}

/** The steps of a write, from the difference to the result. */
export type WriteStep =
  | {
      readonly step: 'review';
      readonly shown: Shown;
      /** Why it is shown once more: the timer holds something else than was shown, or something else is wanted by now. Nothing was sent. */
      readonly moved: 'timer' | 'edits' | null;
    }
  | {
      readonly step: 'running';
      readonly progress: Progress | null;
      /** The pilot has asked to stop; the request under way comes to its end. */
      readonly stopping: boolean;
    }
  /** The browser does not keep a copy of what the timer holds: nothing is sent before the pilot has answered. */
  | { readonly step: 'unkept'; readonly answer: (goOn: boolean) => void }
  | {
      readonly step: 'done';
      readonly report: WriteReport;
      /** What was written, as the dialog had shown it. */
      readonly shown: Shown;
      /** Milliseconds since 1970. */
      readonly at: number;
      /** What became of the write has to be seen: only its button closes it, not an Escape meant for something else. */
      readonly stays: boolean;
      /** Positions were not kept, perhaps because the servos did not move. */
      readonly unkept: boolean;
    }
  | { readonly step: 'refused'; readonly error: TimerError };

/** Shows the difference, writes it, and says what became of it. */
export class WriteFlow {
  readonly current = signal<WriteStep | null>(null, { name: 'write' });
  readonly #acknowledged = signal(false, { name: 'acknowledged' });
  /** The pilot has read the serious findings. */
  readonly acknowledged: ReadonlySignal<boolean> = this.#acknowledged;
  readonly serious: ReadonlySignal<readonly Finding[]> = computed(() =>
    this.#session.editor.findings.value.filter(({ severity }) => severity === 'serious'),
  );
  /** Whether the write may begin. */
  readonly ready: ReadonlySignal<boolean> = computed(
    () => this.#session.safety.confirmed.value && (this.serious.value.length === 0 || this.acknowledged.value),
  );
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
    effect(() => {
      const connection = session.connection.value;
      const current = this.current.peek();
      // What was shown was of the timer on that connection; the notice says why it is gone.
      if (current?.step === 'review' && current.shown.connection !== connection) this.current.value = null;
      if (current?.step === 'unkept') current.answer(false);
    });
  }

  /** Reads the timer afresh and shows the difference: what is written is told apart from what the timer holds now. */
  async open(): Promise<void> {
    const { editor } = this.#session;
    const memory = editor.working.value?.memory;
    if (editor.blocked.value || !(await this.#session.read()) || editor.blocked.value) return;
    // Another memory is current by now: the edits were set aside, and the pilot is told so.
    if (editor.working.value?.memory !== memory) return;
    this.#review(null);
  }

  /** The pilot has read the serious findings, or takes that back. */
  acknowledge(read: boolean): void {
    this.#acknowledged.value = read;
  }

  /** Writes what was shown, on the connection where it was shown; shows it once more where anything else is wanted by now. */
  async start(): Promise<void> {
    const { editor, knowledge } = this.#session;
    const current = this.current.value;
    if (current?.step !== 'review' || !this.ready.value) return;
    const { shown } = current;
    const isAsShown = editor.baseline.value === shown.baseline && editor.working.value === shown.goal;
    if (!isAsShown || editor.blocked.value) return this.#review('edits');
    const end = await this.#session.runner.perform('write', async (connection, options) => {
      try {
        await this.#write(shown, connection, options);
      } catch (error) {
        // These come before the first byte; after anything else it is not known what was sent.
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
    this.#refused(end.error, end.lost);
  }

  /** The browser keeps no copy: writes without one, or not at all. */
  answer(goOn: boolean): void {
    if (this.current.value?.step === 'unkept') this.current.value.answer(goOn);
  }

  /** Leaves the result and shows what still differs. */
  async again(): Promise<void> {
    this.dismiss();
    await this.open();
  }

  /** Whether the dialog has to stay open whatever key is pressed. */
  get held(): boolean {
    const { value } = this.current;
    return value?.step === 'running' || (value?.step === 'done' && value.stays);
  }

  /** Escape was pressed: leaves the dialog where it may be left; while bytes move, asks the write to stop. */
  escape(): void {
    if (this.current.value?.step === 'running' || !this.held) this.dismiss();
  }

  /** Leaves the dialog; while bytes move, asks the write to stop instead. */
  dismiss(): void {
    const { value } = this.current;
    if (value?.step === 'running') {
      void this.#session.runner.stop();
      this.current.value = { ...value, stopping: true };
    } else if (value?.step === 'unkept') {
      value.answer(false);
    } else {
      this.current.value = null;
    }
  }

  #review(moved: 'timer' | 'edits' | null): void {
    const { editor, connection: link, servoMoves } = this.#session;
    const connection = link.value;
    const baseline = editor.baseline.value;
    const goal = editor.working.value;
    batch(() => {
      this.#acknowledged.value = false;
      servoMoves.ask();
      const shown = connection &&
        baseline &&
        goal && { connection, baseline, goal, changes: differences(baseline, goal) };
      this.current.value = shown && { step: 'review', shown, moved };
    });
  }

  async #write(shown: Shown, connection: TimerConnection, options: JobOptions): Promise<void> {
    const { editor, knowledge, recovery, servoMoves, link } = this.#session;
    const { baseline, goal } = shown;
    if (connection !== shown.connection) throw new TimerError('closed', 'it was shown for another connection');
    const { signal, stillOn } = options;
    const running = (progress: Progress | null): void => {
      if (progress) options.onProgress(progress);
      this.current.value = { step: 'running', progress, stopping: signal.aborted };
    };
    running(null);
    const isSimulated = link.simulated.value;
    // The goal and a backup are kept before the first byte: whatever happens, what the timer holds can be explained.
    const kept = shown.changes.length === 0 || (await recovery.begin(baseline, goal, isSimulated));
    stillOn();
    if (!kept) {
      if (!(await this.#agreed())) throw new TimerError('aborted', 'not without a copy');
      stillOn();
      running(null);
    }
    const moveServos = servoMoves.take();
    const report = await connection.client.writeProgram(goal, {
      baseline,
      moveServos,
      signal,
      onProgress: running,
    });
    const at = Date.now();
    batch(() => {
      if (report.held) {
        // What was read back to its end needs no finding out at the next meeting.
        if (!report.stopped) void knowledge.ended(baseline);
        knowledge.read(report.held, at, report.result === 'verified');
        if (report.stopped) recovery.look(report.held, isSimulated);
        editor.wrote(report.held);
      }
      const stays = report.result !== 'verified' || signal.aborted;
      const unkept = servoMoves.wanted(moveServos, [report]);
      this.current.value = { step: 'done', report, shown, at, stays, unkept };
    });
  }

  /** Asks whether to go on without a copy. */
  #agreed(): Promise<boolean> {
    return new Promise((resolve) => {
      this.current.value = { step: 'unkept', answer: resolve };
    });
  }

  /** Nothing was written, or nobody knows: says why. */
  #refused(error: unknown, lost: boolean): void {
    const session = this.#session;
    // Another job holds the wire: it can be tried again.
    if (error === null && !lost) return;
    if (!(error instanceof TimerError)) {
      this.current.value = null;
      if (!lost) session.notices.report(error);
    } else if (error.code === 'stale' && error.details.held && !lost) {
      session.editor.rebase(error.details.held);
      session.knowledge.read(error.details.held);
      this.#review('timer');
    } else if (error.code === 'aborted') {
      this.current.value = null;
      session.notices.say('nothing-written');
    } else if (error.code === 'port-lost' || error.code === 'closed') {
      this.current.value = null;
    } else {
      if (error.code === 'other-memory') session.nextFlight.doubt();
      this.current.value = { step: 'refused', error };
    }
  }
}
