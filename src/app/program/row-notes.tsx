import type { ReadonlySignal } from '@preact/signals';
import { fieldKey } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { fieldLabel, messages } from '../messages/index.js';
import type { FieldNote } from './field-notes.js';
import './row-notes.css';

interface RowNotesProps {
  readonly identity: Identity;
  readonly notes: ReadonlySignal<readonly FieldNote[]>;
  /** How many columns the table has. */
  readonly width: number;
}

/** Under a row: the notes about its fields. It reads them itself, so that they do not draw the row again. */
export function RowNotes({ identity, notes: { value: notes }, width }: RowNotesProps) {
  if (notes.length === 0) return null;
  return (
    <tr class="row-notes">
      <td colSpan={width}>
        {notes.map(({ field, severity, text }, at) => (
          // The figures in its text change with each digit, but the element stays the same.
          <p key={`${fieldKey(field)} ${at}`} class={severity}>
            <strong>{messages.value.about(fieldLabel(identity, field))}</strong> {text}
          </p>
        ))}
      </td>
    </tr>
  );
}
