import { signal } from '@preact/signals';

/** The event with which a browser offers to install the page. The types of the DOM do not have it. */
interface InstallEvent extends Event {
  prompt(): Promise<unknown>;
}

/** The page as an app of this device: whether it works without a network, and how to install it. */
export class Installation {
  // Only this model writes these.
  /** Whether the whole page is kept for use without a network. */
  readonly ready = signal(false, { name: 'readyOffline' });
  /** Lets the browser ask whether to install the page; null where it does not offer that, or the page is installed. */
  readonly install = signal<(() => void) | null>(null, { name: 'install' });

  readonly isKept = (): void => {
    this.ready.value = true;
  };

  /** Listens for what the browser offers. */
  follow(window: Pick<EventTarget, 'addEventListener'>): void {
    window.addEventListener('beforeinstallprompt', (event) => {
      // The browser must ask only when the pilot wants it, not over the table.
      event.preventDefault();
      this.install.value = () => {
        this.install.value = null;
        void (event as InstallEvent).prompt().catch(() => {});
      };
    });
    window.addEventListener('appinstalled', () => {
      this.install.value = null;
    });
  }
}
