import type { ComponentChildren } from 'preact';
import type { TimerProgram } from '../../program/index.js';
import { formatTime, MINUTE } from '../editing/units.js';
import { messages, slotLabel } from '../messages/index.js';
import { SlotHead } from './slot-head.js';
import './slot-table.css';

interface SlotRow {
  readonly slot: number;
  /** The unit of its figures where it is not that of the heading. It stands beside the name. */
  readonly unit?: string | null;
  readonly cells: readonly ComponentChildren[];
}

interface SlotTableProps {
  readonly program: TimerProgram;
  readonly caption: string;
  /** The headings between the name of a slot and its positions. */
  readonly headings: readonly string[];
  readonly rows: readonly SlotRow[];
  /** Further rows. */
  readonly children?: ComponentChildren;
}

/** A table of slots with their positions, to read only. */
export function SlotTable({ program, caption, headings, rows, children }: SlotTableProps) {
  const { program: words, servoName } = messages.value;
  const { identity, positions } = program;
  const servos = positions.map((_, servo) => servoName(servo));
  return (
    <table class="slot-table">
      <caption class="visually-hidden">{caption}</caption>
      <SlotHead slot={words.slot} headings={headings} servos={identity.servos} />
      <tbody>
        {rows.map(({ slot, unit, cells }) => (
          <tr key={slot}>
            <th scope="row">
              {slotLabel(identity, slot)}
              {unit && <span class="slot-unit"> {unit}</span>}
            </th>
            {cells.map((cell, index) => (
              <td key={headings[index]}>{cell}</td>
            ))}
            {positions.map((row, servo) => (
              <td key={servos[servo]}>{row[slot]}</td>
            ))}
          </tr>
        ))}
        {children}
      </tbody>
    </table>
  );
}

/**
 * A table of a whole program, to read only: when each function comes, and the positions.
 * The motor stop stands beside it.
 */
export function TimesTable({ program, caption }: Pick<SlotTableProps, 'program' | 'caption'>) {
  const { program: words, times } = messages.value;
  const heading = `${words.time}\u00a0${times.units.s}`;
  const rows = program.times.map((time, slot) => ({
    slot,
    unit: slot === 0 || time < MINUTE ? null : times.units.min,
    cells: [slot === 0 ? '0' : formatTime(time)],
  }));
  return <SlotTable program={program} caption={caption} headings={[heading]} rows={rows} />;
}
