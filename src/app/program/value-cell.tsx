import { type ReadonlySignal, useComputed } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useCallback, useMemo, useRef } from 'preact/hooks';
import type { ProgramField } from '../../program/index.js';
import { cellFor, cellKey, type GridField, isInRange } from '../editing/grid.js';
import { fieldLabel, gridLabel, messages } from '../messages/index.js';
import type { Standing } from '../timer/standing.js';
import { TimeQuestion } from '../ui/time-question.js';
import { OldValue } from '../ui/was-text.js';
import type { EditedValue } from '../work/edited-value.js';
import { FieldModel } from '../work/field-model.js';
import { IntervalModel } from './interval-model.js';
import type { TableModel } from './table-model.js';
import '../ui/value.css';

interface ValueCellProps {
  readonly table: TableModel;
  readonly standing: ReadonlySignal<Standing>;
  /** A value of the program, or the interval before a slot. */
  readonly field: ProgramField | GridField;
  /** What stands in the cell before it. */
  readonly children?: ComponentChildren;
}

/** A cell of the table with its field. A value that differs from the timer is marked, with the old value beside it. */
export function ValueCell({ table, standing, field, children }: ValueCellProps) {
  const { editor, hand, selection, marked } = table;
  const input = useRef<HTMLInputElement>(null);
  const isInterval = field.kind === 'interval';
  const key = cellKey(field);
  const model = useMemo(
    (): EditedValue => (isInterval ? new IntervalModel(editor, field.slot) : new FieldModel(editor, field)),
    [editor, key],
  );
  const cell = cellFor(field);
  const isSelected = useComputed(() => cell !== null && isInRange(selection.shown.value, cell)).value;
  const isMarked = useComputed(() => marked.value !== null && cellKey(marked.value) === key).value;
  const column = { position: '', interval: 'interval', time: 'time', idleThrottle: 'time' }[field.kind];
  const { text, unit, isChanged, isConfirmed, isWrong, either, was, old, notes } = model.face.value;
  const state = isChanged ? 'changed' : isConfirmed ? 'confirmed' : '';
  const { value: identity } = editor.identity;
  const label = identity ? (isInterval ? gridLabel(identity, field) : fieldLabel(identity, field)) : '';
  const isFocused = useComputed(() => hand.held.value?.value === model).value;
  // The sheet shows everything else about the field.
  const isHeld = isFocused && hand.field.value !== null;
  const id = (what: string): string => `${what}-${key}`;
  const described = [unit && id('unit'), was !== null && id('was'), notes && id('notes')].filter(Boolean);
  // The same function from key to key, so that its reader is not drawn again.
  const putBack = useCallback(() => model.putBack(), [model]);
  return (
    <td data-cell={cell?.column} class={`${column} ${isSelected ? 'selected' : ''} ${isMarked ? 'marked' : ''}`}>
      {children}
      <span
        class={`value ${state} ${either ? 'asked' : isWrong ? 'wrong' : ''}`}
        onFocusOut={({ relatedTarget, currentTarget }) => {
          const stays = relatedTarget instanceof Node && currentTarget.contains(relatedTarget);
          if (!stays) model.leave();
        }}
      >
        <input
          ref={input}
          type="text"
          data-field={key}
          // From a sheet one types times and positions. The arrows still lead to an interval.
          tabIndex={isInterval && !table.byIntervals.value ? -1 : undefined}
          inputMode={hand.isTouch.value ? 'none' : model.kind === 'steps' ? 'numeric' : 'decimal'}
          autocomplete="off"
          spellcheck={false}
          aria-label={label}
          aria-invalid={isWrong}
          aria-describedby={described.join(' ') || undefined}
          value={text}
          onFocus={({ currentTarget }) => {
            currentTarget.select();
            hand.hold({ input: currentTarget, label, value: model });
          }}
          onInput={(event) => model.type(event.currentTarget.value)}
          onBlur={({ currentTarget }) => hand.release(currentTarget)}
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
            label={isFocused ? messages.value.edits.field.putBackTo({ field: label, figure: old }) : null}
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
    </td>
  );
}
