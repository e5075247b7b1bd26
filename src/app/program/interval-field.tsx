import { useSignal } from '@preact/signals';
import type { TargetedFocusEvent } from 'preact';
import { useMemo, useRef } from 'preact/hooks';
import type { Editor } from '../editing/editor.js';
import { TimeQuestion } from '../ui/time-question.js';
import { type OnStep, stepByKey, useWheel } from './field-tools.js';
import type { Hand } from './hand.js';
import { IntervalModel } from './interval-model.js';
import { refuseDrag } from './refuse-drag.js';
import type { Selection } from './selection.js';
import { useWhole } from './use-whole.js';
import './value-field.css';

interface IntervalFieldProps {
  readonly editor: Editor;
  readonly selection: Selection;
  readonly hand: Hand;
  readonly slot: number;
  readonly label: string;
}

/** The time since the function before. It shows the same as the time, only relative. */
export function IntervalField({ editor, selection, hand, slot, label }: IntervalFieldProps) {
  const input = useRef<HTMLInputElement>(null);
  const focused = useSignal(false);
  const model = useMemo(() => new IntervalModel(editor, slot), [editor, slot]);
  const { value: problem } = model.notes;
  const { value: either } = model.either;
  // The sheet shows everything else about the field.
  const isHeld = focused.value && hand.field.value !== null;
  const notesId = `interval-notes-${slot}`;
  const step: OnStep = (direction, options) => {
    if (selection.isWide.value) selection.stepAll(direction, options);
    else model.step(direction, options);
  };
  /** The text goes away with the focus, unless the focus goes to the field's own question. */
  const leave = ({ relatedTarget, currentTarget }: TargetedFocusEvent<HTMLElement>): void => {
    if (relatedTarget instanceof Node && currentTarget.contains(relatedTarget)) return;
    model.leave();
  };
  useWheel(input, step);
  useWhole(input);
  return (
    <span class={`value ${either ? 'asked' : problem ? 'wrong' : ''}`} onFocusOut={leave} {...refuseDrag}>
      <input
        ref={input}
        type="text"
        inputMode={hand.isTouch.value ? 'none' : 'decimal'}
        autocomplete="off"
        spellcheck={false}
        aria-label={label}
        aria-invalid={problem !== ''}
        aria-describedby={problem ? notesId : undefined}
        value={model.text.value}
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
          // First asks what was meant. Tab leads to the answers.
          if (event.key === 'Enter' && either) event.preventDefault();
          if (event.key === 'Escape') model.escape();
        }}
      />
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
      {problem !== '' && (
        <span class={isHeld ? 'visually-hidden' : 'notes bad-text'} role="alert" id={notesId}>
          {problem}
        </span>
      )}
    </span>
  );
}
