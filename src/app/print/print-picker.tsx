import { useEffect, useMemo } from 'preact/hooks';
import { print as words } from '../messages/en-print.js';
import type { Print } from './print.js';
import { ON_SCREEN } from './print-order.js';

/** More are not listed: they are searched for. */
const MOST = 40;

interface PrintPickerProps {
  readonly print: Print;
}

/** Which settings are printed: any of the library, of several models, and the program on the screen. */
export function PrintPicker({ print }: PrintPickerProps) {
  const { order } = print;
  const { value: chosen } = order.keys;
  const { value: found } = print.found;
  useEffect(() => void print.load(), [print]);
  // Where there is nothing to print, this is the next step.
  const isFirst = useMemo(
    () => !print.hasProgram.peek() && order.keys.peek().every((key) => key === ON_SCREEN),
    [print, order],
  );
  // What is chosen stands first, whatever is searched for.
  const first = found.filter(({ key }) => chosen.includes(key));
  const listed = [...first, ...found.filter(({ key }) => !chosen.includes(key))].slice(0, Math.max(MOST, first.length));
  return (
    <details class="print-picker" open={isFirst}>
      <summary>{words.choose(print.copies.value.length)}</summary>
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
        {listed.map((record) => (
          <Choice
            key={record.key}
            name={print.nameOf(record)}
            on={chosen.includes(record.key)}
            onToggle={() => order.toggle(record.key)}
          />
        ))}
      </div>
      {listed.length === 0 && <p class="hint">{words.none}</p>}
      {found.length > listed.length && <p class="hint">{words.more(found.length - listed.length)}</p>}
      {chosen.length > 1 && (
        <button type="button" class="quiet" onClick={() => order.choose([])}>
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
    <label class="check">
      <input type="checkbox" checked={on} onChange={onToggle} />
      {name}
    </label>
  );
}
