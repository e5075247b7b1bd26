import { effect } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import { LineView } from '../../../src/app/line/line-view.js';
import { LineLog } from '../../../src/app/timer/line-log.js';
import type { LineEntry } from '../../../src/client/index.js';
import { B536 } from '../../protocol/vectors.js';
import { came, damage, IDENTIFIED, lineError, sent } from '../line/line.js';

/** Lets what was added become known. */
const told = (): Promise<void> => Promise.resolve();

/** What no timer can be: the class must be printable. */
const unreadable: LineEntry = {
  ...came({ name: 'GETSWVER', identity: B536 }),
  frame: { code: 0x6c, data: new Uint8Array(9) },
};

function logOf(...entries: readonly LineEntry[]): LineLog {
  const log = new LineLog();
  entries.forEach(log.add);
  return log;
}

const numbers = (records: readonly { readonly number: number }[]): number[] => records.map(({ number }) => number);

describe('the log of the line', () => {
  it('keeps the last 500 in their order, and never more', async () => {
    const log = new LineLog();
    for (let time = 1; time <= 1234; time++) log.add(sent({ name: 'GETMEMORY' }, time));
    await told();
    const kept = log.entries.value;
    expect(kept).toHaveLength(500);
    expect(numbers(kept)).toEqual(Array.from({ length: 500 }, (_, i) => 735 + i));
    expect(kept.map(({ time }) => time)).toEqual(numbers(kept));
    expect(log.newest.value).toBe(1234);
  });

  it('updates the screen once for all that came together', async () => {
    const log = new LineLog();
    let drawn = 0;
    const stop = effect(() => {
      log.entries.value;
      drawn++;
    });
    for (let i = 0; i < 50; i++) log.add(sent({ name: 'GETMEMORY' }));
    expect(drawn, 'the screen is not drawn at each entry').toBe(1);
    await told();
    expect(drawn).toBe(2);
    expect(log.entries.value).toHaveLength(50);
    stop();
  });

  it('counts what was sent, what came, and what was wrong, also beyond what it keeps', async () => {
    const log = logOf(...IDENTIFIED, damage('noise', 'ff'), lineError('framing'), lineError('break'));
    for (let i = 0; i < 600; i++) log.add(sent({ name: 'GETMEMORY' }));
    await told();
    expect(log.counts.value).toEqual({ out: 601, in: 1, damaged: 1, errors: 2 });
  });

  it('is empty and counts from zero once it is cleared, and never gives a number twice', async () => {
    expect(new LineLog().used.value).toBe(false);
    const log = logOf(...IDENTIFIED);
    await told();
    expect(log.used.value).toBe(true);
    log.clear();
    await told();
    expect(log.entries.value).toEqual([]);
    expect(log.counts.value).toEqual({ out: 0, in: 0, damaged: 0, errors: 0 });
    expect(log.used.value, 'the panel stays open').toBe(true);
    log.add(sent({ name: 'GETTIMERS' }));
    await told();
    expect(numbers(log.entries.value)).toEqual([3]);
    expect(log.entries.value[0]?.layout.identity, 'the identity of the timer is still known').toEqual(B536);
  });

  it('remembers with each entry what was known of the timer at that time', async () => {
    const other = { ...B536, functions: 3 };
    let servoFirst = false;
    const log = new LineLog(() => ({ servoFirst }));
    for (const entry of [...IDENTIFIED, sent({ name: 'GETTIMERS' })]) log.add(entry);
    servoFirst = true;
    log.add(came({ name: 'GETSWVER', identity: other }));
    log.add(unreadable);
    await told();
    expect(log.entries.value.map(({ layout }) => layout)).toEqual([
      { identity: undefined, quirks: { servoFirst: false } },
      { identity: B536, quirks: { servoFirst: false } },
      { identity: B536, quirks: { servoFirst: false } },
      { identity: other, quirks: { servoFirst: true } },
      { identity: undefined, quirks: { servoFirst: true } },
    ]);
  });

  it('puts the identity of the timer in front of newer entries', async () => {
    const log = logOf(...IDENTIFIED);
    await told();
    expect(numbers(log.introduced(log.entries.value)), 'the identity is among the entries, so it is not added').toEqual(
      [1, 2],
    );
    for (let i = 0; i < 500; i++) log.add(sent({ name: 'GETMEMORY' }));
    await told();
    expect(numbers(log.introduced(log.entries.value)).slice(0, 4)).toEqual([1, 2, 3, 4]);
    log.add(sent({ name: 'GETMEMORY' }));
    await told();
    expect(numbers(log.introduced(log.entries.value)).slice(0, 4)).toEqual([1, 2, 4, 5]);
    expect(log.introduced([])).toEqual([]);
  });

  it.each([
    ['answers something else', sent({ name: 'GETMEMORY' }), came({ name: 'GETSWVER', identity: B536 })],
    ['cannot be read', sent({ name: 'GETSWVER' }), unreadable],
  ])('puts nothing in front that %s', async (_, ...entries) => {
    const log = logOf(...IDENTIFIED, ...entries);
    for (let i = 0; i < 500; i++) log.add(sent({ name: 'GETMEMORY' }));
    await told();
    expect(numbers(log.introduced(log.entries.value)).slice(0, 3)).toEqual([1, 2, 5]);
  });

  it('puts the request back in front of its answer when only the request was lost', async () => {
    const log = logOf(sent({ name: 'GETSWVER' }), damage('noise', 'ff'), came({ name: 'GETSWVER', identity: B536 }));
    for (let i = 0; i < 498; i++) log.add(sent({ name: 'GETMEMORY' }));
    await told();
    expect(numbers(log.introduced(log.entries.value)).slice(0, 4)).toEqual([1, 2, 3, 4]);
  });
});

describe('the picture of the line', () => {
  const mixed: readonly LineEntry[] = [
    ...IDENTIFIED,
    sent({ name: 'SETSERVO', function: 4, servo: 1, position: 70 }),
    came({ name: 'SETSERVO' }),
    damage('checksum', '00 00 00 00 00 03 6b 6c 45'),
    lineError('parity'),
  ];

  const shownBy = (view: LineView): number[] => numbers(view.shown.value);

  async function shown(change: (view: LineView) => void): Promise<number[]> {
    const log = logOf(...mixed);
    await told();
    const view = new LineView(log);
    change(view);
    return shownBy(view);
  }

  it('shows the newest first', async () => {
    expect(await shown(() => {})).toEqual([6, 5, 4, 3, 2, 1]);
  });

  it.each([
    ['out', [3, 1]],
    ['in', [6, 5, 4, 2]],
    ['damaged', [6, 5]],
  ] as const)('shows one kind: %s', async (filter, expected) => {
    expect(await shown((view) => view.setFilter(filter))).toEqual(expected);
  });

  it.each([
    ['a name', 'write a POSITION', [4, 3]],
    ['the letters', 'setservo', [4, 3]],
    ['a value', 'function 4 70', [3]],
    ['each of its words, wherever it stands', 'function 4', [3, 2]],
    ['bytes', '04 01 46', [3]],
    ['bytes without spaces', '040146', [3]],
    ['no half bytes', '40 14', []],
    ['the reason of damage', 'damaged', [5]],
    ['an error of the line', 'parity', [6]],
    ['spaces only', '  ', [6, 5, 4, 3, 2, 1]],
    ['nothing that is there', 'xyz', []],
  ])('finds %s', async (_, search, expected) => {
    expect(await shown((view) => view.setSearch(search))).toEqual(expected);
  });

  it('finds within one kind', async () => {
    const both = (view: LineView): void => {
      view.setFilter('out');
      view.setSearch('position');
    };
    expect(await shown(both)).toEqual([3]);
  });

  it('can be paused while the log goes on, says how many came, and goes on', async () => {
    const log = logOf(...mixed);
    await told();
    const view = new LineView(log);
    view.pause();
    for (let i = 0; i < 600; i++) log.add(sent({ name: 'GETMEMORY' }));
    await told();
    expect(shownBy(view)).toEqual([6, 5, 4, 3, 2, 1]);
    expect([view.paused.value, view.came.value]).toEqual([true, 600]);
    view.goOn();
    expect(shownBy(view)[0]).toBe(606);
    expect(view.found.value).toHaveLength(500);
    expect([view.paused.value, view.came.value]).toEqual([false, 0]);
  });

  it('is live again when it is cleared', async () => {
    const log = logOf(...mixed);
    await told();
    const view = new LineView(log);
    view.pause();
    view.clear();
    await told();
    expect(view.shown.value).toEqual([]);
    expect(view.paused.value).toBe(false);
  });
});
