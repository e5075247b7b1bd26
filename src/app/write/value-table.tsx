import type { ComponentChildren } from 'preact';
import { fieldKey, type ProgramField } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { fieldName, figureText, messages } from '../messages/index.js';
import '../timeline/program-grid.css';
import './value-table.css';

interface ValueTableProps {
  readonly identity: Identity;
  /** The headings of the columns. */
  readonly names: readonly string[];
  readonly rows: readonly {
    readonly field: ProgramField;
    /** One for each column; null when it is not known. */
    readonly values: readonly (number | null)[];
    /** Stands after the last value, in a column without a heading. */
    readonly note?: ComponentChildren;
  }[];
  /** Whether the last column is what holds, or will hold: the others are pale then. */
  readonly lastCounts?: boolean;
}

/** The values of some fields side by side. */
export function ValueTable({ identity, names, rows, lastCounts = false }: ValueTableProps) {
  const { write } = messages.value;
  const last = names.length - 1;
  const hasNotes = rows.some(({ note }) => note);
  return (
    <table class="value-grid difference">
      <caption class="visually-hidden">{write.sideBySide({ names: names.join(', ') })}</caption>
      <thead>
        <tr>
          {[write.field, ...names].map((name) => (
            <th scope="col" key={name}>
              {name}
            </th>
          ))}
          {hasNotes && <td />}
        </tr>
      </thead>
      <tbody>
        {rows.map(({ field, values, note }) => (
          <tr key={fieldKey(field)}>
            <th scope="row">{fieldName(identity, field)}</th>
            {values.map((value, index) => {
              const text = figureText(identity, field, value);
              return (
                <td key={names[index]} class={lastCounts && index < last ? 'earlier' : undefined}>
                  {lastCounts && index === last ? <strong>{text}</strong> : <span>{text}</span>}
                </td>
              );
            })}
            {hasNotes && <td>{note}</td>}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
