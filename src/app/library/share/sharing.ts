import { type ReadonlySignal, signal } from '@preact/signals';
import { LINK_MARK, type SharedSetting } from '../../../program/index.js';

/** What is open of it; one at a time. */
export type SharingStep =
  /** A setting of this device is offered as a link and a QR code. */
  | { readonly step: 'offer'; readonly shared: SharedSetting }
  /** A link has come, perhaps a damaged one: what it holds is shown. */
  | { readonly step: 'received'; readonly link: string }
  /** A QR code is to be read, or a link pasted. */
  | { readonly step: 'read' };

/** What is used of the window. */
export type LinkWindow = Pick<Window, 'location' | 'history' | 'addEventListener' | 'removeEventListener'>;

/** Settings on their way to another device, and from one: all that is needed before any of that is shown. */
export class Sharing {
  readonly #current = signal<SharingStep | null>(null);
  readonly current: ReadonlySignal<SharingStep | null> = this.#current;
  #putBack: (() => void) | null = null;

  /** Offers a setting as a link and a QR code. */
  offer(shared: SharedSetting): void {
    this.#current.value = { step: 'offer', shared };
  }

  /** Shows what a link holds. */
  take(link: string): void {
    this.#current.value = { step: 'received', link };
  }

  /** Asks for a QR code or a link. */
  read(): void {
    this.#current.value = { step: 'read' };
  }

  close(): void {
    this.#putBack?.();
    this.#putBack = null;
    this.#current.value = null;
  }

  /**
   * Takes links out of the address of a window, also while the page is open. The address stays until the pilot has
   * answered: a reload before that asks again, one after it does not.
   * @param address the address that the page has without it, from `#`.
   * @returns a function that ends it.
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

/** Whether a fragment of an address is a setting, and no view. */
export function isLink(hash: string): boolean {
  return hash.startsWith(LINK_MARK);
}
