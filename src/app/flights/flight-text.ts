import { sameLayout, type TimerProgram } from '../../program/index.js';
import { changesSince } from '../editing/content.js';
import { formatFigure } from '../editing/units.js';
import { formatDate } from '../messages/date-format.js';
import { dotted } from '../messages/dotted.js';
import { changeText, messages } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import { deviceOffset, offsetText, onClock, timeOfDay, type When } from './flight-list.js';

/** A result as a large figure: “2:58 min”, “40.5 s”. */
export function resultText(seconds: number): string {
  const { text, unit } = formatFigure(Math.round(seconds * 100), 100);
  const { figure, units } = messages.value.times;
  return figure({ text, unit: units[unit] });
}

/** “Round 3”, “Fly-off”: a number, or the pilot's own word. */
export function roundText(round: string): string {
  if (/^\d/.test(round)) return moreMessages.value.flights.row.round({ round });
  return `${round.charAt(0).toUpperCase()}${round.slice(1)}`;
}

/** The memory and the figures of a program that a timer holds: “M1 · DT 3:00 min · motor stop 10.0 s”. */
export function heldText(program: TimerProgram): string {
  const { memory } = program;
  const figures = keyFigures(program).map(({ label, text }) => `${label} ${text}`);
  return dotted([memory === null ? null : memoryName(memory), ...figures]);
}

/** So many changes are named; of more, only their number. */
const NAMED = 2;

/** What changed since the flight before: “DT: 3:00 min → 3:30 min”, “3 values changed”. Empty when nothing did. */
export function changedText(before: TimerProgram, flown: TimerProgram): string {
  const { row } = moreMessages.value.flights;
  const { identity } = flown;
  if (!sameLayout(before.identity, identity)) return row.otherTimer;
  const changes = changesSince(before, flown);
  if (changes.length > NAMED) return row.changed({ values: messages.value.edits.cells({ count: changes.length }) });
  return dotted(changes.map((change) => changeText(identity, change)));
}

/** A day as the heading of a group: “Sun 22 Nov 2026”. */
export function dayHeading(when: When): string {
  const day = { weekday: 'short', day: 'numeric', month: 'short', year: 'numeric', timeZone: 'UTC' } as const;
  return formatDate(day, onClock(when).getTime());
}

/** A time of day, with its offset where this device has another one: “06:30 UTC+08:00”. */
export function clockOf(when: When): string {
  const isOurs = when.utcOffset === undefined || when.utcOffset === deviceOffset(when.at);
  return isOurs ? timeOfDay(when) : `${timeOfDay(when)} ${offsetText(when)}`;
}
