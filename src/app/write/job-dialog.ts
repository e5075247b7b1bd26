import { batch, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { TimerConnection } from '../../serial/index.js';
import type { Session } from '../session/session.js';

/** What a dialog shows. While it is `running`, how far its job has come is told by the runner: see `Job`. */
interface AnyStep {
  readonly step: string;
}

/**
 * The dialog of a job that changes a timer: it shows what is about to be done, runs that, and says what became of it.
 * While it is open nothing else is sent to the timer.
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
      // What was shown was of the timer on that connection; the notice says why it is gone.
      if (bound && bound !== connection) this.show(null);
    });
  }

  /** Whether the dialog has to stay open whatever key is pressed. */
  get held(): boolean {
    const { value } = this.#current;
    if (value?.step === 'running') return !this.#session.runner.job.value?.asking;
    return value !== null && this.stays(value);
  }

  /** Escape was pressed: leaves the dialog where it may be left; while a job is at work, asks it to stop. */
  escape(): void {
    if (this.#current.value?.step === 'running' || !this.held) this.dismiss();
  }

  /** Leaves the dialog; while a job is at work, asks it to stop instead. */
  dismiss(): void {
    if (this.#current.value?.step === 'running') void this.#session.runner.stop();
    else this.show(null);
  }

  /** The connection to which a step is bound; null when it is to none. */
  protected abstract connectionOf(step: Step): TimerConnection | null;

  /** Whether a step has to be seen: only its button closes it, not an Escape meant for something else. */
  protected abstract stays(step: Step): boolean;

  /** Shows a step, or closes the dialog. */
  protected show(step: Step | null): void {
    batch(() => {
      this.#current.value = step;
      this.#session.runner.claim(this, step !== null);
    });
  }
}
