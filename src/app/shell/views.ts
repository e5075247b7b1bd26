import { effect, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { tried } from '../browser/services.js';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** The views of the page, in the order in which they stand in the rail. */
export const VIEWS = ['program', 'memories', 'bench', 'library', 'line', 'settings'] as const;
/** Views that are reached from others, and have no place in the rail. */
const SIDE_VIEWS = ['print'] as const;
export type View = (typeof VIEWS | typeof SIDE_VIEWS)[number];

/** What a view is told of the window: its address, and when that changes. */
export type AddressWindow = Pick<Window, 'location' | 'history' | 'addEventListener' | 'removeEventListener'>;

/** Which view is shown. Its name stands in the address, so that Back works and a reload shows it again. */
export class Views {
  readonly #shown = signal<View>('program');
  readonly shown: ReadonlySignal<View> = this.#shown;
  readonly #expert = signal(loadSetting('expert', v.boolean()) ?? false);
  /** Whether the pilot wants to see what only few need: the line. */
  readonly expert: ReadonlySignal<boolean> = this.#expert;
  readonly #leaving = new Set<(view: View) => void>();

  show(view: View): void {
    if (view === this.#shown.peek()) return;
    for (const tell of this.#leaving) tell(this.#shown.peek());
    this.#shown.value = view;
  }

  setExpert(on: boolean): void {
    this.#expert.value = on;
    saveSetting('expert', on);
  }

  /**
   * Tells that a view is about to go, while it can still be looked at.
   * @returns a function that ends it.
   */
  onLeave(tell: (view: View) => void): () => void {
    this.#leaving.add(tell);
    return () => this.#leaving.delete(tell);
  }

  /**
   * Keeps the address of a window and the view together.
   * @returns a function that ends it.
   */
  follow(window: AddressWindow): () => void {
    const read = (): void => this.show(viewAt(window.location.hash) ?? 'program');
    read();
    // A browser would scroll before the view is there.
    tried(() => {
      window.history.scrollRestoration = 'manual';
    });
    const stop = effect(() => {
      const view = this.shown.value;
      if ((viewAt(window.location.hash) ?? 'program') !== view) window.history.pushState(null, '', `#${view}`);
    });
    window.addEventListener('popstate', read);
    window.addEventListener('hashchange', read);
    return () => {
      stop();
      window.removeEventListener('popstate', read);
      window.removeEventListener('hashchange', read);
    };
  }
}

/** The view that a hash names; null when it names none. */
export function viewAt(hash: string): View | null {
  return [...VIEWS, ...SIDE_VIEWS].find((view) => hash === `#${view}`) ?? null;
}
