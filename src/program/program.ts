import { CodecError, type Hundredths, type Identity, MAX_TIME, slotCount } from '../protocol/index.js';
import { requireCount, whole } from './require.js';

/**
 * What a pilot sets: the content of one memory. Its slots are start, function 1 .. NF-1 and DT; the identity gives NF.
 */
export interface TimerProgram {
  /** The timer that it is for. */
  readonly identity: Identity;
  /** The memory that it was read from, counted from 0; null when the timer does not say. */
  readonly memory: number | null;
  /**
   * The time of each slot, absolute from launch. Slot 0 is the motor stop on class Q and reserved on B and E.
   */
  readonly times: readonly Hundredths[];
  /** `[servo][slot]`, steps 0..130. A timer may hold 131..255; such a value stays as it was read. */
  readonly positions: readonly (readonly number[])[];
  /** 0..255, unit unknown; null when nobody asked for it (any class but Q) or the timer did not answer. */
  readonly idleThrottle: number | null;
}

/** Names one value of a program. Slots and servos count from 0. */
export type ProgramField =
  | { readonly kind: 'time'; readonly slot: number }
  | { readonly kind: 'position'; readonly servo: number; readonly slot: number }
  | { readonly kind: 'idleThrottle' };

/** What a slot is, counted from 0: `start` is slot 0, `dt` the last one, `function` any between them. */
export function slotKind(identity: Identity, slot: number): 'start' | 'function' | 'dt' {
  if (slot === 0) return 'start';
  return slot === identity.functions ? 'dt' : 'function';
}

/** All fields of a program for this timer: the times, the positions servo by servo, the idle throttle. */
export function fieldsOf(identity: Identity): ProgramField[] {
  const slots = Array.from({ length: slotCount(identity) }, (_, slot) => slot);
  const servos = Array.from({ length: identity.servos }, (_, servo) => servo);
  return [
    ...slots.map((slot): ProgramField => ({ kind: 'time', slot })),
    ...servos.flatMap((servo) => slots.map((slot): ProgramField => ({ kind: 'position', servo, slot }))),
    { kind: 'idleThrottle' },
  ];
}

/** A short name of a field. Equal fields have equal names: `time:3`, `position:0:3`, `idleThrottle`. */
export function fieldKey(field: ProgramField): string {
  if (field.kind === 'time') return `time:${field.slot}`;
  if (field.kind === 'position') return `position:${field.servo}:${field.slot}`;
  return field.kind;
}

/** The value of a field; null for an idle throttle that is not known, and for a slot or servo that is not there. */
export function valueAt(program: TimerProgram, field: ProgramField): number | null {
  if (field.kind === 'time') return program.times[field.slot] ?? null;
  if (field.kind === 'position') return program.positions[field.servo]?.[field.slot] ?? null;
  return program.idleThrottle;
}

/**
 * A copy of the program in which one field has another value.
 * @param value hundredths of a second (see {@link seconds}), steps, or idle throttle. It is not checked here, but by
 * `checkProgram`, and by the client before a write.
 * @throws CodecError `not-an-integer` or `out-of-range` (`slot`, `servo`, `kind`) for a field that this program does
 * not have.
 */
export function withValue(program: TimerProgram, field: ProgramField, value: number): TimerProgram {
  const replaced = <T>(list: readonly T[], index: number, name: 'slot' | 'servo', by: (old: T) => T): T[] => {
    whole(index, name, 0, list.length - 1);
    return list.map((old, i) => (i === index ? by(old) : old));
  };
  const inSlot = (list: readonly number[], slot: number): number[] => replaced(list, slot, 'slot', () => value);
  switch (field.kind) {
    case 'time':
      return { ...program, times: inSlot(program.times, field.slot) };
    case 'position': {
      const positions = replaced(program.positions, field.servo, 'servo', (row) => inSlot(row, field.slot));
      return { ...program, positions };
    }
    case 'idleThrottle':
      return { ...program, idleThrottle: value };
    default: {
      // A caller without types may pass anything. What changes nothing would later be called verified.
      const { kind } = field as { readonly kind: unknown };
      throw new CodecError('out-of-range', 'kind', 'kind must be time, position or idleThrottle', { value: kind });
    }
  }
}

/**
 * Seconds as a time of a program: `seconds(180)` is 18000 hundredths.
 * @param value 0..655.35, in whole hundredths of a second.
 * @throws CodecError `not-an-integer` when it is finer than a hundredth or no number, `out-of-range`.
 */
export function seconds(value: number): Hundredths {
  const hundredths = typeof value === 'number' ? Math.round(value * 100) : Number.NaN;
  // 0.29 * 100 is 28.999999999999996.
  return whole(Math.abs(hundredths - value * 100) < 1e-6 ? hundredths : Number.NaN, 'seconds', 0, MAX_TIME);
}

/** Whether two timers have the same class, firmware and layout. They may still be two timers. */
export function sameKind(a: Identity, b: Identity): boolean {
  return a.timerClass === b.timerClass && a.firmware === b.firmware && sameLayout(a, b) && a.memories === b.memories;
}

/** Whether the programs of two timers have the same slots and servos. */
export function sameLayout(a: Identity, b: Identity): boolean {
  return a.functions === b.functions && a.servos === b.servos;
}

/**
 * Makes sure that the lists of a program have the shape that its identity gives.
 * @throws CodecError `wrong-count`.
 */
export function requireShape(program: TimerProgram): void {
  const slots = slotCount(program.identity);
  requireCount(program.times, 'times', slots);
  requireCount(program.positions, 'positions', program.identity.servos);
  program.positions.forEach((row, servo) => {
    requireCount(row, `positions[${servo}]`, slots);
  });
}
