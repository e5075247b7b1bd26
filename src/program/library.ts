import { CodecError, type Identity, MAX_POSITION, MAX_TIME, requireIdentity } from '../protocol/index.js';
import { requireShape, type TimerProgram } from './program.js';
import {
  date,
  flag,
  id,
  list,
  measured,
  optional,
  record,
  refuse,
  text,
  whole,
  wholes,
  within,
  word,
} from './require.js';

/*
 * What a pilot keeps: models, settings, flights. The file and the storage of the page hold the same shapes. One
 * function here checks each of them, wherever it comes from.
 */

/**
 * What a servo does. `rudder`, `tailplane`, `wing`: it turns a surface. `release`: it releases something, such as a
 * disc that frees arms one after another, or a line that holds the tailplane until DT. `other`: something that only the
 * pilot has a name for. `none`: no servo is there.
 */
export const DUTIES = ['rudder', 'tailplane', 'wing', 'release', 'other', 'none'] as const;
/** What a servo does, see {@link DUTIES}. */
export type Duty = (typeof DUTIES)[number];

/** What the pilot has told about a servo. */
export interface ServoUse {
  /** What the servo does. */
  readonly duty: Duty;
  /** What it does, for the duty `other`: up to 16 characters. Empty for any other duty. */
  readonly name: string;
  /** The lower end of its travel, in steps 0..130. Not above `high`. */
  readonly low: number;
  /** The upper end of its travel, in steps 0..130. */
  readonly high: number;
  /** True: more steps turn the trailing edge down (a rudder to the left). False: up (a rudder to the right). */
  readonly reversed: boolean;
}

/** A model aircraft with its timer. Nothing on the wire names it, so the pilot says what belongs to it. */
export interface Model {
  /** Unique and never changed: 1 to 64 characters of `A-Z a-z 0-9 - _`. */
  readonly id: string;
  /** 1 to 60 characters. */
  readonly name: string;
  /** The class of its timer; null until the pilot has said it. */
  readonly timerClass: string | null;
  /** Up to 5000 characters. */
  readonly note: string;
  /** What its servos move, one entry for each. Empty where the pilot has not said. At most 255. */
  readonly servos: readonly ServoUse[];
  /**
   * The pilot's names for the memories, such as “calm”.
   * A memory without a name has an empty text, or the list ends before it.
   */
  readonly memoryNames: readonly string[];
  /** In the archive: kept, but shown only on request. */
  readonly archived: boolean;
}

/**
 * Where the values of a setting come from: the pilot typed them; a timer or a simulated timer was read; a backup before
 * a write; a file; a link.
 */
export const SOURCES = ['typed', 'timer', 'simulated', 'backup', 'file', 'link'] as const;
/** Where the values of a setting come from, see {@link SOURCES}. */
export type SettingSource = (typeof SOURCES)[number];

/** A program that the pilot keeps under a name. */
export interface Setting {
  /** Unique and never changed, as in {@link Model.id}. */
  readonly id: string;
  /** The id of the model that it belongs to; null for none. */
  readonly model: string | null;
  /** 1 to 60 characters. */
  readonly name: string;
  /** Up to 5000 characters. */
  readonly note: string;
  /** Up to 20, of 1 to 30 characters each. */
  readonly tags: readonly string[];
  /** When its values were last read or changed, in milliseconds since 1970. */
  readonly at: number;
  /** The values, with the identity of the timer that they are for. */
  readonly program: TimerProgram;
  /** Where the values come from. */
  readonly from: SettingSource;
  /** In the archive: kept, but shown only on request. */
  readonly archived: boolean;
}

/** What a setting held before a save replaced it. */
export interface SettingVersion extends Pick<Setting, 'at' | 'program' | 'from'> {
  /** Until when the setting held it, in milliseconds since 1970: it was saved over at that moment. */
  readonly until: number;
}

/** One flight in the pilot's log. It holds a copy of the program that was flown, so that it never changes. */
export interface Flight {
  /** Unique and never changed, as in {@link Model.id}. */
  readonly id: string;
  /** When it was flown, in milliseconds since 1970. */
  readonly at: number;
  /**
   * How far the clock of the field was ahead of UTC when the flight was logged, in minutes, -840 to 840. Missing where
   * it is not known.
   */
  readonly utcOffset?: number;
  /** Up to 100 characters. */
  readonly place: string;
  /** The id of the model; null when it was not in the library. */
  readonly model: string | null;
  /** The name of the model on that day, up to 60 characters. Empty when it was not in the library. */
  readonly modelName: string;
  /** The id of the setting; null when it was not in the library. */
  readonly setting: string | null;
  /** The name of the setting on that day, up to 60 characters. Empty when it was not in the library. */
  readonly settingName: string;
  /** The program that the timer held. */
  readonly program: TimerProgram;
  /** Metres per second, 0 to 50; null when nobody noted it. */
  readonly wind: number | null;
  /** Degrees Celsius, -50 to 60; null when nobody noted it. */
  readonly temperature: number | null;
  /** Such as `3` or `fly-off 1`, up to 30 characters. */
  readonly round: string;
  /** The flight time in seconds, 0 to 36,000; null when nobody noted it. */
  readonly result: number | null;
  /** The longest time that counts in its round, in seconds, 1 to 36,000. Missing where the pilot has not said it. */
  readonly maximum?: number;
  /** True where the pilot has chosen this flight among several of its round. By default the last result counts. */
  readonly counts?: boolean;
  /** Up to 5000 characters. */
  readonly note: string;
}

/** All that a pilot keeps, or a part of it. The order of the lists means nothing. */
export interface Library {
  /** The models. */
  readonly models: readonly Model[];
  /** The settings of all models, and those without a model. */
  readonly settings: readonly Setting[];
  /** The log of flights. */
  readonly flights: readonly Flight[];
}

/** The greatest lengths of texts, in characters, and of lists. */
export const LIMITS = {
  name: 60,
  servoName: 16,
  note: 5000,
  tag: 30,
  tags: 20,
  versions: 20,
  place: 100,
  round: 30,
} as const;

/**
 * Makes sure that a value is a model.
 * @param path the place that an error names: `models[3]`.
 * @returns a copy that has the fields of a model and no others.
 * @throws CodecError `wrong-type`, `out-of-range`, `not-an-integer`, `wrong-count`, `unknown-word`.
 */
export function requireModel(value: unknown, path = 'model'): Model {
  const of = record<Model>(value, path);
  const timerClass = of.timerClass ?? null;
  if (timerClass !== null && (typeof timerClass !== 'string' || !/^[!-~]$/.test(timerClass))) {
    refuse('wrong-type', `${path}.timerClass`, 'one printable character, or null', timerClass);
  }
  return {
    id: id(of.id, `${path}.id`),
    name: text(of.name, `${path}.name`, LIMITS.name, 1),
    timerClass,
    note: text(of.note, `${path}.note`, LIMITS.note),
    servos: list(of.servos, `${path}.servos`, 255).map((servo, at) => servoUse(servo, `${path}.servos[${at}]`)),
    memoryNames: list(of.memoryNames, `${path}.memoryNames`, 255).map((name, at) =>
      text(name, `${path}.memoryNames[${at}]`, LIMITS.name),
    ),
    archived: flag(of.archived, `${path}.archived`),
  };
}

/** Makes sure that a value is a setting; see {@link requireModel}. */
export function requireSetting(value: unknown, path = 'setting'): Setting {
  const of = record<Setting>(value, path);
  return {
    id: id(of.id, `${path}.id`),
    model: optional(of.model, (given) => id(given, `${path}.model`)),
    name: text(of.name, `${path}.name`, LIMITS.name, 1),
    note: text(of.note, `${path}.note`, LIMITS.note),
    tags: list(of.tags, `${path}.tags`, LIMITS.tags).map((tag, at) => text(tag, `${path}.tags[${at}]`, LIMITS.tag, 1)),
    at: date(of.at, `${path}.at`),
    program: requireProgram(of.program, `${path}.program`),
    from: word(of.from, `${path}.from`, SOURCES),
    archived: flag(of.archived, `${path}.archived`),
  };
}

/** Makes sure that a value is an earlier version of a setting; see {@link requireModel}. */
export function requireVersion(value: unknown, path = 'version'): SettingVersion {
  const of = record<SettingVersion>(value, path);
  return {
    until: date(of.until, `${path}.until`),
    at: date(of.at, `${path}.at`),
    program: requireProgram(of.program, `${path}.program`),
    from: word(of.from, `${path}.from`, SOURCES),
  };
}

/** Makes sure that a value is a flight; see {@link requireModel}. */
export function requireFlight(value: unknown, path = 'flight'): Flight {
  const of = record<Flight>(value, path);
  return {
    id: id(of.id, `${path}.id`),
    at: date(of.at, `${path}.at`),
    ...known('utcOffset', of.utcOffset, (value) => whole(value, `${path}.utcOffset`, -FARTHEST, FARTHEST)),
    place: text(of.place, `${path}.place`, LIMITS.place),
    model: optional(of.model, (given) => id(given, `${path}.model`)),
    modelName: text(of.modelName, `${path}.modelName`, LIMITS.name),
    setting: optional(of.setting, (given) => id(given, `${path}.setting`)),
    settingName: text(of.settingName, `${path}.settingName`, LIMITS.name),
    program: requireProgram(of.program, `${path}.program`),
    wind: measured(of.wind, `${path}.wind`, 0, 50),
    temperature: measured(of.temperature, `${path}.temperature`, -50, 60),
    round: text(of.round, `${path}.round`, LIMITS.round),
    result: measured(of.result, `${path}.result`, 0, 36_000),
    ...known('maximum', of.maximum, (value) => measured(value, `${path}.maximum`, 1, 36_000) as number),
    ...known('counts', of.counts, (value) => flag(value, `${path}.counts`)),
    note: text(of.note, `${path}.note`, LIMITS.note),
  };
}

/** The farthest that a clock is from UTC, in minutes: 14 hours, on the Line Islands. */
const FARTHEST = 840;

/** A field that is missing where nothing is known. */
function known<N extends string, T>(name: N, value: unknown, check: (value: unknown) => T): { [K in N]?: T } {
  return value === undefined || value === null ? {} : ({ [name]: check(value) } as { [K in N]?: T });
}

/**
 * Makes sure that a value is a library. The fields of its errors begin with `models[3]`, `settings[0]`, `flights[7]`.
 * @throws CodecError as {@link requireModel}; also `duplicate` for an id that stands twice in one list.
 */
export function requireLibrary(value: unknown): Library {
  const of = record<Library>(value, 'library');
  return {
    models: entries(of.models, 'models', requireModel),
    settings: entries(of.settings, 'settings', requireSetting),
    flights: entries(of.flights, 'flights', requireFlight),
  };
}

/** A list of the library. Each entry must have an id of its own. */
export function entries<T extends { readonly id: string }>(
  value: unknown,
  path: string,
  require: (value: unknown, path: string) => T,
): readonly T[] {
  const ids = new Set<string>();
  return list(value, path, Number.POSITIVE_INFINITY).map((each, at) => {
    const entry = require(each, `${path}[${at}]`);
    const field = `${path}[${at}].id`;
    if (ids.has(entry.id)) throw new CodecError('duplicate', field, `${field} stands twice`, { value: entry.id });
    ids.add(entry.id);
    return entry;
  });
}

/**
 * Makes sure that a value is a program that a timer can hold. Positions and idle throttle go up to 255: a timer may
 * hold what nobody should set.
 * @throws CodecError `wrong-type`, `out-of-range`, `not-an-integer`, `wrong-count`, `bad-identity`.
 */
export function requireProgram(value: unknown, path = 'program'): TimerProgram {
  const of = record<TimerProgram>(value, path);
  const identity = identityOf(of.identity, path);
  const program: TimerProgram = {
    identity,
    memory: optional(of.memory, (given) => whole(given, `${path}.memory`, 0, identity.memories - 1)),
    times: wholes(of.times, `${path}.times`, 256, MAX_TIME),
    positions: list(of.positions, `${path}.positions`, 255).map((row, servo) =>
      wholes(row, `${path}.positions[${servo}]`, 256, 255),
    ),
    idleThrottle: optional(of.idleThrottle, (given) => whole(given, `${path}.idleThrottle`, 0, 255)),
  };
  within(path, () => requireShape(program));
  return program;
}

/**
 * Makes sure that a value is an identity that a timer can have.
 * @param path the place of the program that holds it.
 */
export function identityOf(value: unknown, path: string): Identity {
  const place = `${path}.identity`;
  const { timerClass, firmware, functions, memories, servos } = record<Identity>(value, place);
  const identity = { timerClass, firmware, functions, memories, servos } as Identity;
  for (const name of ['timerClass', 'firmware'] as const) text(identity[name], `${place}.${name}`, 6);
  for (const name of ['functions', 'memories', 'servos'] as const) {
    if (typeof identity[name] !== 'number') refuse('wrong-type', `${place}.${name}`, 'a number', identity[name]);
  }
  within(path, () => requireIdentity(identity));
  return identity;
}

function servoUse(value: unknown, path: string): ServoUse {
  const of = record<ServoUse>(value, path);
  const high = whole(of.high, `${path}.high`, 0, MAX_POSITION);
  return {
    duty: word(of.duty, `${path}.duty`, DUTIES),
    name: text(of.name, `${path}.name`, LIMITS.servoName),
    low: whole(of.low, `${path}.low`, 0, high),
    high,
    reversed: flag(of.reversed, `${path}.reversed`),
  };
}
