import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { type Progress, TimerError, type WriteReport } from '../../client/index.js';
import type { Finding } from '../../program/index.js';
import type { Session } from './session.js';

/** The steps of a write, from the difference to the result. */
export type WriteStep =
  | { readonly step: 'review' }
  | {
      readonly step: 'running';
      readonly progress: Progress | null;
      readonly stop: AbortController;
      /** The pilot has asked to stop; the request under way comes to its end. */
      readonly stopping: boolean;
    }
  | {
      readonly step: 'done';
      readonly report: WriteReport;
      /** What became of the write has to be seen: only its button closes it, not an Escape meant for something else. */
      readonly stays: boolean;
      /** Positions were not kept, perhaps because the servos did not move. */
      readonly unkept: boolean;
    }
  | { readonly step: 'refused'; readonly error: TimerError };

/** Shows the difference, writes it, and says what became of it. */
export class WriteFlow {
  readonly current = signal<WriteStep | null>(null, { name: 'write' });
  /** The pilot has read the serious findings. */
  readonly acknowledged = signal(false, { name: 'acknowledged' });
  readonly serious: ReadonlySignal<readonly Finding[]> = computed(() =>
    this.#session.editor.findings.value.filter(({ severity }) => severity === 'serious'),
  );
  /** Whether the write may begin. */
  readonly ready: ReadonlySignal<boolean> = computed(
    () => this.#session.safe.value && (this.serious.value.length === 0 || this.acknowledged.value),
  );
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
    effect(() => {
      // Without a wire there is nothing to write to; the notice says why.
      if (!session.connection.value && this.current.peek()?.step === 'review') this.current.value = null;
    });
  }

  /** Reads the timer afresh and shows the difference: what is written is told apart from what the timer holds now. */
  async open(): Promise<void> {
    const { editor } = this.#session;
    const memory = editor.working.value?.memory;
    if (editor.blocked.value || !(await this.#session.read()) || editor.blocked.value) return;
    // Another memory is current by now: the edits were set aside, and the pilot is told so.
    if (editor.working.value?.memory !== memory) return;
    batch(() => {
      this.acknowledged.value = false;
      this.#session.servoMoves.ask();
      this.current.value = { step: 'review' };
    });
  }

  async start(): Promise<void> {
    const { editor, connection } = this.#session;
    const baseline = editor.baseline.value;
    const working = editor.working.value;
    if (this.current.value?.step !== 'review' || !this.ready.value) return;
    if (!connection.value || !baseline || !working) return;
    const stop = new AbortController();
    const running = (progress: Progress | null): void => {
      this.current.value = { step: 'running', progress, stop, stopping: stop.signal.aborted };
    };
    running(null);
    const { knowledge, recovery, simulated, servoMoves, link } = this.#session;
    const isSimulated = simulated.value;
    // The goal and a backup are kept before the first byte: whatever happens, what the timer holds can be explained.
    const kept = editor.changes.value.length === 0 || (await recovery.begin(baseline, working, isSimulated));
    if (!kept) this.#session.say('not-kept');
    try {
      const moveServos = servoMoves.take();
      const options = { baseline, moveServos, signal: stop.signal, onProgress: running };
      const report = await connection.value.client.writeProgram(working, options);
      // What was read back to its end needs no finding out at the next meeting.
      batch(() => {
        if (report.held) {
          if (!report.stopped) void knowledge.ended(baseline);
          knowledge.read(report.held, Date.now(), report.result === 'verified');
          if (report.stopped) recovery.look(report.held, isSimulated);
        }
        if (report.held) editor.wrote(report.held);
        const stays = report.result !== 'verified' || stop.signal.aborted;
        this.current.value = { step: 'done', report, stays, unkept: servoMoves.wanted(moveServos, [report]) };
      });
      if (report.stopped?.code === 'no-answer') this.#session.report(report.stopped);
    } catch (error) {
      // Nothing has been written yet.
      await knowledge.ended(baseline);
      if (error instanceof TimerError && error.code !== 'port-lost' && error.code !== 'aborted') {
        this.current.value = { step: 'refused', error };
        return;
      }
      this.current.value = null;
      if (!(error instanceof TimerError)) this.#session.report(error);
      else if (error.code === 'aborted') this.#session.say('nothing-written');
    } finally {
      knowledge.jobOver();
      void link.learn();
    }
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
      value.stop.abort();
      this.current.value = { ...value, stopping: true };
    } else {
      this.current.value = null;
    }
  }
}
