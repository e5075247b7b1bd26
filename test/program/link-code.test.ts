import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { crc32 } from '../../src/program/bytes.js';
import { decodeLink, encodeLink, LINK_MARK, type SharedSetting } from '../../src/program/index.js';
import { CodecError } from '../../src/protocol/index.js';
import { program, shared } from '../fuzz/kept.js';
import { MODEL, SETTING } from './library-examples.js';

const { name, note, tags, at, program: held } = SETTING;
const SHARED: SharedSetting = { name, note, tags, at, program: held, modelName: MODEL.name };

const bytesOf = (code: string): Uint8Array => Uint8Array.from(Buffer.from(code, 'base64url'));
const codeOf = (bytes: Iterable<number>): string => Buffer.from([...bytes]).toString('base64url');
/** The same bytes with the sum that fits. */
const summed = (bytes: Iterable<number>): string => {
  const sum = crc32(Uint8Array.from(bytes));
  return codeOf([...bytes, sum & 0xff, (sum >> 8) & 0xff, (sum >> 16) & 0xff, sum >>> 24]);
};
const bodyOf = (of: SharedSetting): number[] => [...bytesOf(encodeLink(of))].slice(0, -4);

/** Ends with its name and three empty lists: 1, a, 0, 0, 0. */
const BARE: SharedSetting = { ...SHARED, name: 'a', modelName: '', note: '', tags: [] };

/** The body of an example with another byte at one place. */
const other = (at: number, byte: number): number[] => bodyOf(SHARED).map((old, index) => (index === at ? byte : old));

const refusal = (link: string): string => {
  try {
    decodeLink(link);
  } catch (error) {
    return error instanceof CodecError ? `${error.code} ${error.field}` : String(error);
  }
  return 'taken';
};

describe('a link', () => {
  it('has the bytes that docs/file-format.md shows', () => {
    const small: SharedSetting = {
      name: 'calm',
      modelName: 'Lancer 07',
      note: '',
      tags: ['fly-off'],
      at: 1_795_000_000_000,
      program: {
        identity: { timerClass: 'Q', firmware: '536', functions: 2, memories: 4, servos: 2 },
        memory: 1,
        times: [1000, 30, 18000],
        positions: [
          [15, 25, 115],
          [20, 30, 120],
        ],
        idleThrottle: 12,
      },
    };
    const page = readFileSync(new URL('../../docs/file-format.md', import.meta.url), 'utf8');
    const [, shown = ''] = /```text link\n(.*?)```/s.exec(page) ?? [];
    const lines = shown.split('\n');
    const hex = lines.map((line) => /^(?:[0-9a-f]{2} )+/.exec(`${line.split('  ')[0]} `)?.[0] ?? '').join('');
    const [code = ''] = lines.filter((line) => line.startsWith(LINK_MARK)).map((line) => line.slice(LINK_MARK.length));
    expect(encodeLink(small)).toBe(code);
    expect([...bytesOf(code)].map((byte) => byte.toString(16).padStart(2, '0')).join(' ')).toBe(hex.trim());
    expect(decodeLink(encodeLink(small))).toEqual(small);
  });

  it.each(['5A6', '050306', ' 5.'])('brings back a firmware that is no number: %s', (firmware) => {
    const program = { ...SHARED.program, identity: { ...SHARED.program.identity, firmware } };
    expect(decodeLink(encodeLink({ ...SHARED, program })).program).toEqual(program);
  });

  it('brings back whatever a pilot can share', () => {
    fc.assert(
      fc.property(shared, (setting) => {
        const code = encodeLink(setting);
        expect(code).toMatch(/^[\w-]+$/);
        expect(decodeLink(code)).toEqual(setting);
        expect(decodeLink(`https://example.org/sidus/?x=1${LINK_MARK}${code}`)).toEqual(setting);
      }),
    );
  });

  it('of 44 values is shorter than 200 characters, with its mark and 60 characters of text', () => {
    const identity = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };
    const row = Array.from({ length: 11 }, () => 255);
    const full = { identity, memory: 3, times: row.map(() => 65_535), positions: [row, row, row], idleThrottle: 255 };
    const setting = { ...SHARED, program: full, name: 'x'.repeat(20), modelName: 'y'.repeat(20), note: 'z'.repeat(20) };
    const spoken = `${LINK_MARK}${encodeLink({ ...setting, tags: [] })}`;
    expect(spoken.length).toBeLessThan(200);
  });

  it.each(['', 'https://example.org/#library', `${LINK_MARK}%41`])('is not %j', (text) =>
    expect(refusal(text)).toBe('bad-link link'),
  );

  it.each<[string, (code: string) => string]>([
    [
      'the line breaks of a mail program',
      (code) => ` https://example.org/\n ${LINK_MARK}${code.replaceAll(/.{20}/g, '$&\r\n ')} \n`,
    ],
    ['a full stop after it', (code) => `${LINK_MARK}${code}.`],
    ['a bracket and a line after it', (code) => `<https://example.org/${LINK_MARK}${code}>\nSee you, Jo`],
    ['words after it', (code) => `Take this: https://example.org/${LINK_MARK}${code} and good luck. It is calm.`],
    ['words in lines after it', (code) => `${LINK_MARK}\n${code}\n\nSent from the field`],
    ['a full stop and a line after its lines', (code) => `${LINK_MARK}${code.replaceAll(/.{20}/g, '$&\n')}.\nJo`],
    ['what counts clicks', (code) => `${LINK_MARK}${code}&utm_source=x&fbclid=IwAR0-_`],
    ['the marks of a text in bold', (code) => `**${LINK_MARK}${code}**`],
    ['signs in percent coding', (code) => `#s%3D${code.replaceAll('-', '%2D').replaceAll('_', '%5f')}%0d%0A`],
    ['all signs in percent coding', (code) => encodeURIComponent(`https://example.org/${LINK_MARK}${code}`)],
    ['spaces in percent coding', (code) => `${LINK_MARK}${code.replaceAll(/.{20}/g, '$&%20')}`],
  ])('is read with %s', (_, change) => {
    expect(decodeLink(change(encodeLink(SHARED)))).toEqual(SHARED);
  });

  it('of which a part is missing is refused, whatever follows', () => {
    const code = encodeLink(SHARED);
    expect(refusal(`${LINK_MARK}${code.slice(0, 20)} ${code.slice(21)}`)).toBe('bad-link link');
    expect(refusal(`${LINK_MARK}${code.slice(0, -1)}… and more`)).toBe('bad-link link');
    expect(refusal(`${LINK_MARK}%C3%A4${code}`), 'a letter of two bytes').toBe('bad-link link');
    expect(refusal(summed([2, 1]).replace(/^.{3}/, '$&\n')), 'a newer one in two lines').toBe('newer-version link');
  });

  it('is refused when it was cut or changed anywhere', () => {
    const code = encodeLink(SHARED);
    for (let cut = 0; cut < code.length; cut++) {
      expect(refusal(code.slice(0, cut))).toBe('bad-link link');
      expect(refusal(code.slice(cut + 1))).toBe('bad-link link');
      for (const wrong of 'A_9z*') {
        if (code[cut] === wrong) continue;
        expect(refusal(code.slice(0, cut) + wrong + code.slice(cut + 1))).toBe('bad-link link');
      }
    }
  });

  it.each([
    ['a newer version', [2, 1, 2, 3], 'newer-version link'],
    ['version 0', [0, ...bodyOf(SHARED).slice(1)], 'bad-link link'],
    ['nothing in it', [1], 'bad-link link'],
    ['something after its end', [...bodyOf(SHARED), 0], 'bad-link link'],
    ['an unknown flag', other(7, 4), 'bad-link link'],
    ['an unknown flag beside all others', other(7, 7), 'bad-link link'],
    ['only the sum of no bytes', [], 'bad-link link'],
    ['a class that is no letter', other(1, 0x20), 'bad-identity setting.program.identity.timerClass'],
    ['more servos than bytes', other(6, 255), 'bad-link link'],
    ['a firmware of four digits', other(3, 254), 'bad-identity setting.program.identity.firmware'],
    ['a memory that the timer has not', other(8, 4), 'out-of-range setting.program.memory'],
    ['an empty name', [...bodyOf(BARE).slice(0, -5), 0, 0, 0, 0], 'out-of-range setting.name'],
    ['a text that is not UTF-8', [...bodyOf(BARE).slice(0, -4), 0xff, 0, 0, 0], 'bad-link link'],
  ])('with %s and the right sum is refused', (_, body, expected) => {
    expect(refusal(summed(body))).toBe(expected);
  });

  it.each<[string, string, object]>([
    ['A'.repeat(60_001), 'a link has at most 60000 characters', { value: 60_001, max: 60_000 }],
    [summed([2, 1]), 'version 2 is newer than 1', { value: 2, max: 1 }],
    [summed([0, 1]), 'no whole link: there is no version 0', {}],
    ['A', 'no whole link: no bytes have this length', {}],
  ])('says what is wrong, with the limits (%#)', (link, message, details) => {
    expect(() => decodeLink(link)).toThrowError(expect.objectContaining({ message, details }));
  });

  it('is refused unread when it is far too long', () => {
    expect(refusal('A'.repeat(60_000)), 'a code of a length that is allowed is read, and then refused').toBe(
      'bad-link link',
    );
    expect(refusal('A'.repeat(60_001))).toBe('too-large link');
    expect(refusal(`${' '.repeat(1_000_000)}${encodeLink(SHARED)}`)).toBe('too-large link');
  });

  it('carries only as much of a note as it has room for, and says so', () => {
    const long = { ...SHARED, note: '🛩️ '.repeat(1600) };
    const whole = encodeLink(long);
    expect(decodeLink(whole)).toEqual(long);
    fc.assert(
      fc.property(fc.integer({ min: 150, max: whole.length - 1 }), (longest) => {
        const code = encodeLink(long, { longest });
        expect(code.length).toBeLessThanOrEqual(longest);
        expect(code.length).toBeGreaterThan(longest - 30);
        const { note: cut, ...rest } = decodeLink(code);
        expect({ ...rest, note: long.note }).toEqual(long);
        expect(cut.endsWith('…')).toBe(true);
        expect(long.note.startsWith(cut.slice(0, -2))).toBe(true);
      }),
      { numRuns: 50 },
    );
    expect(encodeLink(long, { longest: whole.length })).toBe(whole);
    expect(decodeLink(encodeLink(long, { longest: 0 })).note).toBe('');
    const cut = encodeLink(long, { longest: 1000 });
    expect(encodeLink(long, { longest: cut.length }), 'a note that just fits is not cut').toBe(cut);
  });

  it('cuts a note after a word, however long the gap is', () => {
    const noted = (note: string) => ({ ...SHARED, note });
    const gap = noted(`  ab${' '.repeat(400)}${'x'.repeat(400)}`);
    const longest = encodeLink(noted('x'.repeat(300))).length;
    expect(decodeLink(encodeLink(gap, { longest })).note).toBe('  ab …');
  });

  it('is made only of a setting', () => {
    expect(() => encodeLink({ ...SHARED, modelName: 'x'.repeat(61) })).toThrowError(
      expect.objectContaining({ code: 'out-of-range', field: 'setting.modelName' }),
    );
    fc.assert(
      fc.property(program, (of) => {
        expect(() => encodeLink({ ...SHARED, program: { ...of, times: of.times.slice(1) } })).toThrow(CodecError);
      }),
      { numRuns: 20 },
    );
  });
});
