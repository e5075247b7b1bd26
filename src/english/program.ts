import { type Finding, type FindingCode, type ProgramField, slotKind } from '../program/index.js';
import type { Hundredths, Identity } from '../protocol/index.js';

/** The name of a slot, counted from 0: `Start`, `Function 1` ..., `DT`. */
export function slotName(identity: Identity, slot: number): string {
  const kind = slotKind(identity, slot);
  if (kind === 'function') return `Function ${slot}`;
  return kind === 'dt' ? 'DT' : 'Start';
}

/** The name of a value: `Function 3`, `DT` and on class Q `Motor stop` for times, `Function 3, S1`, `Idle throttle`. */
export function fieldName(identity: Identity, field: ProgramField): string {
  if (field.kind === 'idleThrottle') return 'Idle throttle';
  const name = slotName(identity, field.slot);
  if (field.kind === 'position') return `${name}, S${field.servo + 1}`;
  return field.slot === 0 && identity.timerClass === 'Q' ? 'Motor stop' : name;
}

/** The facts of a finding, by name, as they are said. */
type Facts = Readonly<Record<string, string>>;

const whole = (): string => 'must be a whole number';
const range = ({ min, max }: Facts): string => `must be ${min} to ${max}`;

const FINDINGS: Readonly<Record<FindingCode, (facts: Facts) => string>> = {
  'time-not-whole': whole,
  'time-out-of-range': range,
  'position-not-whole': whole,
  'position-out-of-range': range,
  'throttle-not-whole': whole,
  'throttle-out-of-range': range,
  'position-as-read': ({ value, max }) => `was read as ${value}, past the last step, ${max}`,
  'time-falls': ({ previous }) => `comes before the function above it (${previous})`,
  'time-repeats': ({ previous }) => `has the same time as the function above it, ${previous}`,
  'position-never-reached': ({ previous }) =>
    `has the same time as the function above it, ${previous}, whose positions are never reached`,
  'motor-stop-after-dt': ({ dt }) => `comes after DT (${dt}): the model comes down with the motor running`,
  'motor-run-long': ({ limit }) => `is later than ${limit}, the longest motor run of F1Q`,
  'time-outside-manual': ({ min, max }) => `is ${min} to ${max} in the manual`,
  'time-too-fine': ({ step }) => `has steps of ${step} in the manual: the timer may round`,
  'dt-short': ({ limit }) => `is shorter than ${limit}`,
  'dt-moves-nothing': () => 'moves no servo: the timer does not bring the model down',
  'throttle-unusual': ({ limit }) => `is more than ${limit}, which is unusual; the unit is not known`,
  'class-unknown': ({ timerClass }) => `The class “${timerClass}” is not known: its rules were not checked`,
};

/** A finding of `checkProgram` as a sentence: `DT is shorter than 60.00 s.` */
export function findingText({ code, field, params }: Finding, identity: Identity): string {
  const say = (value: number | string): string =>
    field?.kind === 'time' && typeof value === 'number' ? inSeconds(value) : String(value);
  const facts = Object.fromEntries(Object.entries(params).map(([name, value]) => [name, say(value)]));
  return `${field ? `${fieldName(identity, field)} ` : ''}${FINDINGS[code](facts)}.`;
}

function inSeconds(time: Hundredths): string {
  return `${(time / 100).toFixed(2)} s`;
}
