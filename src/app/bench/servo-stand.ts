import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { Session } from '../session/session.js';

/** What an acknowledged movement has told. */
interface Stand {
  readonly connection: TimerConnection;
  /** What was worked on: the servos stand where this memory has them. */
  readonly key: string;
  readonly slot: number;
  /** All positions that the timer held then. */
  readonly positions: TimerProgram['positions'];
}

/**
 * Where the servos stand. The timer cannot be asked: it is known only from a movement that it has acknowledged on this
 * connection, as long as nothing went out since that could have moved them. Storing a position may be enough for that
 * (rows 15 and 17 of the protocol page), so it is known only while the timer holds all positions as it did then.
 */
export class ServoStand {
  /** 0 start to NF; null when it is not known. */
  readonly at: ReadonlySignal<number | null>;
  readonly #session: Session;
  readonly #last = signal<Stand | null>(null, { name: 'stand' });

  constructor(session: Session) {
    this.#session = session;
    this.at = computed(() => {
      const last = this.#last.value;
      const held = session.editor.baseline.value;
      if (!last || !held || session.nextFlight.open.value || session.connection.value !== last.connection) return null;
      const isSame = session.onScreen.workKey(held) === last.key && String(held.positions) === String(last.positions);
      return isSame ? last.slot : null;
    });
  }

  /** The timer has acknowledged that the servos moved to a slot, as it holds that now. */
  moved(connection: TimerConnection, slot: number): void {
    const held = this.#session.editor.baseline.peek();
    this.#last.value = held && {
      connection,
      key: this.#session.onScreen.workKey(held),
      slot,
      positions: held.positions,
    };
  }

  /** Something may have moved them, and it is not known where to. */
  lose(): void {
    this.#last.value = null;
  }
}
