import { act, fireEvent } from '@testing-library/preact';
import { expect, it, vi } from 'vitest';
import { connected, field, lookAt } from '../screen.js';

/** The notes below the rows of the table; those that only keep their room in brackets. */
function notes(): string[] {
  return [...document.querySelectorAll('.row-notes p')].map(({ textContent, classList }) =>
    classList.contains('over') ? `(${textContent})` : String(textContent),
  );
}

function typeIn(name: string, text: string): void {
  act(() => void fireEvent.input(field(name), { target: { value: text } }));
}

/** Lets the hands rest so many milliseconds. */
const rest = (ms: number) => act(() => void vi.advanceTimersByTime(ms));

async function atFunction4(): Promise<void> {
  await connected();
  field('Function 4 time').focus();
}

const EARLY = 'Function 4 time: This comes before the function above it (11.50\u00a0s).';

it('notes get their room when the keys rest, so that no row jumps while somebody types', async () => {
  await atFunction4();
  for (const text of ['1', '12', '12.', '12.x', '12', '1']) {
    typeIn('Function 4 time', text);
    rest(399);
    expect(notes(), text).toEqual([]);
  }
  rest(1);
  expect(notes()).toEqual([EARLY]);
});

it('a note that no longer holds is hidden at once, and its room goes when the keys rest', async () => {
  await atFunction4();
  typeIn('Function 4 time', '1');
  rest(400);
  typeIn('Function 4 time', '12');
  expect(notes()).toEqual([`(${EARLY})`]);
  typeIn('Function 4 time', '1x');
  const [unreadable] = notes();
  expect(unreadable, 'what holds instead takes its place').toMatch(/^Function 4 time: (?!This comes before)/);
  typeIn('Function 4 time', '12');
  rest(399);
  expect(notes()).toHaveLength(1);
  rest(1);
  expect(notes()).toEqual([]);
});

it('another program has its own notes at once', async () => {
  await atFunction4();
  typeIn('Function 4 time', '1');
  rest(400);
  expect(notes()).toEqual([EARLY]);
  await lookAt('M2');
  expect(notes()).toEqual([]);
  await lookAt('M1, flies next');
  expect(notes()).toEqual([EARLY]);
});
