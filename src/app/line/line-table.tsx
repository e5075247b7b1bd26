import { messages } from '../messages/index.js';
import type { LineRecord } from '../session/line-record.js';
import { type LineGroup, type LineView, STEP } from './line-view.js';
import { rowText } from './row-text.js';
import './line-table.css';

/** What was on the line, newest first: time, direction, meaning, bytes. */
export function LineTable({ view }: { readonly view: LineView }) {
  const { line, program, showMore, views } = messages.value;
  const found = view.found.value.length;
  const hidden = found - view.shownCount.value;
  const timeText = view.recording.value ? sinceBegin : clockTime;
  return (
    <div class="panel">
      <table class="line-rows" aria-label={views.names.line}>
        <thead>
          <tr>
            <th scope="col">{program.time}</th>
            <th scope="col">{line.direction}</th>
            <th scope="col">{line.message}</th>
            <th scope="col">{line.bytes}</th>
          </tr>
        </thead>
        {view.shown.value.map((group) => (
          <Group key={group.key} group={group} timeText={timeText} />
        ))}
      </table>
      {found === 0 && <p class="hint row line-end">{line.empty}</p>}
      {hidden > 0 && (
        <div class="row line-end">
          <button type="button" onClick={() => view.showOlder()}>
            {showMore(Math.min(STEP, hidden))}
          </button>
        </div>
      )}
    </div>
  );
}

type TimeText = (time: number) => string;

interface GroupProps {
  readonly group: LineGroup;
  readonly timeText: TimeText;
}

/** It reads nothing but the language: while its group is the same object, it is not drawn again. */
function Group({ group, timeText }: GroupProps) {
  const { line } = messages.value;
  return (
    <tbody>
      {group.records.map((record) => (
        <LineRow key={record.number} record={record} way={line[record.direction]} timeText={timeText} />
      ))}
    </tbody>
  );
}

interface LineRowProps {
  readonly record: LineRecord;
  /** “To the timer”. */
  readonly way: string;
  readonly timeText: TimeText;
}

function LineRow({ record, way, timeText }: LineRowProps) {
  const { name, meaning, bytes } = rowText(record);
  return (
    <tr class={record.rejected || record.error ? 'damaged' : record.direction}>
      <td class="when">{timeText(record.time)}</td>
      <td class="way">{way}</td>
      <td class="what">
        <b class="name">{name}</b> {meaning}
      </td>
      <td class="bytes">{bytes}</td>
    </tr>
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
