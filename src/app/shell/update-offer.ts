import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { unsaved } from '../ui/unsaved.js';
import type { Session } from '../work/session.js';

type OfferParts = Pick<Session, 'drafts' | 'library' | 'link' | 'runner'>;

/** A new version of the page. It waits until the pilot accepts it, no port is open, and a reload would lose nothing. */
export class UpdateOffer {
  readonly #offered = signal<(() => void) | null>(null, { name: 'update' });
  readonly #taken = signal(false, { name: 'updateTaken' });
  /** Accepts the new version; null when there is none, or one was accepted already: then this one follows it. */
  readonly take: ReadonlySignal<(() => void) | null> = computed(() => {
    const { value: offered } = this.#offered;
    if (!offered || this.#taken.value) return null;
    return () => {
      this.#taken.value = true;
      offered();
    };
  });
  /** Whether the pilot has accepted it and it waits. */
  readonly taken: ReadonlySignal<boolean> = this.#taken;
  readonly #parts: OfferParts;

  constructor(parts: OfferParts) {
    this.#parts = parts;
  }

  readonly offer = (take: () => void): void => {
    this.#offered.value = take;
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
}
