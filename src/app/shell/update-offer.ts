import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { type News, newTo, type Release } from '../browser/update-news.js';
import { version as mine } from '../browser/version.js';
import type { Session } from '../session/session.js';
import { unsaved } from '../ui/unsaved.js';

/** What a new version waits for once it was taken. */
export type Hindrance = 'port' | 'edits' | 'open';

/**
 * A new version of the page, which waits until the pilot takes it, no port is open and a reload would lose nothing.
 */
export class UpdateOffer {
  readonly #take = signal<(() => void) | null>(null, { name: 'update' });
  readonly #news = signal<News | null>(null, { name: 'updateNews' });
  readonly #taken = signal(false, { name: 'updateTaken' });
  readonly #reading = signal(false, { name: 'updateRead' });
  /** Takes the new version; null while there is none, or once it was taken. */
  readonly take: ReadonlySignal<(() => void) | null> = this.#take;
  /** Whether the pilot has taken it, and it waits. */
  readonly taken: ReadonlySignal<boolean> = this.#taken;
  /** What the new version is called; null while it has not said so. */
  readonly version: ReadonlySignal<string | null> = computed(() => this.#news.value?.version ?? null);
  /** What is new in it. */
  readonly releases: ReadonlySignal<readonly Release[]> = computed(() =>
    this.#news.value ? newTo(mine, this.#news.value) : [],
  );
  /** Whether what is new in it is shown. */
  readonly reading: ReadonlySignal<boolean> = this.#reading;
  readonly #session: Session;
  #offered: (() => void) | null = null;

  constructor(session: Session) {
    this.#session = session;
  }

  readonly offer = (take: () => void, news: Promise<News | null> = Promise.resolve(null)): void => {
    this.#offered = take;
    batch(() => {
      this.#news.value = null;
      // Of one that was taken already the wish holds for whatever has replaced it.
      this.#take.value = this.#taken.peek() ? null : () => this.#begin();
    });
    void news.then((told) => {
      // What was in one that has been replaced is not told of any more.
      if (this.#offered === take) this.#news.value = told;
    });
  };

  /** Shows what is new in it, or no longer. */
  read(open: boolean): void {
    this.#reading.value = open;
  }

  /** What a new version waits for; null when it can begin. */
  readonly waitsFor: ReadonlySignal<Hindrance | null> = computed(() => {
    const { link, runner, keptWork, library } = this.#session;
    // On the way to a port from the first moment.
    if (runner.busy.value || link.state.value.status !== 'off') return 'port';
    if (!keptWork.kept.value || !library.kept.value) return 'edits';
    return unsaved.value ? 'open' : null;
  });

  /**
   * Calls back once, as soon as no port is open or being opened and a reload would lose nothing: at once if so.
   */
  readonly whenFree = (callback: () => void): void => {
    let isDone = false;
    const stop = effect(() => {
      if (this.waitsFor.value !== null || isDone) return;
      queueMicrotask(() => {
        // Something may have been opened in the same breath.
        if (isDone || this.waitsFor.peek() !== null) return;
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
      this.#reading.value = false;
    });
    take?.();
  }
}
