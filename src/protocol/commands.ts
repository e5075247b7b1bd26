import {
  acknowledgedTimesField,
  byteField,
  currentIdleThrottleField,
  currentMemoryField,
  type Field,
  identityField,
  MAX_POSITION,
  memoryField,
  positionsField,
  timesField,
} from './fields.js';
import { MAX_DATA } from './frame.js';

/** One row of the table of commands. */
export interface Command {
  /** The letter of the request: an odd number. */
  readonly request: number;
  /** The letter of the reply: the even number after it. */
  readonly reply: number;
  /** Another letter that the source prints for this reply in one place, though it belongs to another command. */
  readonly misprint?: number;
  /** The values that the request carries, in their order on the wire. */
  readonly sends: readonly Field[];
  /** The values that the reply carries, in their order on the wire. */
  readonly answers: readonly Field[];
  /** Whether it may be sent again: twice leaves the timer as once does. */
  readonly repeatable: boolean;
  /** What it does to the timer: nothing (`reads`), changes what it stores, moves servos, or frees the motor. */
  readonly effect: 'reads' | 'stores' | 'moves' | 'frees-motor' | 'unknown';
}

/** The last function, and the last servo, that any timer can have: times and positions must fit into one frame. */
const LAST = MAX_DATA / 2 - 1;
/** Function numbers: 0 start, 1 .. NF-1, NF is DT. */
const functionField = byteField('function', (identity) => identity.functions, LAST);
const servoField = byteField('servo', (identity) => identity.servos - 1, LAST);
const positionField = byteField('position', () => MAX_POSITION, MAX_POSITION);
/** Unit unknown, 0..255. */
const idleThrottleField = byteField('idleThrottle', () => 255);

/** Freezes a table and the lists in it: the whole program shares it. */
function frozen<const T extends object>(table: T): T {
  for (const value of Object.values(table)) {
    if (typeof value === 'object') frozen(value);
  }
  return Object.freeze(table);
}

/**
 * All commands of the protocol. Only here stands the letter of a command, the layout of its data and what it does.
 * Encoders, decoders, client, virtual timer, log and documentation read this table.
 */
export const COMMANDS = frozen({
  GETTIMERS: {
    request: 0x61,
    reply: 0x62,
    misprint: 0x66,
    sends: [],
    answers: [timesField],
    repeatable: true,
    effect: 'reads',
  },
  SETSERVO: {
    request: 0x63,
    reply: 0x64,
    sends: [functionField, servoField, positionField],
    answers: [],
    repeatable: true,
    effect: 'stores',
  },
  SETTIMERS: {
    request: 0x65,
    reply: 0x66,
    sends: [timesField],
    answers: [acknowledgedTimesField],
    repeatable: true,
    effect: 'stores',
  },
  GETSERVOPOS: {
    request: 0x67,
    reply: 0x68,
    sends: [],
    answers: [positionsField],
    repeatable: true,
    effect: 'reads',
  },
  MOVETOFUNC: {
    request: 0x69,
    reply: 0x6a,
    sends: [functionField],
    answers: [],
    repeatable: false,
    effect: 'moves',
  },
  GETSWVER: {
    request: 0x6b,
    reply: 0x6c,
    sends: [],
    answers: [identityField],
    repeatable: true,
    effect: 'reads',
  },
  UNLOCK: {
    request: 0x6d,
    reply: 0x6e,
    misprint: 0x6a,
    sends: [],
    answers: [],
    repeatable: false,
    effect: 'frees-motor',
  },
  JUMP2: { request: 0x6f, reply: 0x70, sends: [], answers: [], repeatable: false, effect: 'unknown' },
  GETMEMORY: {
    request: 0x71,
    reply: 0x72,
    sends: [],
    answers: [currentMemoryField],
    repeatable: true,
    effect: 'reads',
  },
  SETMEMORY: {
    request: 0x73,
    reply: 0x74,
    sends: [memoryField],
    answers: [],
    repeatable: true,
    effect: 'stores',
  },
  GETLOWRPM: {
    request: 0x75,
    reply: 0x76,
    sends: [],
    answers: [currentIdleThrottleField],
    repeatable: true,
    effect: 'reads',
  },
  SETLOWRPM: {
    request: 0x77,
    reply: 0x78,
    sends: [idleThrottleField],
    answers: [],
    repeatable: true,
    effect: 'stores',
  },
} as const satisfies Record<string, Command>);

/** The maker's name of a command. */
export type CommandName = keyof typeof COMMANDS;

/** The names of all commands, in the order of their letters. */
export const COMMAND_NAMES: readonly CommandName[] = Object.freeze(Object.keys(COMMANDS) as CommandName[]);

/**
 * The command that has this letter, and whether it is the letter of its request or of its reply. Undefined for a letter
 * that no command has.
 */
export function commandOf(code: number): { name: CommandName; direction: 'request' | 'reply' } | undefined {
  for (const name of COMMAND_NAMES) {
    if (COMMANDS[name].request === code) return { name, direction: 'request' };
    if (COMMANDS[name].reply === code) return { name, direction: 'reply' };
  }
  return undefined;
}

type FieldValues<Fields extends readonly Field[]> = {
  readonly [F in Fields[number] as F['name']]: F extends Field<string, infer Value> ? Value : never;
};
/** Shows one object in hovers and errors, in place of an intersection. */
type Flat<T> = { [Name in keyof T]: T[Name] } & {};

/** The request of one command: its name and its values. Of several commands: any of their requests. */
export type RequestOf<Name extends CommandName> = Name extends CommandName
  ? Flat<{ readonly name: Name } & FieldValues<(typeof COMMANDS)[Name]['sends']>>
  : never;
/** The reply to one command: its name and its values. Of several commands: any of their replies. */
export type ReplyOf<Name extends CommandName> = Name extends CommandName
  ? Flat<{ readonly name: Name } & FieldValues<(typeof COMMANDS)[Name]['answers']>>
  : never;

/** Any request: `{ name: 'GETSWVER' }`, `{ name: 'SETSERVO', function: 10, servo: 0, position: 65 }` ... */
export type Request = RequestOf<CommandName>;
/** Any reply: `{ name: 'GETTIMERS', times: [...] }`, `{ name: 'SETSERVO' }` ... */
export type Reply = ReplyOf<CommandName>;
