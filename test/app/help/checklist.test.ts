import { signal } from '@preact/signals';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Checklist, ownKey } from '../../../src/app/help/checklist.js';

const timerClass = signal<string | null>(null);
const tickAll = (list: Checklist): void => {
  for (const item of [...list.items.value, ...list.own.value.map(ownKey)]) list.tick(item, true);
};

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['Date'] });
  localStorage.clear();
  timerClass.value = null;
});
afterEach(() => void vi.useRealTimers());

describe('the checklist', () => {
  it('counts what is left, for the class of the timer: a glider has no propeller', () => {
    const list = new Checklist(timerClass);
    expect([list.items.value.includes('propeller'), list.left.value]).toEqual([true, 8]);
    timerClass.value = 'E';
    expect([list.items.value.includes('propeller'), list.left.value]).toEqual([false, 7]);
    timerClass.value = 'B';
    list.tick('memory', true);
    expect([list.left.value, list.begun.value]).toEqual([7, true]);
  });

  it('begins afresh for the next flight, but not while the pilot works through it', () => {
    const list = new Checklist(timerClass);
    list.tick('memory', true);
    list.enter();
    expect(
      list.ticked.value.has('memory'),
      'a tick stays when the pilot has only looked at the program meanwhile',
    ).toBe(true);
    tickAll(list);
    expect([list.left.value, list.begun.value]).toEqual([0, false]);
    list.enter();
    expect([list.left.value, list.ticked.value.size]).toEqual([8, 0]);
  });

  it('begins afresh after 20 minutes: what was looked at then may have changed', () => {
    const list = new Checklist(timerClass);
    list.tick('memory', true);
    vi.setSystemTime(Date.now() + 20 * 60_000);
    list.enter();
    expect(list.ticked.value.size).toBe(1);
    vi.setSystemTime(Date.now() + 1);
    list.enter();
    expect(list.ticked.value.size).toBe(0);
  });

  it('begins afresh when the clock was put back since', () => {
    const list = new Checklist(timerClass);
    list.tick('memory', true);
    vi.setSystemTime(Date.now() - 3_600_000);
    list.enter();
    expect(list.ticked.value.size).toBe(0);
  });

  it('keeps what the pilot has added, and no tick', () => {
    const list = new Checklist(timerClass);
    expect([list.add(' Tracker is on '), list.own.value]).toEqual([true, ['Tracker is on']]);
    tickAll(list);
    const again = new Checklist(timerClass);
    expect([again.own.value, again.ticked.value.size, again.left.value]).toEqual([['Tracker is on'], 0, 9]);
    again.tick(ownKey('Tracker is on'), true);
    again.remove('Tracker is on');
    expect([again.own.value, again.ticked.value.size, new Checklist(timerClass).own.value]).toEqual([[], 0, []]);
  });

  it('refuses an item that is empty, too long, there already, or one too many', () => {
    const list = new Checklist(timerClass);
    expect([list.add('  '), list.add('x'.repeat(121)), list.add('x'.repeat(120))]).toEqual([false, false, true]);
    expect(list.add('x'.repeat(120))).toBe(false);
    for (let n = 1; n < 30; n++) expect(list.add(`item ${n}`)).toBe(true);
    expect([list.add('one too many'), list.own.value.length]).toEqual([false, 30]);
  });

  it('does not confuse an item of the pilot with one of the page', () => {
    const list = new Checklist(timerClass);
    list.add('memory');
    list.tick(ownKey('memory'), true);
    expect(list.ticked.value.has('memory')).toBe(false);
  });

  it.each(['"text"', '[1]', '["", "a"]', '["a", "a"]', '{', `[${Array(31).fill('"a"')}]`])(
    'stands whatever is kept in its place: %s',
    (kept) => {
      localStorage.setItem('sidus-timer/checklist', kept);
      const { own } = new Checklist(timerClass);
      expect(own.value.length).toBeLessThan(2);
    },
  );
});
