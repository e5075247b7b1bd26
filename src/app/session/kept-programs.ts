import { type ReadonlySignal, signal } from '@preact/signals';
import type { Draft } from '../storage/index.js';
import type { Drafts } from './drafts.js';

/** What a pilot has worked on and this device keeps: programs that were made here, and changes that no timer has. */
export class KeptPrograms {
  readonly #list = signal<readonly Draft[]>([], { name: 'keptPrograms' });
  /** The latest first, as it was when it was looked for last. */
  readonly list: ReadonlySignal<readonly Draft[]> = this.#list;
  readonly #drafts: Drafts;

  constructor(drafts: Drafts) {
    this.#drafts = drafts;
  }

  /** Looks what is kept. A browser that keeps nothing has none. */
  async load(): Promise<void> {
    this.#list.value = await this.#drafts.available();
  }

  /** It comes to the screen. */
  take(draft: Draft): Draft {
    return this.#drafts.take(draft);
  }

  /** Deletes it for good. */
  async remove(draft: Draft): Promise<void> {
    this.#list.value = this.#list.value.filter(({ key }) => key !== draft.key);
    await this.#drafts.remove(draft);
  }
}
