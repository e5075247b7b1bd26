import type { Identity } from '../../protocol/index.js';
import { fieldsIn, type GridRange } from '../editing/grid.js';
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
  const { range: words, selected } = messages.value.edits.table;
  const range = selection.shown.value;
  const isWide = selection.isWide.value;
  return (
    <>
      <p class="visually-hidden" role="status">
        {range && (isWide ? selected(fieldsIn(identity, range).length) : words.pick)}
      </p>
      {range && (
        <div
          class="row gap-1 range-bar"
          role="toolbar"
          aria-label={words.title}
          onPointerDown={(event) => event.target instanceof HTMLButtonElement && event.preventDefault()}
          onKeyDown={(event) => {
            if (event.key !== 'Escape') return;
            event.preventDefault();
            onDone();
          }}
        >
          <p>{isWide ? sizeOf(identity, range) : words.pick}</p>
          <CopyButton key={Object.values(range).join()} label={words.copy} text={text} />
          <button type="button" onClick={onPaste}>
            {words.paste}
          </button>
          <button type="button" disabled={range.bottom === 0} onClick={onFill}>
            {words.fillDown}
          </button>
          <button type="button" class="primary" onClick={onDone}>
            {words.done}
          </button>
        </div>
      )}
    </>
  );
}

/** “3 functions, 2 columns”; “rows” when start or DT is among them. */
function sizeOf({ functions }: Identity, { top, left, bottom, right }: GridRange): string {
  const { size } = messages.value.edits.table.range;
  return size(bottom - top + 1, right - left + 1, top > 0 && bottom < functions);
}
