import { type ReadonlySignal, signal } from '@preact/signals';
import { TimerError, type TimerErrorCode, type TimerErrorDetails } from '../../client/index.js';
import type { ConnectionErrorCode, PortInfo } from '../../serial/index.js';

/** Messages that are not about errors. */
export type NoteCode =
  | 'back'
  | 'moved'
  | 'timer-moved'
  | 'kept'
  | 'other-kind'
  | 'write-completed'
  | 'nothing-written'
  | 'backed-up'
  | 'not-backed-up'
  | 'select-unanswered'
  | 'strays'
  | 'made-laid'
  | 'unexpected';

/** Those about changes on the screen. They end with the last change. */
export const ABOUT_CHANGES: ReadonlySet<string> = new Set<NoteCode>(['back', 'moved', 'made-laid']);

/** A message to the pilot, as a code. messages/ has the sentence. */
export type Notice =
  | {
      readonly kind: 'connection';
      readonly code: ConnectionErrorCode;
      readonly port: PortInfo | null;
      /** The bytes that came in place of an answer, where they tell something. */
      readonly bytes: Uint8Array | null;
    }
  | {
      readonly kind: 'timer';
      readonly code: TimerErrorCode;
      /** The facts, where they say more than the code. */
      readonly details?: TimerErrorDetails;
    }
  | { readonly kind: 'note'; readonly code: NoteCode };

/** The message to the pilot: one at a time, the latest. */
export class Notices {
  readonly #current = signal<Notice | null>(null, { name: 'notice' });
  readonly current: ReadonlySignal<Notice | null> = this.#current;
  readonly #onSilence: () => void;

  /** @param onSilence called when a timer no longer answers. The link then waits for it, and says so itself. */
  constructor(onSilence: () => void) {
    this.#onSilence = onSilence;
  }

  say(code: NoteCode): void {
    this.show({ kind: 'note', code });
  }

  /** Shows it, unless another message is there. */
  sayIfSilent(code: NoteCode): void {
    if (!this.#current.peek()) this.say(code);
  }

  show(notice: Notice): void {
    this.#current.value = notice;
  }

  /** Shows that something went wrong with the timer. Only here an error becomes a message. */
  report(error: unknown): void {
    if (!(error instanceof TimerError)) this.say('unexpected');
    else if (isRefusedSelection(error)) this.say('select-unanswered');
    else if (error.code === 'no-answer') this.#onSilence();
    else if (error.details.alike) this.show({ kind: 'timer', code: error.code, details: error.details });
    else if (error.code !== 'aborted' && error.code !== 'closed') this.show({ kind: 'timer', code: error.code });
  }

  /** Does something that clears the present message. Shows it again if that had no message of its own. */
  async keepThrough(work: () => Promise<unknown>): Promise<void> {
    const said = this.#current.peek();
    await work();
    if (said && !this.#current.peek()) this.show(said);
  }

  /** The pilot has read the message, or it is no longer true. */
  dismiss(): void {
    this.#current.value = null;
  }
}

/** The timer answers everything but SETMEMORY: waiting for it would not help. */
function isRefusedSelection({ code, details }: TimerError): boolean {
  return code === 'no-answer' && details.request === 'SETMEMORY' && details.answersOthers === true;
}
