import { useSignal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import { formatTime } from '../editing/units.js';
import { messages, slotLabel } from '../messages/index.js';
import { motorStopOf, stagesOf } from './preview/flight.js';

/** The picture as a table: when each function begins and ends, and where the servos stand meanwhile. Made when it is opened. */
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
        // With many servos it scrolls, by the keyboard too.
        <section class="timeline-scroll" tabindex={0} aria-label={messages.value.timeline.tableCaption}>
          <Stages program={program} />
        </section>
      )}
    </details>
  );
}

function Stages({ program }: { program: TimerProgram }) {
  const { timeline, servoName, program: words, seconds } = messages.value;
  const { identity, positions } = program;
  const stop = motorStopOf(program);
  const time = (hundredths: number): string => seconds(formatTime(hundredths));
  return (
    <table>
      <caption class="visually-hidden">{timeline.tableCaption}</caption>
      <thead>
        <tr>
          <th scope="col">{words.slot}</th>
          <th scope="col">{timeline.from}</th>
          <th scope="col">{timeline.until}</th>
          {positions.map((_, servo) => (
            <th scope="col" key={servoName(servo)}>
              {servoName(servo)}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {stagesOf(program).map(({ slot, from, until, passing }) => (
          <tr key={slot}>
            <th scope="row">{slotLabel(identity, slot)}</th>
            <td>{time(from)}</td>
            <td>{passing === 'held' ? until !== null && time(until) : timeline.passing[passing]}</td>
            {positions.map((row, servo) => (
              <td key={servoName(servo)}>{row[slot]}</td>
            ))}
          </tr>
        ))}
        {stop !== null && (
          <tr>
            <th scope="row">{timeline.motorRuns}</th>
            <td>{time(0)}</td>
            <td>{time(stop)}</td>
            <td colSpan={positions.length} />
          </tr>
        )}
      </tbody>
    </table>
  );
}

/** More of these are counted and not listed. */
const MOST_NOTES = 3;

/** What the picture shows that is not plain: functions that are passed over, and times that fall. */
export function TimelineNotes({ program }: { program: TimerProgram }) {
  const { timeline } = messages.value;
  const { identity } = program;
  const notes = stagesOf(program)
    .filter(({ slot, passing }) => passing === 'back' || (passing === 'passed' && changes(program, slot)))
    .map(({ slot, passing }) => {
      const [here, next] = [slotLabel(identity, slot), slotLabel(identity, slot + 1)] as const;
      return passing === 'back' ? timeline.goesBack(next, here) : timeline.passedOver(here, next);
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

/** Whether a slot has other positions than the one after it. */
function changes({ positions }: TimerProgram, slot: number): boolean {
  return positions.some((row) => row[slot] !== row[slot + 1]);
}
