import { type Change, fieldKey } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { changeText, fieldLabel, messages } from '../messages/index.js';
import { formatValue } from '../state/editing.js';

interface DifferenceProps {
  readonly identity: Identity;
  readonly changes: readonly Change[];
}

/** What is, and what will be, value by value. */
export function DifferenceTable({ identity, changes }: DifferenceProps) {
  const { write } = messages.value;
  return (
    <table class="difference">
      <thead>
        <tr>
          <th scope="col">{write.field}</th>
          <th scope="col">{write.from}</th>
          <th scope="col">{write.to}</th>
        </tr>
      </thead>
      <tbody>
        {changes.map(({ field, from, to }) => (
          <tr key={fieldKey(field)}>
            <th scope="row">{fieldLabel(identity, field)}</th>
            <td>{from === null ? write.status.unknown : formatValue(field, from)}</td>
            <td>
              <strong>{to === null ? write.status.unknown : formatValue(field, to)}</strong>
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** The same in one sentence, to be read aloud or sent to someone. */
export function DifferenceInWords({ identity, changes }: DifferenceProps) {
  return <p class="hint">{changes.map((change) => changeText(identity, change)).join('; ')}</p>;
}
