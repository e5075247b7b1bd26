import { CodecError } from '../protocol/index.js';
import { dateFromFile, dateToFile, programFromFile, programToFile } from './file-values.js';
import { placeInText, readJson, writeJson } from './json-text.js';
import {
  entries,
  type Flight,
  LIMITS,
  type Library,
  type Model,
  requireFlight,
  requireLibrary,
  requireModel,
  requireSetting,
  requireVersion,
  type Setting,
  type SettingVersion,
} from './library.js';
import type { TimerProgram } from './program.js';
import { flag, LAST_DATE, list, type Raw, record, text, whole } from './require.js';

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
  /** For a setting: what it held before, the latest first. At most 20. */
  readonly versions?: readonly SettingVersion[];
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

const KINDS = ['models', 'settings', 'flights'] as const;
type Kind = (typeof KINDS)[number];
type Entry = Model | Setting | Flight;
type Content = Omit<LibraryFile, 'ignored' | 'facts'> & { readonly facts: ReadonlyMap<Entry, EntryFacts | undefined> };

/** In characters. */
const LONGEST_NAME = 200;
const MOST_IGNORED = 20;
const MOST_VERIFIED = 255;

/**
 * Writes a library, or a part of one, as JSON that a person can read, too. docs/file-format.md describes it.
 * @param head when it is written, in milliseconds since 1970, and which program writes it, up to 200 characters.
 * @throws CodecError `wrong-type`, `out-of-range`, `not-an-integer`, `wrong-count`, `unknown-word`, `bad-identity` or
 * `duplicate` when it is no library; `too-large` past 20 million characters.
 */
export function formatLibraryFile(
  library: Library,
  head: { readonly writtenAt: number; readonly writtenBy: string; readonly facts?: FactsOf },
): string {
  // Whatever could not be read back must not be written.
  const checked = requireLibrary(library);
  whole(head.writtenAt, 'writtenAt', 0, LAST_DATE);
  text(head.writtenBy, 'writtenBy', LONGEST_NAME);
  const facts = new Map(
    KINDS.flatMap((kind) => checked[kind].map((entry, at) => [entry, head.facts?.get(library[kind][at] as Entry)])),
  );
  const written = writeJson(toFile({ ...head, library: checked, facts }));
  requireSize(written);
  return `${written}\n`;
}

/** What stands in the file. */
function toFile({ library, facts, writtenAt, writtenBy }: Content): object {
  const held = ({ at, program }: Pick<VerifiedMemory, 'at' | 'program'>): object => ({
    at: dateToFile(at),
    program: programToFile(program),
  });
  const written = (entry: Entry): object => {
    const { changedAt, verified, versions } = facts.get(entry) ?? {};
    return {
      ...entry,
      ...('program' in entry && held(entry)),
      ...(changedAt !== undefined && { changedAt: dateToFile(changedAt) }),
      ...(verified && {
        verified: verified.map((each) => ({
          ...held(each),
          ...(each.simulated !== undefined && { simulated: each.simulated }),
        })),
      }),
      ...(versions && {
        versions: versions.map((each) => ({ until: dateToFile(each.until), ...held(each), from: each.from })),
      }),
    };
  };
  return {
    format: FILE_FORMAT,
    version: FILE_VERSION,
    writtenAt: dateToFile(writtenAt),
    writtenBy,
    models: library.models.map(written),
    settings: library.settings.map(written),
    flights: library.flights.map(written),
  };
}

/**
 * Reads a library file. Line ends may be those of any system. An unknown field is skipped and named in `ignored`.
 * Everything else is checked as strictly as a reply of a timer.
 * @throws CodecError with the path as field, and line and column in its details: `bad-file` for another kind of file
 * (field `format`), a broken text (`text`), a text that ends too early (`end`) or UTF-16 that was read as another
 * encoding (`encoding`); `newer-version`; and as {@link formatLibraryFile}.
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
    const file = fromFile(value);
    return { ...file, ignored: ignoredIn(Object(value), toFile(file)) };
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

function fromFile(value: unknown): Content & Pick<LibraryFile, 'facts'> {
  const of = Object(value) as Raw<Library & Record<'format' | 'version' | 'writtenAt' | 'writtenBy', unknown>>;
  if (of.format !== FILE_FORMAT) throw new CodecError('bad-file', 'format', `format must be “${FILE_FORMAT}”`);
  const version = whole(of.version, 'version', 1, Number.MAX_SAFE_INTEGER);
  if (version > FILE_VERSION) {
    const details = { value: version, max: FILE_VERSION };
    throw new CodecError('newer-version', 'version', `version ${version} is newer than ${FILE_VERSION}`, details);
  }
  const facts = new Map<Entry, EntryFacts>();
  const read = <T extends Entry>(kind: Kind, entryOf: (raw: unknown, path: string) => T): readonly T[] =>
    entries(of[kind], kind, (raw, path) => {
      const entry = entryOf(raw, path);
      const known = factsOf(raw as Raw<EntryFacts>, path, kind);
      if (Object.keys(known).length > 0) facts.set(entry, known);
      return entry;
    });
  return {
    writtenAt: dateFromFile(of.writtenAt, 'writtenAt'),
    writtenBy: text(of.writtenBy, 'writtenBy', LONGEST_NAME),
    library: {
      models: read('models', requireModel),
      settings: read('settings', (raw, path) => requireSetting(withHeld(raw, path), path)),
      flights: read('flights', (raw, path) => requireFlight(withHeld(raw, path), path)),
    },
    facts,
  };
}

function withHeld(raw: unknown, path: string): Raw<VerifiedMemory> & Pick<VerifiedMemory, 'at' | 'program'> {
  const of = record<VerifiedMemory>(raw, path);
  const at = dateFromFile(of.at, `${path}.at`);
  return { ...of, at, program: programFromFile(of.program, `${path}.program`) };
}

function factsOf({ verified, versions, changedAt }: Raw<EntryFacts>, path: string, kind: Kind): EntryFacts {
  const memory = (raw: unknown, index: number): VerifiedMemory => {
    const place = `${path}.verified[${index}]`;
    const { at, program, simulated } = withHeld(raw, place);
    return { at, program, ...(simulated !== undefined && { simulated: flag(simulated, `${place}.simulated`) }) };
  };
  const version = (raw: unknown, index: number): SettingVersion => {
    const place = `${path}.versions[${index}]`;
    const of = record<SettingVersion>(raw, place);
    return requireVersion({ ...withHeld(of, place), until: dateFromFile(of.until, `${place}.until`) }, place);
  };
  return {
    ...(kind === 'models' &&
      verified !== undefined && { verified: list(verified, `${path}.verified`, MOST_VERIFIED).map(memory) }),
    ...(kind === 'settings' &&
      versions !== undefined && { versions: list(versions, `${path}.versions`, LIMITS.versions).map(version) }),
    ...(changedAt !== undefined && { changedAt: dateFromFile(changedAt, `${path}.changedAt`) }),
  };
}

/** Names that say nothing: where the schema is; the picture of a model, in files of an earlier version. */
const SILENT = ['$schema', 'photo'];

/** The names of a file that what was read of it does not have. */
function ignoredIn(given: object, read: object): string[] {
  const found: string[] = [];
  for (const place of namesBeyond(given, read)) {
    if (found.length === MOST_IGNORED) break;
    found.push(place.slice(1));
  }
  return found;
}

function* namesBeyond(given: object, read: object): Generator<string> {
  for (const [name, value] of Object.entries(given)) {
    if (value === null || SILENT.includes(name)) continue;
    const inside = (read as Readonly<Record<string, object>>)[name];
    const place = Array.isArray(given) ? `[${name}]` : `.${name}`;
    if (!Object.hasOwn(read, name)) yield place;
    else if (typeof value === 'object') for (const inner of namesBeyond(value, inside as object)) yield place + inner;
  }
}
