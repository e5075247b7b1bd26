import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { type Edit, stepSize } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { setInterval, stepInterval } from '../editing/edits.js';
import { cellKey, type GridField, intervalAt } from '../editing/grid.js';
import { groupOf } from '../editing/history.js';
import { type Ambiguous, formatInterval, MINUTE, readInterval } from '../editing/units.js';
import { messages, obstacleText } from '../messages/index.js';
import type { EditedValue, FieldFace } from '../work/edited-value.js';

/** An interval lies between two times that may both have changed. */
const NO_OLD_VALUE = { isChanged: false, isConfirmed: false, was: null, old: '', canPutBack: false };

/** Says why something was not done, in the language that the page speaks by then. */
type Problem = () => string;

/** The last entry in the field. */
interface Entry {
  /** The text as it was typed; null for a step. */
  readonly text: string | null;
  /** Why it changed nothing; null when it was done. */
  readonly problem: Problem | null;
  /** The possible meanings of an ambiguous text, which changed nothing. */
  readonly either?: Ambiguous['either'] | undefined;
  /** The interval after the entry. Once that has changed, as by undo, the entry no longer counts. */
  readonly interval: number | null;
}

/**
 * An interval that is being edited. What is typed moves this function and later ones. A text that is no interval, or is
 * ambiguous, changes nothing; when the field is left, the interval is shown again.
 */
export class IntervalModel implements EditedValue {
  readonly #editor: Editor;
  readonly #field: GridField;
  readonly #entered = signal<Entry | null>(null);
  readonly #interval = computed(() => this.#find());
  readonly #entry = computed(() => {
    const { value: entered } = this.#entered;
    return entered?.interval === this.#interval.value ? entered : null;
  });

  readonly kind = 'interval';
  readonly face: ReadonlySignal<FieldFace> = computed(() => {
    const interval = this.#interval.value;
    const { text = null, problem = null, either = null } = this.#entry.value ?? {};
    return {
      text: text ?? (interval === null ? '' : formatInterval(interval)),
      unit: interval === null || text !== null ? null : Math.abs(interval) < MINUTE ? 's' : 'min',
      isWrong: problem !== null,
      either,
      // Why nothing was changed.
      notes: problem?.() ?? '',
      ...NO_OLD_VALUE,
    };
  });

  constructor(editor: Editor, slot: number) {
    this.#editor = editor;
    this.#field = { kind: 'interval', slot };
  }

  get stepSize(): number {
    const { value: identity } = this.#editor.identity;
    return identity ? stepSize(identity, { kind: 'time', slot: this.#field.slot }) : 1;
  }

  step(by: number): void {
    const working = this.#editor.working.value;
    if (!working) return;
    const unreadable = this.#editor.unreadable.value;
    this.#enter(null, this.#apply(stepInterval(working, this.#field.slot, by, { unreadable })));
  }

  type(text: string): void {
    const working = this.#editor.working.value;
    if (!working) return;
    const parsed = readInterval(text, { isDt: this.#field.slot === working.identity.functions });
    const problem =
      'unreadable' in parsed ? () => messages.value.unreadable[parsed.unreadable] : this.#set(parsed.value);
    // The beginning of the text may have been an interval.
    if (problem) this.#editor.abandon(groupOf('type', cellKey(this.#field)));
    const either = 'either' in parsed ? parsed.either : undefined;
    this.#enter(text, either ? null : problem, either);
  }

  answer(value: number): void {
    const problem = this.#set(value);
    if (problem) this.#enter(formatInterval(value), problem);
    else this.takeBack();
  }

  /** Shows the interval in place of the text. */
  takeBack(): void {
    this.#entered.value = null;
  }

  /** Takes back what was typed or stepped since the field was entered. */
  escape(): void {
    const hadProblem = this.face.value.isWrong;
    this.takeBack();
    if (!hadProblem) this.#editor.abandonAt(this.#field);
  }

  leave(): void {
    this.takeBack();
    this.#editor.settle();
  }

  finish(): boolean {
    return this.face.value.either === null;
  }

  putBack(): void {}

  #find(): number | null {
    const { value: working } = this.#editor.working;
    return working && intervalAt(working, this.#field.slot);
  }

  #enter(text: string | null, problem: Problem | null, either?: Ambiguous['either']): void {
    this.#entered.value = { text, problem, either, interval: this.#find() };
  }

  #set(value: number): Problem | null {
    const { working, unreadable } = this.#editor;
    return (
      working.value &&
      this.#apply(setInterval(working.value, this.#field.slot, value, { unreadable: unreadable.value }))
    );
  }

  /** @returns why it was not done; null when it was. */
  #apply(edit: Edit): Problem | null {
    const { value: identity } = this.#editor.identity;
    const obstacle = this.#editor.apply(edit);
    return obstacle && identity && (() => obstacleText(identity, obstacle));
  }
}
