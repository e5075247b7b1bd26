import { describeFrame, frameName, hexOf } from '../messages/frame-text.js';
import { messages } from '../messages/index.js';
import type { LineRecord } from '../session/line-record.js';
import type { LineView } from './line-view.js';
import './line-table.css';

/** What was on the line, newest first: when, which way, what it means, its bytes. */
export function LineTable({ view }: { view: LineView }) {
  const { line } = messages.value;
  const shown = view.shown.value;
  const found = view.found.value.length;
  const timeText = view.recording.value ? sinceBegin : clockTime;
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable by keyboard
    <section class="line-scroll" tabIndex={0} aria-label={line.title}>
      <table>
        <thead>
          <tr>
            <th scope="col">{line.time}</th>
            <th scope="col">{line.direction}</th>
            <th scope="col">{line.message}</th>
            <th scope="col">{line.bytes}</th>
          </tr>
        </thead>
        <tbody>
          {shown.map((record) => (
            <LineRow key={record.number} record={record} timeText={timeText} />
          ))}
        </tbody>
      </table>
      {found === 0 && <p class="hint">{line.empty}</p>}
      {found > shown.length && <p class="hint">{line.more(shown.length, found)}</p>}
    </section>
  );
}

interface LineRowProps {
  readonly record: LineRecord;
  readonly timeText: (time: number) => string;
}

function LineRow({ record, timeText }: LineRowProps) {
  const { line } = messages.value;
  const { time, direction, bytes, rejected, error, layout } = record;
  return (
    <tr class={rejected || error ? 'damaged' : direction}>
      <td class="when">{timeText(time)}</td>
      <td class="way">{line[direction]}</td>
      <td class="what">
        <span class="name">{frameName(record)}</span> <span class="meaning">{describeFrame(record, layout)}</span>
      </td>
      <td class="bytes">{hexOf(bytes)}</td>
    </tr>
  );
}

function clockTime(time: number): string {
  const date = new Date(time);
  const two = (n: number): string => String(n).padStart(2, '0');
  const seconds = `${two(date.getSeconds())}.${String(date.getMilliseconds()).padStart(3, '0')}`;
  return `${two(date.getHours())}:${two(date.getMinutes())}:${seconds}`;
}

/** Seconds since a recording began, as they stand in its file. */
function sinceBegin(time: number): string {
  return (time / 1000).toFixed(3);
}
