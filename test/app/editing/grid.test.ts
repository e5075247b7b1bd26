import { describe, expect, it } from 'vitest';
import {
  cellFor,
  columnsIn,
  fieldsIn,
  type GridField,
  gridField,
  intervalAt,
  programField,
  rangeBetween,
  rowsIn,
} from '../../../src/app/editing/grid.js';
import { fieldKey, fieldsOf } from '../../../src/program/index.js';
import { programOf, Q4 } from './grid-programs.js';

function keysIn(...[top, left, bottom, right]: [number, number, number, number]): string[] {
  return fieldsIn(Q4, { top, left, bottom, right }).map(keyOf);
}

function keyOf(field: GridField): string {
  return field.kind === 'interval' ? `interval:${field.slot}` : fieldKey(field);
}

describe('the grid', () => {
  it('has a row for each slot of the timer, and time, interval and servos across', () => {
    const across = (row: number) =>
      [0, 1, 2, 3].map((column) => gridField(Q4, { row, column })).map((field) => field && keyOf(field));
    expect(across(0)).toEqual(['time:0', null, 'position:0:0', 'position:1:0']);
    expect(across(5)).toEqual(['time:5', 'interval:5', 'position:0:5', 'position:1:5']);
  });

  it('ends at its edges', () => {
    for (const [row, column] of [
      [-1, 0],
      [6, 0],
      [0, -1],
      [0, 4],
      [6, 3],
    ] as const) {
      expect(gridField(Q4, { row, column })).toBeNull();
    }
  });

  it('has one cell for each value of the program, and none for the idle throttle', () => {
    for (const field of fieldsOf(Q4)) {
      const cell = cellFor(field);
      expect(cell && gridField(Q4, cell)).toEqual(field.kind === 'idleThrottle' ? null : field);
    }
  });

  it('shows a time twice: an interval stands for the time at its end', () => {
    expect(programField({ kind: 'interval', slot: 3 })).toEqual({ kind: 'time', slot: 3 });
    expect(programField({ kind: 'position', servo: 1, slot: 3 })).toEqual({ kind: 'position', servo: 1, slot: 3 });
  });
});

describe('a range', () => {
  it('is the same from each corner', () => {
    const range = { top: 1, left: 0, bottom: 4, right: 3 };
    expect(rangeBetween({ row: 1, column: 3 }, { row: 4, column: 0 })).toEqual(range);
    expect(rangeBetween({ row: 4, column: 3 }, { row: 1, column: 0 })).toEqual(range);
  });

  it('lists its fields row by row, without intervals where there are times', () => {
    expect(keysIn(0, 0, 1, 2)).toEqual(['time:0', 'position:0:0', 'time:1', 'position:0:1']);
    expect(keysIn(2, 1, 2, 3)).toEqual(['interval:2', 'position:0:2', 'position:1:2']);
  });

  it('has no interval at the start, and nothing past the edges', () => {
    expect(keysIn(0, 1, 1, 1)).toEqual(['interval:1']);
    expect(keysIn(5, 3, 99, 99)).toEqual(['position:1:5']);
    expect(keysIn(9, 9, 12, 12)).toEqual([]);
    const past = { top: 4, left: 2, bottom: 99, right: 99 };
    expect([rowsIn(Q4, past), columnsIn(Q4, past)]).toEqual([
      [4, 5],
      [2, 3],
    ]);
  });
});

describe('an interval', () => {
  it('counts from the row before, from launch for function 1, and not for the start', () => {
    const program = { ...programOf(), times: [1000, 50, 1000, 900, 1500, 18000] };
    expect([0, 1, 2, 3, 4, 5, 6].map((slot) => intervalAt(program, slot))).toEqual([
      null,
      50,
      950,
      -100,
      600,
      16500,
      null,
    ]);
  });
});
