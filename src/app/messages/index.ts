import type { TimerError, TimerErrorDetails } from '../../client/index.js';
import {
  type Change,
  type Finding,
  fieldKey,
  fieldsOf,
  type ProgramField,
  slotKind,
  valueAt,
} from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { figureOfTime, formatValue } from '../editing/content.js';
import type { Obstacle } from '../editing/edit.js';
import type { GridField } from '../editing/grid.js';
import type { StepName } from '../editing/history.js';
import type { PasteProblem } from '../editing/paste.js';
import {
  type Ambiguous,
  type Figure,
  formatFigure,
  formatInterval,
  formatTime,
  MINUTE,
  plainSeconds,
  spokenParts,
} from '../editing/units.js';
import { say } from './catalogue.js';
import { formatDate } from './date-format.js';
import { dotted, whole } from './dotted.js';
import { servoName } from './names.js';
import { messages, type Said } from './page.js';
import { isToday } from './today.js';

export { messages, type Said };

export function slotLabel(identity: Identity, slot: number): string {
  return messages.value.slotName({ slot, kind: slotKind(identity, slot) });
}

/** The name of a field: “DT time”, “Motor stop time”, “Function 3, S1”. */
export function fieldLabel(identity: Identity, field: ProgramField): string {
  const { program } = messages.value;
  if (field.kind === 'idleThrottle') return program.idleThrottle;
  const slot = slotLabel(identity, field.slot);
  if (field.kind === 'position') return program.positionOf({ slot, servo: servoName(field.servo) });
  return field.slot === 0 && identity.timerClass === 'Q' ? program.motorStopTime : program.timeOf({ slot });
}

/** Where a sentence is about one field: “DT”, “Motor stop”, “Function 3 time”, “Function 3, S1”. */
export function fieldName(identity: Identity, field: ProgramField): string {
  const { program } = messages.value;
  if (field.kind !== 'time') return fieldLabel(identity, field);
  if (field.slot === 0 && identity.timerClass === 'Q') return program.motorStop;
  return field.slot === identity.functions ? program.dt : fieldLabel(identity, field);
}

/** The same inside a sentence: “DT”, “motor stop”, “function 3 time”, “function 3, S1”. */
export function fieldInSentence(identity: Identity, field: ProgramField): string {
  const { program, within, knowledge } = messages.value;
  if (field.kind === 'idleThrottle') return within.idleThrottle;
  const slot = slotInSentence(identity, field.slot);
  if (field.kind === 'position') return program.positionOf({ slot, servo: servoName(field.servo) });
  if (field.slot === 0 && identity.timerClass === 'Q') return knowledge.motorStop;
  return field.slot === identity.functions ? program.dt : program.timeOf({ slot });
}

/** The name of a slot inside a sentence: “function 3”, “start”, “DT”. */
export function slotInSentence(identity: Identity, slot: number): string {
  return messages.value.within.slot({ slot, kind: slotKind(identity, slot) });
}

/** Several slots, in one line: “start, functions 5 to 9, DT”. @param first the name of slot 0. */
export function slotsText({ functions }: Identity, slots: readonly number[], first: string): string {
  const { program } = messages.value;
  const between = slots.filter((slot) => slot > 0 && slot < functions);
  return [slots.includes(0) && first, functionsText(between), slots.includes(functions) && program.dt]
    .filter(Boolean)
    .join(', ');
}

/** “function 3”, “functions 5 to 9”: usually they follow each other. Empty for none. */
function functionsText(numbers: readonly number[]): string {
  const { shift: words } = messages.value.edits;
  const [first] = numbers;
  const last = numbers.at(-1);
  if (first === undefined || last === undefined) return '';
  if (first === last) return words.function({ number: first });
  if (last - first + 1 === numbers.length) return words.functionRange({ first, last });
  return words.functions({ numbers: numbers.join(', ') });
}

/** A time in spoken form: “2 min 30 s”, “20 s”, “2.3 s”. Before launch with a minus. */
export function spokenTime(hundredths: number): string {
  const { minutes, seconds } = spokenParts(Math.abs(hundredths));
  const { times, seconds: secondsOnly } = messages.value;
  const wholeMinutes = seconds === '0' ? times.minutes({ minutes }) : times.minutesSeconds({ minutes, seconds });
  const said = minutes > 0 ? wholeMinutes : secondsOnly({ time: seconds });
  return hundredths < 0 ? `-${said}` : said;
}

/** A time as it is typed: “0.50 s”, “3:00”. */
export function secondsText(time: string): string {
  return time.includes(':') ? time : messages.value.seconds({ time });
}

/** The possible meanings of a text, to choose from: “2 min 30 s” and “2.3 s”, or “230 s, 3:50”. */
export function eitherTexts(either: Ambiguous['either']): readonly string[] {
  const asSeconds = either.length - 1;
  return either.map((value, at) =>
    at < asSeconds || Math.abs(value) < MINUTE
      ? spokenTime(value)
      : messages.value.times.asSeconds({ seconds: plainSeconds(value), clock: formatInterval(value) }),
  );
}

/**
 * A value as a large figure, with its unit apart. For a value that is no time, or an impossible one, the whole text.
 */
export function figureOf(
  identity: Identity,
  field: ProgramField,
  value: number,
): Figure | { readonly text: string; readonly unit: null } {
  if (field.kind !== 'time' || !Number.isInteger(value) || value < 0)
    return { text: formatValue(identity, field, value), unit: null };
  return figureOfTime(identity, field.slot, value);
}

/** A value as a large figure: “10.0 s”, “3:00 min”, “65”, or that it is not known. */
export function figureText(identity: Identity, field: ProgramField, value: number | null): string {
  if (value === null) return messages.value.write.status.unknown;
  const { text, unit } = figureOf(identity, field, value);
  return unit ? inUnit({ text, unit }) : text;
}

/** A DT on a button: “20 s”, “3 min”, “1:30 min”. */
export function presetText(value: number): string {
  if (value % MINUTE === 0) return spokenTime(value);
  return inUnit(formatFigure(value, 100));
}

/** The DT of a program: “20 s”, “3:00 min”. */
export function dtText(value: number): string {
  return inUnit(formatFigure(value, 100));
}

/** A moment of a flight: “10.60 s”, “3:00 min”. */
export function momentText(hundredths: number): string {
  return withUnit(formatTime(hundredths));
}

/** A time with its unit: “3:00 min”, “0.50 s”. */
function withUnit(text: string): string {
  return inUnit({ text, unit: text.includes(':') ? 'min' : 's' });
}

function inUnit({ text, unit }: Figure): string {
  const { figure, units } = messages.value.times;
  return figure({ text, unit: units[unit] });
}

/** What ended a job with the timer, with the facts that the error gives. */
export function timerSaid({ code, details }: Pick<TimerError, 'code' | 'details'>): Said {
  const { timer, alike } = messages.value;
  if (!details.alike || !details.request) return timer[code];
  return { title: alike.title({ request: details.request }), advice: alike.advice };
}

/** What could be read of a program, in one line; null when nothing could. */
export function partText({ part }: TimerErrorDetails): string | null {
  if (!part) return null;
  const { identity, times = [], positions = [] } = part;
  const program = { ...part, times, positions, idleThrottle: null };
  const known = fieldsOf(identity).flatMap((field) => {
    const value = valueAt(program, field);
    return value === null ? [] : [`${fieldName(identity, field)} ${figureText(identity, field, value)}`];
  });
  return dotted(known);
}

/** The sentence for a finding of the check, with times as a pilot writes them. */
export function findingText({ code, params, field }: Finding): string {
  const isTime = field?.kind === 'time';
  const { findings } = messages.value;
  const shown = Object.entries(params).map(([name, value]): [string, string] => [
    name,
    isTime && typeof value === 'number' ? whole(momentText(value)) : String(value),
  ]);
  return say(findings[code], Object.fromEntries(shown));
}

/** The name of a cell in the table, intervals included. */
export function gridLabel(identity: Identity, field: GridField): string {
  if (field.kind !== 'interval') return fieldName(identity, field);
  return messages.value.edits.table.intervalOf({ slot: slotLabel(identity, field.slot) });
}

/** Readable bytes as text, the others as dots. */
export function readable(bytes: Uint8Array): string {
  return Array.from(bytes, (byte) => (byte >= 0x20 && byte < 0x7f ? String.fromCharCode(byte) : '·')).join('');
}

/** A day and a time of day, in the form of this language. */
export function dateText(time: number): string {
  return formatDate({ dateStyle: 'medium', timeStyle: 'short' }, time);
}

/** For today the hour and minute, for any other day the day alone: “12 Nov”, “12 Nov 2025”. */
export function dayText(time: number): string {
  const day = new Date(time);
  const now = new Date();
  if (isToday(day)) return clockText(time);
  const year = day.getFullYear() === now.getFullYear() ? {} : ({ year: 'numeric' } as const);
  return formatDate({ day: 'numeric', month: 'short', ...year }, time);
}

/** For today the hour and minute, for any other day also the day. */
export function clockText(time: number): string {
  return isToday(new Date(time)) ? formatDate({ timeStyle: 'short' }, time) : dateText(time);
}

/** A value inside a sentence: “3:00”, “10.0 s”, “65”, or that it is not known. */
export function valueText(identity: Identity, field: ProgramField, value: number | null): string {
  if (value === null) return messages.value.write.status.unknown;
  const { text, unit } = figureOf(identity, field, value);
  return unit === 's' ? inUnit({ text, unit }) : text;
}

/** The name of a step: “shift from function 3 by 0.50 s”. */
export function stepText(identity: Identity, { code, params }: StepName): string {
  const { edits } = messages.value;
  const { by, count, from } = params;
  return say(edits.steps[code === 'step-servo' && from ? 'step-servo-from' : code], {
    what: subjectText(identity, params),
    by: secondsText(formatInterval(Number(by))),
    steps: signed(Number(by)),
    from: from ? slotInSentence(identity, Number(from)) : '',
    count: edits.cells({ count: Number(count) }),
  });
}

/** A number of steps up or down: “+3”, “−3”. */
export function signed(steps: number): string {
  return `${steps < 0 ? '−' : '+'}${Math.abs(steps)}`;
}

/** What a step was done to: a field, a row, some values, or what was opened. */
function subjectText(identity: Identity, params: StepName['params']): string {
  const { field, slot, count, to, servo = to, name = '' } = params;
  const { edits } = messages.value;
  const found = fieldsOf(identity).find((each) => fieldKey(each) === field);
  if (found) return fieldInSentence(identity, found);
  if (typeof slot === 'number') return slotInSentence(identity, slot);
  // In a draft of an earlier version also one that was changed, or copied to.
  if (typeof servo === 'number') return servoName(servo);
  if (typeof count === 'number') return edits.cells({ count });
  return name === '' ? edits.openedUnnamed : edits.opened({ name });
}

/** The sentence that says why an edit was not done. */
export function obstacleText(identity: Identity, obstacle: Obstacle): string {
  const { edits, about } = messages.value;
  const where = about({ name: fieldName(identity, obstacle.field) });
  if (obstacle.code === 'unreadable') return `${where} ${edits.refused.unreadable}`;
  if (obstacle.field.kind === 'time' && obstacle.params.value < 0) return `${where} ${edits.beforeLaunch}`;
  return `${where} ${reasonText(obstacle.code, obstacle.params, obstacle.field.kind === 'time')}`;
}

/** The sentence that says what is wrong with a pasted cell. */
export function pasteProblemText({ code, params, field }: PasteProblem): string {
  return reasonText(code, params, field !== null && field.kind !== 'position');
}

/** Each reason stands in one place: with the checks, the fields, or the edits. */
function reasonText(
  code: Exclude<Obstacle['code'], 'unreadable'> | PasteProblem['code'],
  params: Readonly<Record<string, number>>,
  isTime: boolean,
): string {
  const { findings, unreadable, edits } = messages.value;
  const figure = (value: number): string => (isTime ? whole(withUnit(formatInterval(value))) : String(value));
  const shown = Object.fromEntries(Object.entries(params).map(([name, value]) => [name, figure(value)]));
  if (code in edits.refused) return say(edits.refused[code as keyof typeof edits.refused], shown);
  if (code in unreadable) return unreadable[code as keyof typeof unreadable];
  return say(findings[code as keyof typeof findings], shown);
}

/** A difference in words: “DT: 3:00 min → 6:00 min”. */
export function changeText(identity: Identity, { field, from, to }: Change): string {
  const { edits, write } = messages.value;
  const shown = (value: number | null): string =>
    value === null ? write.status.unknown : figureText(identity, field, value);
  return edits.change({ field: fieldName(identity, field), from: whole(shown(from)), to: whole(shown(to)) });
}

/** “DT of M1 is 20 s.” @param memory null where the timer does not say which one is current. */
export function shortDtText(memory: string | null, dt: string): string {
  const { shortDt } = messages.value;
  return memory === null ? shortDt.heldHere({ dt: whole(dt) }) : shortDt.held({ memory, dt: whole(dt) });
}
