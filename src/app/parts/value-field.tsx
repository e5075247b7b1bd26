import { useSignal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { fieldKey, type ProgramField } from '../../program/index.js';
import { formatValue } from '../edit/content.js';
import { messages } from '../messages/index.js';
import { useModels } from '../models.js';
import { stepField } from '../state/attempt.js';
import { notesFor } from './field-notes.js';
import { FieldTools, type OnStep, stepByKey, useWheel } from './field-tools.js';
import { refuseDrag } from './refuse-drag.js';
import { useSteady } from './use-steady.js';
import { useSwipe } from './use-swipe.js';

interface ValueFieldProps {
  readonly field: ProgramField;
  readonly label: string;
  /** Which of several fields for the same value this is, to keep their ids apart. In the table the arrows alone go to other cells. */
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
  const input = useRef<HTMLInputElement>(null);
  const focused = useSignal(false);
  const key = fieldKey(field);
  const { text, change, unreadable, notes } = useSteady(
    () => ({
      text: editor.textOf(field),
      change: editor.changed.value.get(key) ?? null,
      unreadable: editor.unreadable.value.has(key),
      notes: notesFor(editor, field),
    }),
    [editor, key],
  );
  const wrong = notes.some(({ severity }) => severity === 'error');
  const wasId = `${place}-was-${key}`;
  const notesId = `${place}-notes-${key}`;
  const described = [change && wasId, notes.length > 0 && notesId].filter(Boolean).join(' ');
  const revert = (): void => editor.revert(field);
  const step: OnStep = (direction, options) => {
    if (!readOnly) stepField(editor, field, direction, options);
  };
  useWheel(input, step);
  useSwipe(input, step);
  return (
    <span class={`value ${change ? 'changed' : ''} ${wrong ? 'wrong' : ''}`} {...refuseDrag}>
      <input
        ref={input}
        type="text"
        data-field={key}
        inputMode={field.kind === 'time' ? 'decimal' : 'numeric'}
        autocomplete="off"
        spellcheck={false}
        aria-label={label}
        aria-invalid={wrong}
        aria-describedby={described || undefined}
        readOnly={readOnly}
        class={text.length > LONG ? 'long' : ''}
        value={text}
        onFocus={(event) => {
          focused.value = true;
          event.currentTarget.select();
        }}
        onInput={(event) => editor.type(field, event.currentTarget.value)}
        onBlur={() => {
          focused.value = false;
          editor.leave(field);
        }}
        onKeyDown={(event) => {
          if (event.defaultPrevented || stepByKey(event, step, place === 'large')) return;
          if (event.key === 'Escape') editor.escape(field);
        }}
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
      {focused.value && !readOnly && (
        <FieldTools label={label} onStep={step} onRevert={change || unreadable ? revert : undefined} />
      )}
    </span>
  );
}
