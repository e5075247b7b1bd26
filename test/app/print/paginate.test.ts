import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Filler, type Measured, type Pages, paginate } from '../../../src/app/print/paginate.js';

const FILLER: Filler = { head: 10, row: 10, least: 3, most: 12 };
const rows = (count: number, height: number): number[] => Array.from({ length: count }, () => height);
const table = (count: number, height: number): Measured => ({ head: 10, rows: rows(count, height) });
const block = (height: number): Measured => ({ head: 0, rows: [height] });
/** Which rows of which section stand on each page. */
const shown = ({ pages }: Pages) =>
  pages.map((parts) => parts.map(({ section, from, until }) => `${section}:${from}-${until}`));

describe('sheets are distributed over pages', () => {
  it.each<[string, Measured[], string[][]]>([
    ['all on one', [block(20), table(5, 10)], [['0:0-1', '1:0-5']]],
    ['a table that does not fit goes to the next page whole', [block(60), table(5, 10)], [['0:0-1'], ['1:0-5']]],
    [
      'one that fits on no page is cut between rows',
      [block(50), table(15, 10)],
      [['0:0-1', '1:0-4'], ['1:4-13'], ['1:13-15']],
    ],
    [
      'running text goes on where it is',
      [block(50), { ...table(8, 10), loose: true }],
      [['0:0-1', '1:0-4'], ['1:4-8']],
    ],
    ['no row stands alone at the head of a page', [{ ...table(10, 10), loose: true }], [['0:0-8'], ['0:8-10']]],
    [
      'no row stands alone at the foot of a page',
      [block(80), { ...table(5, 10), loose: true }],
      [['0:0-1'], ['1:0-5']],
    ],
    [
      'a block that is higher than a page gets its own page',
      [block(20), block(200), block(20)],
      [['0:0-1'], ['1:0-1'], ['2:0-1']],
    ],
  ])('%s', (_, sections, pages) => {
    expect(shown(paginate(sections, 100, null))).toEqual(pages);
  });

  it('empty rows fill the last page, or get their own', () => {
    expect(paginate([block(50)], 100, FILLER)).toMatchObject({ pages: [[{}]], empty: 4 });
    expect(paginate([block(61)], 100, FILLER)).toMatchObject({ pages: [[{}], []], empty: 9 });
    expect(paginate([block(20)], 1000, FILLER).empty, 'there are never more than 12 empty rows').toBe(12);
    expect(paginate([block(20)], 100, null).empty).toBe(0);
  });

  it('each row stands on one page, in order, and no page is fuller than it can be', () => {
    const height = fc.double({ min: 0.5, max: 60, noNaN: true });
    const section = fc.record({
      head: fc.double({ min: 0, max: 30, noNaN: true }),
      rows: fc.array(height, { minLength: 1, maxLength: 60 }),
      loose: fc.boolean(),
    });
    fc.assert(
      fc.property(
        fc.array(section, { maxLength: 8 }),
        fc.double({ min: 100, max: 400, noNaN: true }),
        (sections, room) => {
          const { pages } = paginate(sections, room, FILLER);
          const dealt = pages
            .flat()
            .flatMap(({ section, from, until }) => Array.from({ length: until - from }, (_, i) => [section, from + i]));
          expect(dealt).toEqual(sections.flatMap(({ rows: own }, at) => own.map((_, row) => [at, row])));
          for (const parts of pages) {
            const used = parts.map(({ section, from, until }) => {
              const { head, rows: own } = sections[section] as Measured;
              return own.slice(from, until).reduce((sum, each) => sum + each, head);
            });
            // A measured height may be off by a part of a pixel, once for each section.
            const sum = used.reduce((total, each) => total + each, 0);
            if (parts.length > 1 || (parts[0] && parts[0].until - parts[0].from > 1)) {
              expect(sum).toBeLessThanOrEqual(room + 0.5 * parts.length);
            }
          }
        },
      ),
    );
  });
});
