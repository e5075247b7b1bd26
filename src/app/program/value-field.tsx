import { useSignal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { fieldKey, type ProgramField, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { formatValue } from '../editing/content.js';
import { stepValue } from '../editing/edits.js';
import { figureOf, messages, spokenTime, valueText } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { useSteady } from '../ui/use-steady.js';
import { notesFor } from './field-notes.js';
import { FieldTools, type OnStep, stepByKey, useWheel } from './field-tools.js';
import { refuseDrag } from './refuse-drag.js';
import { TimeQuestion } from './time-question.js';
import { useSwipe } from './use-swipe.js';
import { WasText } from './was-text.js';
import './value-field.css';

interface ValueFieldProps {
  readonly session: Session;
  readonly field: ProgramField;
  readonly label: string;
  /** Which of several fields for the same value this is, to keep their ids apart. In the table the arrows alone go to other cells. */
  readonly place: 'table' | 'large';
  readonly readOnly?: boolean;
  /** Shows what is to be said about the value under it; else that is left to whoever reads aloud, and to the table. */
  readonly notesShown?: boolean;
}

/** More letters than there is room for beside a unit on a phone: such a time has a colon. */
const LONG = 5;

/** One value of the program, to be typed over. What differs from the timer is marked, with the old value under it. */
export function ValueField({ session, field, label, place, readOnly = false, notesShown = false }: ValueFieldProps) {
  const { editor } = session;
  const input = useRef<HTMLInputElement>(null);
  const focused = useSignal(false);
  const key = fieldKey(field);
  const isLarge = place === 'large';
  const { text, unit, spoken, change, was, unreadable, either, notes } = useSteady(() => {
    const working = editor.working.value;
    const value = working && valueAt(working, field);
    const change = editor.changed.value.get(key) ?? null;
    const isTyped = editor.isTyped(field);
    const figure = working && value !== null && !isTyped ? figureOf(working.identity, field, value) : null;
    const isSaid =
      isLarge && field.kind === 'time' && (field.slot === working?.identity.functions || figure?.unit === 'min');
    return {
      text: isLarge && figure ? figure.text : editor.textOf(field),
      // In the table a column of seconds says it at its head, as it were; what is not seconds there says it itself.
      unit: isLarge || figure?.unit === 'min' ? (figure?.unit ?? null) : null,
      spoken: isSaid && change && value !== null && !editor.unreadable.value.has(key) ? spokenTime(value) : null,
      change,
      was: working && change && change.from !== null ? wasText(working.identity, field, change.from, isLarge) : null,
      unreadable: editor.unreadable.value.has(key),
      either: editor.asked.value.get(key) ?? null,
      notes: notesFor(editor, field),
    };
  }, [editor, key]);
  const wrong = notes.some(({ severity }) => severity === 'error');
  const id = (what: string): string => `${place}-${what}-${key}`;
  const described = [
    unit && id('unit'),
    spoken && id('spoken'),
    was !== null && id('was'),
    notes.length > 0 && id('notes'),
  ].filter(Boolean);
  const revert = (): void => editor.revert(field);
  const step: OnStep = (direction, options) => {
    const working = editor.working.value;
    if (working && !readOnly) editor.apply(stepValue(working, field, direction, options));
  };
  useWheel(input, step);
  useSwipe(input, step);
  return (
    <span class={`value ${change ? 'changed' : ''} ${either ? 'asked' : wrong ? 'wrong' : ''}`} {...refuseDrag}>
      <input
        ref={input}
        type="text"
        data-field={key}
        inputMode={field.kind === 'time' ? 'decimal' : 'numeric'}
        autocomplete="off"
        spellcheck={false}
        aria-label={label}
        aria-invalid={wrong}
        aria-describedby={described.join(' ') || undefined}
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
          if (event.defaultPrevented || stepByKey(event, step, isLarge)) return;
          if (event.key === 'Escape') {
            if (either) editor.takeBack(field);
            else editor.escape(field);
          }
          if (event.key !== 'Enter' && (event.key !== 'Tab' || event.shiftKey || either)) return;
          editor.leave(field);
          // It asks first what was meant; the answers are the next thing that Tab comes to.
          if (editor.asked.value.has(key)) event.preventDefault();
          if (isLarge && event.key === 'Enter') event.currentTarget.select();
        }}
      />
      {unit && (
        <span class="unit" id={id('unit')}>
          {messages.value.times.units[unit]}
        </span>
      )}
      {either && (
        <TimeQuestion
          label={label}
          either={either}
          onAnswer={(value, byKey) => {
            editor.answer(field, value);
            if (byKey) input.current?.focus();
          }}
          onEscape={() => {
            editor.takeBack(field);
            input.current?.focus();
          }}
        />
      )}
      {(spoken || was !== null) && (
        <span class="below">
          {spoken && (
            <span class="spoken" id={id('spoken')}>
              {spoken}
            </span>
          )}
          {was !== null && (
            <span class="was" id={id('was')}>
              <WasText standing={session.standing} value={was} />
            </span>
          )}
        </span>
      )}
      {notes.length > 0 && (
        <span class={notesShown ? 'notes bad-text' : 'visually-hidden'} id={id('notes')}>
          {notes.map(({ text }) => text).join(' ')}
        </span>
      )}
      {focused.value && !readOnly && (
        <FieldTools label={label} onStep={step} onRevert={change || unreadable ? revert : undefined} />
      )}
    </span>
  );
}

/** An old value in the form of the new one above it, with its unit. */
function wasText(identity: Identity, field: ProgramField, value: number, isLarge: boolean): string {
  if (isLarge) return valueText(identity, field, value);
  const text = formatValue(field, value);
  return field.kind === 'time' ? messages.value.seconds(text) : text;
}
