import { expect, it } from 'vitest';
import { formatDate } from '../../../src/app/messages/date-format.js';

it('a date breaks only after its commas', () => {
  const at = new Date(2026, 10, 23, 10, 8).getTime();
  const said = formatDate({ dateStyle: 'medium', timeStyle: 'short' }, at);
  expect(said).toBe('23\u00a0Nov\u00a02026, 10:08');
});
