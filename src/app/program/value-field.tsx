import { useSignal } from '@preact/signals';
import { useMemo, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField } from '../../program/index.js';
import { stepValue } from '../editing/edits.js';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { FieldModel, type FieldPlace } from './field-model.js';
import { FieldTools, type OnStep, stepByKey, useWheel } from './field-tools.js';
import { refuseDrag } from './refuse-drag.js';
import type { Selection } from './selection.js';
import { TimeQuestion } from './time-question.js';
import { useSwipe } from './use-swipe.js';
import { WasText } from './was-text.js';
import './value-field.css';

interface ValueFieldProps {
  readonly session: Session;
  readonly field: ProgramField;
  readonly label: string;
  /** It keeps the ids of fields for one value apart. In the table the arrows alone go to other cells. */
  readonly place: FieldPlace;
  /** Of the table; absent elsewhere. */
  readonly selection?: Selection;
  readonly readOnly?: boolean;
  /** Shows what is to be said about the value under it; else that is left to whoever reads aloud, and to the table. */
  readonly notesShown?: boolean;
}

/** More letters than there is room for beside a unit on a phone: such a time has a colon. */
const LONG = 5;

/** One value of the program, to be typed over. What differs from the timer is marked, with the old value under it. */
export function ValueField(props: ValueFieldProps) {
  const { session, field, label, place, selection, readOnly = false, notesShown = false } = props;
  const { editor } = session;
  const input = useRef<HTMLInputElement>(null);
  const focused = useSignal(false);
  const key = fieldKey(field);
  const isLarge = place === 'large';
  const model = useMemo(() => new FieldModel(editor, field, place), [editor, key, place]);
  const { value: text } = model.text;
  const { value: unit } = model.unit;
  const { value: spoken } = model.spoken;
  const { value: was } = model.was;
  const { value: either } = model.either;
  const { value: notes } = model.notes;
  const isChanged = model.isChanged.value;
  const isWrong = model.isWrong.value;
  const id = (what: string): string => `${place}-${what}-${key}`;
  const described = [
    unit && id('unit'),
    spoken && id('spoken'),
    was !== null && id('was'),
    notes && id('notes'),
  ].filter(Boolean);
  const revert = (): void => editor.revert(field);
  const step: OnStep = (direction, options) => {
    const working = editor.working.value;
    if (working && !readOnly) editor.apply(stepValue(working, field, direction, options));
  };
  useWheel(input, step);
  useSwipe(input, step);
  return (
    <span class={`value ${isChanged ? 'changed' : ''} ${either ? 'asked' : isWrong ? 'wrong' : ''}`} {...refuseDrag}>
      <input
        ref={input}
        type="text"
        data-field={key}
        inputMode={field.kind === 'time' ? 'decimal' : 'numeric'}
        autocomplete="off"
        spellcheck={false}
        aria-label={label}
        aria-invalid={isWrong}
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
      {notes && (
        <span class={notesShown ? 'notes bad-text' : 'visually-hidden'} id={id('notes')}>
          {notes}
        </span>
      )}
      {focused.value && !readOnly && (
        <FieldTools
          {...{ label, selection }}
          onStep={step}
          onRevert={isChanged || model.isUnreadable.value ? revert : undefined}
        />
      )}
    </span>
  );
}
