import { CodecError } from '../protocol/index.js';
import { dateFromFile, dateToFile, programFromFile, programToFile, startTime } from './file-values.js';
import { placeInText, readJson, writeJson } from './json-text.js';
import {
  entries,
  type Flight,
  type Library,
  type Model,
  requireFlight,
  requireLibrary,
  requireModel,
  requireSetting,
  type Setting,
} from './library.js';
import type { TimerProgram } from './program.js';
import { flag, list, record, text, whole } from './require.js';

/** The name of the format, which every library file carries. */
export const FILE_FORMAT = 'sidus-timer library';
/** The version that is written. Files of a newer version are refused. */
export const FILE_VERSION = 1;
/**
 * The longest file that is read or written, in characters. 2,000 settings and 10,000 flights take 17 million, and
 * a hostile file of this size is refused within seconds.
 */
export const MAX_FILE = 20_000_000;

/** What one memory of a timer held when it was last verified. */
export interface VerifiedMemory {
  /** What it held. */
  readonly program: TimerProgram;
  /** When that was verified, in milliseconds since 1970. */
  readonly at: number;
  /** Whether it was a simulated timer. */
  readonly simulated?: boolean;
}

/** Facts about an entry that the pilot did not type. */
export interface EntryFacts {
  /** When it was last changed, in milliseconds since 1970. */
  readonly changedAt?: number;
  /** For a model: what the memories of its timer held when they were last verified. At most 255. */
  readonly verified?: readonly VerifiedMemory[];
}
/** The facts of each entry of a library, by the entry itself. */
export type FactsOf = ReadonlyMap<Model | Setting | Flight, EntryFacts>;

/** What a library file holds. */
export interface LibraryFile {
  /** Its models, settings and flights. */
  readonly library: Library;
  /** The facts of each entry, by the entry itself. An entry without facts is not in the map. */
  readonly facts: FactsOf;
  /** When the file was written, in milliseconds since 1970. */
  readonly writtenAt: number;
  /** The program that wrote it, such as `Sidus Timer 0.2.0`. */
  readonly writtenBy: string;
  /** Fields that this version does not know and has skipped. At most 20 are named. */
  readonly ignored: readonly string[];
}

/** In characters. */
const LONGEST_NAME = 200;
const MOST_IGNORED = 20;
const MOST_VERIFIED = 255;

/**
 * Writes a library, or a part of one, as JSON that a person can read, too. docs/file-format.md describes it.
 * @param head when it is written, in milliseconds since 1970, and which program writes it, up to 200 characters.
 * @throws CodecError as {@link requireLibrary} when it is no library; `too-large` past {@link MAX_FILE}.
 */
export function formatLibraryFile(
  library: Library,
  head: { readonly writtenAt: number; readonly writtenBy: string; readonly facts?: FactsOf },
): string {
  // Whatever could not be read back must not be written.
  const { models, settings, flights } = requireLibrary(library);
  const factsOf = (each: Model | Setting | Flight | undefined): object => {
    const { changedAt, verified } = (each && head.facts?.get(each)) ?? {};
    return {
      ...(changedAt === undefined ? {} : { changedAt: dateToFile(changedAt) }),
      ...(verified === undefined
        ? {}
        : {
            verified: verified.map(({ at, program, ...rest }) => ({
              at: dateToFile(at),
              program: programToFile(program),
              ...(rest.simulated === undefined ? {} : { simulated: rest.simulated }),
            })),
          }),
    };
  };
  const written = writeJson({
    format: FILE_FORMAT,
    version: FILE_VERSION,
    writtenAt: dateToFile(whole(head.writtenAt, 'writtenAt', 0, 8.64e15)),
    writtenBy: text(head.writtenBy, 'writtenBy', LONGEST_NAME),
    models: models.map((model, index) => ({ ...model, ...factsOf(library.models[index]) })),
    settings: settings.map((setting, index) => ({
      ...setting,
      at: dateToFile(setting.at),
      program: programToFile(setting.program),
      ...factsOf(library.settings[index]),
    })),
    flights: flights.map((flight, index) => ({
      ...flight,
      at: dateToFile(flight.at),
      program: programToFile(flight.program),
      ...factsOf(library.flights[index]),
    })),
  });
  requireSize(written);
  return `${written}\n`;
}

/**
 * Reads a library file. Line ends may be those of any system. An unknown field is skipped and named in `ignored`.
 * Everything else is checked as strictly as a reply of a timer.
 * @throws CodecError with the path as field, and line and column in its details: `bad-file` for another kind of file
 * (field `format`), a broken text (`text`), a text that ends too early (`end`) or UTF-16 that was read as another
 * encoding (`encoding`); `newer-version`, `too-large`, `duplicate`; and as {@link requireLibrary}.
 */
export function parseLibraryFile(source: string): LibraryFile {
  requireSize(source);
  const text = source.replace(/^\uFEFF/, '');
  // The byte order mark of UTF-16 as another encoding shows it, or the zeros beside each letter.
  if (/^(?:ÿþ|þÿ|\uFFFE|\uFFFD\uFFFD|\0|.\0)/.test(text)) {
    throw new CodecError('bad-file', 'encoding', 'the text is UTF-16 that was read as something else');
  }
  const value = readJson(text);
  try {
    return new FileReader().read(value);
  } catch (cause) {
    if (!(cause instanceof CodecError)) throw cause;
    const { line, column } = placeInText(text, cause.field);
    const message = `line ${line}, column ${column}: ${cause.message}`;
    throw new CodecError(cause.code, cause.field, message, { ...cause.details, line, column });
  }
}

function requireSize({ length }: string): void {
  if (length <= MAX_FILE) return;
  const details = { value: length, max: MAX_FILE };
  throw new CodecError('too-large', 'file', `a file has at most ${MAX_FILE} characters, not ${length}`, details);
}

/** The known names, by the object that they stand in. */
const HEAD = ['$schema', 'format', 'version', 'writtenAt', 'writtenBy', 'models', 'settings', 'flights'] as const;
const MODEL = [
  'id',
  'name',
  'timerClass',
  'note',
  'servos',
  'memoryNames',
  // A picture, in files of an earlier version. Nothing reads it.
  'photo',
  'archived',
  'changedAt',
  'verified',
] as const;
const SERVO = ['duty', 'name', 'low', 'high', 'reversed'] as const;
const SETTING = ['id', 'model', 'name', 'note', 'tags', 'at', 'program', 'from', 'archived', 'changedAt'] as const;
const FLIGHT = [
  ...['id', 'at', 'place', 'model', 'modelName', 'setting', 'settingName', 'program', 'wind', 'temperature', 'round'],
  ...['result', 'note', 'utcOffset', 'changedAt'],
] as const;
const VERIFIED = ['at', 'program', 'simulated'] as const;
const PROGRAM = ['identity', 'memory', 'idleThrottle', 'slots'] as const;
const IDENTITY = ['timerClass', 'firmware', 'functions', 'memories', 'servos'] as const;
const SLOT = ['slot', 'positions'] as const;

type Fields<Name extends string> = { readonly [Field in Name]?: unknown };

class FileReader {
  readonly #facts = new Map<Model | Setting | Flight, EntryFacts>();
  readonly #ignored: string[] = [];

  read(value: unknown): LibraryFile {
    const isFile = typeof value === 'object' && value !== null && 'format' in value && value.format === FILE_FORMAT;
    if (!isFile) throw new CodecError('bad-file', 'format', `format must be “${FILE_FORMAT}”`);
    const file = this.#know(value, '', HEAD);
    const version = whole(file.version, 'version', 1, Number.MAX_SAFE_INTEGER);
    if (version > FILE_VERSION) {
      const details = { value: version, max: FILE_VERSION };
      throw new CodecError('newer-version', 'version', `version ${version} is newer than ${FILE_VERSION}`, details);
    }
    return {
      writtenAt: dateFromFile(file.writtenAt, 'writtenAt'),
      writtenBy: text(file.writtenBy, 'writtenBy', LONGEST_NAME),
      library: {
        models: entries(file.models, 'models', (each, path) => this.#model(each, path)),
        settings: entries(file.settings, 'settings', (each, path) => this.#setting(each, path)),
        flights: entries(file.flights, 'flights', (each, path) => this.#flight(each, path)),
      },
      facts: this.#facts,
      ignored: this.#ignored,
    };
  }

  #model(value: unknown, path: string): Model {
    const of = this.#know(value, path, MODEL);
    const model = requireModel(of, path);
    for (const [at, servo] of (of.servos as unknown[]).entries()) this.#know(servo, `${path}.servos[${at}]`, SERVO);
    const { verified } = of;
    const memories =
      verified === undefined
        ? {}
        : {
            verified: list(verified, `${path}.verified`, MOST_VERIFIED).map((each, at) =>
              this.#verified(each, `${path}.verified[${at}]`),
            ),
          };
    return this.#noted(model, of, path, memories);
  }

  #setting(value: unknown, path: string): Setting {
    const of = this.#know(value, path, SETTING);
    return this.#noted(requireSetting({ ...of, ...this.#held(of, path) }, path), of, path);
  }

  #flight(value: unknown, path: string): Flight {
    const of = this.#know(value, path, FLIGHT);
    return this.#noted(requireFlight({ ...of, ...this.#held(of, path) }, path), of, path);
  }

  #verified(value: unknown, path: string): VerifiedMemory {
    const of = this.#know(value, path, VERIFIED);
    const held = this.#held(of, path);
    return of.simulated === undefined ? held : { ...held, simulated: flag(of.simulated, `${path}.simulated`) };
  }

  #held(of: Fields<'at' | 'program'>, path: string): { at: number; program: TimerProgram } {
    return { at: dateFromFile(of.at, `${path}.at`), program: this.#program(of.program, `${path}.program`) };
  }

  #program(value: unknown, path: string): TimerProgram {
    const program = programFromFile(value, path);
    const of = this.#know(value, path, [...PROGRAM, startTime(program.identity)]);
    this.#know(of.identity, `${path}.identity`, IDENTITY);
    for (const [at, row] of (of.slots as unknown[]).entries()) {
      this.#know(row, `${path}.slots[${at}]`, at === 0 ? SLOT : [...SLOT, 'time']);
    }
    return program;
  }

  #noted<T extends Model | Setting | Flight>(
    entry: T,
    { changedAt }: Fields<'changedAt'>,
    path: string,
    more: EntryFacts = {},
  ): T {
    const facts = changedAt === undefined ? more : { ...more, changedAt: dateFromFile(changedAt, `${path}.changedAt`) };
    if (Object.keys(facts).length > 0) this.#facts.set(entry, facts);
    return entry;
  }

  /** Notes the names that are not known. */
  #know<Name extends string>(value: unknown, path: string, names: readonly Name[]): Fields<Name> {
    const of = record<Fields<Name>>(value, path);
    for (const name of Object.keys(of)) {
      if ((names as readonly string[]).includes(name) || this.#ignored.length === MOST_IGNORED) continue;
      this.#ignored.push(path === '' ? name : `${path}.${name}`);
    }
    return of;
  }
}
