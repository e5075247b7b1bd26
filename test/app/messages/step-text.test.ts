import { expect, it } from 'vitest';
import type { StepName } from '../../../src/app/editing/history.js';
import { stepText } from '../../../src/app/messages/index.js';

const Q10 = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };

it.each<[text: string, params: StepName['params']]>([
  ['change of S2', { servo: 1 }],
  ['change of S3', { from: 0, to: 2 }],
  ['change of “S1”', { name: 'S1' }],
])('a step of a draft from before says what it changed: %s', (text, params) => {
  expect(stepText(Q10, { code: 'change', params })).toBe(text);
});
