import { computed, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../browser/settings.js';
import type { AsideRecord, Keeper } from '../storage/index.js';

const SEEN = 'aside-seen';

/** Stored data that cannot be read. It is kept as it is, and shown to the pilot until he has seen it. */
export class SetAside {
  readonly #list = signal<readonly AsideRecord[]>([], { name: 'aside' });
  readonly list: ReadonlySignal<readonly AsideRecord[]> = this.#list;
  /** Whether there is something that the pilot has not seen. */
  readonly isNew: ReadonlySignal<boolean> = computed(() =>
    this.list.value.some(({ at }) => !this.#seen.value.includes(at)),
  );
  readonly #keeper: Keeper<AsideRecord>;
  /** When those that he has seen were set aside. The clock may have been wrong: a later time need not be newer. */
  readonly #seen = signal<readonly number[]>(loadSetting(SEEN, v.array(v.number())) ?? []);

  constructor(keeper: Keeper<AsideRecord>) {
    this.#keeper = keeper;
  }

  /** Looks up what was set aside. Call it after everything else was read. */
  async load(): Promise<void> {
    const kept = await this.#keeper.all().catch(() => null);
    if (kept) this.#list.value = kept;
  }

  /** Whether a record of a write is among them: then a timer's content may be uncertain without any other sign. */
  get hasWrite(): boolean {
    return this.list.value.some(({ shelf }) => shelf === 'unfinished');
  }

  /** All of them, as the text of a file. */
  asText(): string {
    // Values that JSON does not have are written as text: they may be what is wrong.
    const plain = (_: string, value: unknown): unknown =>
      (typeof value === 'number' && !Number.isFinite(value)) || typeof value === 'bigint' ? String(value) : value;
    return JSON.stringify(this.list.value, plain, 2);
  }

  dismiss(): void {
    this.#seen.value = [...new Set(this.list.value.map(({ at }) => at))];
    saveSetting(SEEN, this.#seen.value);
  }
}
