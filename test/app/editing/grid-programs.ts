import fc from 'fast-check';
import { expect } from 'vitest';
import type { Edit, FieldValue } from '../../../src/app/editing/edit.js';
import type { GridRange } from '../../../src/app/editing/grid.js';
import { fieldKey, type TimerProgram } from '../../../src/program/index.js';

/** What an edit sets that is not refused. */
export function valuesOf(edit: Edit): readonly FieldValue[] {
  return 'values' in edit ? edit.values : expect.fail(`refused: ${edit.refused.code} ${fieldKey(edit.refused.field)}`);
}

/** A small Q timer. */
export const Q4 = { timerClass: 'Q', firmware: '536', functions: 5, memories: 4, servos: 2 };

/** A program of it, with no two values of one kind alike. */
export function programOf(): TimerProgram {
  return {
    identity: Q4,
    memory: 0,
    times: [1000, 50, 1000, 1250, 1500, 18000],
    positions: [
      [10, 20, 30, 40, 50, 60],
      [15, 25, 35, 45, 55, 65],
    ],
    idleThrottle: 30,
  };
}

const time = fc.oneof(fc.integer({ min: 0, max: 3000 }), fc.integer({ min: 0, max: 65535 }));
const position = fc.oneof({ weight: 9, arbitrary: fc.nat(130) }, fc.nat(255));

/**
 * A program of any class and a small layout, with times in any order and now and then a position past the last step.
 */
export const anyProgram: fc.Arbitrary<TimerProgram> = fc
  .record({
    timerClass: fc.constantFrom('Q', 'B', 'E', 'X'),
    functions: fc.integer({ min: 1, max: 7 }),
    servos: fc.integer({ min: 1, max: 3 }),
  })
  .chain((layout) => {
    const slots = layout.functions + 1;
    const row = fc.array(position, { minLength: slots, maxLength: slots });
    return fc.record({
      identity: fc.constant({ ...layout, firmware: '536', memories: 4 }),
      memory: fc.constant(0),
      times: fc.array(time, { minLength: slots, maxLength: slots }),
      positions: fc.array(row, { minLength: layout.servos, maxLength: layout.servos }),
      idleThrottle: fc.constantFrom(null, 30),
    });
  });

/** A program, and a range within its grid. */
export const programAndRange: fc.Arbitrary<[TimerProgram, GridRange]> = anyProgram.chain((program) => {
  const { functions, servos } = program.identity;
  const row = fc.nat(functions);
  const column = fc.nat(servos + 1);
  return fc.tuple(
    fc.constant(program),
    fc.tuple(row, row, column, column).map(([a, b, c, d]) => ({
      top: Math.min(a, b),
      bottom: Math.max(a, b),
      left: Math.min(c, d),
      right: Math.max(c, d),
    })),
  );
});
