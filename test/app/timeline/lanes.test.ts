import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { leastHeightOf, measuresOf } from '../../../src/app/timeline/geometry.js';
import { laneAt, lanesOf, leastHeight } from '../../../src/app/timeline/lanes.js';
import { layoutOf } from '../../../src/app/timeline/layout.js';
import { isFine, refined } from '../../../src/app/timeline/move-handle.js';
import { Scale } from '../../../src/app/timeline/scale.js';
import { programOf } from '../programs.js';

const lanes = fc
  .record({ servos: fc.integer({ min: 1, max: 40 }), front: fc.nat(), more: fc.integer({ min: 0, max: 600 }) })
  .map(({ servos, front, more }) => {
    const bottom = 36 + leastHeight(servos) + more;
    return { servos, front: front % servos, bottom, lanes: lanesOf(servos, front % servos, 36, bottom) };
  });

describe('the lanes', () => {
  it('lie one below the other inside of the plot, none over another', () => {
    fc.assert(
      fc.property(lanes, ({ servos, bottom, lanes }) => {
        expect(lanes).toHaveLength(servos);
        lanes.forEach(({ from, top, bottom: low, until }, servo) => {
          expect([from < top, top < low, low < until], `the edges of lane ${servo} are in order`).toEqual([
            true,
            true,
            true,
          ]);
          expect(from).toBeGreaterThanOrEqual(lanes[servo - 1]?.until ?? 36);
        });
        expect(lanes.at(-1)?.until).toBeLessThanOrEqual(bottom + 1e-6);
      }),
    );
  });

  it('have a tall one for the selected servo, and one height for all others', () => {
    fc.assert(
      fc.property(lanes, ({ front, lanes, servos, bottom }) => {
        const heights = lanes.map(({ from, until }) => until - from);
        const low = heights.filter((_, servo) => servo !== front);
        expect(low.every((height) => Math.abs(height - (low[0] as number)) < 1e-6)).toBe(true);
        expect(low.every((height) => height >= 24 - 1e-6 && height <= 64 + 1e-6)).toBe(true);
        const isRoom = bottom - 36 >= 180 + (servos - 1) * 26;
        expect(heights[front]).toBeGreaterThanOrEqual((isRoom ? 180 : 110) - 1e-6);
      }),
    );
  });

  it('draw equal positions alike, whichever servo is selected', () => {
    fc.assert(
      fc.property(lanes, fc.integer({ min: 0, max: 130 }), ({ servos, lanes, bottom }, position) => {
        const box = { left: 0, right: 100, top: 36, bottom };
        const layout = layoutOf(new Scale([0, 100], [0, 1]), { start: 0, span: 1 }, box, lanes, 130);
        for (let servo = 0; servo < servos; servo++) {
          const { top, bottom } = lanes[servo] as (typeof lanes)[number];
          const y = layout.y(servo, position);
          expect((bottom - y) / (bottom - top)).toBeCloseTo(position / 130, 9);
          expect(layout.position(servo, y)).toBeCloseTo(position, 9);
          expect(laneAt(lanes, y)).toBe(servo);
        }
      }),
    );
  });

  it('make the picture of many servos higher than there is room', () => {
    const program = programOf(
      'Q',
      [1000, 200, 18000],
      Array.from({ length: 30 }, () => [15, 15, 15]),
    );
    expect(leastHeightOf(program)).toBeGreaterThan(30 * 24);
    expect(measuresOf(program, { width: 640, height: 320 }).height).toBe(leastHeightOf(program));
  });
});

describe('moving finely', () => {
  const way = fc.double({ min: -200, max: 200, noNaN: true });
  const plain = fc.double({ min: -60_000, max: 60_000, noNaN: true });

  it('is for a pointer that is far away', () => {
    expect([0, 20, -90, 91, -500].map(isFine)).toEqual([false, false, false, true, true]);
  });

  it('goes less far than the pointer, never the other way, and less than a step for ten pixels', () => {
    fc.assert(
      fc.property(plain, way, fc.constantFrom(1, 10, 100), (plain, way, step) => {
        const went = refined(plain, way, step);
        expect(Math.abs(went)).toBeLessThanOrEqual(Math.abs(plain) / 4 + 1e-6);
        expect(went * plain).toBeGreaterThanOrEqual(0);
        expect(Math.abs(went)).toBeLessThanOrEqual((Math.abs(way) * step) / 10 + 1e-6);
      }),
    );
  });
});
