import { type Signal, signal } from '@preact/signals';
import { act, render, screen } from '@testing-library/preact';
import { beforeEach, expect, it, onTestFinished, vi } from 'vitest';
import { useAfter, useLateComputed } from '../../../src/app/ui/use-late.js';

const FRAME = 16;

function Shown({ value, of }: { readonly value: Signal<number>; readonly of: Signal<string> }) {
  const late = useLateComputed(() => value.value, of);
  return <output>{`${of.value} ${late}`}</output>;
}

function After({ value, of }: { readonly value: Signal<number>; readonly of: Signal<string> }) {
  return <output>{`${of.value} ${value.value} after ${useAfter(value.value, of.value)}`}</output>;
}

const shown = () => screen.getByRole('status').textContent;
const frames = (count: number) => act(() => void vi.advanceTimersByTime(count * FRAME));

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['requestAnimationFrame', 'cancelAnimationFrame', 'performance'] });
  onTestFinished(() => {
    // Nothing may wait for a frame of this clock any more.
    vi.advanceTimersByTime(1000);
    vi.useRealTimers();
  });
});

async function drawn(Part = Shown) {
  const value = signal(0);
  const of = signal('one');
  render(<Part value={value} of={of} />);
  await frames(3);
  const set = (next: number) =>
    act(() => {
      value.value = next;
    });
  return { set, value, of };
}

it('a late value is drawn a frame after the change', async () => {
  const { set } = await drawn();
  await set(1);
  await frames(1);
  expect(shown()).toBe('one 0');
  await frames(1);
  expect(shown()).toBe('one 1');
});

it('a late value waits while it changes at each frame, but not for ever', async () => {
  const { set } = await drawn();
  for (let change = 1; change <= 20; change++) {
    await set(change);
    await frames(1);
  }
  expect(shown(), 'after 320 ms the value still waits').toBe('one 0');
  for (let change = 21; change <= 40; change++) {
    await set(change);
    await frames(1);
  }
  expect(shown(), 'after 500 ms the value has come').toMatch(/^one 3\d$/);
  await frames(2);
  expect(shown(), 'once it no longer changes, the last value comes').toBe('one 40');
});

it('a late value shows nothing of the former subject', async () => {
  const { value, of } = await drawn();
  await act(() => {
    of.value = 'two';
    value.value = 7;
  });
  expect(shown()).toBe('two 7');
});

it('draws a part of a component a frame after the rest of it, and at once where it is of another', async () => {
  const { set, value, of } = await drawn(After);
  await set(1);
  expect(shown()).toBe('one 1 after 0');
  await frames(2);
  expect(shown()).toBe('one 1 after 1');
  await act(() => {
    of.value = 'two';
    value.value = 7;
  });
  expect(shown()).toBe('two 7 after 7');
});
