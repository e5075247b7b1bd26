import { CodecError } from './errors.js';
import { MAX_DATA } from './frame.js';

/** The maker's letters: B for rubber motor, Q for electric motor, E for slope. Any other letter stays as it came. */
export type TimerClass = 'B' | 'Q' | 'E' | (string & {});

/**
 * What a timer says about itself in its version reply. It gives the layout of every other message. It does not tell two
 * timers of the same class and firmware apart.
 */
export interface Identity {
  /** One printable ASCII letter. */
  readonly timerClass: TimerClass;
  /**
   * Three characters, digits on all that are known: `536`. Bytes that are no letters, digits, spaces, dots or dashes
   * are given as six hexadecimal digits: `050306`.
   */
  readonly firmware: string;
  /** NF, 1 or more. Functions are 1 .. NF-1; DT is number NF. Start (number 0) comes before them. */
  readonly functions: number;
  /** NM, 1 or more: the number of memories, which count from 0. */
  readonly memories: number;
  /** NS, 1 or more: the number of servos, which count from 0. */
  readonly servos: number;
}

/** The number of slots in a program: start, function 1 .. NF-1, DT. */
export function slotCount(identity: Identity): number {
  return identity.functions + 1;
}

const VERSION_LENGTH = 9;
const SPACE = 0x20;
const FIRMWARE = /^[0-9A-Za-z. -]{3}$/;

/**
 * Makes sure that an identity can be real and that its messages fit into frames.
 * @throws CodecError `bad-identity`, or `wrong-type` when it is no object.
 */
export function requireIdentity(identity: Identity, bytes?: Uint8Array): void {
  const refuse = (field: string, why: string): never => {
    throw new CodecError('bad-identity', `identity.${field}`, why, bytes ? { bytes } : {});
  };
  const isText = (value: unknown, form: RegExp): boolean => typeof value === 'string' && form.test(value);
  if (typeof identity !== 'object' || identity === null) {
    throw new CodecError('wrong-type', 'identity', 'an identity must be an object', { value: identity });
  }
  if (!isText(identity.timerClass, /^[!-~]$/)) refuse('timerClass', 'the class must be one printable character');
  if (!isText(identity.firmware, FIRMWARE) && !isText(identity.firmware, /^[0-9a-f]{6}$/))
    refuse('firmware', 'the firmware must be three characters');
  for (const field of ['functions', 'memories', 'servos'] as const) {
    const value = identity[field];
    if (!Number.isInteger(value) || value < 1 || value > 255) refuse(field, `${field} must be 1 to 255`);
  }
  if (2 * slotCount(identity) > MAX_DATA) refuse('functions', 'more functions than one frame of times can hold');
  if (identity.servos * slotCount(identity) > MAX_DATA) {
    refuse('servos', 'more servo positions than one frame can hold');
  }
}

/** The nine bytes of a version reply: class, firmware, a space, NF, NM, NS, a space. */
export function encodeIdentity(identity: Identity): number[] {
  requireIdentity(identity);
  const { timerClass, firmware, functions, memories, servos } = identity;
  const version = FIRMWARE.test(firmware)
    ? [...firmware].map((c) => c.charCodeAt(0))
    : [0, 2, 4].map((at) => Number.parseInt(firmware.slice(at, at + 2), 16));
  return [timerClass.charCodeAt(0), ...version, SPACE, functions, memories, servos, SPACE];
}

/**
 * Reads the two separators as any bytes: nobody knows what they are for (row 22 of docs/protocol.md).
 * @throws CodecError `wrong-length` or `bad-identity`, both with the raw bytes.
 */
export function decodeIdentity(data: Uint8Array): Identity {
  if (data.length !== VERSION_LENGTH) {
    throw new CodecError('wrong-length', 'data', `a version is ${VERSION_LENGTH} bytes, not ${data.length}`, {
      bytes: data,
    });
  }
  const [letter, , , , , functions, memories, servos] = data as unknown as number[];
  const version = [...data.subarray(1, 4)];
  const text = String.fromCharCode(...version);
  const identity: Identity = {
    timerClass: String.fromCharCode(letter as number),
    firmware: FIRMWARE.test(text) ? text : version.map((byte) => byte.toString(16).padStart(2, '0')).join(''),
    functions: functions as number,
    memories: memories as number,
    servos: servos as number,
  };
  requireIdentity(identity, data);
  // Every caller gets this object itself, and the layout of every message rests on it.
  return Object.freeze(identity);
}

/** Whether a version reply looks like those that are known: three digits of firmware, spaces as separators. */
export function isUsualVersion(data: Uint8Array): boolean {
  return data[4] === SPACE && data[8] === SPACE && data.subarray(1, 4).every((byte) => byte >= 0x30 && byte <= 0x39);
}
