import { render, screen } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { App } from '../../src/app/app.js';
import type { ProgramField } from '../../src/program/index.js';
import { en } from '../tools/en.js';
import { type AppBench, appBench, type BenchOptions, connectedBench, idle, run } from './bench/bench.js';
import { FAULTS, FaultyStore } from './faults.js';

const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };

/** Each call of the storage waits until the function that comes back is called. */
function delay(store: FaultyStore): () => void {
  let answer = (): void => {};
  const answered = new Promise<void>((resolve) => {
    answer = resolve;
  });
  store.before = () => answered;
  return answer;
}

/** A storage that never answers. */
function silent(): FaultyStore {
  const store = new FaultyStore();
  store.before = FAULTS.hangs;
  return store;
}

async function drawn(options: BenchOptions): Promise<AppBench> {
  const bench = await appBench({ ...options, started: false });
  render(<App models={bench.models} />);
  void bench.session.keptWork.start();
  await idle(0);
  expect(screen.getByRole('button', { name: 'Connect' })).toBeTruthy();
  return bench;
}

/** What a pilot has left behind: M1 with S1 of function 2 at 7. */
async function left(): Promise<FaultyStore> {
  const store = new FaultyStore();
  const bench = await connectedBench({ store });
  bench.editor.type(S1, '7');
  await idle();
  return store;
}

describe('a storage that does not answer', () => {
  it('is reported after five seconds, and not before', async () => {
    await drawn({ store: silent() });
    await idle(4900);
    expect(screen.queryByText(en.keeping.notKnown, { exact: false })).toBeNull();
    await idle(100);
    expect(screen.getByText(en.keeping.notKnown, { exact: false })).toBeTruthy();
  });

  it('does not prevent reading, typing and writing', async () => {
    const store = silent();
    const bench = await drawn({ store });
    await run(bench.session.timer.connect());
    bench.editor.type(S1, '7');
    await idle();
    expect(bench.editor.textOf(S1)).toBe('7');
    expect(store.drafts.records.size).toBe(0);
  });

  it.each([0, 1000, 20_000])('lets the program be drawn within one limit, %i ms after the page', async (wait) => {
    const store = silent();
    const bench = await drawn({ store });
    await idle(wait);
    const begun = performance.now();
    void bench.session.timer.connect();
    while (bench.editor.working.value === null && performance.now() - begun < 60_000) await idle(50);
    // One that is known to hang is asked twice more, for a quarter of a second each.
    expect(performance.now() - begun).toBeLessThanOrEqual(5500);
  });

  it('gives back what was kept when it answers at last', async () => {
    const store = await left();
    const answer = delay(store);
    const bench = await drawn({ store });
    await idle();
    expect([bench.editor.working.value, bench.keeping.kept.value]).toEqual([null, null]);
    answer();
    await idle();
    expect([bench.editor.textOf(S1), bench.keeping.kept.value]).toEqual(['7', true]);
    expect(screen.getByText(en.notes.back.title)).toBeTruthy();
  });

  it('does not overwrite what was typed meanwhile when it answers at last, and loses neither', async () => {
    const store = await left();
    const answer = delay(store);
    const bench = await drawn({ store });
    await run(bench.session.timer.connect());
    bench.editor.type(S1, '8');
    await idle();
    answer();
    await idle();
    expect(bench.editor.textOf(S1)).toBe('8');
    bench.editor.type(S1, '9');
    await idle();
    const kept = [...store.drafts.records.values()].map(({ key, working }) => [key, working.positions[0]?.[2]]);
    expect(kept.map(([, value]) => value).sort(), 'the older draft is kept beside the newer one').toEqual([7, 9]);
  });
});

it('a storage that refuses does not keep, and that is said', async () => {
  const store = new FaultyStore();
  store.before = FAULTS['is full'];
  const bench = await drawn({ store });
  expect(bench.keeping.kept.value).toBe(false);
  expect(screen.getByText(en.keeping.notKept, { exact: false })).toBeTruthy();
});

it.each([
  ['tabs', en.keeping.oneTab, en.keeping.notKept],
  ['settings', en.keeping.notKept, en.keeping.oneTab],
  ['emptied', en.keeping.emptied, en.keeping.notKept],
] as const)('a browser that lacks “%s” is told apart from a storage that refuses', async (lack, said, other) => {
  const bench = await drawn({});
  bench.keeping.lack(lack);
  await idle(0);
  expect(screen.getByText(said, { exact: false })).toBeTruthy();
  expect(screen.queryByText(other, { exact: false })).toBeNull();
});
