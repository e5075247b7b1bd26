import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { Session } from '../work/session.js';

/** What an acknowledged movement has shown. */
interface Stand {
  readonly connection: TimerConnection;
  /** The work that the movement belongs to: the servos stand at the positions of this memory. */
  readonly key: string;
  readonly slot: number;
  /** All positions that the timer held at that time. */
  readonly positions: TimerProgram['positions'];
}

/**
 * Where the servos stand. The timer cannot be asked. It is known only after a movement that the timer acknowledged on
 * this connection, as long as nothing was sent since that could move them. Storing a position may be enough to move
 * them (rows 15 and 17 of docs/protocol.md), so it is known only while the timer holds all positions unchanged.
 */
export class ServoStand {
  /** The slot, from 0 (start) to NF (DT); null when it is not known. */
  readonly at: ReadonlySignal<number | null>;
  readonly #session: Session;
  readonly #last = signal<Stand | null>(null, { name: 'stand' });

  constructor(session: Session) {
    this.#session = session;
    this.at = computed(() => {
      const last = this.#last.value;
      const held = session.editor.baseline.value;
      if (!last || !held || session.nextFlight.open.value || session.connection.value !== last.connection) return null;
      const isSame = session.onScreen.keyOf(held) === last.key && String(held.positions) === String(last.positions);
      return isSame ? last.slot : null;
    });
  }

  /** The timer has acknowledged that the servos moved to a slot. */
  moved(connection: TimerConnection, slot: number): void {
    const held = this.#session.editor.baseline.peek();
    this.#last.value = held && {
      connection,
      key: this.#session.onScreen.keyOf(held),
      slot,
      positions: held.positions,
    };
  }

  /** Something may have moved the servos to an unknown place. */
  lose(): void {
    this.#last.value = null;
  }
}
