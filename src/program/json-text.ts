import { CodecError } from '../protocol/index.js';

/*
 * `JSON.parse` reads a text ten times as fast as the reader below, but does three things less: it does not say where a
 * fault stands (even one that is found later, by the path of a value), takes a name that stands twice, and has no limit
 * of depth. So it comes first, and whatever is wrong is left to the reader, which makes no value.
 */

/** Deeper than anything that a pilot keeps. */
const DEEPEST = 32;
/** A line of this width still fits on a screen, or on a sheet of paper in landscape. */
const WIDEST = 110;

/** Called where each value begins, with its path: `settings[3].name`. */
type Listener = (path: string, offset: number) => void;

/** @throws CodecError `bad-file` (field `text` or `end`), `duplicate`, `too-large`; each with line and column. */
export function readJson(text: string): unknown {
  try {
    const value: unknown = JSON.parse(text);
    // A colon that is written as an escape is none of the text.
    const isPlain = !text.includes('\\u003a') && !text.includes('\\u003A');
    if (isPlain && colonsIn(value, 0) === colonsIn(text, 0)) return value;
  } catch {
    // The reader says where the fault stands.
  }
  new JsonReader(text, null).read();
  return JSON.parse(text);
}

/**
 * How many colons a value takes in a text: one for each name, and those inside names and texts. A name that stands
 * twice leaves fewer of them than the text has.
 * @throws Error when it is nested too deeply.
 */
function colonsIn(value: unknown, depth: number): number {
  if (depth > DEEPEST) throw new Error('too deep');
  let found = 0;
  if (typeof value === 'string') {
    for (let at = value.indexOf(':'); at >= 0; at = value.indexOf(':', at + 1)) found++;
    return found;
  }
  if (typeof value !== 'object' || value === null) return 0;
  if (Array.isArray(value)) for (const each of value) found += colonsIn(each, depth + 1);
  else {
    const parts = value as Readonly<Record<string, unknown>>;
    for (const name of Object.keys(parts)) found += 1 + colonsIn(name, depth) + colonsIn(parts[name], depth + 1);
  }
  return found;
}

/**
 * Where a value begins. For a missing value: where the value that should hold it begins. Line and column count from 1.
 */
export function placeInText(text: string, path: string): { line: number; column: number } {
  let begin = 0;
  // An outer value is reported before the values inside it, so the last match is the deepest.
  new JsonReader(text, (at, offset) => {
    const next = path[at.length];
    const within = path.startsWith(at) && (next === undefined || next === '.' || next === '[');
    if (at === '' || within) begin = offset;
  }).read();
  return lineAndColumn(text, begin);
}

function lineAndColumn(text: string, offset: number): { line: number; column: number } {
  const lines = text.slice(0, offset).split(/\r\n|\r|\n/);
  return { line: lines.length, column: (lines.at(-1) as string).length + 1 };
}

const SPACE = /[ \n\r\t]*/y;
const COMMA = /,/y;
const WORD = /true|false|null|-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y;
/** All but quotes, backslashes and control characters. */
const PLAIN = /[ !#-[\]-\uffff]*/y;
const ESCAPE = /\\(?:["\\/bfnrt]|u[\dA-Fa-f]{4})/y;

class JsonReader {
  readonly #text: string;
  readonly #listener: Listener | null;
  #at = 0;

  constructor(text: string, listener: Listener | null) {
    this.#text = text;
    this.#listener = listener;
  }

  /** Goes through the whole text. @throws CodecError */
  read(): void {
    this.#value('', 0);
    this.#match(SPACE);
    if (this.#at < this.#text.length) this.#refuse('something follows the end');
  }

  #value(path: string, depth: number): void {
    this.#match(SPACE);
    this.#listener?.(path, this.#at);
    if (depth > DEEPEST) {
      throw this.#error('too-large', path, `nested deeper than ${DEEPEST}`, { max: DEEPEST });
    }
    const next = this.#text[this.#at];
    if (next === '{' || next === '[') this.#parts(path, depth, next === '{');
    else if (next === '"') this.#string();
    else if (this.#match(WORD) === '') this.#refuse('a value must stand here');
  }

  /** The parts of an object or a list, separated by commas. */
  #parts(path: string, depth: number, isObject: boolean): void {
    const names = new Set<string>();
    const end = isObject ? '}' : ']';
    this.#at++;
    this.#match(SPACE);
    if (this.#text[this.#at] !== end) {
      let count = 0;
      do {
        this.#value(isObject ? this.#name(path, names) : `${path}[${count++}]`, depth + 1);
        this.#match(SPACE);
      } while (this.#match(COMMA) !== '');
    }
    this.#take(end);
  }

  /** The name of a part and its colon. @returns the path of the part. */
  #name(path: string, names: Set<string>): string {
    this.#match(SPACE);
    const from = this.#at;
    if (this.#text[from] !== '"') this.#refuse('a name must stand here');
    const name = this.#string();
    const inside = path === '' ? name : `${path}.${name}`;
    if (names.has(name)) throw this.#error('duplicate', inside, 'this name stands twice', { value: name }, from);
    names.add(name);
    this.#match(SPACE);
    this.#take(':');
    return inside;
  }

  #string(): string {
    const from = this.#at++;
    do this.#match(PLAIN);
    while (this.#match(ESCAPE) !== '');
    const next = this.#text[this.#at];
    if (next !== '"') this.#refuse(next === '\\' ? 'no such character can follow \\' : 'a text must end on its line');
    this.#at++;
    return JSON.parse(this.#text.slice(from, this.#at));
  }

  /** Goes past what matches here. */
  #match(pattern: RegExp): string {
    pattern.lastIndex = this.#at;
    const [found = ''] = pattern.exec(this.#text) ?? [];
    this.#at += found.length;
    return found;
  }

  #take(wanted: string): void {
    if (this.#text[this.#at] !== wanted) this.#refuse(`“${wanted}” must stand here`);
    this.#at++;
  }

  #refuse(why: string): never {
    const ended = this.#at >= this.#text.length;
    throw this.#error('bad-file', ended ? 'end' : 'text', ended ? 'it ends too early' : why, {});
  }

  #error(
    code: 'bad-file' | 'duplicate' | 'too-large',
    field: string,
    why: string,
    details: { readonly value?: unknown; readonly max?: number },
    at = this.#at,
  ): CodecError {
    const place = lineAndColumn(this.#text, at);
    return new CodecError(code, field, `line ${place.line}, column ${place.column}: ${why}`, { ...details, ...place });
  }
}

/**
 * Writes JSON for people: a value that fits on one line stands on one; any other has one line for each of its parts.
 */
export function writeJson(value: unknown, indent = ''): string {
  const inner = `${indent}  `;
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const lines = Array.isArray(value)
    ? value.map((each) => writeJson(each, inner))
    : Object.entries(value).map(([name, each]) => `${JSON.stringify(name)}: ${writeJson(each, inner)}`);
  const [open, close] = Array.isArray(value) ? ['[', ']'] : ['{ ', ' }'];
  if (lines.length === 0) return `${open}${close}`.replace('  ', '');
  const length = lines.reduce((sum, line) => sum + line.length + 2, indent.length + 4);
  // A text that has several lines inside is longer than the limit in any case.
  if (length <= WIDEST) return `${open}${lines.join(', ')}${close}`;
  return `${open.trim()}\n${lines.map((line) => inner + line).join(',\n')}\n${indent}${close.trim()}`;
}
