import { useSignal } from '@preact/signals';
import { useCallback, useMemo, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField } from '../../program/index.js';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { TimeQuestion } from '../ui/time-question.js';
import { FieldModel, type FieldPlace } from './field-model.js';
import { FieldTools, type OnStep, stepByKey, useWheel } from './field-tools.js';
import type { Hand } from './hand.js';
import { refuseDrag } from './refuse-drag.js';
import type { Selection } from './selection.js';
import { useWhole } from './use-whole.js';
import { OldValue, WasText } from './was-text.js';
import './value-field.css';

interface ValueFieldProps {
  readonly session: Session;
  readonly field: ProgramField;
  readonly label: string;
  /** Keeps the ids of fields for the same value apart. In the table, plain arrows go to other cells. */
  readonly place: FieldPlace;
  readonly hand: Hand;
  /** The selection of the table; absent elsewhere. */
  readonly selection?: Selection;
  readonly readOnly?: boolean;
}

/** A field for one value of the program. A value that differs from the timer is marked, with the old value under it. */
export function ValueField(props: ValueFieldProps) {
  const { session, field, label, place, hand, selection, readOnly = false } = props;
  const { editor } = session;
  const input = useRef<HTMLInputElement>(null);
  const focused = useSignal(false);
  const key = fieldKey(field);
  const isLarge = place === 'large';
  const model = useMemo(() => new FieldModel(editor, field, place), [editor, key, place]);
  const { text, unit, isChanged, isConfirmed, isWrong, either, spoken, was, old, notes } = model.face.value;
  const state = isChanged ? 'changed' : isConfirmed ? 'confirmed' : '';
  // The sheet shows everything else about the field.
  const isHeld = focused.value && hand.field.value !== null;
  const id = (what: string): string => `${place}-${what}-${key}`;
  const described = [
    unit && id('unit'),
    spoken && id('spoken'),
    was !== null && id('was'),
    notes && id('notes'),
  ].filter(Boolean);
  // The same function from key to key, so that its reader is not drawn again.
  const putBack = useCallback(() => model.putBack(), [model]);
  const step: OnStep = (direction, options) => {
    if (selection?.isWide.value) selection.stepAll(direction, options);
    else if (!readOnly) model.step(direction, options);
  };
  useWheel(input, step);
  useWhole(input);
  return (
    <span class={`value ${state} ${either ? 'asked' : isWrong ? 'wrong' : ''}`} {...refuseDrag}>
      <input
        ref={input}
        type="text"
        data-field={key}
        inputMode={hand.isTouch.value ? 'none' : field.kind === 'time' ? 'decimal' : 'numeric'}
        autocomplete="off"
        spellcheck={false}
        aria-label={label}
        aria-invalid={isWrong}
        aria-describedby={described.join(' ') || undefined}
        readOnly={readOnly}
        value={text}
        onFocus={({ currentTarget }) => {
          focused.value = true;
          currentTarget.select();
          if (!currentTarget.readOnly) hand.hold({ input: currentTarget, label, value: model, selection });
        }}
        onInput={(event) => editor.type(field, event.currentTarget.value)}
        onBlur={({ currentTarget }) => {
          focused.value = false;
          hand.release(currentTarget);
          editor.leave(field);
        }}
        onKeyDown={(event) => {
          if (event.defaultPrevented || stepByKey(event, step, isLarge)) return;
          if (event.key === 'Escape') {
            if (either) editor.takeBack(field);
            else if (!isLarge) editor.escape(field);
            // Else it closes the panel of the large field, and changes nothing.
            if (isLarge && (either || editor.abandonAt(field))) event.preventDefault();
          }
          if (event.key !== 'Enter' && (event.key !== 'Tab' || event.shiftKey || either)) return;
          // First asks what was meant. Tab leads to the answers.
          if (!model.finish()) event.preventDefault();
          if (isLarge && event.key === 'Enter') event.currentTarget.select();
        }}
      />
      {unit && (
        <span class="unit" id={id('unit')}>
          {messages.value.times.units[unit]}
        </span>
      )}
      {either && !isHeld && (
        <TimeQuestion
          label={label}
          either={either}
          onAnswer={(value, byKey) => {
            model.answer(value);
            if (byKey) input.current?.focus();
          }}
          onEscape={() => {
            editor.takeBack(field);
            input.current?.focus();
          }}
        />
      )}
      {isLarge && (spoken || was !== null) && (
        <span class="below">
          {spoken && <span id={id('spoken')}>{spoken}</span>}
          {was !== null && (
            <span class="was" id={id('was')}>
              <WasText standing={session.standing} value={was} />
            </span>
          )}
        </span>
      )}
      {!isLarge && was !== null && (
        <OldValue
          id={id('was')}
          standing={session.standing}
          value={was}
          figure={old}
          // Otherwise a click into the field would count as a click on it.
          label={focused.value ? messages.value.edits.field.putBackTo(label, old) : null}
          onPutBack={putBack}
        />
      )}
      {/* In the table the notes stand under the row. */}
      {notes !== '' && (
        <span class="visually-hidden" id={id('notes')}>
          {notes}
        </span>
      )}
      {isLarge && focused.value && !readOnly && !isHeld && <FieldTools label={label} value={model} />}
    </span>
  );
}
