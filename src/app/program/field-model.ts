import { computed, type ReadonlySignal } from '@preact/signals';
import { fieldKey, type ProgramField, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { formatValue } from '../editing/content.js';
import type { Editor } from '../editing/editor.js';
import { type StepOptions, stepSize, stepValue } from '../editing/edits.js';
import type { Ambiguous, Figure } from '../editing/units.js';
import { figureOf, messages, spokenTime, valueText } from '../messages/index.js';
import { notesFor } from './field-notes.js';
import type { EditedValue } from './hand.js';

/** Which of several fields for the same value this is. */
export type FieldPlace = 'table' | 'large';

/**
 * What one field shows. Each part tells of its own changes alone: a keystroke elsewhere draws the field anew only where
 * it says something else.
 */
export class FieldModel implements EditedValue {
  readonly #editor: Editor;
  readonly #field: ProgramField;
  readonly kind: EditedValue['kind'];
  readonly text: ReadonlySignal<string>;
  readonly unit: ReadonlySignal<Figure['unit'] | null>;
  /** The value as it is said, where a wrong minute would be dear. */
  readonly spoken: ReadonlySignal<string | null>;
  readonly isChanged: ReadonlySignal<boolean>;
  /** A write has just changed it, and the reading back has confirmed it. */
  readonly isConfirmed: ReadonlySignal<boolean>;
  /** The value that the timer held, where it was another and is known. */
  readonly was: ReadonlySignal<string | null>;
  /** The same without a unit. */
  readonly old: ReadonlySignal<string>;
  readonly isUnreadable: ReadonlySignal<boolean>;
  readonly canPutBack: ReadonlySignal<boolean>;
  readonly either: ReadonlySignal<Ambiguous['either'] | null>;
  readonly isWrong: ReadonlySignal<boolean>;
  readonly notes: ReadonlySignal<string>;
  readonly stepSize: ReadonlySignal<number>;

  constructor(editor: Editor, field: ProgramField, place: FieldPlace) {
    this.#editor = editor;
    this.#field = field;
    this.kind = field.kind === 'time' ? 'time' : 'steps';
    const key = fieldKey(field);
    const isLarge = place === 'large';
    const { identity } = editor;
    const value = computed(() => editor.working.value && valueAt(editor.working.value, field));
    /** What the timer held; undefined where it holds the same. */
    const from = computed(() => editor.changed.value.get(key)?.from);
    const isTyped = computed(() => editor.isTyped(field));
    const figure = computed(() =>
      identity.value && value.value !== null && !isTyped.value ? figureOf(identity.value, field, value.value) : null,
    );
    const isSaid = computed(
      () =>
        isLarge &&
        field.kind === 'time' &&
        (field.slot === identity.value?.functions || figure.value?.unit === 'min') &&
        this.isChanged.value &&
        !this.isUnreadable.value,
    );
    this.text = computed(() => (isLarge && figure.value ? figure.value.text : editor.textOf(field)));
    this.unit = computed(() => figure.value?.unit ?? null);
    this.spoken = computed(() => (isSaid.value && value.value !== null ? spokenTime(value.value) : null));
    this.isChanged = computed(() => from.value !== undefined);
    this.isConfirmed = computed(() => editor.confirmed.value.has(key));
    this.was = computed(() =>
      identity.value && typeof from.value === 'number' ? wasText(identity.value, field, from.value, isLarge) : null,
    );
    this.old = computed(() =>
      identity.value && typeof from.value === 'number' ? formatValue(identity.value, field, from.value) : '',
    );
    this.isUnreadable = computed(() => editor.unreadable.value.has(key));
    this.canPutBack = computed(() => this.isChanged.value || this.isUnreadable.value);
    this.either = computed(() => editor.asked.value.get(key) ?? null);
    const notes = computed(() => notesFor(editor, field));
    this.isWrong = computed(() => notes.value.some(({ severity }) => severity === 'error'));
    this.notes = computed(() => notes.value.map(({ text }) => text).join(' '));
    this.stepSize = computed(() => (identity.value ? stepSize(identity.value, field) : 1));
  }

  step(direction: 1 | -1, options?: StepOptions): void {
    const working = this.#editor.working.value;
    if (working) this.#editor.apply(stepValue(working, this.#field, direction, options));
  }

  putBack(): void {
    this.#editor.revert(this.#field);
  }

  answer(value: number): void {
    this.#editor.answer(this.#field, value);
  }

  finish(): boolean {
    this.#editor.leave(this.#field);
    return !this.#editor.asked.value.has(fieldKey(this.#field));
  }
}

/** An old value in the form of the new one above it, with its unit. */
function wasText(identity: Identity, field: ProgramField, value: number, isLarge: boolean): string {
  if (isLarge) return valueText(identity, field, value);
  const text = formatValue(identity, field, value);
  return field.kind === 'time' ? messages.value.seconds(text) : text;
}
