import { useSignal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { type Edit, setInterval, stepInterval } from '../edit/edits.js';
import { intervalAt } from '../edit/grid.js';
import { messages, obstacleText } from '../messages/index.js';
import { useModels } from '../models.js';
import { attempt } from '../state/attempt.js';
import { formatInterval, parseInterval } from '../units.js';
import { FieldTools, type OnStep, stepByKey, useWheel } from './field-tools.js';
import { useSteady } from './use-steady.js';

/**
 * The time since the function before: the same truth as the time, seen from there. What is typed moves this function and those after it. A
 * text that is no interval changes nothing, and the interval stands there again when the field is left.
 */
export function IntervalField({ column, label }: { readonly column: number; readonly label: string }) {
  const { session } = useModels();
  const { editor } = session;
  const input = useRef<HTMLInputElement>(null);
  const typed = useSignal<string | null>(null);
  const problem = useSignal<string | null>(null);
  const focused = useSignal(false);
  const interval = useSteady(() => editor.working.value && intervalAt(editor.working.value, column), [editor, column]);
  const group = `interval ${column}`;
  const notesId = `interval-notes-${column}`;

  const set = (edit: Edit): void => {
    const identity = editor.identity.value;
    const obstacle = attempt(editor, edit, { code: 'interval', params: { column } }, group);
    problem.value = obstacle && identity && obstacleText(identity, obstacle);
  };
  const step: OnStep = (direction, options) => {
    typed.value = null;
    const working = editor.working.value;
    if (working) set(stepInterval(working, column, direction, options));
  };
  const type = (text: string): void => {
    typed.value = text;
    const parsed = parseInterval(text);
    const working = editor.working.value;
    if ('unreadable' in parsed) problem.value = messages.value.unreadable[parsed.unreadable];
    else if (working) set(setInterval(working, column, parsed.value));
  };
  useWheel(input, step);
  return (
    <span class={`value ${problem.value ? 'wrong' : ''}`}>
      <input
        ref={input}
        type="text"
        inputMode="decimal"
        autocomplete="off"
        spellcheck={false}
        aria-label={label}
        aria-invalid={problem.value !== null}
        aria-describedby={problem.value ? notesId : undefined}
        value={typed.value ?? (interval === null ? '' : formatInterval(interval))}
        onFocus={(event) => {
          focused.value = true;
          event.currentTarget.select();
        }}
        onInput={(event) => type(event.currentTarget.value)}
        onBlur={() => {
          focused.value = false;
          typed.value = null;
          problem.value = null;
          editor.settle();
        }}
        onKeyDown={(event) => {
          if (event.defaultPrevented || stepByKey(event, step) || event.key !== 'Escape') return;
          typed.value = null;
          problem.value = null;
          editor.abandon(group);
        }}
      />
      {problem.value && (
        <span class="notes bad-text" role="alert" id={notesId}>
          {problem.value}
        </span>
      )}
      {focused.value && <FieldTools label={label} onStep={step} />}
    </span>
  );
}
