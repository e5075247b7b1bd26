import { type ReadonlySignal, signal } from '@preact/signals';

/**
 * The pilot's word that it is safe: propeller off or model held, timer not armed.
 * The page asks once for each connection.
 */
export class Safety {
  readonly #confirmed = signal(false, { name: 'safe' });
  readonly confirmed: ReadonlySignal<boolean> = this.#confirmed;

  /** The pilot has said that it is safe. */
  confirm(): void {
    this.#confirmed.value = true;
  }

  /** It is no longer safe, or another timer was connected. */
  withdraw(): void {
    this.#confirmed.value = false;
  }
}
