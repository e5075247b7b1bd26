import type { TimerProgram } from '../../program/index.js';
import { replaceAll } from '../editing/edit.js';
import type { Session } from '../session/session.js';
import type { WriteFlow } from './write-flow.js';

/** What the pilot can do after an interrupted write. Each way shows the difference first, like any other write. */
export class FinishWrite {
  readonly #session: Session;
  readonly #write: WriteFlow;

  constructor(session: Session, write: WriteFlow) {
    this.#session = session;
    this.#write = write;
  }

  /** Writes the values that are still missing. */
  finish(): Promise<void> {
    return this.#toward('goal');
  }

  /** Puts back the values from before. */
  goBack(): Promise<void> {
    return this.#toward('before');
  }

  /** Shows the goal as edits and forgets the interrupted write. */
  async show(): Promise<void> {
    const goal = this.#program('goal');
    if (!goal) return;
    this.#session.editor.apply(replaceAll({ code: 'finish-write', params: {} }, goal));
    await this.#session.recovery.settle();
  }

  async #toward(end: 'goal' | 'before'): Promise<void> {
    const program = this.#program(end);
    if (!program) return;
    this.#session.editor.apply(replaceAll({ code: 'restore', params: {} }, program));
    await this.#write.open();
  }

  /** An unknown idle throttle stays as the timer holds it. */
  #program(end: 'goal' | 'before'): TimerProgram | null {
    const offer = this.#session.recovery.offer.value;
    const { baseline } = this.#session.editor;
    if (offer?.kind !== 'write' || !baseline.value) return null;
    const program = offer.record[end];
    const { times, positions, idleThrottle } = program;
    return { ...baseline.value, times, positions, idleThrottle: idleThrottle ?? baseline.value.idleThrottle };
  }
}
