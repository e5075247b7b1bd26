import { type ReadonlySignal, signal } from '@preact/signals';

/** Stands for the program on the screen among the keys of settings: no key has a space. */
export const ON_SCREEN = 'on screen';

/** Which settings are to be printed. All that the other views need to know of printing. */
export class PrintOrder {
  readonly #keys = signal<readonly string[]>([ON_SCREEN]);
  /** The keys of the settings, in their order; {@link ON_SCREEN} among them. */
  readonly keys: ReadonlySignal<readonly string[]> = this.#keys;

  /** These settings, by their keys, and nothing else; without any the program on the screen. */
  choose(keys: readonly string[] = [ON_SCREEN]): void {
    this.#keys.value = [...new Set(keys)];
  }

  /** Puts one on the print, or takes it off. */
  toggle(key: string): void {
    const keys = this.#keys.peek();
    this.#keys.value = keys.includes(key) ? keys.filter((each) => each !== key) : [...keys, key];
  }
}
