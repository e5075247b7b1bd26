import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { guessedUses, movedAtDt, SURFACES, turnsAt } from '../../../../src/app/timeline/preview/surfaces.js';
import type { ServoUse } from '../../../../src/program/index.js';
import { exampleMemories } from '../../../../src/simulator/index.js';
import { programOf } from '../../programs.js';

const TIMES = [1000, 200, 400, 600, 18000];
const use = (duty: ServoUse['duty'], low = 0, high = 130, reversed = false): ServoUse => ({
  duty,
  name: '',
  low,
  high,
  reversed,
});
const turns = (row: readonly number[], said: ServoUse) => {
  const program = programOf('Q', TIMES, [row]);
  if (said.duty !== 'rudder' && said.duty !== 'tailplane' && said.duty !== 'wing') throw new Error('no surface');
  const { duty } = said;
  return row.map((_, slot) => turnsAt(program, slot, [said])[duty]?.degrees);
};

describe('a surface', () => {
  it('turns from one end of its range to the other, and in reverse', () => {
    expect(turns([60, 65, 70, 60, 60], use('rudder', 60, 70))).toEqual([-28, 0, 28, -28, -28]);
    expect(turns([60, 65, 70, 60, 60], use('rudder', 60, 70, true))).toEqual([28, 0, -28, 28, 28]);
    expect(turns([0, 130, 65, 65, 65], use('wing'))).toEqual([-8, 8, 0, 0, 0]);
  });

  it('if it is the tailplane, is straight in the glide and all up at DT, and small trims look small', () => {
    expect(turns([48, 24, 52, 56, 95], use('tailplane', 24, 95))).toEqual([-4, -16, -2, 0, 42]);
    expect(turns([52, 55, 55, 55, 110], use('tailplane', 52, 110))).toEqual([-2.3, 0, 0, 0, 42]);
    expect(turns([56, 84, 56, 56, 20], use('tailplane', 20, 84, true))).toEqual([0, -16, 0, 0, 42]);
  });

  it('goes no further than the ends, whatever a timer holds', () => {
    const position = fc.integer({ min: 0, max: 255 });
    const row = fc.array(position, { minLength: 5, maxLength: 5 });
    const said = fc.record({
      duty: fc.constantFrom(...SURFACES),
      name: fc.constant(''),
      low: fc.integer({ min: 0, max: 130 }),
      high: fc.integer({ min: 0, max: 130 }),
      reversed: fc.boolean(),
    });
    fc.assert(
      fc.property(row, said, (positions, each) => {
        for (const turn of turns(positions, each)) {
          expect(turn).toBeGreaterThanOrEqual(-28);
          expect(turn).toBeLessThanOrEqual(42);
        }
      }),
      { numRuns: 300 },
    );
  });

  it('stands still when no servo turns it, or when the servo has no range', () => {
    const program = programOf('Q', TIMES);
    expect(turnsAt(program, 0, [use('rudder'), use('other'), use('none')]).wing).toBeNull();
    expect(turnsAt(program, 0, [use('none'), use('none'), use('none'), use('wing')]).wing).toBeNull();
    expect(turns([50, 60, 50, 60, 50], use('wing', 50, 50))).toEqual([0, 0, 0, 0, 0]);
  });
});

describe('where nobody has said what the servos move', () => {
  const guess = (servos: number) =>
    guessedUses(
      programOf(
        'Q',
        TIMES,
        Array.from({ length: servos }, () => [62, 66, 70, 62, 95]),
      ),
    );

  it('the first three count as rudder, tailplane and wing, and a single one as a disc', () => {
    expect([1, 2, 3, 4].map((servos) => guess(servos).map(({ duty }) => duty))).toEqual([
      ['release'],
      ['rudder', 'tailplane'],
      ['rudder', 'tailplane', 'wing'],
      ['rudder', 'tailplane', 'wing', 'other'],
    ]);
  });

  it('each uses the range of the program, and a rudder is trimmed about its middle', () => {
    expect(guess(3).map(({ low, high }) => [low, high])).toEqual([
      [35, 95],
      [62, 95],
      [62, 95],
    ]);
  });

  it.each([
    ['up is more', [48, 44, 30, 56, 95]],
    ['up is less', [48, 44, 84, 84, 20]],
  ])('the tailplane goes up at DT: %s', (_, row) => {
    const program = programOf('Q', TIMES, [TIMES.map(() => 65), row]);
    expect(turnsAt(program, 4, guessedUses(program)).tailplane?.degrees).toBe(42);
  });

  it('DT looks like DT in every memory of the simulated timers', () => {
    for (const timerClass of ['Q', 'B', 'E'] as const) {
      for (const { times, positions } of exampleMemories(timerClass)) {
        const program = programOf(timerClass, times, positions);
        const tailplane = times.map((_, slot) => turnsAt(program, slot, guessedUses(program)).tailplane?.degrees);
        expect(tailplane.at(-1)).toBe(42);
        expect(Math.max(...tailplane.slice(0, -1).map(Number))).toBeLessThan(5);
      }
    }
  });
});

describe('DT', () => {
  it('is the work of the servos that move then', () => {
    const still = [65, 66, 67, 68, 68];
    const moves = [65, 65, 65, 65, 66];
    expect(movedAtDt(programOf('Q', TIMES, [still, moves, still, moves]))).toEqual([1, 3]);
    expect(movedAtDt(programOf('Q', TIMES, [still]))).toEqual([]);
  });

  it('releases the tailplane when the servo for that moves', () => {
    const program = programOf('Q', TIMES, [
      [65, 66, 67, 68, 68],
      [65, 65, 65, 65, 66],
    ]);
    expect(turnsAt(program, 4, [use('rudder'), use('release')]).tailplane).toEqual({ degrees: 42, servo: null });
    expect(turnsAt(program, 3, [use('rudder'), use('release')]).tailplane, 'not before DT').toBeNull();
    expect(turnsAt(program, 4, [use('release'), use('rudder')]).tailplane).toBeNull();
  });
});
