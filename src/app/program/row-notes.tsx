import { fieldKey } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { fieldLabel, messages } from '../messages/index.js';
import type { FieldNote } from './field-notes.js';
import './row-notes.css';

interface RowNotesProps {
  readonly identity: Identity;
  readonly notes: readonly FieldNote[];
  /** How many columns the table has. */
  readonly width: number;
}

/** Under a row: what is to be said about its fields. */
export function RowNotes({ identity, notes, width }: RowNotesProps) {
  if (notes.length === 0) return null;
  return (
    <tr class="row-notes">
      <td colSpan={width}>
        {notes.map(({ field, severity, text }, at) => (
          // The figures in its text follow each digit: it stays the same element.
          <p key={`${fieldKey(field)} ${at}`} class={severity}>
            <strong>{messages.value.about(fieldLabel(identity, field))}</strong> {text}
          </p>
        ))}
      </td>
    </tr>
  );
}
