import { type Signal, signal } from '@preact/signals';
import { act, render, screen } from '@testing-library/preact';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { useLate } from '../../../src/app/ui/use-late.js';

const FRAME = 16;
let catchUp = (): void => {};

function Shown({ value }: { readonly value: Signal<number> }) {
  const [late, now] = useLate(value);
  catchUp = now;
  return <output>{late}</output>;
}

const shown = () => Number(screen.getByRole('status').textContent);
const frames = (count: number) => act(() => void vi.advanceTimersByTime(count * FRAME));

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['requestAnimationFrame', 'cancelAnimationFrame', 'performance'] });
});
// Nothing may wait for a frame of this clock any more.
afterEach(() => void vi.advanceTimersByTime(1000));

async function drawn() {
  const value = signal(0);
  render(<Shown value={value} />);
  await frames(3);
  const set = (next: number) =>
    act(() => {
      value.value = next;
    });
  return { set };
}

it('a late value is drawn a frame after the change', async () => {
  const { set } = await drawn();
  await set(1);
  await frames(1);
  expect(shown()).toBe(0);
  await frames(1);
  expect(shown()).toBe(1);
});

it('a late value waits while it changes at each frame, but not for ever', async () => {
  const { set } = await drawn();
  for (let change = 1; change <= 20; change++) {
    await set(change);
    await frames(1);
  }
  expect(shown(), 'after 320 ms the value still waits').toBe(0);
  for (let change = 21; change <= 40; change++) {
    await set(change);
    await frames(1);
  }
  expect(shown(), 'after 500 ms the value has come').toBeGreaterThan(29);
  await frames(2);
  expect(shown(), 'once it no longer changes, the last value comes').toBe(40);
});

it('a late value comes at once where that is asked for', async () => {
  const { set } = await drawn();
  await set(1);
  await act(catchUp);
  expect(shown()).toBe(1);
});
