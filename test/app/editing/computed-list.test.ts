import { effect, signal } from '@preact/signals';
import { expect, it } from 'vitest';
import { computedList } from '../../../src/app/editing/computed-list.js';

it('a computed list reports items that have changed, and keeps those that have not', () => {
  const times = signal([100, 200]);
  const items = computedList(
    () => times.value.map((time) => ({ time })),
    (a, b) => a.time === b.time,
  );
  const told: (readonly { time: number }[])[] = [];
  const stop = effect(() => void told.push(items.value));
  times.value = [100, 200];
  expect(told.length).toBe(1);
  times.value = [50, 200];
  expect(told.map((list) => list.map(({ time }) => time))).toEqual([
    [100, 200],
    [50, 200],
  ]);
  expect(told[1]?.[1]).toBe(told[0]?.[1]);
  times.value = [200, 50];
  times.value = [200];
  expect(told.length).toBe(4);
  stop();
});
