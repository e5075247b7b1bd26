import { signal } from '@preact/signals';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { Checklist } from '../../../src/app/help/checklist.js';

const timerClass = signal<string | null>(null);
const tickAll = (list: Checklist): void => {
  for (const item of list.items.value) list.tick(item, true);
};

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['Date'] });
  timerClass.value = null;
});
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
});
