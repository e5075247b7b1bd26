import { afterEach, expect, it, vi } from 'vitest';
import { onPageKey, type PageKey } from '../../../src/app/browser/page-keys.js';

const ends: (() => void)[] = [];
afterEach(() => {
  for (const end of ends.splice(0)) end();
});

/** @returns whether the browser leaves the key to the page. */
function tell(target: EventTarget, key: string, how: KeyboardEventInit = {}): boolean {
  return !target.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true, ...how }));
}

const press = (key: string, how?: KeyboardEventInit) => tell(document.body, key, how);

function acting(key: PageKey, acts = true) {
  const act = vi.fn(() => acts);
  ends.push(onPageKey(key, act));
  return act;
}

it('keeps Ctrl+K and Cmd+K from the browser and carries them out', () => {
  const list = acting('commands');
  expect([press('k', { ctrlKey: true }), press('k', { metaKey: true })]).toEqual([true, true]);
  expect(list).toHaveBeenCalledTimes(2);
});

it('knows the keys of a keyboard without Latin letters', () => {
  const acts = [acting('commands'), acting('print')];
  expect([press('Λ', { code: 'KeyK', ctrlKey: true }), press('פ', { code: 'KeyP', ctrlKey: true })]).toEqual([
    true,
    true,
  ]);
  expect(acts.map((act) => act.mock.calls.length)).toEqual([1, 1]);
});

it('prints by Ctrl+P or Cmd+P, and leaves other keys with P to the browser', () => {
  const print = acting('print');
  const keys = [
    { ctrlKey: true },
    { metaKey: true },
    { ctrlKey: true, shiftKey: true },
    { ctrlKey: true, altKey: true },
    {},
  ];
  expect(keys.map((how) => press('p', how))).toEqual([true, true, false, false, false]);
  expect(print).toHaveBeenCalledTimes(2);
});

it('leaves to the browser what is typed, has another meaning, or is not carried out', () => {
  const help = acting('help');
  const refused = acting('commands', false);
  const input = document.body.appendChild(document.createElement('input'));
  expect([tell(input, '?'), press('?', { altKey: true }), press('k')]).toEqual([false, false, false]);
  input.remove();
  expect(help).not.toHaveBeenCalled();
  expect([press('k', { ctrlKey: true }), refused.mock.calls.length]).toEqual([false, 1]);
});
