import { computed, signal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { Session } from '../work/session.js';

/** What an acknowledged movement has shown. */
interface Stand {
  readonly connection: TimerConnection;
  readonly slot: number;
  /** What the memory held then: the servos stand at its positions. */
  readonly held: TimerProgram;
}

export type StandParts = Pick<Session, 'connection' | 'editor' | 'nextFlight' | 'onScreen'>;

/**
 * Where the servos stand. The timer cannot be asked. It is known only after a movement that the timer acknowledged on
 * this connection, as long as nothing was sent since that could move them. Storing a position may be enough to move
 * them (rows 15 and 17 of docs/protocol.md), so it is known only while the timer holds all positions unchanged.
 */
export class ServoStand {
  /** The slot, from 0 (start) to NF (DT); null when it is not known. */
  readonly at = computed(() => {
    const { editor, nextFlight, connection, onScreen } = this.#parts;
    const last = this.#last.value;
    const held = editor.baseline.value;
    if (!last || !held || nextFlight.open.value || connection.value !== last.connection) return null;
    const isSame = onScreen.keyOf(held) === onScreen.keyOf(last.held);
    return isSame && String(held.positions) === String(last.held.positions) ? last.slot : null;
  });
  readonly #parts: StandParts;
  readonly #last = signal<Stand | null>(null, { name: 'stand' });

  constructor(parts: StandParts) {
    this.#parts = parts;
  }

  /** The timer has acknowledged that the servos moved to a slot. */
  moved(connection: TimerConnection, slot: number): void {
    const held = this.#parts.editor.baseline.peek();
    this.#last.value = held && { connection, slot, held };
  }

  /** Something may have moved the servos to an unknown place. */
  lose(): void {
    this.#last.value = null;
  }
}
