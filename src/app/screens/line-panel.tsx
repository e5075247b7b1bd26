import type { LineEntry } from '../../client/index.js';
import { commandOf } from '../../protocol/index.js';
import { messages } from '../messages/index.js';
import { useModels } from '../models.js';

/** Everything that was on the line, newest first. */
export function LinePanel() {
  const { session } = useModels();
  const { line } = messages.value;
  const entries = [...session.log.entries.value].reverse();
  return (
    <details class="line">
      <summary>{line.title}</summary>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable by keyboard */}
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
            {entries.map((entry, index) => (
              <tr key={entries.length - index} class={entry.rejected ? 'damaged' : entry.direction}>
                <td>{clockTime(entry.time)}</td>
                <td>{entry.direction === 'out' ? line.out : line.in}</td>
                <td>{messageName(entry)}</td>
                <td class="bytes">{hex(entry.bytes)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </section>
    </details>
  );
}

function messageName({ frame, rejected }: LineEntry): string {
  const { line } = messages.value;
  if (rejected) return line.rejected[rejected];
  const command = frame && commandOf(frame.code);
  if (!command) return line.unknown;
  const name = line.names[command.name];
  return command.direction === 'request' ? line.request(name, command.name) : line.reply(name, command.name);
}

function clockTime(time: number): string {
  const date = new Date(time);
  const two = (n: number): string => String(n).padStart(2, '0');
  const seconds = `${two(date.getSeconds())}.${String(date.getMilliseconds()).padStart(3, '0')}`;
  return `${two(date.getHours())}:${two(date.getMinutes())}:${seconds}`;
}

function hex(bytes: Uint8Array): string {
  return [...bytes].map((byte) => byte.toString(16).padStart(2, '0')).join(' ');
}
