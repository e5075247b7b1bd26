import { afterEach, expect, it, vi } from 'vitest';
import { holdPageKeys, type PageKey, takePageKey } from '../../../src/app/browser/page-keys.js';

const ends: (() => void)[] = [];
afterEach(() => {
  for (const end of ends.splice(0)) end();
  tell(document.body, 'Escape');
});

/** @returns whether the browser leaves the key to the page. */
function tell(target: EventTarget, key: string, how: KeyboardEventInit = {}): boolean {
  return !target.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true, ...how }));
}

const press = (key: string, how?: KeyboardEventInit) => tell(document.body, key, how);
const list = (how: KeyboardEventInit = { ctrlKey: true }) => press('k', how);

function taker(key: PageKey, acts = true) {
  const act = vi.fn(() => acts);
  ends.push(takePageKey(key, act));
  return act;
}

it('carries a key out once the part of the page is there that can, and only once', () => {
  holdPageKeys();
  expect([press('?', { shiftKey: true }), press('Shift')], 'a modifier is nothing else').toEqual([true, false]);
  expect([taker('commands'), taker('help'), taker('help')].map((act) => act.mock.calls.length)).toEqual([0, 1, 0]);
});

it.each<[string, KeyboardEventInit]>([
  ['Ctrl+K', { ctrlKey: true }],
  ['Cmd+K', { metaKey: true }],
])('keeps %s from the browser and carries it out, too', (_, how) => {
  holdPageKeys();
  expect(list(how)).toBe(true);
  expect([taker('help'), taker('commands')].map((act) => act.mock.calls.length)).toEqual([0, 1]);
});

it('knows the keys of a keyboard without Latin letters', () => {
  const acts = [taker('commands'), taker('print')];
  expect([press('Λ', { code: 'KeyK', ctrlKey: true }), press('פ', { code: 'KeyP', ctrlKey: true })]).toEqual([
    true,
    true,
  ]);
  expect(acts.map((act) => act.mock.calls.length)).toEqual([1, 1]);
});

it.each<[string, () => unknown]>([
  ['another key', () => press('Tab')],
  ['a key that waits, too', () => list()],
  ['a click', () => document.body.dispatchEvent(new Event('pointerdown', { bubbles: true }))],
])('forgets it after %s', (_, act) => {
  holdPageKeys();
  press('?');
  act();
  expect(taker('help')).not.toHaveBeenCalled();
});

it.each([
  [9, 1],
  [11, 0],
])('%i seconds later it is carried out %i times', (seconds, times) => {
  holdPageKeys();
  press('?');
  const later = performance.now() + seconds * 1000;
  const clock = vi.spyOn(performance, 'now').mockReturnValue(later);
  expect(taker('help')).toHaveBeenCalledTimes(times);
  clock.mockRestore();
});

it('prints by Ctrl+P or Cmd+P, and leaves other keys with P to the browser', () => {
  holdPageKeys();
  const print = taker('print');
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
  holdPageKeys();
  const input = document.body.appendChild(document.createElement('input'));
  expect([tell(input, '?'), press('?', { altKey: true }), press('k')]).toEqual([false, false, false]);
  input.remove();
  expect(taker('help')).not.toHaveBeenCalled();
  const refused = taker('commands', false);
  expect([list(), refused.mock.calls.length]).toEqual([false, 1]);
});
