import { cleanup, render, screen } from '@testing-library/preact';
import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import { App } from '../../src/app/app.js';
import type { ProgramField, TimerProgram } from '../../src/program/index.js';
import { shareOf } from '../tools/share.js';
import { type AppBench, appBench, connectedBench, idle } from './bench/bench.js';
import { type Door, FAULTS, type FaultName, FaultyStore } from './faults.js';

const DT: ProgramField = { kind: 'time', slot: 10 };
const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };
const NAMES = Object.keys(FAULTS) as FaultName[];
/** `npm run test:matrix` tries all of a matrix in one test. Milliseconds. */
const LONG = 300_000;

/** Each fault at each of these calls. */
const faultsAt = (doors: Iterable<Door>, names: readonly FaultName[]) =>
  [...doors].flatMap((door) => names.map((fault) => [door, fault] as const));

/** An earlier page has left edits of M1: S1 of function 2 is 7. */
async function left(): Promise<FaultyStore> {
  const store = new FaultyStore();
  const bench = await connectedBench({ store });
  bench.editor.type(S1, '7');
  await idle();
  vi.useRealTimers();
  return store.next();
}

/** What stands under S1 of function 2 in all that is kept. */
const kept = (store: FaultyStore): unknown[] =>
  [...store.drafts.records.values()].map(({ working }) => working.positions[0]?.[2]);

/** Types into S1, and gives time for whatever comes of it. @returns whether it was said that something is not kept. */
async function typeAndWait(bench: AppBench, text: string): Promise<boolean> {
  let said = false;
  const stop = bench.keeping.kept.subscribe((kept) => {
    said ||= kept !== true;
  });
  bench.editor.type(S1, text);
  await idle(12_000);
  stop();
  return said;
}

/** What is true of any page, whatever its storage does. */
function expectNothingLost(bench: AppBench, store: FaultyStore, typed: string, restored: boolean, said: boolean): void {
  expect(screen.getByRole('table', { name: /^Time and servo positions/ }), 'the table is drawn').toBeTruthy();
  expect(bench.editor.textOf(S1), 'the field shows what was typed').toBe(typed);
  if (bench.session.drafts.kept.value)
    expect(kept(store), 'the page says that it is kept, and it is').toContain(Number(typed));
  else expect(said, 'the page says that it keeps nothing').toBe(true);
  // What was left by the page before was seen before it was typed over, or is still there.
  if (!restored) expect(kept(store), 'the draft of the page before is still kept').toContain(7);
}

/** A pilot opens the page on a storage, connects, types, and types again once the storage is fine. */
async function typed(store: FaultyStore): Promise<void> {
  const bench = await appBench({ store, started: false, plug: { granted: true } });
  render(<App models={bench.models} />);
  void bench.session.keptWork.start();
  expect(
    screen.getByRole('button', { name: 'Connect' }),
    'Connect is there before the storage has answered',
  ).toBeTruthy();
  await idle(200);
  void bench.session.timer.connect();
  await idle(15_000);
  const restored = bench.editor.textOf(S1) === '7';
  expectNothingLost(bench, store, '8', restored, await typeAndWait(bench, '8'));
  store.before = () => undefined;
  expectNothingLost(bench, store, '9', restored, await typeAndWait(bench, '9'));
}

it(
  'whatever the storage does at any call, the page is drawn, nothing typed is lost, and the page never says that something is kept when it is not',
  async () => {
    const fine = await left();
    const made = fine.listen();
    await typed(fine);
    expect(made.size, 'a visit makes several calls').toBeGreaterThan(4);
    for (const [door, fault] of shareOf(faultsAt(made, NAMES))) {
      cleanup();
      vi.useRealTimers();
      localStorage.clear();
      const store = await left();
      const isMet = store.fail(door, fault);
      await typed(store).catch((cause) => {
        throw new Error(`where ${door} ${fault}`, { cause });
      });
      expect(isMet(), `${door} ${fault}, and the page has met it`).toBe(true);
    }
  },
  LONG,
);

/** In whatever order the browser answers; a seed that has failed stays here. */
const SEEDS: readonly (readonly [number, string])[] = [
  [-268465162, '5:0'],
  [-1209843424, '4:1:0:11:0:0:0:0:2:0'],
  [1, '12:0:2:13:0'],
];

describe('in any order of the answers', () => {
  const law = fc.asyncProperty(
    fc.scheduler(),
    fc.array(fc.nat({ max: 6 }), { minLength: 8, maxLength: 8 }),
    async (scheduler, releases) => {
      // Of a run before this one that has failed.
      cleanup();
      vi.useRealTimers();
      localStorage.clear();
      const store = await left();
      let isOpen = false;
      store.before = (door) => (isOpen ? undefined : scheduler.schedule(Promise.resolve(), door));
      const bench = await appBench({ store, started: false, plug: { granted: true } });
      render(<App models={bench.models} />);
      const step = async (count: number): Promise<void> => {
        for (let i = 0; i < count && scheduler.count() > 0; i++) await scheduler.waitOne();
        await idle(1500);
      };
      const [a, b, c, d, e, ...rest] = releases as [number, number, number, number, number];
      void bench.session.keptWork.start();
      await step(a);
      void bench.session.timer.connect();
      await step(b);
      await step(c);
      await idle();
      const restored = bench.editor.textOf(S1) === '7';
      bench.editor.type(S1, '8');
      await step(d);
      bench.editor.type(S1, '9');
      await step(e);
      for (const count of rest) await step(count);
      const typed = bench.editor.textOf(S1);
      expect(typed).toBe('9');
      isOpen = true;
      while (scheduler.count() > 0) await scheduler.waitOne();
      await idle(8000);
      expectNothingLost(bench, store, '9', restored, false);
    },
  );

  it('nothing typed is lost', () => fc.assert(law, { numRuns: 15 }));

  it.each(SEEDS)('nor with the seed %s %s', (seed, path) => fc.assert(law, { seed, path, endOnFailure: true }));
});

/**
 * All that the page says of what the timer holds, judged by what it does hold. While bytes move nothing is said but
 * that they do.
 */
function expectNoFalseWord({ session, editor, write, timer }: AppBench, before: TimerProgram, why: string): void {
  const { times, positions } = timer.core.content;
  const holds = (program: TimerProgram): boolean =>
    JSON.stringify([program.times, program.positions]) === JSON.stringify([times, positions]);
  const known = session.knowledge.of(0);
  const { value } = write.current;
  const isAsking = session.runner.job.value?.asking ?? false;
  if (value?.step === 'running' && !isAsking) return;
  if (value?.step === 'done' && value.ends[0]?.state === 'verified') {
    expect(
      holds(value.ends[0].change?.goal as TimerProgram),
      `the page says verified, but the timer does not hold the goal: ${why}`,
    ).toBe(true);
  }
  if (
    session.notices.current.value?.code === 'nothing-written' ||
    (value?.step === 'done' && value.ends[0]?.state === 'untouched') ||
    isAsking
  ) {
    expect(holds(before), `the page says that nothing was written, but the timer has changed: ${why}`).toBe(true);
  }
  if (known.state === 'read')
    expect(holds(known.program), `the timer does not hold what the page says it has read: ${why}`).toBe(true);
  if (known.state === 'uncertain') {
    const either = [known.before, known.goal].map((program) => [...program.times, ...program.positions.flat()]);
    [...times, ...positions.flat()].forEach((held, i) => {
      expect(
        [either[0]?.[i], either[1]?.[i]],
        `a value is neither the one before the write nor the one of the goal: ${why}`,
      ).toContain(held);
    });
  }
  if (known.state !== 'uncertain' && editor.baseline.value)
    expect(holds(editor.baseline.value), `the timer does not hold what the page shows as its value: ${why}`).toBe(true);
}

const ENDS = ['goes well', 'loses its answer', 'is unplugged'] as const;

/** The pilot has edited a time and a position, opened the dialog, and looks at it while the write ends like this. */
async function written(store: FaultyStore, end: (typeof ENDS)[number], begin: () => void, why = ''): Promise<AppBench> {
  const bench = await connectedBench({ store });
  const before = bench.editor.baseline.value as TimerProgram;
  bench.editor.type(DT, '4:00');
  bench.editor.type(S1, '8');
  await idle(1000);
  begin();
  void bench.write.open();
  await idle(10_000);
  bench.session.safety.confirm();
  if (end !== 'goes well') {
    bench.timer.core.onAnswer = ({ name }) => {
      if (name !== 'SETTIMERS') return;
      bench.timer.core.onAnswer = undefined;
      if (end === 'is unplugged') bench.adapter.unplug();
      else bench.timer.core.sleep();
    };
  }
  void bench.write.goOn();
  for (let i = 0; i < 25; i++) {
    await idle(1000);
    expectNoFalseWord(bench, before, why);
    if (bench.session.runner.job.value?.asking) bench.session.runner.answer(true);
  }
  expect([bench.editor.textOf(DT), bench.editor.textOf(S1)], 'the fields show what was typed').toEqual(['4:00', '8']);
  return bench;
}

it.each(ENDS)(
  'a write which %s says nothing false, whatever the storage does at any call',
  async (end) => {
    const fine = new FaultyStore();
    let made: ReadonlySet<Door> = new Set();
    await written(fine, end, () => {
      made = fine.listen();
    });
    // The calls that such a write makes; the ways to fail that are told apart.
    expect(made.size).toBeGreaterThan(2);
    for (const [door, fault] of shareOf(faultsAt(made, ['refuses', 'throws', 'hangs', 'comes late']))) {
      vi.useRealTimers();
      localStorage.clear();
      const store = new FaultyStore();
      const why = `${door} ${fault}`;
      let isMet = (): boolean => false;
      const bench = await written(
        store,
        end,
        () => {
          isMet = store.fail(door, fault);
        },
        why,
      );
      expect(isMet(), `the write has met it: ${why}`).toBe(true);
      if (end === 'goes well') {
        expect(bench.write.current.value, why).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
        continue;
      }
      expect(bench.session.knowledge.of(0).state, why).toBe('uncertain');
      // The next page knows it, too, where the browser has kept it; where it has not, that was said.
      const next = await appBench({ store: store.next(), plug: { granted: true } });
      await idle(1000);
      const isKnown = next.session.knowledge.uncertain.value.length === 1;
      expect(isKnown || bench.keeping.kept.value !== true, why).toBe(true);
    }
  },
  LONG,
);
