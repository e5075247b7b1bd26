import type { TargetedEvent } from 'preact';
import type { Identity } from '../../protocol/index.js';
import type { GridRange } from '../editing/grid.js';
import { messages } from '../messages/index.js';
import { CopyButton } from '../ui/copy-button.js';
import { cellAt } from './table-cells.js';
import type { TableModel } from './table-model.js';
import './range-bar.css';

interface RangeBarProps {
  readonly table: TableModel;
  readonly identity: Identity;
}

/** The selected range, and buttons for what the keys do. The focus stays in the table. */
export function RangeBar({ table, identity }: RangeBarProps) {
  const { selection } = table;
  const { copy, done, edits } = messages.value;
  const { range: words } = edits.table;
  const range = selection.shown.value;
  /** With the keyboard, the focus goes back to the cell. A thumb does not want the screen keyboard. */
  const onDone = ({ currentTarget }: TargetedEvent<HTMLElement>): void => {
    const { value: cell } = selection.active;
    const box = currentTarget.contains(document.activeElement) && currentTarget.closest('.table-box');
    table.done();
    if (box && cell) cellAt(box, cell)?.querySelector('input')?.focus();
  };
  const said = range && (selection.isWide.value ? sizeOf(identity, range) : words.pick);
  return (
    <div
      class={range ? 'row gap-1 panel range-bar' : ''}
      role="toolbar"
      aria-label={words.title}
      onPointerDown={(event) => event.target instanceof HTMLButtonElement && event.preventDefault()}
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        event.preventDefault();
        onDone(event);
      }}
    >
      <p role="status">{said}</p>
      {range && (
        <>
          <CopyButton key={Object.values(range).join()} label={copy} text={() => table.selectedText()} />
          <button type="button" onClick={() => void table.pasteCopied()}>
            {words.paste}
          </button>
          <button type="button" disabled={range.bottom === 0} onClick={() => table.fillDown()}>
            {words.fillDown}
          </button>
          <button type="button" class="primary" onClick={onDone}>
            {done}
          </button>
        </>
      )}
    </div>
  );
}

/** “3 functions, 2 columns”; “rows” when start or DT is among them. */
function sizeOf({ functions }: Identity, { top, left, bottom, right }: GridRange): string {
  const { range: words } = messages.value.edits.table;
  const cells = top > 0 && bottom < functions ? words.functions : words.rows;
  return words.size({
    cells: cells({ count: bottom - top + 1 }),
    columns: words.columns({ count: right - left + 1 }),
  });
}
