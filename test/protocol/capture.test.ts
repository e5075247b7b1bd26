import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  analyse,
  type CaptureEntry,
  captureOf,
  encodeReply,
  encodeRequest,
  formatCapture,
  parseCapture,
} from '../../src/protocol/index.js';
import { fromHex } from '../tools/bytes.js';
import { B536 } from './vectors.js';

const example: CaptureEntry[] = [
  { time: 0, direction: 'out', bytes: fromHex('00 00 00 00 00 03 6b 6b 45') },
  { time: 52.5, direction: 'in', bytes: fromHex('00 00 00 00 00 0c 6c') },
  { time: 52.5, direction: 'in', bytes: fromHex('42') },
];
const text = `# Sidus capture 1
0.000 > 00 00 00 00 00 03 6b 6b 45
0.0525 < 00 00 00 00 00 0c 6c
0.0525 < 42
`;

describe('a capture as text', () => {
  it('has a heading, and time, direction and bytes in each line', () => {
    expect(formatCapture(example.map((entry) => ({ ...entry, time: Math.round(entry.time) })))).toBe(
      text.replaceAll('0.0525', '0.053'),
    );
    expect(parseCapture(text)).toEqual(example);
  });

  it('is read with remarks, empty lines, tabs, capitals, a byte order mark and the line ends of any system', () => {
    const other = `\uFEFF${text.toUpperCase().replace('SIDUS CAPTURE', 'Sidus capture').replaceAll(' > ', '\t>  ')}# end\n\n`;
    expect(parseCapture(other.replaceAll('\n', '\r\n'))).toEqual(example);
    expect(parseCapture(other.replaceAll('\n', '\r'))).toEqual(example);
    expect(parseCapture('# Sidus capture 1')).toEqual([]);
    expect(parseCapture(' # Sidus capture 1 \n  # a remark\n \n 5 > 00 ')).toEqual([
      { time: 5000, direction: 'out', bytes: fromHex('00') },
    ]);
  });

  it.each([
    ['nothing', '', 'line 1'],
    ['no heading', '0.000 > 00', 'line 1'],
    ['another version', '# Sidus capture 2\n', 'line 1'],
    ['no time', '# Sidus capture 1\n> 00', 'line 2'],
    ['a negative time', '# Sidus capture 1\n-1 > 00', 'line 2'],
    ['no direction', '# Sidus capture 1\n0.1 00 00', 'line 2'],
    ['no bytes', '# Sidus capture 1\n0.1 >', 'line 2'],
    ['half a byte', '# Sidus capture 1\n0.1 > 00 0', 'line 2'],
    ['no hex', '# Sidus capture 1\n0.1 > 00 0g', 'line 2'],
    ['a time that runs backwards', '# Sidus capture 1\n0.2 > 00\n# pause\n0.1 < 00', 'line 4'],
  ])('is refused with its line: %s', (_, bad, field) => {
    expect(() => parseCapture(bad)).toThrowError(expect.objectContaining({ code: 'bad-capture', field }));
  });

  it('comes back as it was, whatever was captured', () => {
    const entry = fc.record({
      wait: fc.integer({ min: 0, max: 100_000 }),
      direction: fc.constantFrom('out' as const, 'in' as const),
      bytes: fc.uint8Array({ minLength: 1, maxLength: 300 }),
    });
    fc.assert(
      fc.property(fc.array(entry, { maxLength: 20 }), (list) => {
        let time = 0;
        const entries = list.map(({ wait, direction, bytes }) => {
          time += wait;
          return { time, direction, bytes };
        });
        expect(parseCapture(formatCapture(entries))).toEqual(entries);
      }),
      { numRuns: 300 },
    );
  });

  it('never throws anything but its own error', () => {
    const line = fc.oneof(fc.string(), fc.constantFrom('# Sidus capture 1', '0.1 > 00', '0.0 < ff', '1e309 > 00'));
    fc.assert(
      fc.property(fc.array(line, { maxLength: 6 }), (lines) => {
        try {
          parseCapture(lines.join('\n'));
        } catch (error) {
          expect(error).toMatchObject({ name: 'CodecError', code: 'bad-capture' });
        }
      }),
      { numRuns: 1000 },
    );
  });
});

describe('what cannot be a capture', () => {
  const bytes = Uint8Array.of(1);
  const entry: CaptureEntry = { time: 0, direction: 'in', bytes };
  it.each([
    [
      'times since 1970',
      [
        { ...entry, time: Date.UTC(2026, 0) },
        { ...entry, time: 0 },
      ],
      'entry 0',
    ],
    ['a time longer than a capture can be', [entry, { ...entry, time: 1e12 }], 'entry 1'],
    ['a negative time', [{ ...entry, time: -1 }], 'entry 0'],
    ['no time', [{ ...entry, time: Number.NaN }], 'entry 0'],
    ['a time that rounds to one', [{ ...entry, time: 1e12 - 0.4 }], 'entry 0'],
    ['no bytes', [entry, { ...entry, bytes: new Uint8Array() }], 'entry 1'],
    ['no list of bytes', [{ time: 0, direction: 'in' } as CaptureEntry], 'entry 0'],
    ['what is no byte', [{ ...entry, bytes: [256] as unknown as Uint8Array }], 'entry 0'],
    ['no direction', [{ ...entry, direction: 'up' as 'in' }], 'entry 0'],
  ])('is not written: %s', (_, entries, field) => {
    expect(() => formatCapture(entries)).toThrow(expect.objectContaining({ code: 'bad-capture', field }));
  });

  it('does not include the longest time, which has nine digits of seconds', () => {
    const longest = [{ ...entry, time: 999_999_999_999 }];
    expect(parseCapture(formatCapture(longest))).toEqual(longest);
  });

  it('can be converted: entries with the time of day, errors of the line, and a clock that was put back', () => {
    const begin = Date.UTC(2026, 0);
    const entries: CaptureEntry[] = [
      { time: begin - 5, direction: 'in', bytes: new Uint8Array() },
      { time: begin, direction: 'out', bytes },
      { time: begin + 30, direction: 'in', bytes },
      { time: begin - 3_600_000, direction: 'in', bytes },
    ];
    expect(captureOf(entries).map(({ time }) => time)).toEqual([0, 30, 30]);
    expect(parseCapture(formatCapture(captureOf(entries)))).toEqual(captureOf(entries));
    expect(captureOf([])).toEqual([]);
  });
});

describe('analyse()', () => {
  const seen = (entries: readonly CaptureEntry[]) =>
    analyse(entries).map(({ message, answers }) => [message?.name, answers]);
  const out = (time: number, bytes: Uint8Array): CaptureEntry => ({
    time,
    direction: 'out',
    bytes: Uint8Array.from(bytes),
  });
  const came = (time: number, bytes: Uint8Array): CaptureEntry => ({ ...out(time, bytes), direction: 'in' });

  it('reads each frame, and says which request a reply answers', () => {
    const times = Array.from({ length: 11 }, (_, slot) => 100 * slot);
    const reply = encodeReply({ name: 'GETTIMERS', times });
    const misprint = encodeReply({ name: 'SETTIMERS', times });
    const entries = [
      came(0, reply),
      out(10, encodeRequest({ name: 'GETSWVER' })),
      came(20, encodeReply({ name: 'GETSWVER', identity: B536 })),
      out(30, encodeRequest({ name: 'GETTIMERS' })),
      out(40, encodeRequest({ name: 'GETTIMERS' })),
      came(50, misprint.subarray(0, 9)),
      came(60, misprint.subarray(9)),
      came(70, reply),
      out(80, encodeRequest({ name: 'GETMEMORY' })),
      came(90, reply),
    ];
    expect(seen(entries)).toEqual([
      ['GETTIMERS', null],
      ['GETSWVER', null],
      ['GETSWVER', 1],
      ['GETTIMERS', null],
      ['GETTIMERS', null],
      ['GETTIMERS', 4],
      ['GETTIMERS', null],
      ['GETMEMORY', null],
      ['GETTIMERS', null],
    ]);
    expect(analyse(entries)[5]).toMatchObject({ time: 60, direction: 'in', bytes: misprint, message: { times } });
  });

  it('tells bytes of no frame, frames that fell silent, and messages that cannot be read', () => {
    const [cutOff, noise, unread] = analyse([
      came(0, fromHex('00 00 00 00 00 0c 6c 42')),
      came(100, fromHex('ff')),
      came(200, fromHex('00 00 00 00 00 04 68 01 69 45')),
    ]);
    expect(cutOff).toMatchObject({ time: 0, frame: null, rejected: 'silence', message: null });
    expect(noise).toMatchObject({ time: 100, frame: null, rejected: 'noise' });
    // Positions without an identity have no layout.
    expect(unread).toMatchObject({ frame: { code: 0x68 }, rejected: null, message: null, answers: null });
  });
});
