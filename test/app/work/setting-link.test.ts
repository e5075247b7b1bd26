import fc from 'fast-check';
import { decodeQR } from 'qr/decode.js';
import { describe, expect, it } from 'vitest';
import { qrPath } from '../../../src/app/ui/qr-code.js';
import { linkOf, qrLinkOf, sharedOf } from '../../../src/app/work/setting-link.js';
import { decodeLink, type SharedSetting } from '../../../src/program/index.js';
import { MODEL, SETTING } from '../../program/library-examples.js';
import { programOf } from '../programs.js';

const PAGE = 'https://pilot.example/timer/?x=1#library/none';
const SHARED = sharedOf(SETTING, MODEL);
const wide = (servos: number, functions: number): SharedSetting => ({
  ...SHARED,
  program: programOf(
    'Q',
    Array.from({ length: functions + 1 }, (_, slot) => 100 + slot * 37),
    Array.from({ length: servos }, (_, servo) =>
      Array.from({ length: functions + 1 }, (_, slot) => (servo * slot) % 131),
    ),
  ),
});

/** What another library reads from the pixels of a code, as they would be on a screen. */
function readBack(text: string): string {
  const { size, path } = qrPath(text);
  const each = 4;
  const edge = size * each;
  const data = new Uint8ClampedArray(edge * edge * 4).fill(255);
  for (const [, x, y, width] of path.matchAll(/M(\d+) (\d+)h(\d+)v1h-\d+z/g)) {
    for (let row = Number(y) * each; row < (Number(y) + 1) * each; row++) {
      const from = row * edge + Number(x) * each;
      for (let pixel = from; pixel < from + Number(width) * each; pixel++) data.fill(0, 4 * pixel, 4 * pixel + 3);
    }
  }
  return decodeQR({ width: edge, height: edge, data });
}

describe('a setting as a link', () => {
  it('is the page itself, with the setting after the #, and holds all of it', () => {
    const link = linkOf(SHARED, PAGE);
    expect(link).toMatch(/^https:\/\/pilot\.example\/timer\/#s=[\w-]+$/);
    expect(decodeLink(link)).toEqual(SHARED);
    expect(SHARED).toMatchObject({ name: 'calm morning', modelName: 'Lancer 07', note: SETTING.note });
    expect(Object.keys(SHARED), 'the link holds nothing that only this library knows').not.toContain('id');
  });

  it('works for a page that lies on a disc', () => {
    expect(linkOf(SHARED, 'file:///home/pilot/sidus/index.html#program')).toMatch(
      /^file:\/\/\/home\/pilot\/sidus\/index\.html#s=/,
    );
  });
});

describe('a setting as a QR code', () => {
  it.each([
    ['a small one', SHARED],
    ['8 servos with 20 functions', wide(8, 20)],
    ['a long note', { ...SHARED, note: 'Turns left. '.repeat(400) }],
    ['letters of other languages', { ...SHARED, name: 'Штиль, früh', modelName: 'Tűzmadár 🛩' }],
  ])('is read back by another library: %s', (_, shared) => {
    const code = qrLinkOf(shared, PAGE);
    const read = decodeLink(readBack(code?.link ?? ''));
    expect(read).toEqual({ ...shared, note: read.note });
    expect(shared.note.startsWith(read.note.replace(/ …$/, ''))).toBe(true);
    expect(code?.isCut).toBe(read.note !== shared.note);
  });

  it('stays small enough for a phone; a longer setting has no code', () => {
    expect(qrLinkOf({ ...SHARED, note: 'n'.repeat(5000) }, PAGE)?.link.length).toBeLessThanOrEqual(500);
    const { note: _, ...bare } = wide(8, 30);
    expect(qrLinkOf({ ...bare, note: '' }, PAGE)).toMatchObject({ isCut: false });
    const most = { ...wide(4, 50), tags: Array.from({ length: 20 }, () => 'ж'.repeat(30)) };
    expect(qrLinkOf(most, PAGE)).toBeNull();
  });

  it('has four white modules around it, whatever it holds, and can be read back', () => {
    const text = fc.stringMatching(/^[\w-]{1,400}$/);
    fc.assert(
      fc.property(text, (code) => {
        const link = `https://pilot.example/#s=${code}`;
        const { size, path } = qrPath(link);
        const runs = [...path.matchAll(/M(\d+) (\d+)h(\d+)/g)].map(([, ...numbers]) => numbers.map(Number));
        for (const [x = 0, y = 0, width = 0] of runs) {
          expect(Math.min(x, y, size - x - width, size - 1 - y)).toBeGreaterThanOrEqual(4);
        }
        expect(readBack(link)).toBe(link);
      }),
      { numRuns: 25 },
    );
  });
});
