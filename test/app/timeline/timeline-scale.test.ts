import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { stepSize } from '../../../src/app/editing/edit.js';
import { locale } from '../../../src/app/editing/locale.js';
import { limitsOf, snapped, stepped } from '../../../src/app/timeline/drag.js';
import { eventsBetween, flightEnd, reachedAt, stagesOf } from '../../../src/app/timeline/flight.js';
import { geometryOf, measuresOf } from '../../../src/app/timeline/geometry.js';
import { spread, WHOLE } from '../../../src/app/timeline/layout.js';
import { RUN_OUT, Scale, stretchedScale } from '../../../src/app/timeline/scale.js';
import { shortTime, ticks } from '../../../src/app/timeline/ticks.js';
import { TimelineModel } from '../../../src/app/timeline/view-model.js';
import type { ProgramField } from '../../../src/program/index.js';
import { programOf } from '../programs.js';

const time = fc.oneof(fc.integer({ min: 0, max: 65535 }), fc.integer({ min: 0, max: 100 }));
const times = fc.array(time, { minLength: 1, maxLength: 126 });
const options = fc.record({
  minGap: fc.double({ min: 0.001, max: 0.2, noNaN: true }),
  runOut: fc.double({ min: 0.001, max: 0.1, noNaN: true }),
  others: fc.array(time, { maxLength: 30 }),
});
const anyScale = fc.tuple(times, options).map(([marks, given]) => stretchedScale(marks, given));

describe('times that no timer has', () => {
  const hostile = fc.oneof(
    fc.double(),
    fc.constantFrom(1e300, Number.MAX_VALUE, Number.MAX_SAFE_INTEGER, Infinity, -Infinity, Number.NaN, -1, 0.1),
  );

  it('are drawn in a bounded number of steps', () => {
    fc.assert(
      fc.property(fc.array(hostile, { minLength: 1, maxLength: 20 }), fc.array(hostile), (marks, others) => {
        const scale = stretchedScale(marks, { minGap: 0.05, runOut: 0.05, others });
        let places = 0;
        const place = scale.place.bind(scale);
        scale.place = (at) => {
          if (++places > 10_000) throw new Error('no end of it');
          return place(at);
        };
        const shown = ticks(scale, [0], [], WHOLE, 0.02);
        expect(shown.every(Number.isFinite)).toBe(true);
        expect(scale.times.every((at, i) => i === 0 || at > (scale.times[i - 1] as number))).toBe(true);
      }),
      { numRuns: 500 },
    );
  });

  it('are drawn at launch or at the end', () => {
    const program = programOf('Q', [1e300, Number.NaN, -5, Infinity]);
    expect(stagesOf(program).every(({ from, until }) => Number.isFinite(from) && Number.isFinite(until ?? 0))).toBe(
      true,
    );
    expect(flightEnd(program)).toBe(1e9 + RUN_OUT);
  });
});

describe('any scale', () => {
  it('has one place for every time, and one time for every place, from launch on and past its end', () => {
    const place = fc.double({ min: 0, max: 2, noNaN: true });
    fc.assert(
      fc.property(anyScale, fc.integer({ min: 0, max: 200000 }), place, (scale, at, place) => {
        expect(Math.round(scale.time(scale.place(at)))).toBe(at);
        expect(scale.place(scale.time(place))).toBeCloseTo(place, 9);
        expect([scale.place(0), scale.time(0), scale.place(-5), scale.time(-0.1)]).toEqual([0, 0, 0, 0]);
      }),
      { numRuns: 2000 },
    );
  });
});

describe('the stretched scale', () => {
  it('keeps neighbouring marks apart, as far as there is room', () => {
    fc.assert(
      fc.property(times, options, (marks, given) => {
        const scale = stretchedScale(marks, given);
        const own = [...new Set([0, ...marks])].sort((a, b) => a - b);
        const least = Math.min(given.minGap, (0.8 * (1 - given.runOut)) / own.length);
        for (let i = 1; i < own.length; i++) {
          const gap = scale.place(own[i] as number) - scale.place(own[i - 1] as number);
          expect(gap).toBeGreaterThanOrEqual(least - 1e-9);
        }
      }),
      { numRuns: 1000 },
    );
  });

  it('ends with the run-out, at 1', () => {
    fc.assert(
      fc.property(times, options, (marks, given) => {
        const scale = stretchedScale(marks, given);
        const last = Math.max(0, ...marks, ...given.others);
        expect(scale.end).toBe(last + RUN_OUT);
        expect(scale.place(scale.end)).toBeCloseTo(1, 9);
        if (last > 0) expect(scale.place(last)).toBeCloseTo(1 - given.runOut, 9);
      }),
    );
  });

  it('shows 0.05 s and 6 min alike', () => {
    const scale = stretchedScale([5, 10, 36000], { minGap: 26 / 300, runOut: 14 / 300 });
    const width = (from: number, to: number): number => (scale.place(to) - scale.place(from)) * 300;
    expect(width(5, 10)).toBeGreaterThanOrEqual(26);
    expect(width(10, 36000)).toBeGreaterThan(5 * width(5, 10));
  });
});

describe('the times at the axis', () => {
  it('rise, lie in view, and leave each other room', () => {
    const fraction = fc.double({ min: 0, max: 0.9, noNaN: true });
    fc.assert(
      fc.property(anyScale, fraction, fc.double({ min: 0.02, max: 0.1, noNaN: true }), (scale, from, share) => {
        const shown = ticks(scale, [], [], { start: from, span: 0.1 }, share * 0.1);
        const places = shown.map((at) => scale.place(at));
        places.forEach((place, i) => {
          expect(place).toBeGreaterThanOrEqual(from - 1e-9);
          expect(place).toBeLessThanOrEqual(from + 0.1 + 1e-9);
          if (i > 0) expect(place - (places[i - 1] as number)).toBeGreaterThanOrEqual(share * 0.1 - 1e-9);
        });
      }),
      { numRuns: 500 },
    );
  });

  it('are DT before all others, then marks, then round ones', () => {
    const scale = new Scale([0, 18330], [0, 1]);
    expect(ticks(scale, [18030], [0, 17900, 7777], WHOLE, 0.1)).toEqual([0, 3000, 7777, 12000, 15000, 18030]);
  });

  it('are as short as they can be, with the decimal sign of the language', () => {
    const texts = () => [0, 50, 1000, 1005, 18000, 6050].map(shortTime);
    expect(texts()).toEqual(['0', '0.5', '10', '10.05', '3:00', '1:00.50']);
    const english = locale.value;
    locale.value = { ...english, decimal: ',' };
    expect(texts()).toEqual(['0', '0,5', '10', '10,05', '3:00', '1:00,50']);
    locale.value = english;
  });
});

describe('spread', () => {
  const numbers = fc.array(fc.double({ min: 0, max: 100, noNaN: true }), { maxLength: 30 });

  it('keeps the order, the distance and the bounds', () => {
    fc.assert(
      fc.property(numbers, fc.double({ min: 0, max: 20, noNaN: true }), (given, gap) => {
        const result = spread(given, gap, 0, 100);
        const order = given.map((_, i) => i).sort((a, b) => (given[a] as number) - (given[b] as number) || a - b);
        const least = Math.min(gap, 100 / Math.max(1, given.length - 1));
        order.forEach((at, i) => {
          const here = result[at] as number;
          expect(here).toBeGreaterThanOrEqual(-1e-6);
          expect(here).toBeLessThanOrEqual(100 + 1e-6);
          if (i > 0) expect(here - (result[order[i - 1] as number] as number)).toBeGreaterThanOrEqual(least - 1e-6);
        });
      }),
      { numRuns: 2000 },
    );
  });

  it('moves nothing that is far enough apart', () => {
    expect(spread([30, 10, 20], 5, 0, 100)).toEqual([30, 10, 20]);
    expect(spread([50, 50], 4, 0, 100)).toEqual([48, 52]);
  });
});

describe('what is in view', () => {
  it('never leaves the picture, whatever is done; zooming in leaves a mark where it is, or brings it into view', () => {
    const place = fc.double({ min: 0, max: 1, noNaN: true });
    const act = fc.oneof(
      fc.record({ zoom: fc.double({ min: 0.1, max: 10, noNaN: true }), at: place }),
      fc.record({ pan: fc.double({ min: -3, max: 3, noNaN: true }) }),
      fc.record({ reveal: place }),
    );
    fc.assert(
      fc.property(fc.array(act, { maxLength: 20 }), (acts) => {
        const model = new TimelineModel();
        for (const one of acts) {
          const before = model.view.value;
          if ('zoom' in one) model.zoom(one.zoom, one.at);
          else if ('pan' in one) model.pan(one.pan);
          else model.reveal(one.reveal);
          const { start, span } = model.view.value;
          expect([start >= 0, start + span <= 1 + 1e-9, span > 0]).toEqual([true, true, true]);
          const sought = 'zoom' in one ? one.at : 'reveal' in one ? one.reveal : start;
          expect(sought).toBeGreaterThanOrEqual(start - 1e-9);
          expect(sought).toBeLessThanOrEqual(start + span + 1e-9);
          const wasInView = sought >= before.start && sought <= before.start + before.span;
          if ('zoom' in one && one.zoom >= 1 && wasInView)
            expect((sought - start) / span).toBeCloseTo((sought - before.start) / before.span, 6);
        }
      }),
    );
  });
});

const at = (slot: number): ProgramField => ({ kind: 'time', slot });

describe('moving a time', () => {
  const q = programOf('Q', [1000, 200, 400, 600, 18000]);

  it('stays one step away from its neighbours', () => {
    expect(limitsOf(q, at(2))).toEqual({ min: 210, max: 590 });
    expect(limitsOf(q, at(1))).toEqual({ min: 10, max: 390 });
    expect(limitsOf(q, at(4))).toEqual({ min: 700, max: 65500 });
    expect(limitsOf(q, at(0)), 'the motor stop moves between launch and DT').toEqual({ min: 10, max: 17990 });
  });

  it('is not stopped by a neighbour that it has passed or reached', () => {
    const falls = programOf('Q', [0, 500, 300, 300, 18000]);
    expect(limitsOf(falls, at(2))).toEqual({ min: 0, max: 300 });
    expect(limitsOf(falls, at(3))).toEqual({ min: 300, max: 17990 });
  });

  it('stays where it is when there is no whole step between its neighbours', () => {
    const close = programOf('Q', [0, 201, 203, 205, 18000]);
    expect(snapped(close, at(2), 999)).toBe(203);
    expect(stepped(close, at(2), -1)).toBe(203);
  });

  it('goes from between two steps to the next of them', () => {
    const odd = programOf('Q', [0, 203, 400, 600, 18000]);
    expect([stepped(odd, at(1), 1), stepped(odd, at(1), -1), stepped(odd, at(1), 10)]).toEqual([210, 200, 300]);
  });

  it('is a whole step within the range of the protocol, or stays where it was', () => {
    fc.assert(
      fc.property(
        fc.array(time, { minLength: 5, maxLength: 5 }),
        fc.nat({ max: 4 }),
        fc.double({ min: -1e6, max: 1e6, noNaN: true }),
        (times, slot, to) => {
          const program = programOf('Q', times);
          const value = snapped(program, at(slot), to);
          const step = stepSize(program.identity, at(slot));
          const kept = value === times[slot];
          expect([value >= 0, value <= 65535, kept || value % step === 0]).toEqual([true, true, true]);
        },
      ),
      { numRuns: 2000 },
    );
  });
});

describe('moving a position', () => {
  const program = programOf('Q', [0, 200, 400, 600, 18000], [[0, 10, 200, 130, 5]]);
  const position = (slot: number): ProgramField => ({ kind: 'position', servo: 0, slot });

  it('is a whole step from 0 to 130', () => {
    expect([-5, 3.4, 3.5, 130.4, 500].map((to) => snapped(program, position(1), to))).toEqual([0, 3, 4, 130, 130]);
    expect([stepped(program, position(0), -1), stepped(program, position(3), 10)]).toEqual([0, 130]);
    expect(stepped(program, position(2), -1), 'a step down from past the last step gives the last step').toBe(130);
  });
});

describe('a flight', () => {
  const rising = programOf('Q', [300, 200, 400, 400, 18000]);
  const falling = programOf('Q', [300, 500, 200, 600, 18000]);

  it('holds, passes over, and goes back', () => {
    expect(stagesOf(rising).map(({ from, until, passing }) => [from, until, passing])).toEqual([
      [0, 200, 'held'],
      [200, 400, 'held'],
      [400, 400, 'passed'],
      [400, 18000, 'held'],
      [18000, null, 'held'],
    ]);
    expect(stagesOf(falling).map(({ passing }) => passing)).toEqual(['held', 'back', 'held', 'held', 'held']);
  });

  it.each([
    [0, 0],
    [199, 0],
    [200, 1],
    [399, 1],
    [400, 3],
    [17999, 3],
    [18000, 4],
    [70000, 4],
  ])('at %i has reached slot %i', (time, slot) => {
    expect(reachedAt(rising, time)).toEqual({ slot, certain: true });
  });

  it('is not known when a later function has come and an earlier one has not', () => {
    expect(reachedAt(falling, 199)).toEqual({ slot: 0, certain: true });
    expect(reachedAt(falling, 300)).toEqual({ slot: 0, certain: false });
    expect(reachedAt(falling, 500)).toEqual({ slot: 2, certain: true });
  });

  it('lists what happens between two times, each event once', () => {
    expect(eventsBetween(rising, 200, 400)).toEqual([
      { slot: 0, time: 300 },
      { slot: 2, time: 400 },
      { slot: 3, time: 400 },
    ]);
    expect(eventsBetween(programOf('B', [300, 200, 400]), 0, 65535)).toHaveLength(2);
  });

  it('ends after the last event', () => {
    expect(flightEnd(rising)).toBe(18000 + RUN_OUT);
    expect(flightEnd(programOf('Q', [20000, 200, 18000]))).toBe(20000 + RUN_OUT);
    expect(flightEnd(programOf('B', [20000, 200, 18000])), 'on B slot 0 is reserved, so it does not count').toBe(
      18000 + RUN_OUT,
    );
  });
});

describe('the marks above the lanes', () => {
  it.each([20, 12, 9, 1])('stand in the picture, with %i functions and in each width', (functions) => {
    const times = [1000, ...Array.from({ length: functions }, (_, at) => 1050 + 50 * at), 18000];
    const program = programOf('Q', times, [times.map(() => 15)]);
    for (let width = 300; width <= 1060; width += 7) {
      const { flags } = geometryOf(program, measuresOf(program, { width, height: 320 }), { front: 0 });
      for (const { x, radius, isDt, slot } of flags) {
        // DT stands in a box, which is wider than the circle of a function.
        const half = isDt ? radius + 2 : radius;
        expect(x - half, `mark ${slot} at ${width} px`).toBeGreaterThanOrEqual(0);
        expect(x + half, `mark ${slot} at ${width} px`).toBeLessThanOrEqual(width);
      }
    }
  });
});
