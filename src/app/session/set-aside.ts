import { computed, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../browser/settings.js';
import type { AsideRecord, Keeper } from '../storage/index.js';

const SEEN = 'aside-seen';

/**
 * What was found in the storage and cannot be read: it is kept as it is, and the pilot is told of it until he has seen
 * it.
 */
export class SetAside {
  readonly #list = signal<readonly AsideRecord[]>([], { name: 'aside' });
  readonly list: ReadonlySignal<readonly AsideRecord[]> = this.#list;
  /** Whether there is something that the pilot has not been told of. */
  readonly isNew: ReadonlySignal<boolean> = computed(() => this.list.value.some(({ at }) => at > this.#seen.value));
  readonly #keeper: Keeper<AsideRecord>;
  readonly #seen = signal(loadSetting(SEEN, v.number()) ?? 0);

  constructor(keeper: Keeper<AsideRecord>) {
    this.#keeper = keeper;
  }

  /** Looks what has been set aside. To be called when everything else was read. */
  async load(): Promise<void> {
    const kept = await this.#keeper.all().catch(() => null);
    if (kept) this.#list.value = kept;
  }

  /** Whether the note of a write is among them: what a timer holds may not be known, and nobody could say so. */
  get hasWrite(): boolean {
    return this.list.value.some(({ shelf }) => shelf === 'unfinished');
  }

  /** All of them, as a file. */
  asText(): string {
    // What JSON cannot say is written as text: it is what may be wrong with it.
    const plain = (_: string, value: unknown): unknown =>
      (typeof value === 'number' && !Number.isFinite(value)) || typeof value === 'bigint' ? String(value) : value;
    return JSON.stringify(this.list.value, plain, 2);
  }

  dismiss(): void {
    this.#seen.value = Math.max(0, ...this.list.value.map(({ at }) => at));
    saveSetting(SEEN, this.#seen.value);
  }
}
