import { type TimerProgram, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import {
  cellFor,
  FIRST_SERVO_COLUMN,
  type GridField,
  gridField,
  INTERVAL_COLUMN,
  intervalAt,
  TIME_COLUMN,
} from '../editing/grid.js';
import type { PastePreview } from '../editing/paste.js';
import { formatInterval } from '../editing/units.js';
import { figureText, messages, slotLabel } from '../messages/index.js';
// A paste looks like a write: what it changes stands over what it replaces.
import '../write/comparison-grid.css';

interface PasteTableProps {
  readonly before: TimerProgram;
  readonly after: TimerProgram;
  readonly preview: PastePreview;
}

interface Row {
  readonly key: string;
  readonly name: string;
  readonly fields: readonly (GridField | null)[];
}

/** What goes where: the rows and columns that a paste touches, with the new values over the old ones. */
export function PasteTable({ before, after, preview }: PasteTableProps) {
  const { program, edits } = messages.value;
  const { identity } = before;
  const places = [...preview.cells, ...preview.problems, ...preview.changes].flatMap(({ field }) => {
    if (!field || field.kind === 'idleThrottle') return [];
    return field.kind === 'interval' ? [{ row: field.slot, column: INTERVAL_COLUMN }] : [cellFor(field)];
  });
  const cells = places.filter((place) => place !== null);
  if (cells.length === 0) return null;
  const columns = [...new Set(cells.map(({ column }) => column))].sort((a, b) => a - b);
  const pasted = new Set(preview.cells.map(({ field }) => keyOf(field)));
  return (
    <div class="comparison-grid replaces">
      <table>
        <caption class="visually-hidden">{edits.pasting.table}</caption>
        <thead>
          <tr>
            {[program.slot, ...columns.map(columnName)].map((name) => (
              <th scope="col" key={name}>
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rowsOf(identity, columns, cells).map(({ key, name, fields }) => (
            <tr key={key} class={key === 'motor' ? 'motor-stop' : ''}>
              <th scope="row">{name}</th>
              {fields.map((field, at) => (
                <Cell
                  key={columns[at]}
                  {...{ before, after, field }}
                  isPasted={field !== null && pasted.has(keyOf(field))}
                />
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function columnName(column: number): string {
  const { program, edits, servoName } = messages.value;
  if (column === TIME_COLUMN) return program.time;
  return column === INTERVAL_COLUMN ? edits.table.interval : servoName(column - FIRST_SERVO_COLUMN);
}

function keyOf(field: GridField): string {
  return `${field.kind} ${field.slot} ${field.kind === 'position' ? field.servo : ''}`;
}

/** The motor stop of a Q has a row of its own, as in the table of the program. */
function rowsOf(
  identity: Identity,
  columns: readonly number[],
  cells: readonly { row: number; column: number }[],
): Row[] {
  const isQ = identity.timerClass === 'Q';
  const slots = [...new Set(cells.map(({ row }) => row))].sort((a, b) => a - b);
  return slots.flatMap((row): Row[] => {
    const fields = columns.map((column) => gridField(identity, { row, column }));
    if (row > 0 || !isQ) return [{ key: String(row), name: slotLabel(identity, row), fields }];
    const isTouched = (wanted: (column: number) => boolean): boolean =>
      cells.some((cell) => cell.row === 0 && wanted(cell.column));
    const only = (kind: GridField['kind']) => fields.map((field) => (field?.kind === kind ? field : null));
    const motor = { key: 'motor', name: messages.value.program.motorStop, fields: only('time') };
    const start = { key: '0', name: slotLabel(identity, 0), fields: only('position') };
    return [
      ...(isTouched((column) => column === TIME_COLUMN) ? [motor] : []),
      ...(isTouched((column) => column >= FIRST_SERVO_COLUMN) ? [start] : []),
    ];
  });
}

interface CellProps extends Pick<PasteTableProps, 'before' | 'after'> {
  readonly field: GridField | null;
  readonly isPasted: boolean;
}

/** Empty where nothing is pasted and nothing moves. */
function Cell({ before, after, field, isPasted }: CellProps) {
  if (!field) return <td />;
  const [was, is] = [before, after].map((program) => textOf(program, field));
  if (was === is) return <td>{isPasted ? is : ''}</td>;
  return (
    <td class="differs">
      {is} <small>{was}</small>
    </td>
  );
}

function textOf(program: TimerProgram, field: GridField): string {
  if (field.kind === 'interval') return formatInterval(intervalAt(program, field.slot) ?? 0);
  return figureText(program.identity, field, valueAt(program, field) ?? 0);
}
