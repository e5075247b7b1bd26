import { fieldKey, type ProgramField } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { useModels } from '../models.js';
import { formatValue } from '../state/editor.js';
import { notesFor } from './field-notes.js';

interface ValueFieldProps {
  readonly field: ProgramField;
  readonly label: string;
  /** Which of several fields for the same value this is, to keep their ids apart. */
  readonly place: 'table' | 'large';
  readonly readOnly?: boolean;
  /** Shows what is to be said about the value under it; else that is left to whoever reads aloud, and to the table. */
  readonly notesShown?: boolean;
}

/** More letters than a large figure has room for on a phone. */
const LONG = 6;

/** One value of the program, to be typed over. What differs from the timer is marked, with the old value under it. */
export function ValueField({ field, label, place, readOnly = false, notesShown = false }: ValueFieldProps) {
  const { session } = useModels();
  const { editor } = session;
  const key = fieldKey(field);
  const change = editor.changed.value.get(key);
  const notes = notesFor(editor, field);
  const wrong = notes.some(({ severity }) => severity === 'error');
  const text = editor.textOf(field);
  const wasId = `${place}-was-${key}`;
  const notesId = `${place}-notes-${key}`;
  const described = [change && wasId, notes.length > 0 && notesId].filter(Boolean).join(' ');
  return (
    <span class={`value ${change ? 'changed' : ''} ${wrong ? 'wrong' : ''}`}>
      <input
        type="text"
        inputMode={field.kind === 'time' ? 'decimal' : 'numeric'}
        autocomplete="off"
        spellcheck={false}
        aria-label={label}
        aria-invalid={wrong}
        aria-describedby={described || undefined}
        readOnly={readOnly}
        class={text.length > LONG ? 'long' : ''}
        value={text}
        onFocus={(event) => event.currentTarget.select()}
        onInput={(event) => editor.type(field, event.currentTarget.value)}
        onBlur={() => editor.leave(field)}
        onKeyDown={(event) => event.key === 'Escape' && editor.revert(field)}
      />
      {change && change.from !== null && (
        <span class="was" id={wasId}>
          {messages.value.program.was(formatValue(field, change.from))}
        </span>
      )}
      {notes.length > 0 && (
        <span class={notesShown ? 'notes bad-text' : 'visually-hidden'} id={notesId}>
          {notes.map(({ text }) => text).join(' ')}
        </span>
      )}
    </span>
  );
}
