import { type ReadonlySignal, signal } from '@preact/signals';
import { attempt } from '../browser/services.js';
import type { Storage } from '../storage/index.js';
import type { Session } from '../work/session.js';

/** How that is emptied which the browser keeps outside of the page's storage. */
export type Erasers = Readonly<Record<'settings' | 'ports' | 'offline', () => Promise<void>>>;

/** `failed`: a part could not be deleted. */
export type EraseStep = 'review' | 'running' | 'failed';

/**
 * How long each part may take, in milliseconds. A slow and busy device needs time, and the pilot has asked for this and
 * waits. Only a part that hangs is given up.
 */
const ERASE_LIMIT = 30_000;

type EraseParts = Pick<Session, 'editor' | 'runner' | 'timer'>;

/** Deletes everything that this page keeps on this device, after one question. */
export class Erase {
  readonly current: ReadonlySignal<EraseStep | null>;
  readonly #current = signal<EraseStep | null>(null, { name: 'erase' });
  readonly #parts: EraseParts;
  readonly #storage: Storage;
  readonly #erasers: Erasers;
  readonly #reload: () => void;

  /** @param reload starts the page again. */
  constructor(parts: EraseParts, storage: Storage, erasers: Erasers, reload: () => void) {
    this.current = this.#current;
    this.#parts = parts;
    this.#storage = storage;
    this.#erasers = erasers;
    this.#reload = reload;
  }

  /** Asks the pilot first. */
  open(): void {
    this.#current.value = 'review';
  }

  dismiss(): void {
    if (this.#current.value !== 'running') this.#current.value = null;
  }

  /** Deletes everything and starts again. If a part could not be deleted, says so and stays. */
  async start(): Promise<void> {
    if (this.#current.value !== 'review') return;
    this.#current.value = 'running';
    // What a job leaves behind on a timer is the last thing to be forgotten.
    await this.#parts.runner.still();
    await this.#parts.timer.disconnect();
    // Nothing may be left that would be stored again.
    this.#parts.editor.clear();
    let isGone = true;
    for (const erase of [() => this.#storage.erase(), ...Object.values(this.#erasers)]) {
      await attempt(erase, ERASE_LIMIT).catch(() => {
        isGone = false;
      });
    }
    if (isGone) this.#reload();
    this.#current.value = isGone ? null : 'failed';
  }
}
