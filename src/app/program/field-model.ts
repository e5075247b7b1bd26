import { computed, type ReadonlySignal } from '@preact/signals';
import { fieldKey, type ProgramField, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { formatValue } from '../editing/content.js';
import { stepSize } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { type StepOptions, stepValue } from '../editing/edits.js';
import type { Ambiguous, Figure } from '../editing/units.js';
import { figureOf, messages, spokenTime, valueText } from '../messages/index.js';
import { notesFor } from './field-notes.js';
import type { EditedValue } from './hand.js';

/** Which of several fields for the same value this is. */
export type FieldPlace = 'table' | 'large';

/** What stands in a field, and its colours. */
export interface FieldFace {
  readonly text: string;
  readonly unit: Figure['unit'] | null;
  readonly isChanged: boolean;
  /** Whether a write has just changed it and the read back has confirmed it. */
  readonly isConfirmed: boolean;
  readonly isWrong: boolean;
  readonly either: Ambiguous['either'] | null;
  /** The value in spoken form, where a wrong minute would be costly. */
  readonly spoken: string | null;
  /** The old value in the timer, if it differs and is known. */
  readonly was: string | null;
  /** The same without a unit. */
  readonly old: string;
  readonly notes: string;
}

const UNCHANGED = { spoken: null, was: null, old: '' };

/**
 * What one field shows. The face stays the same object while nothing in it changes, so typing elsewhere draws the field
 * again only where its content changes. It is one signal: with one for each part, each key would look into a thousand.
 */
export class FieldModel implements EditedValue {
  readonly #editor: Editor;
  readonly #field: ProgramField;
  readonly #key: string;
  readonly #isLarge: boolean;
  #last: FieldFace | null = null;
  readonly kind: EditedValue['kind'];
  readonly face: ReadonlySignal<FieldFace> = computed(() => this.#look());
  readonly text: EditedValue['text'] = computed(() => this.face.value.text);
  readonly unit: EditedValue['unit'] = computed(() => this.face.value.unit);
  readonly was: EditedValue['was'] = computed(() => this.face.value.was);
  readonly either: EditedValue['either'] = computed(() => this.face.value.either);
  readonly notes: EditedValue['notes'] = computed(() => this.face.value.notes);
  readonly canPutBack: EditedValue['canPutBack'] = computed(
    () => this.face.value.isChanged || this.#editor.unreadable.value.has(this.#key),
  );
  readonly stepSize: EditedValue['stepSize'] = computed(() => {
    const { value: identity } = this.#editor.identity;
    return identity ? stepSize(identity, this.#field) : 1;
  });

  constructor(editor: Editor, field: ProgramField, place: FieldPlace) {
    this.#editor = editor;
    this.#field = field;
    this.#key = fieldKey(field);
    this.#isLarge = place === 'large';
    this.kind = field.kind === 'time' ? 'time' : 'steps';
  }

  #look(): FieldFace {
    const editor = this.#editor;
    const field = this.#field;
    const key = this.#key;
    const working = editor.working.value;
    const value = working && valueAt(working, field);
    const isTime = field.kind === 'time' && value !== null && !editor.isTyped(field);
    const figure = working && isTime ? figureOf(working.identity, field, value) : null;
    const unit = figure?.unit ?? null;
    const from = editor.changed.value.get(key)?.from;
    const notes = notesFor(editor, field);
    const face: FieldFace = {
      text: this.#isLarge && figure ? figure.text : editor.textOf(field),
      unit,
      isChanged: from !== undefined,
      isConfirmed: editor.confirmed.value.has(key),
      isWrong: notes.some(({ severity }) => severity === 'error'),
      either: editor.asked.value.get(key) ?? null,
      ...this.#against(from, value, unit),
      notes: notes.map(({ text }) => text).join(' '),
    };
    this.#last = this.#last ? same(this.#last, face) : face;
    return this.#last;
  }

  /** @param from the value in the timer: undefined when it is the same, null when it is not known. */
  #against(
    from: number | null | undefined,
    value: number | null,
    unit: FieldFace['unit'],
  ): Pick<FieldFace, 'spoken' | 'was' | 'old'> {
    const field = this.#field;
    const identity = this.#editor.identity.value;
    if (from === undefined || !identity) return UNCHANGED;
    const isSaid =
      this.#isLarge &&
      field.kind === 'time' &&
      (field.slot === identity.functions || unit === 'min') &&
      !this.#editor.unreadable.value.has(this.#key);
    return {
      spoken: isSaid && value !== null ? spokenTime(value) : null,
      was: from === null ? null : wasText(identity, field, from, this.#isLarge),
      old: from === null ? '' : formatValue(identity, field, from),
    };
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

/** The old face, if the new one says the same. */
function same(last: FieldFace, found: FieldFace): FieldFace {
  return (Object.keys(found) as (keyof FieldFace)[]).every((name) => last[name] === found[name]) ? last : found;
}

/** An old value in the form of the new one above it, with its unit. */
function wasText(identity: Identity, field: ProgramField, value: number, isLarge: boolean): string {
  if (isLarge) return valueText(identity, field, value);
  const text = formatValue(identity, field, value);
  return field.kind === 'time' ? messages.value.seconds(text) : text;
}
