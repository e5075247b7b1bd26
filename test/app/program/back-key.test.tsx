import { fireEvent, screen } from '@testing-library/preact';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { takeBack } from '../../../src/app/browser/back-key.js';
import { idle } from '../bench/bench.js';
import { connected, field, press } from '../screen.js';

/** What a browser gives a page that wants to hear the Back key. */
class Watcher extends EventTarget {
  static readonly open = new Set<Watcher>();
  constructor() {
    super();
    Watcher.open.add(this);
  }
  destroy(): void {
    Watcher.open.delete(this);
  }
}

beforeEach(() => vi.stubGlobal('CloseWatcher', Watcher));
afterEach(() => Watcher.open.clear());

async function tap(name: string): Promise<void> {
  fireEvent.pointerDown(field(name), { pointerType: 'touch' });
  field(name).focus();
  await idle();
}

async function back(): Promise<void> {
  for (const watcher of Watcher.open) watcher.dispatchEvent(new Event('close'));
  await idle();
}

it('the Back key of a phone closes the sheet of keys, and the page stays', async () => {
  await connected();
  await tap('Function 4, S2');
  await tap('Function 4, S3');
  expect(Watcher.open.size).toBe(1);
  await back();
  expect([screen.queryAllByRole('region', { name: /^Keys for/ }).length, Watcher.open.size]).toEqual([0, 0]);
});

it('Back in the history closes the sheet once, and what was typed stays', async () => {
  await connected();
  await tap('Function 4, S2');
  fireEvent.input(field('Function 4, S2'), { target: { value: '7' } });
  await tap('Function 4, S3');
  expect(takeBack()).toBe(true);
  await idle();
  expect([screen.queryAllByRole('region', { name: /^Keys for/ }).length, takeBack()]).toEqual([0, false]);
  expect(field('Function 4, S2').value).toBe('7');
});

it('it closes the tools of a row, and the page stays', async () => {
  const tools = 'Tools for Function 2';
  await connected();
  await press(tools);
  const opener = screen.getByRole('button', { name: tools });
  expect([opener.getAttribute('aria-expanded'), Watcher.open.size]).toEqual(['true', 1]);
  await back();
  expect([opener.getAttribute('aria-expanded'), Watcher.open.size]).toEqual(['false', 0]);
});
