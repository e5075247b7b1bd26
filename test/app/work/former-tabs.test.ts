import * as v from 'valibot';
import { describe, expect, it } from 'vitest';
import { draftSchema } from '../../../src/app/storage/records.js';
import type { ProgramField } from '../../../src/program/index.js';
import { type AppBench, appBench, connectedBench, idle, MemoryStore, run } from '../bench/bench.js';

/*
 * Until version 0.9 several tabs could work at the same time. The work of each had a place of its own: its key ended
 * with the number of the tab, and the record held that number.
 */
const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };

/** A storage with the work of two tabs on one memory, as that version left it. The second tab was the last to save. */
async function ofTwoTabs(): Promise<MemoryStore> {
  const bench = await connectedBench();
  const [first, second] = ['7', '8'].map((text) => {
    bench.editor.type(S1, text);
    return structuredClone(bench.editor.snapshot());
  });
  await idle();
  const [[key, draft]] = [...bench.store.drafts.records] as [[string, object]];
  const store = new MemoryStore();
  for (const [tab, content] of [first, second].entries()) {
    const place = tab === 0 ? key : `${key}/${tab + 1}`;
    const raw = { ...draft, ...content, key: place, tab: tab + 1, savedAt: Date.now() + tab * 1000 };
    store.drafts.records.set(place, v.parse(draftSchema, raw));
  }
  return store;
}

const kept = ({ store }: AppBench) =>
  [...store.drafts.records.values()].map(({ working }) => working.positions[0]?.[2]).sort();

describe('the work of two tabs of an earlier version', () => {
  it('is all there: the latest on the screen, the other among the programs', async () => {
    const bench = await appBench({ store: await ofTwoTabs() });
    await idle();
    expect(bench.editor.textOf(S1)).toBe('8');
    expect(kept(bench)).toEqual([7, 8]);
    const other = bench.session.drafts.edited.value.find(({ working }) => working.positions[0]?.[2] === 7);
    if (!other) throw new Error('it is lost');
    bench.session.onScreen.showKept(other);
    await idle();
    expect(bench.editor.textOf(S1)).toBe('7');
    expect(kept(bench)).toEqual([7, 8]);
  });

  it('is all there when the timer is read first', async () => {
    const bench = await appBench({ store: await ofTwoTabs(), started: false });
    await run(Promise.all([bench.session.timer.connect(), bench.session.keptWork.start()]));
    await idle();
    expect(['7', '8']).toContain(bench.editor.textOf(S1));
    expect(kept(bench)).toEqual([7, 8]);
  });
});
