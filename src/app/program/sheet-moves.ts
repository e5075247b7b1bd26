import { slotKind } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { FIRST_SERVO_COLUMN, type GridCell, INTERVAL_COLUMN, TIME_COLUMN } from '../editing/grid.js';
import { messages } from '../messages/index.js';
import { servoName } from '../messages/names.js';
import { cellOf } from './table-cells.js';

/** A field to which the focus can go. */
export interface Goal {
  readonly input: HTMLInputElement;
  /** How it differs from the present field: a column of the same row, or another row. */
  readonly name: string;
}

/** Where the focus can go: along the row and into the next one, and up and down the column. */
type Goals = Readonly<Record<'before' | 'after' | 'above' | 'below', Goal | null>>;

/** The fields beside a field. */
export function goalsFrom(identity: Identity, from: HTMLInputElement): Goals {
  const inputs = editedIn(from.closest('table'));
  const cell = cellOf(from);
  const column = inputs.filter((input) => cell && cellOf(input)?.column === cell.column);
  const goal = (among: readonly HTMLInputElement[], by: 1 | -1): Goal | null => {
    const input = among[among.indexOf(from) + by];
    return input ? { input, name: nameFrom(identity, from, input) } : null;
  };
  return {
    before: goal(inputs, -1),
    after: goal(inputs, 1),
    above: cell && goal(column, -1),
    below: cell && goal(column, 1),
  };
}

/** The visible fields, in reading order. */
function editedIn(place: Element | null): HTMLInputElement[] {
  return [...(place?.querySelectorAll<HTMLInputElement>('.value > input') ?? [])].filter(
    (input) => input.checkVisibility?.() ?? true,
  );
}

function nameFrom(identity: Identity, from: HTMLInputElement, to: HTMLInputElement): string {
  const cell = cellOf(to);
  if (!cell) return to.getAttribute('aria-label') ?? '';
  return from.closest('tr') === to.closest('tr') ? columnName(cell) : rowName(identity, cell);
}

function columnName({ column }: GridCell): string {
  const { program, edits } = messages.value;
  if (column >= FIRST_SERVO_COLUMN) return servoName(column - FIRST_SERVO_COLUMN);
  return column === INTERVAL_COLUMN ? edits.table.interval : program.time;
}

function rowName(identity: Identity, { row, column }: GridCell): string {
  // The time of the start is the motor stop here, which has its own row.
  if (row === 0 && column === TIME_COLUMN && identity.timerClass === 'Q') return messages.value.program.motor;
  return messages.value.slotShort({ slot: row, kind: slotKind(identity, row) });
}
