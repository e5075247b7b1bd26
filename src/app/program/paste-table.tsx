import type { TimerProgram } from '../../program/index.js';
import { cellFor, INTERVAL_COLUMN, TIME_COLUMN } from '../editing/grid.js';
import type { PastePreview } from '../editing/paste.js';
import { messages } from '../messages/index.js';
import { type GridRow, ProgramGrid } from '../timeline/program-grid.js';

interface PasteTableProps {
  readonly before: TimerProgram;
  readonly after: TimerProgram;
  readonly preview: PastePreview;
}

/** What goes where: the rows and columns that a paste touches, with the new values over the old ones. */
export function PasteTable({ before, after, preview }: PasteTableProps) {
  const places = [...preview.cells, ...preview.problems, ...preview.changes].flatMap(({ field }) => {
    if (!field || field.kind === 'idleThrottle') return [];
    return field.kind === 'interval' ? [{ row: field.slot, column: INTERVAL_COLUMN }] : [cellFor(field)];
  });
  const cells = places.filter((place) => place !== null);
  if (cells.length === 0) return null;
  const isQ = before.identity.timerClass === 'Q';
  // The first time of a Q has the row of the motor stop.
  const rows = new Set<GridRow>(
    cells.map(({ row, column }) => (isQ && row === 0 && column === TIME_COLUMN ? 'motor' : row)),
  );
  return (
    <ProgramGrid
      program={after}
      other={before}
      caption={messages.value.edits.pasting.table}
      columns={[...new Set(cells.map(({ column }) => column))].sort((a, b) => a - b)}
      rows={(row) => rows.has(row)}
      replaces
    />
  );
}
