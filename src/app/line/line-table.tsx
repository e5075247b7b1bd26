import { useCallback, useRef } from 'preact/hooks';
import { messages } from '../messages/index.js';
import type { LineRecord } from '../session/line-record.js';
import { useNear } from '../ui/use-near.js';
import type { LineGroup, LineView } from './line-view.js';
import { rowText } from './row-text.js';
import './line-table.css';

/** What was on the line, newest first: time, direction, meaning, bytes. */
export function LineTable({ view }: { readonly view: LineView }) {
  const { line } = messages.value;
  const found = view.found.value.length;
  const shown = view.shownCount.value;
  const timeText = view.recording.value ? sinceBegin : clockTime;
  return (
    <div class="line-log">
      <table class="line-rows" aria-label={line.title}>
        <thead>
          <tr>
            <th scope="col">{line.time}</th>
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
      {found > shown && <Older key={shown} view={view} />}
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
  /** “to the timer”. */
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

/** A button for older entries. It acts without a click when it comes near the window. */
function Older({ view }: { readonly view: LineView }) {
  const { line } = messages.value;
  const place = useRef<HTMLDivElement>(null);
  const showOlder = useCallback(() => view.showOlder(), [view]);
  useNear(place, showOlder, 400);
  return (
    <div ref={place} class="row line-end">
      <p class="hint">{line.more(view.shownCount.value, view.found.value.length)}</p>
      <button type="button" onClick={showOlder}>
        {line.older}
      </button>
    </div>
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
