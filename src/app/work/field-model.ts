import { computed, type ReadonlySignal } from '@preact/signals';
import { fieldKey, type ProgramField, valueAt } from '../../program/index.js';
import { formatValue } from '../editing/content.js';
import { stepSize } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { stepValue } from '../editing/edits.js';
import { figureOf, figureText } from '../messages/index.js';
import type { EditedValue, FieldFace } from './edited-value.js';
import { notesFor } from './field-notes.js';

/**
 * What one field shows. The face stays the same object while nothing in it changes, so typing elsewhere draws the field
 * again only where its content changes. It is one signal: with one for each part, each key would look into a thousand.
 */
export class FieldModel implements EditedValue {
  readonly #editor: Editor;
  readonly #field: ProgramField;
  #last: FieldFace | null = null;
  readonly kind: EditedValue['kind'];
  readonly face: ReadonlySignal<FieldFace> = computed(() => this.#look());

  constructor(editor: Editor, field: ProgramField) {
    this.#editor = editor;
    this.#field = field;
    this.kind = field.kind === 'time' ? 'time' : 'steps';
  }

  get stepSize(): number {
    const { value: identity } = this.#editor.identity;
    return identity ? stepSize(identity, this.#field) : 1;
  }

  #look(): FieldFace {
    const editor = this.#editor;
    const field = this.#field;
    const key = fieldKey(field);
    const working = editor.working.value;
    const value = working && valueAt(working, field);
    const isTime = field.kind === 'time' && value !== null && !editor.isTyped(field);
    const change = editor.changed.value.get(key);
    const from = change?.from ?? null;
    const notes = notesFor(editor, field);
    const isOld = working !== null && from !== null;
    const face: FieldFace = {
      text: editor.textOf(field),
      unit: working && isTime ? figureOf(working.identity, field, value).unit : null,
      isChanged: change !== undefined,
      isConfirmed: editor.confirmed.value.has(key),
      isWrong: notes.some(({ severity }) => severity === 'error'),
      either: editor.asked.value.get(key) ?? null,
      was: isOld ? figureText(working.identity, field, from) : null,
      old: isOld ? formatValue(working.identity, field, from) : '',
      canPutBack: change !== undefined || editor.unreadable.value.has(key),
      notes: notes.map(({ text }) => text).join(' '),
    };
    this.#last = this.#last ? same(this.#last, face) : face;
    return this.#last;
  }

  type(text: string): void {
    this.#editor.type(this.#field, text);
  }

  step(by: number): void {
    const working = this.#editor.working.value;
    if (working) this.#editor.apply(stepValue(working, this.#field, by));
  }

  putBack(): void {
    this.#editor.revert(this.#field);
  }

  answer(value: number): void {
    this.#editor.answer(this.#field, value);
  }

  takeBack(): void {
    this.#editor.takeBack(this.#field);
  }

  escape(): void {
    if (this.face.value.either) this.takeBack();
    else this.#editor.abandonAt(this.#field);
  }

  finish(): boolean {
    this.leave();
    return !this.#editor.asked.value.has(fieldKey(this.#field));
  }

  leave(): void {
    this.#editor.leave(this.#field);
  }
}

/** The old face, if the new one says the same. */
function same(last: FieldFace, found: FieldFace): FieldFace {
  return (Object.keys(found) as (keyof FieldFace)[]).every((name) => last[name] === found[name]) ? last : found;
}
