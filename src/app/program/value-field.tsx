import { type ReadonlySignal, useSignal } from '@preact/signals';
import { useCallback, useMemo, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { type GridField, intervalKey } from '../editing/grid.js';
import { fieldLabel, gridLabel, messages } from '../messages/index.js';
import type { Standing } from '../timer/standing.js';
import { TimeQuestion } from '../ui/time-question.js';
import { FieldModel } from './field-model.js';
import type { EditedValue, Hand } from './hand.js';
import { IntervalModel } from './interval-model.js';
import { refuseDrag } from './refuse-drag.js';
import type { Selection } from './selection.js';
import { type OnStep, stepByKey, useWheel } from './step-field.js';
import { useWhole } from './use-whole.js';
import { OldValue } from './was-text.js';
import './value-field.css';

interface ValueFieldProps {
  readonly editor: Editor;
  readonly standing: ReadonlySignal<Standing>;
  /** A value of the program, or the interval before a slot. */
  readonly field: ProgramField | GridField;
  readonly hand: Hand;
  /** The selection of the table; absent for a value that has no cell in its grid. */
  readonly selection?: Selection;
}

/** A field of the table. A value that differs from the timer is marked, with the old value beside it. */
export function ValueField({ editor, standing, field, hand, selection }: ValueFieldProps) {
  const input = useRef<HTMLInputElement>(null);
  const focused = useSignal(false);
  const isInterval = field.kind === 'interval';
  const key = isInterval ? intervalKey(field.slot) : fieldKey(field);
  const model = useMemo(
    (): EditedValue => (isInterval ? new IntervalModel(editor, field.slot) : new FieldModel(editor, field)),
    [editor, key],
  );
  const { text, unit, isChanged, isConfirmed, isWrong, either, was, old, notes } = model.face.value;
  const state = isChanged ? 'changed' : isConfirmed ? 'confirmed' : '';
  const { value: identity } = editor.identity;
  const label = identity ? (isInterval ? gridLabel(identity, field) : fieldLabel(identity, field)) : '';
  // The sheet shows everything else about the field.
  const isHeld = focused.value && hand.field.value !== null;
  const id = (what: string): string => `${what}-${key}`;
  const described = [unit && id('unit'), was !== null && id('was'), notes && id('notes')].filter(Boolean);
  // The same function from key to key, so that its reader is not drawn again.
  const putBack = useCallback(() => model.putBack(), [model]);
  const step: OnStep = (direction, options) => {
    if (selection?.isWide.value) selection.stepAll(direction, options);
    else model.step(direction, options);
  };
  useWheel(input, step);
  useWhole(input);
  return (
    <span
      class={`value ${state} ${either ? 'asked' : isWrong ? 'wrong' : ''}`}
      onFocusOut={({ relatedTarget, currentTarget }) => {
        const stays = relatedTarget instanceof Node && currentTarget.contains(relatedTarget);
        if (!stays) model.leave();
      }}
      {...refuseDrag}
    >
      <input
        ref={input}
        type="text"
        data-field={key}
        inputMode={hand.isTouch.value ? 'none' : model.kind === 'steps' ? 'numeric' : 'decimal'}
        autocomplete="off"
        spellcheck={false}
        aria-label={label}
        aria-invalid={isWrong}
        aria-describedby={described.join(' ') || undefined}
        value={text}
        onFocus={({ currentTarget }) => {
          focused.value = true;
          currentTarget.select();
          hand.hold({ input: currentTarget, label, value: model, selection });
        }}
        onInput={(event) => model.type(event.currentTarget.value)}
        onBlur={({ currentTarget }) => {
          focused.value = false;
          hand.release(currentTarget);
        }}
        onKeyDown={(event) => {
          if (event.defaultPrevented || stepByKey(event, step)) return;
          if (event.key === 'Escape') model.escape();
          const isDone = event.key === 'Enter' || (event.key === 'Tab' && !event.shiftKey && !either);
          // First asks what was meant. Tab leads to the answers.
          if (isDone && !model.finish()) event.preventDefault();
        }}
      />
      {unit && (
        <span class="visually-hidden" id={id('unit')}>
          {messages.value.times.units[unit]}
        </span>
      )}
      {either && !isHeld && (
        <TimeQuestion
          {...{ label, either }}
          onAnswer={(value, byKey) => {
            model.answer(value);
            if (byKey) input.current?.focus();
          }}
          onEscape={() => {
            model.takeBack();
            input.current?.focus();
          }}
        />
      )}
      {was !== null && (
        <OldValue
          {...{ standing }}
          id={id('was')}
          value={was}
          figure={old}
          // Otherwise a click into the field would count as a click on it.
          label={focused.value ? messages.value.edits.field.putBackTo(label, old) : null}
          onPutBack={putBack}
        />
      )}
      {/* Those of a value stand under the row. */}
      {notes !== '' && (
        <span
          class={isInterval && !isHeld ? 'notes bad-text' : 'visually-hidden'}
          role={isInterval ? 'alert' : undefined}
          id={id('notes')}
        >
          {notes}
        </span>
      )}
    </span>
  );
}
