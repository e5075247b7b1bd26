import { useSignal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import { formatTime } from '../editing/units.js';
import { messages, slotInSentence, slotLabel } from '../messages/index.js';
import { SlotTable } from '../ui/slot-table.js';
import { motorStopOf, stagesOf } from './flight.js';
import './timeline-table.css';

/**
 * The picture as a table: when each function begins and ends, and the positions of the servos.
 * Made only when it is opened.
 */
export function TimelineTable({ program }: { program: TimerProgram }) {
  const open = useSignal(false);
  return (
    <details
      class="timeline-table"
      onToggle={(event) => {
        open.value = event.currentTarget.open;
      }}
    >
      <summary>{messages.value.timeline.asTable}</summary>
      {open.value && (
        // With many servos it scrolls, also by keyboard.
        <section class="timeline-scroll" tabindex={0} aria-label={messages.value.timeline.tableCaption}>
          <Stages program={program} />
        </section>
      )}
    </details>
  );
}

function Stages({ program }: { program: TimerProgram }) {
  const { timeline, seconds } = messages.value;
  const stop = motorStopOf(program);
  const time = (hundredths: number): string => seconds(formatTime(hundredths));
  return (
    <SlotTable
      program={program}
      caption={timeline.tableCaption}
      headings={[timeline.from, timeline.until]}
      rows={stagesOf(program).map(({ slot, from, until, passing }) => ({
        slot,
        cells: [time(from), passing === 'held' ? until !== null && time(until) : timeline.passing[passing]],
      }))}
    >
      {stop !== null && (
        <tr>
          <th scope="row">{timeline.motorRuns}</th>
          <td>{time(0)}</td>
          <td>{time(stop)}</td>
          <td colSpan={program.positions.length} />
        </tr>
      )}
    </SlotTable>
  );
}

/** Further ones are only counted. */
const MOST_NOTES = 3;

/** Notes on what the picture shows and is not plain: functions that are skipped, and times that fall. */
export function TimelineNotes({ program }: { program: TimerProgram }) {
  const { timeline } = messages.value;
  const { identity } = program;
  const notes = stagesOf(program)
    .filter(({ slot, passing }) => passing === 'back' || (passing === 'passed' && changes(program, slot)))
    .map(({ slot, passing }) => {
      return passing === 'back'
        ? timeline.goesBack(slotLabel(identity, slot + 1), slotInSentence(identity, slot))
        : timeline.passedOver(slotLabel(identity, slot), slotInSentence(identity, slot + 1));
    });
  if (notes.length === 0) return null;
  return (
    <ul class="timeline-notes">
      {notes.slice(0, MOST_NOTES).map((note) => (
        <li key={note}>{note}</li>
      ))}
      {notes.length > MOST_NOTES && <li>{timeline.more(notes.length - MOST_NOTES)}</li>}
    </ul>
  );
}

/** Whether a slot has other positions than the next one. */
function changes({ positions }: TimerProgram, slot: number): boolean {
  return positions.some((row) => row[slot] !== row[slot + 1]);
}
