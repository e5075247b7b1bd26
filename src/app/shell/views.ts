import { batch, effect, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { takeBack } from '../browser/back-key.js';
import { tried } from '../browser/services.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import { isLink } from '../library/share/sharing.js';

/** The views of the page, in the order of the rail. */
export const VIEWS = ['program', 'memories', 'bench', 'library', 'line', 'settings'] as const;
/** Views that other views open, without a place in the rail. */
const SIDE_VIEWS = ['print', 'help'] as const;
export type View = (typeof VIEWS | typeof SIDE_VIEWS)[number];

/** The part of the window that is used: its address, and when that changes. */
export type AddressWindow = Pick<Window, 'location' | 'history' | 'addEventListener' | 'removeEventListener'>;

/** A view, and a place in it: `#library/flights`. */
interface Address {
  readonly view: View;
  /** The text after the name of the view: empty, or words with `/` between them. */
  readonly path: string;
}

/** The most characters that a place in a view has. */
const LONGEST_PATH = 300;

/** Marks the entries of the history where the pilot has been: only Back and Forward lead to one of them again. */
const SEEN = 'seen';

/** Which view is shown. Its name stands in the address, so that Back works and a reload shows it again. */
export class Views {
  readonly #shown = signal<View>('program');
  readonly shown: ReadonlySignal<View> = this.#shown;
  readonly #path = signal('');
  /** The place in the shown view. Empty: its beginning. */
  readonly path: ReadonlySignal<string> = this.#path;
  readonly #expert = signal(loadSetting('expert', v.boolean()) ?? false);
  /** Whether the pilot wants to see the line, which few need. */
  readonly expert: ReadonlySignal<boolean> = this.#expert;
  readonly #leaving = new Set<(view: View) => void>();

  /** @param path the place in it. */
  show(view: View, path = ''): void {
    if (view !== this.#shown.peek()) for (const tell of this.#leaving) tell(this.#shown.peek());
    batch(() => {
      this.#shown.value = view;
      this.#path.value = path;
    });
  }

  /** The present address, from `#`. */
  get address(): string {
    return hashOf({ view: this.#shown.peek(), path: this.#path.peek() });
  }

  setExpert(on: boolean): void {
    this.#expert.value = on;
    saveSetting('expert', on);
  }

  /**
   * Calls `tell` when a view is about to go, while it is still there.
   * @returns a function that ends this.
   */
  onLeave(tell: (view: View) => void): () => void {
    this.#leaving.add(tell);
    return () => this.#leaving.delete(tell);
  }

  /**
   * Keeps the address of a window and the view the same.
   * @returns a function that ends this.
   */
  follow(window: AddressWindow): () => void {
    const read = (): void => {
      // A setting in the address is shown over the present view.
      if (isLink(window.location.hash)) return;
      const { view, path } = addressAt(window.location.hash) ?? PROGRAM;
      const isNew = window.history.state !== SEEN;
      if (isNew) tried(() => window.history.replaceState(SEEN, ''));
      // The present address comes again behind the one that the browser went back to: the next Back leads there.
      if (!isNew && hashOf({ view, path }) !== this.address && takeBack()) write(this.address);
      else this.show(view, path);
    };
    const write = (hash: string): void => {
      const now = addressAt(window.location.hash) ?? PROGRAM;
      if (hashOf(now) !== hash) window.history.pushState(SEEN, '', hash);
    };
    read();
    // A browser would scroll before the view is there.
    tried(() => {
      window.history.scrollRestoration = 'manual';
    });
    const stop = effect(() => write(hashOf({ view: this.shown.value, path: this.path.value })));
    window.addEventListener('popstate', read);
    window.addEventListener('hashchange', read);
    return () => {
      stop();
      window.removeEventListener('popstate', read);
      window.removeEventListener('hashchange', read);
    };
  }
}

const PROGRAM: Address = { view: 'program', path: '' };

/** The view that a hash names, and the place in it; null when it names none. */
export function addressAt(hash: string): Address | null {
  const [, name, path = ''] = /^#([a-z]+)(?:\/([\w/-]*))?$/.exec(hash) ?? [];
  const view = [...VIEWS, ...SIDE_VIEWS].find((each) => each === name);
  return view && path.length <= LONGEST_PATH ? { view, path } : null;
}

function hashOf({ view, path }: Address): string {
  return path === '' ? `#${view}` : `#${view}/${path}`;
}
