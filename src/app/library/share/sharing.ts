import { type ReadonlySignal, signal } from '@preact/signals';
import type { SharedSetting } from '../../../program/index.js';

/** What is open: one thing at a time. */
export type SharingStep =
  /** A setting of this device is offered as a link and a QR code. */
  | { readonly step: 'offer'; readonly shared: SharedSetting }
  /** A link has come in, perhaps damaged. Its setting is shown. */
  | { readonly step: 'received'; readonly link: string }
  /** The pilot pastes a link. */
  | { readonly step: 'paste' };

/** The part of the window that is used. */
export type LinkWindow = Pick<Window, 'location' | 'history' | 'addEventListener' | 'removeEventListener'>;

/** The state of sharing: everything that is needed before its dialogs are loaded. */
export class Sharing {
  readonly #current = signal<SharingStep | null>(null);
  readonly current: ReadonlySignal<SharingStep | null> = this.#current;
  #putBack: (() => void) | null = null;

  /** Offers a setting as a link and a QR code. */
  offer(shared: SharedSetting): void {
    this.#current.value = { step: 'offer', shared };
  }

  /** Shows the setting in a link. */
  take(link: string): void {
    this.#current.value = { step: 'received', link };
  }

  /** Asks for a link. */
  paste(): void {
    this.#current.value = { step: 'paste' };
  }

  close(): void {
    this.#putBack?.();
    this.#current.value = null;
  }

  /**
   * Takes links from the address of a window, also later while the page is open. The address stays until the pilot has
   * answered: a reload before that asks again, a reload after it does not.
   * @param address gives the address of the page without the link, from `#`.
   * @returns a function that ends this.
   */
  follow(window: LinkWindow, address: () => string): () => void {
    const read = (): void => {
      const { hash } = window.location;
      if (!isLink(hash)) return;
      this.#putBack = () => {
        if (isLink(window.location.hash)) window.history.replaceState(null, '', address());
      };
      this.take(hash);
    };
    read();
    window.addEventListener('hashchange', read);
    return () => window.removeEventListener('hashchange', read);
  }
}

/** LINK_MARK, also as programs change it that pass links on. */
const MARK = /(?:#|%23)s(?:=|%3D)/i;

/** Whether the fragment of an address is a setting, and not a view. */
export function isLink(hash: string): boolean {
  return hash.search(MARK) === 0;
}

/** Whether there is a link to a setting in a text. */
export function holdsLink(text: string): boolean {
  return MARK.test(text);
}
