import { signal } from '@preact/signals';
import { differences, fieldKey, type ProgramField, sameLayout, type TimerProgram } from '../../program/index.js';
import { MAX_POSITION } from '../../protocol/index.js';
import type { Editor } from '../editing/editor.js';

export type Position = Extract<ProgramField, { kind: 'position' }>;

/** A position that has changed since the servos follow, and that the timer does not hold yet. */
export interface PendingPosition {
  readonly field: Position;
  readonly value: number;
}

/** A number counts as typed after this many milliseconds without a digit: on the way to 65, 6 is not sent. */
const TYPED = 600;

/** The edits since the servos follow: which positions to send to the timer, and which are still being typed. */
export class FollowedEdits {
  readonly #touched = signal<ReadonlySet<string>>(new Set(), { name: 'touched' });
  /** Goes up each time that typed digits have rested long enough. */
  readonly #rested = signal(0, { name: 'rested' });
  readonly #editor: Editor;
  /** The wanted program at the last call of `note()`. */
  #seen: TimerProgram | null = null;
  #typing: ReturnType<typeof setTimeout> | undefined;
  readonly #changedAt = new Map<string, number>();

  constructor(editor: Editor) {
    this.#editor = editor;
  }

  /** Begins: later edits are followed. */
  begin(): void {
    this.#seen = this.#editor.working.peek();
    this.#touched.value = new Set();
  }

  /** Ends: nobody waits for digits to rest any more. */
  end(): void {
    clearTimeout(this.#typing);
  }

  /** Notes which positions have changed since the last call. */
  note(): void {
    const working = this.#editor.working.value;
    const before = this.#seen;
    this.#seen = working;
    if (!working || !before || before === working || !sameLayout(before.identity, working.identity)) return;
    const changed = differences(before, working).map(({ field }) => field);
    for (const field of changed) this.#changedAt.set(fieldKey(field), performance.now());
    this.#touched.value = new Set([...this.#touched.peek(), ...changed.map(fieldKey)]);
  }

  /** The positions that have changed since following began, and that the timer does not hold yet. */
  pending(): readonly PendingPosition[] {
    const touched = this.#touched.value;
    return this.#editor.changes.value.flatMap(({ field, to }): PendingPosition[] => {
      if (field.kind !== 'position' || to === null || to < 0 || to > MAX_POSITION) return [];
      // The old value of a field with an unreadable text was not asked for.
      const isMeant = touched.has(fieldKey(field)) && !this.#editor.unreadable.value.has(fieldKey(field));
      return isMeant ? [{ field, value: to }] : [];
    });
  }

  /** Those that are no longer being typed. An effect that asks here runs again when the others have rested. */
  due(): readonly PendingPosition[] {
    void this.#rested.value;
    clearTimeout(this.#typing);
    const pending = this.pending();
    const rests = pending.map(({ field }) => (this.#editor.isTyped(field) ? this.#restOf(field) : 0));
    const wait = Math.min(...rests.filter((rest) => rest > 0));
    if (wait < Number.POSITIVE_INFINITY) this.#typing = setTimeout(() => this.#rested.value++, Math.ceil(wait));
    return pending.filter((_, i) => (rests[i] ?? 0) <= 0);
  }

  #restOf(field: Position): number {
    return (this.#changedAt.get(fieldKey(field)) ?? 0) + TYPED - performance.now();
  }
}
