import { expect, it } from 'vitest';
import { stepText } from '../../../src/app/messages/index.js';

const F1Q = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };

it.each([
  ['a servo, in a draft of an earlier version', { servo: 1 }, 'change of S2'],
  ['a field', { field: 'position:1:4' }, 'change of function 4, S2'],
  ['a row', { slot: 4 }, 'change of function 4'],
  ['some values', { count: 3 }, 'change of 3 values'],
])('a step of undo names what it was done to: %s', (_, params, text) => {
  expect(stepText(F1Q, { code: 'change', params })).toBe(text);
});
