import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { unsaved } from '../ui/unsaved.js';
import type { Session } from '../work/session.js';

type OfferParts = Pick<Session, 'drafts' | 'library' | 'link' | 'runner'>;

/** A new version of the page. It waits until the pilot accepts it, no port is open, and a reload would lose nothing. */
export class UpdateOffer {
  readonly #take = signal<(() => void) | null>(null, { name: 'update' });
  readonly #taken = signal(false, { name: 'updateTaken' });
  /** Accepts the new version; null when there is none, or it was accepted already. */
  readonly take: ReadonlySignal<(() => void) | null> = this.#take;
  /** Whether the pilot has accepted it and it waits. */
  readonly taken: ReadonlySignal<boolean> = this.#taken;
  readonly #parts: OfferParts;
  #offered: (() => void) | null = null;

  constructor(parts: OfferParts) {
    this.#parts = parts;
  }

  readonly offer = (take: () => void): void => {
    this.#offered = take;
    // If one version was accepted already, that also holds for the version that replaces it.
    this.#take.value = this.#taken.peek() ? null : () => this.#begin();
  };

  /** Whether it can start: no port is open or being looked for, and a reload would lose nothing. */
  readonly free: ReadonlySignal<boolean> = computed(() => {
    const { link, runner, drafts, library } = this.#parts;
    if (runner.busy.value || link.state.value.status !== 'off') return false;
    return drafts.kept.value && library.kept.value && !unsaved.value;
  });

  /** Calls back once, as soon as no port is open or being opened and a reload would lose nothing: at once if so. */
  readonly whenFree = (callback: () => void): void => {
    let isDone = false;
    const stop = effect(() => {
      if (!this.free.value || isDone) return;
      queueMicrotask(() => {
        // Something may have been opened at the same moment.
        if (isDone || !this.free.peek()) return;
        isDone = true;
        stop();
        callback();
      });
    });
  };

  #begin(): void {
    const take = this.#offered;
    batch(() => {
      this.#take.value = null;
      this.#taken.value = true;
    });
    take?.();
  }
}
