import { type Identity, MAX_TIME, slotCount } from '../protocol/index.js';
import { identityOf, requireProgram } from './library.js';
import { slotKind, type TimerProgram } from './program.js';
import { LAST_DATE, list, record, refuse, requireCount, whole, word } from './require.js';

/* How a program and a date are written in a file: in the words of a pilot, and without any loss. */

/** One row of a program, as in the table on the page. */
interface Row {
  readonly slot: string;
  readonly time?: string;
  readonly positions: readonly number[];
}

/** What the time of slot 0 is called in a file: the motor stop on class Q, reserved on the others. */
function startTime({ timerClass }: Identity): 'motorStop' | 'reserved' {
  return timerClass === 'Q' ? 'motorStop' : 'reserved';
}

export function programToFile({ identity, memory, times, positions, idleThrottle }: TimerProgram): object {
  const [first = 0] = times;
  const { timerClass, firmware, functions, memories, servos } = identity;
  return {
    identity: { timerClass, firmware, functions, memories, servos },
    memory: memory === null ? null : memoryName(memory),
    [startTime(identity)]: timeToFile(first),
    idleThrottle,
    slots: times.map(
      (time, slot): Row => ({
        slot: slotName(identity, slot),
        ...(slot === 0 ? {} : { time: timeToFile(time) }),
        positions: positions.map((row) => row[slot] as number),
      }),
    ),
  };
}

/** @throws CodecError whose field is the place in the file. */
export function programFromFile(value: unknown, path: string): TimerProgram {
  const of = record<{ identity: 0; memory: 0; motorStop: 0; reserved: 0; idleThrottle: 0; slots: 0 }>(value, path);
  const identity = identityOf(of.identity, path);
  const count = slotCount(identity);
  const rows = list(of.slots, `${path}.slots`, count).map((row, slot) => rowOf(row, `${path}.slots[${slot}]`, slot));
  requireCount(rows, `${path}.slots`, count);
  const start = startTime(identity);
  return requireProgram(
    {
      identity,
      memory: memoryOf(of.memory, `${path}.memory`, identity),
      times: rows.map(({ time }, slot) => (slot === 0 ? timeFromFile(of[start], `${path}.${start}`) : time)),
      positions: Array.from({ length: identity.servos }, (_, servo) => rows.map(({ positions }) => positions[servo])),
      idleThrottle: of.idleThrottle,
    },
    path,
  );

  function rowOf(row: unknown, at: string, slot: number): { time: number; positions: readonly number[] } {
    const { slot: name, time, positions } = record<Row>(row, at);
    const wanted = slotName(identity, slot);
    if (name !== wanted) refuse('unknown-word', `${at}.slot`, `“${wanted}”`, name);
    const steps = list(positions, `${at}.positions`, identity.servos);
    requireCount(steps, `${at}.positions`, identity.servos);
    return {
      time: slot === 0 ? 0 : timeFromFile(time, `${at}.time`),
      positions: steps.map((step, servo) => whole(step, `${at}.positions[${servo}]`, 0, 255)),
    };
  }
}

function slotName(identity: Identity, slot: number): string {
  const kind = slotKind(identity, slot);
  return kind === 'start' ? 'start' : kind === 'dt' ? 'DT' : String(slot);
}

/** As the page calls it: `M1` is memory 0. */
function memoryOf(value: unknown, path: string, { memories }: Identity): number | null {
  if (value === null || value === undefined) return null;
  const names = Array.from({ length: memories }, (_, memory) => memoryName(memory));
  return names.indexOf(word(value, path, names));
}

function memoryName(memory: number): string {
  return `M${memory + 1}`;
}

/** Seconds with two decimals, as a text. The number 0.3 would not be exact in every language. */
function timeToFile(hundredths: number): string {
  return `${Math.floor(hundredths / 100)}.${String(hundredths % 100).padStart(2, '0')}`;
}

function timeFromFile(value: unknown, path: string): number {
  if (typeof value !== 'string' || !/^(?:0|[1-9]\d{0,2})\.\d\d$/.test(value)) {
    refuse('wrong-type', path, 'seconds with two decimals, such as "0.30"', value);
  }
  const hundredths = Number(value.replace('.', ''));
  const max = MAX_TIME / 100;
  if (hundredths > MAX_TIME) refuse('out-of-range', path, `0.00 to ${max}`, Number(value), { min: 0, max });
  return hundredths;
}

/** In UTC, so that it reads the same everywhere. */
export function dateToFile(milliseconds: number): string {
  return new Date(milliseconds).toISOString();
}

export function dateFromFile(value: unknown, path: string): number {
  const milliseconds = typeof value === 'string' ? Date.parse(value) : Number.NaN;
  // Only the form that `dateToFile` writes is accepted: some engines take 31 April for 1 May.
  if (Number.isNaN(milliseconds) || dateToFile(milliseconds) !== value) {
    refuse('wrong-type', path, 'a time such as "2026-11-22T14:03:00.000Z"', value);
  }
  return whole(milliseconds, path, 0, LAST_DATE);
}
