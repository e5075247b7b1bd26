import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { foldedText, searchFor } from '../../../src/app/messages/search.js';

describe('a search', () => {
  it.each([
    ['muller', 'Müller'],
    ['MÜLLER', 'muller'],
    ['gyula', 'GYŰLA'],
    ['lodz', 'Łódź'],
    ['strasse', 'Straße'],
    ['skovde', 'Skövde'],
    ['aero', 'Ærø'],
    ['f1b', 'Ｆ１Ｂ'],
    ['cap', 'Čáp'],
    ['ястреб', 'Я́стреб'],
    ['calm 07', 'Lancer 07 · calm'],
    ['', 'anything'],
    ['  ', ''],
  ])('for “%s” finds “%s”', (search, text) => {
    expect(searchFor(search)(foldedText(text))).toBe(true);
  });

  it.each([
    ['calm 08', 'Lancer 07 · calm'],
    ['muler', 'Müller'],
    ['x', ''],
  ])('for “%s” does not find “%s”', (search, text) => {
    expect(searchFor(search)(foldedText(text))).toBe(false);
  });

  it('is this one for every list of the page', () => {
    const page = resolve('src/app');
    const files = readdirSync(page, { recursive: true, encoding: 'utf8' }).filter((file) => /\.tsx?$/.test(file));
    const texts = files.map((file) => [file, readFileSync(join(page, file), 'utf8')] as const);
    const users = texts.filter(([, text]) => /import .*searchFor.* from/.test(text)).map(([file]) => file);
    expect(users.sort()).toEqual([
      'flights/flight-list.ts',
      'library/browse.ts',
      'line/line-view.ts',
      'shell/palette.tsx',
    ]);
    const fields = texts.filter(([, text]) => text.includes('type="search"')).map(([file]) => file);
    // The search of the palette is a box with a list.
    expect(fields.length, 'a new search has its row above').toBe(users.length - 1);
  });
});
