import { CodecError, requireInteger } from './errors.js';
import { decodeIdentity, encodeIdentity, type Identity, slotCount } from './identity.js';

/**
 * How this timer differs from the usual reading of the protocol. The row numbers are those of the open questions in
 * docs/protocol.md. All are off by default.
 */
export interface LayoutQuirks {
  /** Times have their high byte first (row 7). */
  readonly bigEndianTimes?: boolean;
  /** SETSERVO carries servo, function, position instead of function, servo, position (row 9). */
  readonly servoFirst?: boolean;
  /** The wire counts memories from 1 (row 14). Values always count from 0. */
  readonly memoriesFromOne?: boolean;
}

/** What the layout of a message may depend on, besides its values. */
export interface LayoutOptions {
  /** What the timer has said about itself. It gives the length of lists and the range of values. */
  readonly identity?: Identity | undefined;
  /** How this timer differs. Default: not at all. */
  readonly quirks?: LayoutQuirks | undefined;
}

/**
 * One value in the data of a message: how it becomes bytes, and bytes become it. Each value takes one byte, but the
 * last value of a message takes all bytes that are left.
 */
export interface Field<Name extends string = string, Value = unknown> {
  readonly name: Name;
  /** How many bytes it takes for a timer of this identity. Counts a value that may be missing as present. */
  size(identity: Identity): number;
  encode(value: Value, layout: LayoutOptions): readonly number[];
  /** @param data exactly the bytes of this value. */
  decode(data: Uint8Array, layout: LayoutOptions): Value;
}

function requireLength(data: Uint8Array, min: number, max: number): void {
  if (data.length >= min && data.length <= max) return;
  throw new CodecError('wrong-length', 'data', `expected ${min} to ${max} bytes, got ${data.length}`, {
    bytes: data,
    min,
    max,
  });
}

/** A number of one byte, from 0 to `max` of the identity; while that is unknown, to `most`: what any timer can have. */
export function byteField<Name extends string>(
  name: Name,
  max: (identity: Identity) => number,
  most = 255,
): Field<Name, number> {
  const check = (value: number, { identity }: LayoutOptions): number => {
    requireInteger(value, name, 0, identity ? max(identity) : most);
    return value;
  };
  return {
    name,
    size: () => 1,
    encode: (value, layout) => [check(value, layout)],
    decode(data, layout) {
      requireLength(data, 1, 1);
      return check(data[0] as number, layout);
    },
  };
}

/** The memory to select, counted from 0. */
export const memoryField: Field<'memory', number> = {
  name: 'memory',
  size: () => 1,
  encode(memory, { identity, quirks }) {
    requireInteger(memory, 'memory', 0, identity ? identity.memories - 1 : 254);
    return [memory + firstMemory(quirks)];
  },
  decode(data, { identity, quirks }) {
    requireLength(data, 1, 1);
    const memory = (data[0] as number) - firstMemory(quirks);
    requireInteger(memory, 'memory', 0, identity ? identity.memories - 1 : 254);
    return memory;
  },
};

/**
 * The current memory, or null: the source prints this reply once with an index and once without. This field accepts an
 * index that the timer cannot have; the caller judges it. An index equal to the number of memories shows that the timer
 * counts from 1. -1 shows that it counts from 0, although 1 was assumed.
 */
export const currentMemoryField: Field<'memory', number | null> = {
  name: 'memory',
  size: () => 1,
  encode(memory, { quirks }) {
    if (memory === null) return [];
    requireInteger(memory, 'memory', -firstMemory(quirks), 255 - firstMemory(quirks));
    return [memory + firstMemory(quirks)];
  },
  decode(data, { quirks }) {
    if (data.length === 0) return null;
    requireLength(data, 1, 1);
    return (data[0] as number) - firstMemory(quirks);
  },
};

/**
 * The idle throttle that the timer holds, unit unknown, or null:
 * the source prints this reply once with a value and once without.
 */
export const currentIdleThrottleField: Field<'idleThrottle', number | null> = {
  name: 'idleThrottle',
  size: () => 1,
  encode(value) {
    if (value === null) return [];
    requireInteger(value, 'idleThrottle', 0, 255);
    return [value];
  },
  decode(data) {
    if (data.length === 0) return null;
    requireLength(data, 1, 1);
    return data[0] as number;
  },
};

function firstMemory(quirks: LayoutQuirks | undefined): number {
  return quirks?.memoriesFromOne ? 1 : 0;
}

/** The time of every slot, 16 bits each, low byte first. */
export const timesField: Field<'times', readonly Hundredths[]> = {
  name: 'times',
  size: (identity) => 2 * slotCount(identity),
  encode(times, { identity, quirks }) {
    requireCount(times, 'times', identity && slotCount(identity));
    return Array.from(times).flatMap((time, slot) => {
      requireInteger(time, `times[${slot}]`, 0, MAX_TIME);
      const low = time & 0xff;
      const high = time >> 8;
      return quirks?.bigEndianTimes ? [high, low] : [low, high];
    });
  },
  decode(data, { identity, quirks }) {
    if (identity) requireLength(data, this.size(identity), this.size(identity));
    if (data.length % 2 !== 0) {
      throw new CodecError('wrong-length', 'data', `times are two bytes each, got ${data.length}`, { bytes: data });
    }
    const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
    return Array.from({ length: data.length / 2 }, (_, slot) => view.getUint16(2 * slot, !quirks?.bigEndianTimes));
  },
};

/** The times that the timer holds now; null when the acknowledgement carries none. */
export const acknowledgedTimesField: Field<'times', readonly Hundredths[] | null> = {
  name: 'times',
  size: (identity) => timesField.size(identity),
  encode: (times, layout) => (times === null ? [] : timesField.encode(times, layout)),
  decode: (data, layout) => (data.length === 0 ? null : timesField.decode(data, layout)),
};

/** The position of every servo in every slot, servo by servo: S1 from start to DT, then S2, and so on. */
export const positionsField: Field<'positions', readonly (readonly number[])[]> = {
  name: 'positions',
  size: (identity) => identity.servos * slotCount(identity),
  encode(positions, { identity }) {
    requireCount(positions, 'positions', identity?.servos);
    return Array.from(positions).flatMap((row, servo) => {
      requireCount(row, `positions[${servo}]`, identity && slotCount(identity));
      const steps = Array.from(row);
      steps.forEach((position, slot) => {
        // A timer may hold and report 131 to 255, which nobody can set.
        requireInteger(position, `positions[${servo}][${slot}]`, 0, 255);
      });
      return steps;
    });
  },
  decode(data, { identity }) {
    if (!identity) throw new CodecError('identity-needed', 'positions', 'positions need the number of servos');
    requireLength(data, this.size(identity), this.size(identity));
    const slots = slotCount(identity);
    return Array.from({ length: identity.servos }, (_, servo) => [
      ...data.subarray(servo * slots, (servo + 1) * slots),
    ]);
  },
};

/** Class, firmware, and the numbers of functions, memories and servos. */
export const identityField: Field<'identity', Identity> = {
  name: 'identity',
  size: () => 9,
  encode: encodeIdentity,
  decode: decodeIdentity,
};

/** A time in hundredths of a second, a whole number 0..65535: 180 is 1.80 s, and three minutes are 18000. */
export type Hundredths = number;

/** The longest time that 16 bits of hundredths carry: 65535, which is 655.35 s. */
export const MAX_TIME = 0xffff;
/** The last step of a servo; steps are 0..130. Their angle is not known. */
export const MAX_POSITION = 130;

function requireCount(list: readonly unknown[], field: string, count: number | undefined): void {
  if (!Array.isArray(list)) throw new CodecError('wrong-type', field, `${field} must be a list`, { value: list });
  if (count === undefined || list.length === count) return;
  throw new CodecError('wrong-count', field, `${field} must have ${count} entries, not ${list.length}`, {
    value: list.length,
    min: count,
    max: count,
  });
}
