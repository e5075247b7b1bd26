import { useComputed, useSignal } from '@preact/signals';
import type { TargetedFocusEvent } from 'preact';
import { useRef } from 'preact/hooks';
import type { Edit } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { setInterval, stepInterval } from '../editing/edits.js';
import { gridKey, intervalAt } from '../editing/grid.js';
import { groupOf } from '../editing/history.js';
import { formatInterval, type Question, readInterval } from '../editing/units.js';
import { messages, obstacleText } from '../messages/index.js';
import { FieldTools, type OnStep, stepByKey, useWheel } from './field-tools.js';
import { refuseDrag } from './refuse-drag.js';
import type { Selection } from './selection.js';
import { TimeQuestion } from './time-question.js';
import { useSwipe } from './use-swipe.js';
import './value-field.css';

/** What was last done in the field. */
interface Entry {
  /** As it was typed; null when it was a step. */
  readonly text: string | null;
  /** Why it changed nothing; null when it was done. */
  readonly problem: string | null;
  /** What it may mean, where it is asked which: nothing was done. */
  readonly either?: Question['either'] | undefined;
  /** The interval after it. When that has changed, as by undo, the entry counts no more. */
  readonly interval: number | null;
}

interface IntervalFieldProps {
  readonly editor: Editor;
  readonly selection: Selection;
  readonly slot: number;
  readonly label: string;
}

/**
 * The time since the function before: the same truth as the time, seen from there. What is typed moves this function
 * and those after it. A text that is no interval, or asks what it means, changes nothing, and the interval stands there
 * again when the field is left.
 */
export function IntervalField({ editor, selection, slot, label }: IntervalFieldProps) {
  const input = useRef<HTMLInputElement>(null);
  const entered = useSignal<Entry | null>(null);
  const focused = useSignal(false);
  const find = (): number | null => editor.working.value && intervalAt(editor.working.value, slot);
  const interval = useComputed(find).value;
  const entry = entered.value?.interval === interval ? entered.value : null;
  const problem = entry?.problem ?? null;
  const either = entry?.either;
  const key = gridKey({ kind: 'interval', slot });
  const typing = groupOf('type', key);
  const stepping = groupOf('step', key);
  const notesId = `interval-notes-${slot}`;

  /** @returns why it was not done; null when it was. */
  const apply = (edit: Edit): string | null => {
    const identity = editor.identity.value;
    const obstacle = editor.apply(edit);
    return obstacle && identity && obstacleText(identity, obstacle);
  };
  const step: OnStep = (direction, options) => {
    const working = editor.working.value;
    if (!working) return;
    const problem = apply(stepInterval(working, slot, direction, { ...options, unreadable: editor.unreadable.value }));
    entered.value = { text: null, problem, interval: find() };
  };
  const type = (text: string): void => {
    const working = editor.working.value;
    if (!working) return;
    const parsed = readInterval(text, { isDt: slot === working.identity.functions });
    const problem =
      'unreadable' in parsed
        ? messages.value.unreadable[parsed.unreadable]
        : apply(setInterval(working, slot, parsed.value, { unreadable: editor.unreadable.value }));
    // What it began with may have been an interval.
    if (problem) editor.abandon(typing);
    const either = 'either' in parsed ? parsed.either : undefined;
    entered.value = { text, problem: either ? null : problem, either, interval: find() };
  };
  const answer = (value: number, byKey: boolean): void => {
    const working = editor.working.value;
    if (!working) return;
    const problem = apply(setInterval(working, slot, value, { unreadable: editor.unreadable.value }));
    entered.value = problem ? { text: formatInterval(value), problem, interval: find() } : null;
    if (byKey) input.current?.focus();
  };
  const takeBack = (): void => {
    entered.value = null;
    input.current?.focus();
  };
  /** The text gives way when the focus goes, and not when it goes to its question. */
  const leave = ({ relatedTarget, currentTarget }: TargetedFocusEvent<HTMLElement>): void => {
    if (relatedTarget instanceof Node && currentTarget.contains(relatedTarget)) return;
    entered.value = null;
    editor.settle();
  };
  useWheel(input, step);
  useSwipe(input, step);
  return (
    <span class={`value ${either ? 'asked' : problem ? 'wrong' : ''}`} onFocusOut={leave} {...refuseDrag}>
      <input
        ref={input}
        type="text"
        inputMode="decimal"
        autocomplete="off"
        spellcheck={false}
        aria-label={label}
        aria-invalid={problem !== null}
        aria-describedby={problem ? notesId : undefined}
        value={entry?.text ?? (interval === null ? '' : formatInterval(interval))}
        onFocus={(event) => {
          focused.value = true;
          event.currentTarget.select();
        }}
        onInput={(event) => type(event.currentTarget.value)}
        onBlur={() => {
          focused.value = false;
        }}
        onKeyDown={(event) => {
          if (event.defaultPrevented || stepByKey(event, step)) return;
          // It asks first what was meant; the answers are the next thing that Tab comes to.
          if (event.key === 'Enter' && either) event.preventDefault();
          if (event.key !== 'Escape') return;
          entered.value = null;
          if (!problem && !editor.abandon(typing)) editor.abandon(stepping);
        }}
      />
      {either && <TimeQuestion {...{ label, either }} onAnswer={answer} onEscape={takeBack} />}
      {problem && (
        <span class="notes bad-text" role="alert" id={notesId}>
          {problem}
        </span>
      )}
      {focused.value && <FieldTools {...{ label, selection }} onStep={step} />}
    </span>
  );
}
