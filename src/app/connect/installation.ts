import { type ReadonlySignal, signal } from '@preact/signals';

/** What a browser hands out that can install the page; it is not in the types of the DOM. */
interface InstallEvent extends Event {
  prompt(): Promise<unknown>;
}

/** The page as a program of this device: whether it works without a network, and whether it can be installed. */
export class Installation {
  readonly #ready = signal(false, { name: 'readyOffline' });
  readonly #install = signal<(() => void) | null>(null, { name: 'install' });
  /** Whether all of the page is kept for use without a network. */
  readonly ready: ReadonlySignal<boolean> = this.#ready;
  /** Lets the browser ask whether the page is to be installed; null where that is not offered, or was done. */
  readonly install: ReadonlySignal<(() => void) | null> = this.#install;

  readonly isKept = (): void => {
    this.#ready.value = true;
  };

  /** Listens for what the browser offers. */
  follow(window: Pick<EventTarget, 'addEventListener'>): void {
    window.addEventListener('beforeinstallprompt', (event) => {
      // It asks when the pilot says so, and not over the table.
      event.preventDefault();
      this.#install.value = () => {
        this.#install.value = null;
        void (event as InstallEvent).prompt().catch(() => {});
      };
    });
    window.addEventListener('appinstalled', () => {
      this.#install.value = null;
    });
  }
}
