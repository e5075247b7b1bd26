import { batch, type ReadonlySignal, signal } from '@preact/signals';

/** Under what a program is chosen. */
export const SCREEN = 'screen';
export const settingKey = (id: string): string => `setting/${id}`;
export const backupKey = (key: string): string => `backup/${key}`;

/** Which two programs stand side by side: it outlasts its page. */
export class ComparedPair {
  readonly #first = signal<string | null>(null, { name: 'firstSide' });
  readonly #second = signal<string | null>(null, { name: 'secondSide' });
  readonly first: ReadonlySignal<string | null> = this.#first;
  readonly second: ReadonlySignal<string | null> = this.#second;

  /** By their keys; null: what is nearest. */
  show(first: string | null, second: string | null = null): void {
    batch(() => {
      this.#first.value = first;
      this.#second.value = second;
    });
  }
}
