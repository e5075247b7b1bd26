import { effect, signal } from '@preact/signals';
import { expect, it } from 'vitest';
import { steady } from '../../../src/app/editing/steady.js';

it('a steady look at a model tells of what says something else, and of nothing else', () => {
  const program = signal({ times: [1, 2], positions: [[3]] });
  const first = steady(() => ({ time: program.value.times[0] }));
  const told: unknown[] = [];
  const stop = effect(() => void told.push(first.value));
  program.value = { ...program.value, positions: [[4]] };
  program.value = { ...program.value, times: [1, 9] };
  expect(told).toEqual([{ time: 1 }]);
  program.value = { ...program.value, times: [5, 9] };
  expect(told).toEqual([{ time: 1 }, { time: 5 }]);
  stop();
});
