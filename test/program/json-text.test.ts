import { describe, expect, it } from 'vitest';
import { placeInText, readJson, writeJson } from '../../src/program/json-text.js';
import { refusalOf } from './refusal.js';

describe('a text of JSON', () => {
  it.each([
    ['"\\u00e9\\u00E9"', 'éé'],
    ['"\\"\\\\\\/\\b\\f\\n\\r\\t"', '"\\/\b\f\n\r\t'],
    ['"a\\u0041b"', 'aAb'],
    [' [ true , false , null , -1.25e2 ] ', [true, false, null, -125]],
    ['[1e2, 1E+2, 1e-2]', [100, 100, 0.01]],
  ])('%s is read', (text, value) => {
    expect(readJson(text)).toEqual(value);
  });

  it.each([
    ['"a\\x0041"', 3, 'no such character can follow \\'],
    ['"\\u00g1"', 2, 'no such character can follow \\'],
    ['"\\u00"', 2, 'no such character can follow \\'],
    ['"a\nb"', 3, 'a text must end on its line'],
    ['{a: 1}', 2, 'a name must stand here'],
    ['{"a" 1}', 6, '“:” must stand here'],
    ['[1 2]', 4, '“]” must stand here'],
    ['[020]', 3, '“]” must stand here'],
    ['{"a": 1,}', 9, 'a name must stand here'],
    ['{"a": 1]', 8, '“}” must stand here'],
    ['[,]', 2, 'a value must stand here'],
    ['1 2', 3, 'something follows the end'],
  ])('%s is refused at column %i: %s', (text, column, why) => {
    const message = `bad-file text: line 1, column ${column}: ${why}`;
    expect(refusalOf(() => readJson(text))).toEqual([message, { line: 1, column }]);
  });

  it.each(['', '[', '{"a":', '"a', '[1,', '[1'])('%s ends too early', (text) => {
    const column = text.length + 1;
    const message = `bad-file end: line 1, column ${column}: it ends too early`;
    expect(refusalOf(() => readJson(text))).toEqual([message, { line: 1, column }]);
  });

  it('is refused when a name stands twice, with the name and its place', () => {
    expect(refusalOf(() => readJson('{"a": {"b": 1,\n "b": 2}}'))).toEqual([
      'duplicate a.b: line 2, column 2: this name stands twice',
      { value: 'b', line: 2, column: 2 },
    ]);
  });

  it.each(['{"a": 1, "a": "\\u003a"}', '{"a": 1, "a": "\\u003A"}', '{"a": ":", "a": 1}'])(
    '%s has a name twice',
    (text) => {
      expect(() => readJson(text)).toThrow('stands twice');
    },
  );

  it('may have colons in its names and texts', () => {
    const value = { 'a:b': ['::', { c: ':' }], d: 'e' };
    expect(readJson(JSON.stringify(value))).toEqual(value);
  });

  it('may be nested at most 32 deep', () => {
    expect(readJson(`${'['.repeat(32)}1${']'.repeat(32)}`)).toHaveLength(1);
    expect(refusalOf(() => readJson(`${'['.repeat(33)}1${']'.repeat(33)}`))).toEqual([
      `too-large ${'[0]'.repeat(33)}: line 1, column 34: nested deeper than 32`,
      { max: 32, line: 1, column: 34 },
    ]);
  });
});

const text = '{\n  "ab": [1, {"c": 2}],\n  "a": {"b": 3}\n}';

it.each([
  ['', 1, 1],
  ['ab', 2, 9],
  ['ab[0]', 2, 10],
  ['ab[1].c', 2, 19],
  ['a', 3, 8],
  ['a.b', 3, 14],
  ['ab[1].missing', 2, 13],
  ['ab[7]', 2, 9],
  ['a.b.c', 3, 14],
  ['abc', 1, 1],
  ['missing', 1, 1],
])('the place of a value in a text: %s: line %i, column %i', (path, line, column) => {
  expect(placeInText(text, path)).toEqual({ line, column });
});

it('a text begins after the blanks before it', () => {
  expect(placeInText(' \n  {"a": 1}', 'missing')).toEqual({ line: 2, column: 3 });
});

describe('JSON that a person can read', () => {
  it.each([
    [{}, '{}'],
    [[], '[]'],
    [{ a: [] }, '{ "a": [] }'],
    [[1, 'a', null], '[1, "a", null]'],
    [{ a: 1, b: { c: 2 } }, '{ "a": 1, "b": { "c": 2 } }'],
  ])('%o fits on one line', (value, text) => {
    expect(writeJson(value)).toBe(text);
  });

  it('has a line for each value when it does not fit in 110 characters with its surroundings', () => {
    const fits = { a: 'x'.repeat(97) };
    const more = { a: 'x'.repeat(98) };
    expect(writeJson(fits)).toBe(`{ "a": "${fits.a}" }`);
    expect(writeJson(more)).toBe(`{\n  "a": "${more.a}"\n}`);
    expect(writeJson([more, 1])).toBe(`[\n  {\n    "a": "${more.a}"\n  },\n  1\n]`);
    expect(writeJson([fits]), 'an object that is indented has less room on its line').toBe(
      `[\n  {\n    "a": "${fits.a}"\n  }\n]`,
    );
  });
});
