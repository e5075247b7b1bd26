import { useEffect, useMemo } from 'preact/hooks';
import { print as words } from '../messages/en-print.js';
import { Check } from '../ui/check.js';
import type { Print } from './print.js';
import { ON_SCREEN } from './print-order.js';

/** How many are listed. The search finds the others. */
const MOST = 40;

interface PrintPickerProps {
  readonly print: Print;
}

/** Chooses what to print: any settings of the library, the program on the screen, and memories of the timer. */
export function PrintPicker({ print }: PrintPickerProps) {
  const { order } = print;
  const { value: chosen } = order.keys;
  const isScreenAlone = print.hasProgram.value && chosen.length === 1 && chosen[0] === ON_SCREEN;
  const { value: found } = print.found;
  const { value: memories } = print.memories;
  useEffect(() => void print.load(), [print]);
  // With nothing to print, this is the next step.
  const isFirst = useMemo(
    () => !print.hasProgram.peek() && order.keys.peek().every((key) => key === ON_SCREEN),
    [print, order],
  );
  // Chosen settings stand first, whatever the search says.
  const first = found.filter(({ key }) => chosen.includes(key));
  const listed = [...first, ...found.filter(({ key }) => !chosen.includes(key))].slice(0, Math.max(MOST, first.length));
  return (
    <details class="print-picker" open={isFirst}>
      <summary>{isScreenAlone ? words.chosenScreen : words.choose(print.copies.value.length)}</summary>
      <input
        type="search"
        aria-label={words.search}
        placeholder={words.search}
        value={print.search.value}
        onInput={({ currentTarget }) => print.searchFor(currentTarget.value)}
      />
      <div class="print-list">
        {print.hasProgram.value && (
          <Choice name={words.onScreen} on={chosen.includes(ON_SCREEN)} onToggle={() => order.toggle(ON_SCREEN)} />
        )}
        {memories.map(({ key, name }) => (
          <Choice key={key} name={words.asRead(name)} on={chosen.includes(key)} onToggle={() => order.toggle(key)} />
        ))}
        {listed.map((record) => (
          <Choice
            key={record.key}
            name={print.nameOf(record)}
            on={chosen.includes(record.key)}
            onToggle={() => order.toggle(record.key)}
          />
        ))}
      </div>
      {listed.length === 0 && <p class="hint">{print.search.value.trim() === '' ? words.empty : words.none}</p>}
      {found.length > listed.length && <p class="hint">{words.more(found.length - listed.length)}</p>}
      {chosen.length > 1 && (
        <button type="button" class="quiet" onClick={() => order.clear()}>
          {words.clear}
        </button>
      )}
    </details>
  );
}

interface ChoiceProps {
  readonly name: string;
  readonly on: boolean;
  readonly onToggle: () => void;
}

function Choice({ name, on, onToggle }: ChoiceProps) {
  return (
    <Check checked={on} onChange={onToggle}>
      {name}
    </Check>
  );
}
