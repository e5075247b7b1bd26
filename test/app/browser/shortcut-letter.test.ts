import { expect, it } from 'vitest';
import { shortcutLetter } from '../../../src/app/browser/shortcut-letter.js';

const press = (key: string, code: string, more: KeyboardEventInit = {}): string | null =>
  shortcutLetter(new KeyboardEvent('keydown', { key, code, ctrlKey: true, ...more }));

it.each([
  ['Latin', 'zdkpy'],
  ['Latin with Shift or Caps Lock', 'ZDKPY'],
  ['Cyrillic', 'явлзн'],
  ['Greek', 'ζδκπυ'],
  ['Hebrew', 'זגלפט'],
  ['Arabic', 'ئينحغ'],
  ['Thai, where a key types a mark', 'ผกายั'],
])('is known on a keyboard that types %s', (_, typed) => {
  const codes = ['KeyZ', 'KeyD', 'KeyK', 'KeyP', 'KeyY'];
  const found = [...typed].map((key, at) => press(key, codes[at] ?? ''));
  expect(found).toEqual(['z', 'd', 'k', 'p', 'y']);
});

it.each<[string, string | null, string, string, KeyboardEventInit?]>([
  ['a German keyboard has Z and Y exchanged', 'z', 'z', 'KeyY'],
  ['on Dvorak the key at the place of Z types no letter', null, ';', 'KeyZ'],
  ['a Latin letter with a mark is no other letter', null, 'ö', 'KeyZ'],
  ['Cmd counts as Ctrl', 'k', 'л', 'KeyK', { ctrlKey: false, metaKey: true }],
  ['a letter alone is typed', null, 'я', 'KeyZ', { ctrlKey: false }],
  ['AltGr comes as Ctrl with Alt', null, 'z', 'KeyZ', { altKey: true }],
  ['an arrow is no letter', null, 'ArrowUp', 'ArrowUp'],
  ['a digit is no letter', null, '7', 'Digit7'],
])('%s', (_, letter, key, code, more) => {
  expect(press(key, code, more)).toBe(letter);
});
