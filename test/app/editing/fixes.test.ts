import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { withValues } from '../../../src/app/editing/edit.js';
import { fixFor } from '../../../src/app/editing/fixes.js';
import { checkProgram, type FindingCode, type TimerProgram } from '../../../src/program/index.js';
import { anyProgram, programOf } from './grid-programs.js';

/** What is offered for each thing that is found, by code. */
function fixesOf(program: TimerProgram): [FindingCode, number | null][] {
  return checkProgram(program).map((finding) => [finding.code, fixFor(finding, program)?.value ?? null]);
}

const held = programOf();
const timed = (at: number, ...times: number[]): TimerProgram => ({
  ...held,
  times: times.reduce((all, time, i) => all.with(at + i, time), held.times),
});
const placed = (value: number): TimerProgram => ({
  ...held,
  positions: [held.positions[0]?.with(2, value) ?? [], [...(held.positions[1] ?? [])]],
});

describe('an obvious fault', () => {
  it.each([
    ['a time that falls', timed(2, 20), 'time-falls', 60],
    ['a time that repeats', timed(3, 1000), 'position-never-reached', 1010],
    ['a time that is too fine', timed(3, 1256), 'time-too-fine', 1260],
    ['a time that the wire cannot carry', timed(5, 70000), 'time-out-of-range', 65535],
    ['a time before the first of the manual', timed(1, 5), 'time-outside-manual', 10],
    ['a long motor run', timed(0, 5000), 'motor-run-long', 4000],
    ['a position past the last step', placed(200), 'position-out-of-range', 130],
    ['a position below the first step', placed(-1), 'position-out-of-range', 0],
    ['half a step', placed(1.4), 'position-not-whole', 1],
    ['a throttle that the wire cannot carry', { ...held, idleThrottle: 300 }, 'throttle-out-of-range', 255],
  ] as const)('%s is corrected', (_, program, code, value) => {
    expect(fixesOf(program)).toContainEqual([code, value]);
  });
});

describe('what the pilot has to decide', () => {
  it.each([
    ['a motor that stops after DT', { ...held, times: held.times.with(0, 19000) }, 'motor-stop-after-dt'],
    ['a short DT', timed(5, 2000), 'dt-short'],
    ['a DT at which nothing moves', { ...held, positions: [Array(6).fill(50), Array(6).fill(50)] }, 'dt-moves-nothing'],
    ['a time that falls behind several others', { ...held, times: [1000, 50, 2000, 1250, 1500, 18000] }, 'time-falls'],
    ['a time that falls just before the next', { ...held, times: [1000, 50, 1490, 1250, 1500, 18000] }, 'time-falls'],
    ['a time that repeats just before the next', timed(3, 1000, 1010), 'position-never-reached'],
    ['a DT before the function before it', timed(4, 35000), 'time-falls'],
    ['a DT at the function before it', timed(4, 18000), 'position-never-reached'],
    [
      'a DT at the function before it, with nothing to reach',
      { ...timed(4, 18000), positions: [Array(6).fill(50), Array(6).fill(50)] },
      'time-repeats',
    ],
    ['an unusual throttle', { ...held, idleThrottle: 150 }, 'throttle-unusual'],
    ['an unknown class', { ...held, identity: { ...held.identity, timerClass: 'X' } }, 'class-unknown'],
    [
      'a time after the last that a wire carries',
      { ...timed(2, 65535), times: [1000, 50, 65535, 65535, 65535, 65535] },
      'time-repeats',
    ],
  ] as const)('%s is left to them', (_, program, code) => {
    const found = fixesOf(program as TimerProgram).filter(
      ([each]) => each === code || each === 'position-never-reached',
    );
    expect(found.length).toBeGreaterThan(0);
    expect(found.every(([, value]) => value === null)).toBe(true);
  });
});

it('a correction removes the finding for which it was offered', () => {
  fc.assert(
    fc.property(anyProgram, (program) => {
      for (const finding of checkProgram(program)) {
        const fix = fixFor(finding, program);
        if (!fix) continue;
        const after = checkProgram(withValues(program, [fix]));
        const same = after.filter(
          ({ code, field }) => code === finding.code && JSON.stringify(field) === JSON.stringify(finding.field),
        );
        expect(same).toEqual([]);
      }
    }),
    { numRuns: 500 },
  );
});
