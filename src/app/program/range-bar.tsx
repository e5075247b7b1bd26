import type { Identity } from '../../protocol/index.js';
import type { GridRange } from '../editing/grid.js';
import { messages } from '../messages/index.js';
import { CopyButton } from '../ui/copy-button.js';
import type { Selection } from './selection.js';
import './range-bar.css';

interface RangeBarProps {
  readonly identity: Identity;
  readonly selection: Selection;
  /** The text to copy. */
  readonly text: () => string;
  readonly onPaste: () => void;
  readonly onFill: () => void;
  readonly onDone: () => void;
}

/** The selected range, and buttons for what the keys do. The focus stays in the table. */
export function RangeBar({ identity, selection, text, onPaste, onFill, onDone }: RangeBarProps) {
  const { copy, done, edits } = messages.value;
  const { range: words } = edits.table;
  const range = selection.shown.value;
  const said = range && (selection.isWide.value ? sizeOf(identity, range) : words.pick);
  return (
    <div
      class={range ? 'row gap-1 range-bar' : ''}
      role="toolbar"
      aria-label={words.title}
      onPointerDown={(event) => event.target instanceof HTMLButtonElement && event.preventDefault()}
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        event.preventDefault();
        onDone();
      }}
    >
      <p role="status">{said}</p>
      {range && (
        <>
          <CopyButton key={Object.values(range).join()} label={copy} text={text} />
          <button type="button" onClick={onPaste}>
            {words.paste}
          </button>
          <button type="button" disabled={range.bottom === 0} onClick={onFill}>
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
  const { size } = messages.value.edits.table.range;
  return size(bottom - top + 1, right - left + 1, top > 0 && bottom < functions);
}
