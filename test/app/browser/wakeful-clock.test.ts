import { expect, it, onTestFinished, vi } from 'vitest';
import { WakefulClock } from '../../../src/app/browser/wakeful-clock.js';

it('goes with the clock of the page, counts its sleep, and never runs back', () => {
  onTestFinished(() => void vi.restoreAllMocks());
  const start = performance.timeOrigin + 1000;
  let own = 1000;
  let day = start;
  vi.spyOn(performance, 'now').mockImplementation(() => own);
  vi.spyOn(Date, 'now').mockImplementation(() => day);
  const clock = new WakefulClock();
  const at = (ownLater: number, dayLater: number): number => {
    own += ownLater;
    day += dayLater;
    return clock.now() - start;
  };
  expect(at(0, 0)).toBe(0);
  expect(at(500, 500)).toBe(500);
  expect(at(0, 3_600_000), 'asleep for an hour').toBe(3_600_500);
  expect(at(100, 100)).toBe(3_600_600);
  expect(at(100, -7_200_000), 'the clock of the day was put back').toBe(3_600_700);
});
