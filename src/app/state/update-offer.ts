import { effect, signal } from '@preact/signals';
import type { Session } from './session.js';

/** A new version of the page, which waits until the pilot takes it and no port is open. */
export class UpdateOffer {
  /** Takes the new version; null while there is none, or once it was taken. */
  readonly take = signal<(() => void) | null>(null, { name: 'update' });
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
  }

  readonly offer = (take: () => void): void => {
    this.take.value = () => {
      this.take.value = null;
      take();
    };
  };

  /** Calls back once, as soon as no port is open or being opened: at once if none is. */
  readonly whenFree = (callback: () => void): void => {
    let waiting = true;
    effect(() => {
      if (!waiting || this.#session.link.state.value.status !== 'off') return;
      waiting = false;
      queueMicrotask(callback);
    });
  };
}
