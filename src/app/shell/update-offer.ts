import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { Session } from '../session/session.js';

/** A new version of the page, which waits until the pilot takes it, no port is open and what was typed is kept. */
export class UpdateOffer {
  readonly #take = signal<(() => void) | null>(null, { name: 'update' });
  /** Takes the new version; null while there is none, or once it was taken. */
  readonly take: ReadonlySignal<(() => void) | null> = this.#take;
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
  }

  readonly offer = (take: () => void): void => {
    this.#take.value = () => {
      this.#take.value = null;
      take();
    };
  };

  /** What a new version waits for once it was taken; null when it can begin. */
  readonly waitsFor: ReadonlySignal<'port' | 'edits' | null> = computed(() => {
    if (this.#session.link.state.value.status !== 'off') return 'port';
    return this.#session.keptWork.kept.value ? null : 'edits';
  });

  /**
   * Calls back once, as soon as no port is open or being opened and a reload would lose nothing that was typed: at once
   * if so.
   */
  readonly whenFree = (callback: () => void): void => {
    let waiting = true;
    effect(() => {
      if (this.waitsFor.value !== null || !waiting) return;
      waiting = false;
      queueMicrotask(callback);
    });
  };
}
