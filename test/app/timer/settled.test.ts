import { expect, it } from 'vitest';
import { loadSetting, saveSetting } from '../../../src/app/browser/settings.js';
import { ANSWERS, settledSchema } from '../../../src/app/storage/records.js';
import { Settled } from '../../../src/app/timer/settled.js';

const identity = { timerClass: 'B', firmware: '536', functions: 10, memories: 4, servos: 3 };

it('what is settled is kept for timers of that kind, also after a reload and beside another tab', () => {
  const settled = new Settled();
  settled.keep(identity, false, { layout: 'servo-first', delay: 52 });
  new Settled().keep({ ...identity, timerClass: 'Q' }, false, { unlock: '6A' });
  settled.keep(identity, false, { layout: 'servo-first', delay: 60 });
  const after = new Settled();
  expect(after.of(identity, false)).toEqual({ layout: 'servo-first', delay: 60 });
  expect(after.of({ ...identity, timerClass: 'Q' }, false)).toEqual({ unlock: '6A' });
  expect([after.of(identity, true), after.of({ ...identity, firmware: '600' }, false)]).toEqual([{}, {}]);
});

it.each([
  ['an answer that there is not', { layout: 'both' }],
  ['a question that there is not', { owner: 'Anna' }],
  ['a time that no answer takes', { delay: -1 }],
])('%s is not taken from the storage', (_, answers) => {
  saveSetting('settled', [{ key: 'timer/B/536/10/3', answers }]);
  expect(loadSetting('settled', settledSchema)).toBeNull();
  expect(new Settled().of(identity, false)).toEqual({});
});

it('every answer can be kept', () => {
  for (const [name, answers] of Object.entries(ANSWERS)) {
    for (const answer of answers) {
      new Settled().keep(identity, false, { [name]: answer });
      expect(new Settled().of(identity, false)).toEqual({ [name]: answer });
    }
  }
});
