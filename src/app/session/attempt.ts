import { fieldKey, type ProgramField } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { type Edit, type Obstacle, type StepOptions, stepValue } from '../editing/edits.js';
import { countedFrom } from '../editing/grid.js';
import { groupOf, type StepName } from '../editing/history.js';

/**
 * Does an edit of several fields as one step. A text that is no value is not replaced by it: the pilot may not see that field.
 * @returns null when it was done.
 */
export function attempt(editor: Editor, edit: Edit, step: StepName, group: string | null = null): Obstacle | null {
  if ('refused' in edit) return edit.refused;
  const inTheWay = edit.values.find(({ field }) => editor.unreadable.value.has(fieldKey(field)));
  if (inTheWay) return { code: 'unreadable', field: inTheWay.field };
  editor.apply(edit.values, step, group);
  return null;
}

/** Does an edit of the interval of a slot, as {@link attempt}. One cannot count from a time whose text is no value. */
export function attemptInterval(editor: Editor, slot: number, edit: Edit, group: string): Obstacle | null {
  const before = countedFrom(slot);
  if (before && editor.unreadable.value.has(fieldKey(before))) return { code: 'unreadable', field: before };
  return attempt(editor, edit, { code: 'interval', params: { slot } }, group);
}

/** Steps a field up or down. Steps that follow each other are one to undo. A text that is no value has no next one. */
export function stepField(editor: Editor, field: ProgramField, direction: 1 | -1, options: StepOptions = {}): void {
  const working = editor.working.value;
  if (!working) return;
  const key = fieldKey(field);
  const values = stepValue(working, field, direction, options);
  attempt(editor, { values }, { code: 'step', params: { field: key } }, groupOf('step', key));
}
