import type { FindingCode } from '../../program/index.js';
import type { UnreadableReason } from '../editing/units.js';

type Params = Readonly<Record<string, string>>;

const NO_WHOLE_NUMBER = 'It must be a whole number.';
const whole = (): string => NO_WHOLE_NUMBER;
const range = ({ min, max }: Params): string => `It must be ${min} to ${max}.`;

/** Values that are unusual, or cannot be written. */
export const findings: Record<FindingCode, (params: Params) => string> = {
  'time-not-whole': whole,
  'time-out-of-range': range,
  'position-not-whole': whole,
  'position-out-of-range': range,
  'throttle-not-whole': whole,
  'throttle-out-of-range': range,
  'position-as-read': ({ value, max }) =>
    `Read as ${value}, above the last step, ${max}. It stays as it is unless you change it.`,
  'time-falls': ({ previous }) => `This comes before the function above it (${previous}).`,
  'time-repeats': ({ previous }) => `The same time as the function above it, ${previous}.`,
  'position-never-reached': ({ previous }) =>
    `The same time as the function above it, ${previous}. The positions of the function above are never reached.`,
  'motor-stop-after-dt': ({ dt }) => `The motor stops after DT (${dt}): the model comes down with the motor running.`,
  'motor-run-long': ({ limit }) => `The motor runs longer than ${limit}, the limit for F1Q.`,
  'time-outside-manual': ({ min, max }) => `The manual allows ${min} to ${max}.`,
  'time-too-fine': ({ step }) => `The manual gives steps of ${step}: the timer may round.`,
  'dt-short': ({ limit }) => `Shorter than ${limit}.`,
  'dt-moves-nothing': () => 'No servo moves at DT: the timer does not bring the model down.',
  'throttle-unusual': ({ limit }) => `More than ${limit} is unusual. The unit is not known.`,
  'class-unknown': ({ timerClass }) => `The class “${timerClass}” is not known: its rules were not checked.`,
};

/** Why a text in a field is no value. */
export const unreadable: Record<UnreadableReason, string> = {
  empty: 'Empty: type a value.',
  'not-a-time': 'Not a time: type seconds like 12.5, or minutes like 2:05.',
  'too-fine': 'Finer than a hundredth of a second.',
  'not-a-whole-number': NO_WHOLE_NUMBER,
  ambiguous: 'This can be read in several ways: choose one.',
};
