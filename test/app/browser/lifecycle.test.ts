import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { type Moment, on } from '../../../src/app/browser/lifecycle.js';

const MOMENTS: readonly Moment[] = ['leave', 'hide', 'away', 'return', 'restore', 'wake'];

/** What is heard while `happen` happens. */
function heard(happen: () => void): readonly Moment[] {
  const found = new Set<Moment>();
  const ends = MOMENTS.map((moment) => on(moment, () => found.add(moment)));
  happen();
  for (const end of ends) end();
  return [...found];
}

/** The page is seen, or no longer. */
function see(seen: boolean): void {
  vi.spyOn(document, 'hidden', 'get').mockReturnValue(!seen);
  document.dispatchEvent(new Event('visibilitychange'));
}

describe('what happens to the page', () => {
  it.each<[what: string, happen: () => void, moments: readonly Moment[]]>([
    ['it is left', () => dispatchEvent(new Event('pagehide')), ['leave', 'hide', 'away']],
    ['it is no longer seen', () => see(false), ['hide', 'away']],
    ['it is seen again', () => see(true), ['return']],
    ['another window has the keys', () => dispatchEvent(new Event('blur')), ['away']],
    ['it has the keys again', () => dispatchEvent(new Event('focus')), ['return']],
    ['the network is back', () => dispatchEvent(new Event('online')), ['return']],
    ['it is shown afresh', () => dispatchEvent(new Event('pageshow')), []],
    [
      'it is shown as it was left',
      () => dispatchEvent(Object.assign(new Event('pageshow'), { persisted: true })),
      ['restore'],
    ],
    ['the browser continues it', () => document.dispatchEvent(new Event('resume')), ['wake']],
  ])('%s', (_, happen, moments) => {
    expect([...heard(happen)].sort()).toEqual([...moments].sort());
    dispatchEvent(new Event('pageshow'));
  });

  it('is heard no longer once that is ended', () => {
    const act = vi.fn();
    on('leave', act)();
    dispatchEvent(new Event('pagehide'));
    dispatchEvent(new Event('pageshow'));
    expect(act).not.toHaveBeenCalled();
  });

  it('includes a sleep of the computer, but no gap in the background', () => {
    vi.useFakeTimers();
    const act = vi.fn();
    onTestFinished(on('wake', act));
    vi.advanceTimersByTime(60_000);
    expect(act).not.toHaveBeenCalled();
    vi.setSystemTime(Date.now() + 31_000);
    vi.advanceTimersByTime(5000);
    expect(act).toHaveBeenCalledOnce();
    see(false);
    vi.setSystemTime(Date.now() + 31_000);
    vi.advanceTimersByTime(5000);
    expect(act).toHaveBeenCalledOnce();
  });
});
