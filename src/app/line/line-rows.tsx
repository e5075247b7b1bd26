import { describeFrame, frameName } from '../messages/frame-text.js';
import { hexOf } from '../messages/hex.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import type { LineRecord } from '../timer/line-record.js';
import { type LineView, STEP } from './line-view.js';
import './line-rows.css';

/** What was on the line, newest first: time, direction, meaning, bytes. */
export function LineRows({ view }: { readonly view: LineView }) {
  const { showMore, views } = messages.value;
  const { line } = moreMessages.value;
  const { shown, found, recording } = view;
  const hidden = found.value.length - shown.value.length;
  return (
    <>
      <ol class="panel ruled line-rows" aria-label={views.names.line}>
        {shown.value.map((record) => (
          <LineRow
            key={record.number}
            record={record}
            way={line[record.direction]}
            timeText={recording.value ? sinceBegin : clockTime}
          />
        ))}
      </ol>
      {found.value.length === 0 && <p class="hint">{line.empty}</p>}
      {hidden > 0 && (
        <div class="buttons">
          <button type="button" onClick={() => view.showOlder()}>
            {showMore({ count: Math.min(STEP, hidden) })}
          </button>
        </div>
      )}
    </>
  );
}

interface LineRowProps {
  readonly record: LineRecord;
  /** “To the timer”. */
  readonly way: string;
  readonly timeText: (time: number) => string;
}

/** It reads nothing but the language: while its record is the same, it is not drawn again. */
function LineRow({ record, way, timeText }: LineRowProps) {
  return (
    <li class={record.rejected || record.error ? 'damaged' : record.direction}>
      <span class="hint">{timeText(record.time)}</span> <span class="hint">{way}</span>{' '}
      <span class="what">
        <b>{frameName(record)}</b> <span class="hint">{describeFrame(record, record.layout)}</span>
      </span>{' '}
      <code>{hexOf(record.bytes)}</code>
    </li>
  );
}

function clockTime(time: number): string {
  const date = new Date(time);
  const two = (n: number): string => String(n).padStart(2, '0');
  const seconds = `${two(date.getSeconds())}.${String(date.getMilliseconds()).padStart(3, '0')}`;
  return `${two(date.getHours())}:${two(date.getMinutes())}:${seconds}`;
}

/** Seconds since a recording began, as in its file. */
function sinceBegin(time: number): string {
  return (time / 1000).toFixed(3);
}
