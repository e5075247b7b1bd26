import { describe, expect, it } from 'vitest';
import { realClock, VirtualClock } from '../../src/line/index.js';

describe('a clock turned by hand', () => {
  it('calls back in the order of time, and for equal times in the order of asking', async () => {
    const clock = new VirtualClock(1000);
    const kept: string[] = [];
    clock.after(20, () => kept.push(`c at ${clock.now()}`));
    clock.after(10, () => kept.push(`a at ${clock.now()}`));
    clock.after(10, () => kept.push(`b at ${clock.now()}`));
    await clock.advance(9);
    expect(kept).toEqual([]);
    await clock.advance(11);
    expect(kept).toEqual(['a at 1010', 'b at 1010', 'c at 1020']);
    expect(clock.now()).toBe(1020);
  });

  it('does not call back what was cancelled, but calls back what was asked for while it turns', async () => {
    const clock = new VirtualClock();
    const kept: number[] = [];
    const cancel = clock.after(5, () => kept.push(5));
    clock.after(1, () => clock.after(2, () => kept.push(3)));
    cancel();
    await clock.advance(10);
    expect(kept).toEqual([3]);
  });

  it('runs until a promise settles', async () => {
    const clock = new VirtualClock();
    const wait = (ms: number): Promise<void> => new Promise((resolve) => clock.after(ms, resolve));
    const job = async (): Promise<number> => {
      await wait(30);
      await wait(12);
      return clock.now();
    };
    expect(await clock.run(job())).toBe(42);
    await expect(clock.run(Promise.reject(new Error('no')))).rejects.toThrow('no');
  });

  it('says so when nothing can settle the promise', async () => {
    await expect(new VirtualClock().run(new Promise(() => {}))).rejects.toThrow('Nothing is due');
  });
});

describe('a time that is none', () => {
  const none = [Number.NaN, '7', undefined, null] as number[];
  it.each(none)('%s is refused: the clock would show nothing from then on', async (ms) => {
    const clock = new VirtualClock(100);
    expect(() => clock.after(ms, () => {})).toThrow(RangeError);
    await expect(clock.advance(ms)).rejects.toThrow('ms must be a number of at least 0.');
    if (ms !== undefined) expect(() => new VirtualClock(ms)).toThrow('start must be a number.');
    expect(clock.now()).toBe(100);
  });

  it('lies before now, for a clock never runs backwards', async () => {
    const clock = new VirtualClock(100);
    await expect(clock.advance(-1)).rejects.toThrow(RangeError);
    clock.after(-1, () => {});
    await clock.advance(0);
    expect(clock.now()).toBe(100);
  });
});

describe('the real clock', () => {
  it('calls back later, never at once, and can be told not to', async () => {
    const kept: string[] = [];
    const before = realClock.now();
    const cancel = realClock.after(0, () => kept.push('cancelled'));
    cancel();
    await new Promise<void>((resolve) => {
      realClock.after(0, resolve);
      expect(kept).toEqual([]);
    });
    expect(kept).toEqual([]);
    expect(realClock.now()).toBeGreaterThanOrEqual(before);
  });
});
