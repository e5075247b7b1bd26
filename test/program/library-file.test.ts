import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import {
  type EntryFacts,
  type FactsOf,
  type Flight,
  formatLibraryFile,
  type Library,
  type LibraryFile,
  MAX_FILE,
  type Model,
  parseLibraryFile,
  type Setting,
} from '../../src/program/index.js';
import { CodecError } from '../../src/protocol/index.js';
import { breach } from './json-schema.js';
import { FLIGHT, MODEL, SETTING, VERSION } from './library-examples.js';

const LIBRARY: Library = { models: [MODEL], settings: [SETTING], flights: [FLIGHT] };
const HEAD = { writtenAt: 1_795_000_000_000, writtenBy: 'Sidus Timer 0.2.0' };
const TEXT = formatLibraryFile(LIBRARY, HEAD);

const schema = JSON.parse(readFileSync(new URL('../../public/library.schema.json', import.meta.url), 'utf8'));

const refused = (text: string): string => {
  try {
    parseLibraryFile(text);
  } catch (error) {
    if (!(error instanceof CodecError)) return String(error);
    const { line, column } = error.details;
    return `${error.code} ${error.field} ${line}:${column}`;
  }
  return 'taken';
};

/** The example with one text in it replaced. */
const changed = (from: string | RegExp, to: string): string => {
  const text = TEXT.replace(from, to);
  expect(text).not.toBe(TEXT);
  return text;
};

describe('a library file', () => {
  it('is read and written as the example in docs/file-format.md shows', () => {
    const page = readFileSync(new URL('../../docs/file-format.md', import.meta.url), 'utf8');
    const [, example = ''] = /```json library\n(.*?)```/s.exec(page) ?? [];
    const file = parseLibraryFile(example);
    expect(file.library.settings[0]).toMatchObject({
      model: 'lancer-07',
      at: Date.UTC(2026, 10, 18, 11, 6, 40),
      program: { memory: 0, times: [1000, 30, 1050, 1300, 18_000], idleThrottle: 12 },
    });
    expect(file.ignored).toEqual([]);
    expect(formatLibraryFile(file.library, file)).toBe(example);
    expect(breach(schema, JSON.parse(example))).toBeUndefined();
  });

  it('is read without the picture of a model that earlier versions wrote', () => {
    const file = parseLibraryFile(changed('"note":', '"photo": "/9j/4AAQ", "note":'));
    expect(file.library).toEqual(LIBRARY);
    expect(file.ignored).toEqual([]);
  });

  it('lists what the reading leaves out', () => {
    const text = changed('"slot": "1"', '"slot": "1", "comment": "x"')
      .replace('"version": 1,', '"version": 1, "$schema": "library.schema.json", "season": 2026,')
      .replace('"duty": "other"', '"duty": "other", "__proto__": { "polluted": true }');
    const file = parseLibraryFile(text);
    expect(file.library).toEqual(LIBRARY);
    expect(file.ignored).toEqual(['season', 'models[0].servos[1].__proto__', 'settings[0].program.slots[1].comment']);
    expect({}).not.toHaveProperty('polluted');
    const many = changed(
      '"version": 1,',
      `"version": 1,${Array.from({ length: 50 }, (_, at) => `"x${at}": 0,`).join('')}`,
    );
    expect(parseLibraryFile(many).ignored).toHaveLength(20);
  });

  it.each([
    ['nothing', '', 'bad-file end 1:1'],
    ['white space', ' \n\t', 'bad-file end 2:2'],
    ['a recording', '# Sidus capture 1\n0.000 > 00', 'bad-file text 1:1'],
    ['a page', '<!doctype html>\n<html>', 'bad-file text 1:1'],
    ['another JSON', '{ "name": "sidus-timer", "version": 1 }', 'bad-file format 1:1'],
    ['a list', '[]', 'bad-file format 1:1'],
    ['a date of writing', changed('"writtenAt"', '"written"'), 'wrong-type writtenAt 1:1'],
    ['the name of a writer', changed('"writtenBy"', '"written"'), 'wrong-type writtenBy 1:1'],
    ['the letters of UTF-16', `ÿþ${[...TEXT].map((letter) => `${letter}\u0000`).join('')}`, 'bad-file encoding'],
    ['UTF-16 without a mark', [...TEXT].map((letter) => `${letter}\u0000`).join(''), 'bad-file encoding'],
    ['UTF-16 read as UTF-8', `\uFFFD\uFFFD${TEXT}`, 'bad-file encoding'],
    ['a file that was cut', TEXT.slice(0, TEXT.indexOf('"flights"')), 'bad-file end 45:3'],
    ['a name twice', changed('"version": 1,', '"version": 1,\n  "version": 1,'), 'duplicate version 4:3'],
    ['a newer version', changed('"version": 1', '"version": 2'), 'newer-version version 3:14'],
    ['version 0', changed('"version": 1', '"version": 0'), 'out-of-range version 3:14'],
    ['version 1.5', changed('"version": 1', '"version": 1.5'), 'not-an-integer version 3:14'],
    ['no models', changed('"models"', '"model"'), 'wrong-type models 1:1'],
    ['no name', changed('"name": "Lancer 07"', '"nam": "Lancer 07"'), 'wrong-type models[0].name 7:5'],
    ['a wrong class', changed('"timerClass": "Q"', '"timerClass": "QQ"'), 'wrong-type models[0].timerClass 10:21'],
    // What else a program in a file may not be is in file-values.test.ts, what no JSON is in json-text.test.ts.
    ['no motor stop', changed('"motorStop"', '"reserved"'), 'wrong-type settings[0].program.motorStop 28:18'],
    [
      'a step too far',
      changed('[25, 15]', '[25, 256]'),
      'out-of-range settings[0].program.slots[1].positions[1] 35:60',
    ],
    ['M0', changed('"memory": "M2"', '"memory": "M0"'), 'unknown-word settings[0].program.memory 30:19'],
    ['too much wind', changed('"wind": 1.5', '"wind": 1e999'), 'out-of-range flights[0].wind 67:15'],
  ])('that is %s is refused with its place', (_, text, expected) => {
    expect(refused(text).replace(' undefined:undefined', '')).toBe(expected);
    expect(refused(text.replaceAll(/\r?\n/g, '\r\n')).replace(' undefined:undefined', '')).toBe(expected);
  });

  it.each<[string, string, string, object]>([
    [
      'another format',
      '{ "format": "sidus-timer program" }',
      'line 1, column 13: format must be “sidus-timer library”',
      { line: 1, column: 13 },
    ],
    [
      'a newer version',
      changed('"version": 1', '"version": 2'),
      'line 3, column 14: version 2 is newer than 1',
      { value: 2, max: 1, line: 3, column: 14 },
    ],
    [
      'too much',
      'x'.repeat(MAX_FILE + 1),
      `a file has at most ${MAX_FILE} characters, not ${MAX_FILE + 1}`,
      { value: MAX_FILE + 1, max: MAX_FILE },
    ],
  ])('says what is wrong with %s, with its limits', (_, text, message, details) => {
    expect(() => parseLibraryFile(text)).toThrowError(expect.objectContaining({ message, details }));
  });

  it('may have byte order marks of other encodings in a name', () => {
    const name = 'ÿþ \uFEFF 07';
    const models = [{ ...MODEL, name }];
    expect(parseLibraryFile(`\uFEFF${formatLibraryFile({ ...LIBRARY, models }, HEAD)}`).library.models[0]?.name).toBe(
      name,
    );
    expect(parseLibraryFile(formatLibraryFile({ ...LIBRARY, models }, HEAD)).library.models[0]?.name).toBe(name);
  });

  it.each([
    ...[-840, 0, 345, 840].map((utcOffset) => ({ utcOffset })),
    ...[{ maximum: 180 }, { maximum: 1, counts: true }, { maximum: 36_000, counts: false }],
  ])('keeps what is known of a flight: %o', (known) => {
    const flights = [{ ...FLIGHT, ...known }];
    const text = formatLibraryFile({ ...LIBRARY, flights }, HEAD);
    expect(parseLibraryFile(text)).toMatchObject({ library: { flights }, ignored: [] });
    expect(breach(schema, JSON.parse(text))).toBeUndefined();
  });

  it('must not have an id twice', () => {
    const twice = { ...LIBRARY, settings: [SETTING, { ...SETTING, name: 'the same' }] };
    expect(() => formatLibraryFile(twice, HEAD)).toThrowError(
      expect.objectContaining({ code: 'duplicate', field: 'settings[1].id' }),
    );
    const [before = '', entry = '', after = ''] = TEXT.split(/(?<="settings": \[\n)(.*?)(?=\n {2}\],)/s);
    expect(refused(`${before}${entry},\n${entry}${after}`)).toMatch(/^duplicate settings\[1\]\.id 45:13$/);
  });

  it('of 100 MB is refused unread, and none is written that could not be read', () => {
    // Nothing in it is JSON: whoever looks at it finds another fault.
    expect(refused('x'.repeat(100_000_000))).toMatch(/^too-large file/);
    expect(refused('x'.repeat(MAX_FILE + 1))).toMatch(/^too-large file/);
    expect(refused('x'.repeat(MAX_FILE))).toMatch(/^bad-file text/);
    const note = 'A'.repeat(5000);
    const models = Array.from({ length: MAX_FILE / note.length }, (_, at) => ({ ...MODEL, note, id: `m${at}` }));
    expect(() => formatLibraryFile({ ...LIBRARY, models }, HEAD)).toThrowError(
      expect.objectContaining({ code: 'too-large', field: 'file' }),
    );
  });

  it('carries what is known about the timers', () => {
    const { program } = SETTING;
    const facts: FactsOf = new Map<Model | Flight, EntryFacts>([
      [
        MODEL,
        {
          changedAt: 5,
          verified: [
            { program, at: 7 },
            { program, at: 8, simulated: true },
            { program, at: 9, simulated: false },
          ],
        },
      ],
      [FLIGHT, { changedAt: 9 }],
    ]);
    const file: LibraryFile = parseLibraryFile(formatLibraryFile(LIBRARY, { ...HEAD, facts }));
    expect([...file.facts]).toEqual([...facts]);
    expect(file).toMatchObject(HEAD);
  });

  it.each<[string, (text: string) => string, string]>([
    ['a list', (text) => text.replace(/"verified": \[.*?\n {6}\]/s, '"verified": 5'), 'wrong-type models[0].verified'],
    ['of objects', (text) => text.replace('"verified": [', '"verified": [5, '), 'wrong-type models[0].verified[0]'],
    [
      'simulated or not',
      (text) => text.replace('"simulated": true', '"simulated": 1'),
      'wrong-type models[0].verified[0].simulated',
    ],
    [
      'changed on a day',
      (text) => text.replace('"changedAt": "', '"changedAt": "on '),
      'wrong-type models[0].changedAt',
    ],
  ])('must say what is known about the timers as %s', (_, change, expected) => {
    const facts: FactsOf = new Map([
      [MODEL, { changedAt: 5, verified: [{ program: SETTING.program, at: 8, simulated: true }] }],
    ]);
    const text = formatLibraryFile(LIBRARY, { ...HEAD, facts });
    expect(change(text)).not.toBe(text);
    expect(refused(change(text)).replace(/ \d+:\d+$/, '')).toBe(expected);
  });

  const versioned = (count: number): string =>
    formatLibraryFile(LIBRARY, {
      ...HEAD,
      facts: new Map<Setting, EntryFacts>([[SETTING, { versions: Array.from({ length: count }, () => VERSION) }]]),
    });

  it('carries twenty earlier versions of a setting at most, and its schema says so', () => {
    const text = versioned(20);
    const { facts, library, ignored } = parseLibraryFile(text);
    expect([...facts.values()]).toEqual([{ versions: Array.from({ length: 20 }, () => VERSION) }]);
    expect([library, ignored]).toEqual([LIBRARY, []]);
    expect(breach(schema, JSON.parse(text))).toBeUndefined();
    expect(refused(versioned(21))).toMatch(/^wrong-count settings\[0\]\.versions /);
    expect(breach(schema, JSON.parse(versioned(21)))).toBe('settings[0].versions: maxItems');
  });

  it.each<[string, string | RegExp, string, string]>([
    ['are no list', /"versions": \[.*?\n {6}\]/s, '"versions": 5', 'wrong-type settings[0].versions'],
    ['are no objects', '"versions": [', '"versions": [5, ', 'wrong-type settings[0].versions[0]'],
    ['have no end', '"until"', '"till"', 'wrong-type settings[0].versions[0].until'],
    ['end on a day', '"until": "', '"until": "on ', 'wrong-type settings[0].versions[0].until'],
    ['come from nowhere', '"from": "typed"', '"from": "air"', 'unknown-word settings[0].versions[0].from'],
  ])('with versions that %s is refused with the place, and the schema refuses it, too', (_, from, to, expected) => {
    const text = versioned(1).replace(from, to);
    expect(refused(text).replace(/ \d+:\d+$/, '')).toBe(expected);
    expect(breach(schema, JSON.parse(text))).toMatch(/^settings\[0\]\.versions/);
  });

  it.each([
    [{ ...HEAD, writtenAt: Number.NaN }, 'not-an-integer', 'writtenAt'],
    [{ ...HEAD, writtenBy: 'x'.repeat(201) }, 'out-of-range', 'writtenBy'],
  ])('is not written with a head that cannot be read again (%#)', (head, code, field) => {
    expect(() => formatLibraryFile(LIBRARY, head)).toThrowError(expect.objectContaining({ code, field }));
  });
});
