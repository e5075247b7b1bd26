import { type ReadonlySignal, signal } from '@preact/signals';
import type { Session } from '../session/session.js';
import { SHELVES, type Storage, withinLimit } from '../storage/index.js';

/** What the browser keeps outside of the page's storage. */
type KeptOutside = 'settings' | 'ports' | 'offline';

/** How each of these is emptied. */
export type Erasers = Readonly<Record<KeptOutside, () => Promise<void>>>;

/** How many records of each kind are kept; null where the browser does not say. */
export type KeptCounts = Readonly<Record<(typeof SHELVES)[number], number | null>>;

export type EraseStep =
  | { readonly step: 'review'; readonly counts: KeptCounts }
  | { readonly step: 'running' }
  /** Parts that could not be deleted. */
  | { readonly step: 'failed'; readonly left: readonly (KeptOutside | 'storage')[] };

/**
 * How long each part may take, in milliseconds. A slow and busy device needs time, and the pilot has asked for this and
 * waits. Only a part that hangs is given up.
 */
const ERASE_LIMIT = 30_000;

/** Deletes everything that this page keeps on this device, after one question. */
export class Erase {
  readonly current: ReadonlySignal<EraseStep | null>;
  readonly #current = signal<EraseStep | null>(null, { name: 'erase' });
  readonly #session: Session;
  readonly #storage: Storage;
  readonly #erasers: Erasers;
  readonly #reload: () => void;

  /** @param reload starts the page again. */
  constructor(session: Session, storage: Storage, erasers: Erasers, reload: () => void) {
    this.current = this.#current;
    this.#session = session;
    this.#storage = storage;
    this.#erasers = erasers;
    this.#reload = reload;
  }

  /** Shows what would be deleted. */
  async open(): Promise<void> {
    const counted = SHELVES.map(async (shelf) => {
      const records = await this.#storage[shelf].all().catch(() => null);
      return [shelf, records?.length ?? null] as const;
    });
    const counts = Object.fromEntries(await Promise.all(counted)) as KeptCounts;
    this.#current.value = { step: 'review', counts };
  }

  dismiss(): void {
    if (this.#current.value?.step !== 'running') this.#current.value = null;
  }

  /** Deletes everything and starts again. If a part could not be deleted, says so and stays. */
  async start(): Promise<void> {
    if (this.#current.value?.step !== 'review') return;
    this.#current.value = { step: 'running' };
    // What a job leaves behind on a timer is the last thing to be forgotten.
    await this.#session.runner.still();
    await this.#session.timer.disconnect();
    // Nothing may be left that would be stored again.
    this.#session.editor.clear();
    const left: (KeptOutside | 'storage')[] = [];
    const jobs = [
      ['storage', () => this.#storage.erase()] as const,
      ...(Object.entries(this.#erasers) as [KeptOutside, () => Promise<void>][]),
    ];
    for (const [place, erase] of jobs) await withinLimit(erase, ERASE_LIMIT).catch(() => left.push(place));
    if (left.length === 0) this.#reload();
    this.#current.value = left.length === 0 ? null : { step: 'failed', left };
  }
}
