import { expect, it } from 'vitest';
import { valuesText } from '../../../src/app/write/unfinished-text.js';
import { en } from '../../tools/en.js';

it.each([
  [0, 'DT is 3:00 min or 6:00 min'],
  [1, 'DT is 3:00 min or 6:00 min, and 1\u00a0more\u00a0value is not certain'],
  [12, 'DT is 3:00 min or 6:00 min, and 12\u00a0more\u00a0values are not certain'],
])('the band keeps the number of %i further values and what is counted on one line', (more, text) => {
  expect(valuesText([en.knowledge.either({ name: 'DT', before: '3:00 min', goal: '6:00 min' })], more)).toBe(text);
});
