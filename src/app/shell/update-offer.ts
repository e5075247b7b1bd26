import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { type News, newTo, type Release } from '../browser/update-news.js';
import { version as mine } from '../browser/version.js';
import type { Session } from '../session/session.js';
import { unsaved } from '../ui/unsaved.js';

/** What an accepted new version waits for. */
export type Hindrance = 'port' | 'edits' | 'open';

/** A new version of the page. It waits until the pilot accepts it, no port is open, and a reload would lose nothing. */
export class UpdateOffer {
  readonly #take = signal<(() => void) | null>(null, { name: 'update' });
  readonly #news = signal<News | null>(null, { name: 'updateNews' });
  readonly #taken = signal(false, { name: 'updateTaken' });
  readonly #reading = signal(false, { name: 'updateRead' });
  /** Accepts the new version; null when there is none, or it was accepted already. */
  readonly take: ReadonlySignal<(() => void) | null> = this.#take;
  /** Whether the pilot has accepted it and it waits. */
  readonly taken: ReadonlySignal<boolean> = this.#taken;
  /** Its version number; null until it has told it. */
  readonly version: ReadonlySignal<string | null> = computed(() => this.#news.value?.version ?? null);
  /** What is new in it. */
  readonly releases: ReadonlySignal<readonly Release[]> = computed(() =>
    this.#news.value ? newTo(mine, this.#news.value) : [],
  );
  /** Whether the list of what is new is open. */
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
      // If one version was accepted already, that also holds for the version that replaces it.
      this.#take.value = this.#taken.peek() ? null : () => this.#begin();
    });
    void news.then((told) => {
      // What was new in a replaced version is no longer shown.
      if (this.#offered === take) this.#news.value = told;
    });
  };

  /** Opens or closes the list of what is new. */
  read(open: boolean): void {
    this.#reading.value = open;
  }

  /** What a new version waits for; null when it can start. */
  readonly waitsFor: ReadonlySignal<Hindrance | null> = computed(() => {
    const { link, runner, keptWork, library } = this.#session;
    // Already while the connection is being looked for.
    if (runner.busy.value || link.state.value.status !== 'off') return 'port';
    if (!keptWork.kept.value || !library.kept.value) return 'edits';
    return unsaved.value ? 'open' : null;
  });

  /** Calls back once, as soon as no port is open or being opened and a reload would lose nothing: at once if so. */
  readonly whenFree = (callback: () => void): void => {
    let isDone = false;
    const stop = effect(() => {
      if (this.waitsFor.value !== null || isDone) return;
      queueMicrotask(() => {
        // Something may have been opened at the same moment.
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
