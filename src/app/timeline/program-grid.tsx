import type { ComponentChildren } from 'preact';
import { type ProgramField, slotKind, type TimerProgram, valueAt } from '../../program/index.js';
import {
  FIRST_SERVO_COLUMN,
  type GridField,
  gridField,
  INTERVAL_COLUMN,
  intervalAt,
  motorRow,
  TIME_COLUMN,
} from '../editing/grid.js';
import { formatInterval } from '../editing/units.js';
import { figureText, messages, slotLabel } from '../messages/index.js';
import { servoName } from '../messages/names.js';
import './program-grid.css';

/** A slot, or one of the two values that have a row of their own. */
export type GridRow = number | 'motor' | 'idle';

/** What a cell shows: a value of the program, or an interval. */
export type GridValue = ProgramField | GridField;

export interface ProgramGridProps {
  readonly program: TimerProgram;
  readonly caption: string;
  /** The columns of the grid, as in the table on the screen. Default: the times and all servos. */
  readonly columns?: readonly number[];
  /** Default: all. */
  readonly rows?: ((row: GridRow) => boolean) | undefined;
  /** What each servo moves; empty texts otherwise. */
  readonly uses?: readonly string[];
  /** Another program: where it differs, its value stands below. */
  readonly other?: TimerProgram;
  /** The names of the two programs. */
  readonly names?: readonly [string, string];
  /** Whether the values of the other program will go. */
  readonly replaces?: boolean;
  /** The text below a value; empty for none. Default: the value of the other program. */
  readonly below?: (value: GridValue) => string;
  /** The heading above the names of the rows. */
  readonly corner?: string;
  /** The slot where the servos stand. */
  readonly lit?: number | null;
  /** The heading of a row. Default: its name. */
  readonly headOf?: (row: GridRow, name: string) => ComponentChildren;
}

/** A program to read: a row for each slot and for the motor stop, in the order of time. */
export function ProgramGrid({ program, caption, rows, uses, names, replaces = false, lit, ...more }: ProgramGridProps) {
  const { program: words } = messages.value;
  const { identity } = program;
  const { columns = [TIME_COLUMN, ...program.positions.map((_, servo) => FIRST_SERVO_COLUMN + servo)] } = more;
  const { other = program, corner = words.slot, headOf = (_, name) => name } = more;
  const { below = (value) => (textOf(other, value) === textOf(program, value) ? '' : textOf(other, value)) } = more;
  const nameOf = (row: GridRow): string => {
    if (row === 'motor') return words.motorStop;
    return row === 'idle' ? words.idleThrottle : slotLabel(identity, row);
  };
  const all = rowsOf(program);
  // A program alone has it beside its grid. A paste of a copied grid would not know it.
  if (other !== program && (program.idleThrottle ?? other.idleThrottle) !== null) all.push('idle');
  return (
    <div class={`program-grid ${replaces ? 'replaces' : ''}`}>
      <table class="value-grid">
        <caption class="visually-hidden">{caption}</caption>
        <thead>
          <tr>
            <th scope="col">{names ? <Two upper={names[0]} lower={names[1]} /> : corner}</th>
            {columns.map((column) => (
              <th scope="col" key={column}>
                <Two upper={headingOf(column, servoName)} lower={uses?.[column - FIRST_SERVO_COLUMN] ?? ''} />
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {all.filter(rows ?? (() => true)).map((row) => (
            <tr
              key={row}
              class={`${typeof row === 'number' ? slotKind(identity, row) : row} ${row === lit ? 'here' : ''}`}
            >
              <th scope="row">{headOf(row, nameOf(row))}</th>
              {columns.map((column) => {
                const value = valueIn(program, other, row, column);
                const text = value ? textOf(program, value) : row === 0 && column === TIME_COLUMN ? '0' : '';
                return <Cell key={column} text={text} below={value ? below(value) : ''} names={names} />;
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function headingOf(column: number, servoName: (servo: number) => string): string {
  const { program, edits } = messages.value;
  if (column === TIME_COLUMN) return program.time;
  return column === INTERVAL_COLUMN ? edits.table.interval : servoName(column - FIRST_SERVO_COLUMN);
}

function rowsOf(program: TimerProgram): GridRow[] {
  const rows: GridRow[] = program.times.map((_, slot) => slot);
  const motor = motorRow(program);
  if (motor !== null) rows.splice(motor, 0, 'motor');
  return rows;
}

/** The first time is that of the motor stop, or has no meaning: then it stands at the start only where it differs. */
function valueIn(
  { identity, times }: TimerProgram,
  other: TimerProgram,
  row: GridRow,
  column: number,
): GridValue | null {
  if (row === 'motor') return column === TIME_COLUMN ? { kind: 'time', slot: 0 } : null;
  if (row === 'idle') return column === TIME_COLUMN ? { kind: 'idleThrottle' } : null;
  const isSame = identity.timerClass === 'Q' || times[0] === other.times[0];
  return row === 0 && column === TIME_COLUMN && isSame ? null : gridField(identity, { row, column });
}

function textOf(program: TimerProgram, value: GridValue): string {
  if (value.kind === 'interval') return formatInterval(intervalAt(program, value.slot) ?? 0);
  const number = valueAt(program, value);
  return figureText(program.identity, value, number);
}

/** A word, and a smaller one below it. */
function Two({ upper, lower }: { readonly upper: string; readonly lower: string }) {
  if (lower === '') return <>{upper}</>;
  return (
    <>
      {upper} <small>{lower}</small>
    </>
  );
}

interface CellProps {
  readonly text: string;
  /** Empty for none. */
  readonly below: string;
  readonly names: readonly [string, string] | undefined;
}

function Cell({ text, below, names }: CellProps) {
  if (below === '') return <td>{text}</td>;
  return (
    <td class="differs">
      {names && <span class="visually-hidden">{names[0]} </span>}
      {text} {names && <span class="visually-hidden">{names[1]} </span>}
      <small>{below}</small>
    </td>
  );
}
