import { useEffect, useMemo } from 'preact/hooks';
import { comparingMessages } from '../messages/en-compare.js';
import { libraryMessages } from '../messages/en-library.js';
import { print as words } from '../messages/en-print.js';
import { messages } from '../messages/index.js';
import { Check } from '../ui/check.js';
import type { Print } from './print.js';
import { ON_SCREEN } from './print-order.js';

/** How many are listed. The search finds the others. */
const MOST = 40;

/** Chooses what to print: saved programs, the one on the screen, and memories of the timer. */
export function PrintPicker({ print }: { readonly print: Print }) {
  const { order } = print;
  const { value: chosen } = order.keys;
  const { value: found } = print.found;
  useEffect(() => void print.load(), [print]);
  // With nothing to print, this is the next step.
  const isFirst = useMemo(() => print.sheets.peek().length === 0, [print]);
  // Chosen programs stand first, whatever the search says.
  const first = found.filter(({ key }) => chosen.includes(key));
  const listed = [...first, ...found.filter(({ key }) => !chosen.includes(key))].slice(0, Math.max(MOST, first.length));
  const choices = [
    ...(print.hasProgram.value ? [{ key: ON_SCREEN, name: comparingMessages.compare.screen }] : []),
    ...print.memories.value,
    ...listed.map((record) => ({ key: record.key, name: print.nameOf(record) })),
  ];
  return (
    <details class="print-picker" open={isFirst}>
      <summary>{words.choose(print.sheets.value.length)}</summary>
      <input
        type="search"
        aria-label={libraryMessages.search.label}
        placeholder={messages.value.label.search}
        value={print.search.value}
        onInput={({ currentTarget }) => print.searchFor(currentTarget.value)}
      />
      <div class="print-list">
        {choices.map(({ key, name }) => (
          <Check key={key} checked={chosen.includes(key)} onChange={() => order.toggle(key)}>
            {name}
          </Check>
        ))}
      </div>
      {listed.length === 0 && print.search.value.trim() !== '' && <p class="hint">{libraryMessages.search.nothing}</p>}
      {found.length > listed.length && <p class="hint">{messages.value.more(found.length - listed.length)}</p>}
      {chosen.length > 1 && (
        <button type="button" class="quiet" onClick={() => order.clear()}>
          {words.clear}
        </button>
      )}
    </details>
  );
}
