import { batch, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { TimerConnection } from '../../serial/index.js';
import type { Session } from '../session/session.js';

/** A step of a dialog. While it is `running`, the runner reports the progress of its job: see `Job`. */
interface AnyStep {
  readonly step: string;
}

/**
 * The dialog of a job that changes a timer: shows the plan, runs it, and shows the result. While it is open, nothing
 * else is sent to the timer.
 */
export abstract class JobDialog<Step extends AnyStep> {
  readonly #current = signal<Step | null>(null, { name: 'dialog' });
  /** Null while it is closed. */
  readonly current: ReadonlySignal<Step | null> = this.#current;
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
    effect(() => {
      const connection = session.connection.value;
      const shown = this.#current.peek();
      const bound = shown && this.connectionOf(shown);
      // The shown step was for the timer on that connection. The notice says why it is gone.
      if (bound && bound !== connection) this.show(null);
    });
  }

  /** Whether the dialog has to stay open, whatever key is pressed. */
  get held(): boolean {
    const { value } = this.#current;
    if (value?.step === 'running') return !this.#session.runner.job.value?.asking;
    return value !== null && this.stays(value);
  }

  /** Closes the dialog. During a job, asks the job to stop instead. */
  dismiss(): void {
    if (this.#current.value?.step === 'running') void this.#session.runner.stop();
    else this.show(null);
  }

  /** The connection to which a step belongs; null for none. */
  protected abstract connectionOf(step: Step): TimerConnection | null;

  /**
   * Whether only the button of a step closes it, because the pilot has to see it:
   * an Escape may be meant for something else.
   */
  protected abstract stays(step: Step): boolean;

  /** Shows a step, or closes the dialog. */
  protected show(step: Step | null): void {
    batch(() => {
      this.#current.value = step;
      this.#session.runner.claim(this, step !== null);
    });
  }
}
