import { expect, it } from 'vitest';
import { knowledge } from '../../../src/app/messages/en-knowledge.js';

it.each([
  [0, 'DT is 3:00 min or 6:00 min'],
  [1, 'DT is 3:00 min or 6:00 min, and 1\u00a0more\u00a0value is not certain'],
  [12, 'DT is 3:00 min or 6:00 min, and 12\u00a0more\u00a0values are not certain'],
])('the band keeps the number of %i further values and what is counted on one line', (more, text) => {
  expect(knowledge.list([knowledge.either('DT', '3:00 min', '6:00 min')], more)).toBe(text);
});
