import { type ReadonlySignal, signal } from '@preact/signals';
import { TimerError, type TimerErrorCode } from '../../client/index.js';
import type { ConnectionErrorCode, PortInfo } from '../../serial/index.js';

/** What there is to say beside errors. */
export type NoteCode =
  | 'edits-restored'
  | 'edits-kept'
  | 'edits-moved'
  | 'edits-set-aside'
  | 'back-same'
  | 'back-changed'
  | 'other-kind'
  | 'write-completed'
  | 'nothing-written'
  | 'select-unanswered'
  | 'strays'
  | 'taken-over'
  | 'made-restored'
  | 'made-laid'
  | 'made-put-away'
  | 'not-kept'
  | 'unexpected';

/** Something to say to the pilot, by code: the sentence stands in messages/. */
export type Notice =
  | {
      readonly kind: 'connection';
      readonly code: ConnectionErrorCode;
      readonly port: PortInfo | null;
      /** See `portKey`; null when no port is meant. */
      readonly portKey: string | null;
      /** What came in place of an answer, where that tells something. */
      readonly bytes: Uint8Array | null;
    }
  | { readonly kind: 'timer'; readonly code: TimerErrorCode }
  | { readonly kind: 'note'; readonly code: NoteCode };

/** What the pilot is told: one thing at a time, the latest. */
export class Notices {
  readonly #current = signal<Notice | null>(null, { name: 'notice' });
  readonly current: ReadonlySignal<Notice | null> = this.#current;
  readonly #onSilence: () => void;

  /** @param onSilence called when a timer no longer answers: it is waited for, and who waits says so. */
  constructor(onSilence: () => void) {
    this.#onSilence = onSilence;
  }

  say(code: NoteCode): void {
    this.show({ kind: 'note', code });
  }

  /** Says it, unless there is something else to read. */
  sayIfSilent(code: NoteCode): void {
    if (!this.#current.peek()) this.say(code);
  }

  show(notice: Notice): void {
    this.#current.value = notice;
  }

  /**
   * Says that something went wrong on the wire, in the pilot's words: the one place where an error becomes a notice.
   */
  report(error: unknown): void {
    if (!(error instanceof TimerError)) this.say('unexpected');
    else if (isRefusedSelection(error)) this.say('select-unanswered');
    else if (error.code === 'no-answer') this.#onSilence();
    else if (error.code !== 'aborted' && error.code !== 'closed') this.show({ kind: 'timer', code: error.code });
  }

  /** Does something that takes back what was said before; it is said again where that had nothing to say itself. */
  async keepThrough(work: () => Promise<unknown>): Promise<void> {
    const said = this.#current.peek();
    await work();
    if (said && !this.#current.peek()) this.show(said);
  }

  /** It has been read, or holds no longer. */
  dismiss(): void {
    this.#current.value = null;
  }
}

/** A timer that answers all else and not SETMEMORY: waiting for it would not help. */
function isRefusedSelection({ code, details }: TimerError): boolean {
  return code === 'no-answer' && details.request === 'SETMEMORY' && details.answersOthers === true;
}
