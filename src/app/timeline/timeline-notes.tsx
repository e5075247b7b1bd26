import type { TimerProgram } from '../../program/index.js';
import { messages, slotInSentence, slotLabel } from '../messages/index.js';
import { stagesOf } from './flight.js';
import './timeline-notes.css';

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
        ? timeline.goesBack({ next: slotLabel(identity, slot + 1), slot: slotInSentence(identity, slot) })
        : timeline.passedOver({ slot: slotLabel(identity, slot), next: slotInSentence(identity, slot + 1) });
    });
  if (notes.length === 0) return null;
  return (
    <ul class="stack gap-1 timeline-notes">
      {notes.slice(0, MOST_NOTES).map((note) => (
        <li key={note}>{note}</li>
      ))}
      {notes.length > MOST_NOTES && <li>{messages.value.more({ count: notes.length - MOST_NOTES })}</li>}
    </ul>
  );
}

/** Whether a slot has other positions than the next one. */
function changes({ positions }: TimerProgram, slot: number): boolean {
  return positions.some((row) => row[slot] !== row[slot + 1]);
}
