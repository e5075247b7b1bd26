import { computed, type ReadonlySignal } from '@preact/signals';
import { fieldKey, type ProgramField } from '../../program/index.js';
import { computedList } from '../editing/computed-list.js';
import type { Editor } from '../editing/editor.js';
import { cellFor } from '../editing/grid.js';
import { type FieldNote, isSameNote, notesFor } from './field-notes.js';
import type { Selection } from './selection.js';

export interface RowSources {
  readonly editor: Editor;
  readonly selection: Selection;
  /** The field whose handle is used in the timeline. */
  readonly marked: ReadonlySignal<ProgramField | null>;
}

/**
 * What one row of the table shows around its fields. Each signal changes only with its own content, as in `FieldModel`.
 */
export class RowModel {
  /** The notes about its fields. */
  readonly notes: ReadonlySignal<readonly FieldNote[]>;
  readonly isChanged: ReadonlySignal<boolean>;
  /** The first and the last selected column; none when the row is not in the selection. */
  readonly selectedFrom: ReadonlySignal<number>;
  readonly selectedTo: ReadonlySignal<number>;
  /** The column of the field that is used in the timeline; null when it is in another row. */
  readonly markedAt: ReadonlySignal<number | null>;

  constructor({ editor, selection, marked }: RowSources, slot: number, fields: readonly ProgramField[]) {
    const keys = fields.map(fieldKey);
    const selected = computed(() => {
      const range = selection.shown.value;
      return range && slot >= range.top && slot <= range.bottom ? range : null;
    });
    this.notes = computedList(() => fields.flatMap((field) => notesFor(editor, field)), isSameNote);
    this.isChanged = computed(() =>
      keys.some((key) => editor.changed.value.has(key) || editor.unreadable.value.has(key)),
    );
    this.selectedFrom = computed(() => selected.value?.left ?? Number.POSITIVE_INFINITY);
    this.selectedTo = computed(() => selected.value?.right ?? Number.NEGATIVE_INFINITY);
    this.markedAt = computed(() => {
      const isMine = marked.value && keys.includes(fieldKey(marked.value));
      return isMine ? (cellFor(marked.value)?.column ?? null) : null;
    });
  }
}

/** The attributes of a cell: its place in the grid, and whether it is selected, or used in the timeline. */
export function cellProps(
  { selectedFrom, selectedTo, markedAt }: RowModel,
  column: number,
  name = '',
): { readonly 'data-cell': number; readonly class: string } {
  const isSelected = column >= selectedFrom.value && column <= selectedTo.value;
  const isMarked = column === markedAt.value;
  const classes = [name, isSelected && 'selected', isMarked && 'marked'].filter(Boolean);
  return { 'data-cell': column, class: classes.join(' ') };
}
