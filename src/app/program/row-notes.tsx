import { useComputed } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { computedList } from '../editing/computed-list.js';
import { fieldName, messages } from '../messages/index.js';
import { isSameNote, notesFor } from '../work/field-notes.js';
import type { TableModel } from './table-model.js';
import './row-notes.css';

interface RowNotesProps {
  readonly table: TableModel;
  readonly identity: Identity;
  readonly fields: readonly ProgramField[];
  /** How many columns the table has. */
  readonly width: number;
}

/**
 * Under a row: the notes about its fields. It reads them itself, so that they do not draw the row again.
 *
 * They get and lose their room when the hands rest. On the way to `12.3` stands `1`, which is too early: rows that jump
 * at each digit are hard to read. What stands there is true at each moment: a note that no longer holds is hidden.
 */
export function RowNotes({ table, identity, fields, width }: RowNotesProps) {
  const notes = useMemo(
    () => computedList(() => fields.flatMap((field) => notesFor(table.editor, field)), isSameNote),
    [table, identity],
  );
  const room = useComputed(() => {
    // Only its change matters.
    void table.rested.value;
    return notes.peek();
  }).value;
  useFieldInSight(room.length);
  if (room.length === 0) return null;
  const left = [...notes.value];
  return (
    <tr class="row-notes">
      <td colSpan={width}>
        {room.map((old, at) => {
          const key = fieldKey(old.field);
          const found = left.findIndex(({ field }) => fieldKey(field) === key);
          const [note] = found < 0 ? [] : left.splice(found, 1);
          const { field, severity, text } = note ?? old;
          return (
            // The figures in its text change with each digit, but the element stays the same.
            <p key={`${key} ${at}`} class={`${severity} ${note ? '' : 'over'}`}>
              <strong>{messages.value.about({ name: fieldName(identity, field) })}</strong> {text}
            </p>
          );
        })}
      </td>
    </tr>
  );
}

/** Keeps the field with the focus in sight when notes get or lose room above it. */
function useFieldInSight(lines: number): void {
  const had = useRef(lines);
  useEffect(() => {
    if (had.current === lines) return;
    had.current = lines;
    const { activeElement } = document;
    if (activeElement?.matches('.program-table td input')) activeElement.scrollIntoView?.({ block: 'nearest' });
  }, [lines]);
}
