import { type ReadonlySignal, signal } from '@preact/signals';
import type { Draft } from '../storage/index.js';
import type { Drafts } from './drafts.js';

/** The pilot's work on this device: programs that were made here, and changes that are in no timer. */
export class KeptPrograms {
  readonly #list = signal<readonly Draft[]>([], { name: 'keptPrograms' });
  /** The latest first, as of the last look. */
  readonly list: ReadonlySignal<readonly Draft[]> = this.#list;
  readonly #drafts: Drafts;

  constructor(drafts: Drafts) {
    this.#drafts = drafts;
  }

  /** Looks up what is kept. Where the browser keeps nothing there is none. */
  async load(): Promise<void> {
    this.#list.value = await this.#drafts.available();
  }

  /** Deletes it for good. */
  async remove(draft: Draft): Promise<void> {
    this.#list.value = this.#list.value.filter(({ key }) => key !== draft.key);
    await this.#drafts.remove(draft);
  }
}
