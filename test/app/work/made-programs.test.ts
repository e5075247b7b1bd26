import { describe, expect, it } from 'vitest';
import { newProgram, USUAL_LAYOUT } from '../../../src/app/editing/new-program.js';
import type { TimerProgram } from '../../../src/program/index.js';
import { type AppBench, appBench, connectedBench, idle, reloaded, run } from '../bench/bench.js';

const DT = { kind: 'time', slot: 10 } as const;
const S2 = { kind: 'position', servo: 1, slot: 3 } as const;
const USUAL = { timerClass: 'Q', ...USUAL_LAYOUT, from: 'usual' } as const;

async function made(program: TimerProgram = newProgram(USUAL)): Promise<AppBench> {
  const bench = await appBench();
  bench.session.onScreen.make(program);
  return bench;
}

function notice(bench: AppBench): string | undefined {
  return bench.session.notices.current.value?.code;
}

function kept(bench: AppBench) {
  return [...bench.store.drafts.records.values()];
}

describe('a program that was made here', () => {
  it('is edited without a timer, and nothing of it is called changed or read', async () => {
    const { editor, session } = await made();
    editor.type(DT, '4:00');
    editor.leave(DT);
    expect(editor.working.value?.times[10]).toBe(24000);
    expect([editor.changes.value, editor.baseline.value, session.standing.value]).toEqual([
      [],
      null,
      { sure: 'once', at: null },
    ]);
    editor.undo();
    expect(editor.working.value?.times[10]).toBe(18000);
  });

  it('comes back after a reload with what can be undone, also when nothing was typed', async () => {
    const bench = await made();
    await idle();
    const untouched = await reloaded(bench);
    expect([untouched.editor.working.value, notice(untouched)]).toEqual([newProgram(USUAL), undefined]);
    untouched.editor.type(S2, '70');
    await idle();
    const after = await reloaded(untouched);
    expect([after.editor.textOf(S2), after.editor.madeAt.value]).toEqual(['70', bench.editor.madeAt.value]);
    after.editor.undo();
    expect(after.editor.textOf(S2)).toBe('65');
  });

  it('is loaded over what a timer holds, as one step that undo takes back, and is kept', async () => {
    const bench = await made();
    bench.editor.type(S2, '70');
    await run(bench.session.timer.connect());
    const held = bench.editor.baseline.value as TimerProgram;
    expect([notice(bench), held.positions[1]?.[3], bench.editor.textOf(S2)]).toEqual(['made-laid', 45, '70']);
    expect(bench.editor.madeAt.value).toBeNull();
    expect(bench.editor.changes.value.length).toBeGreaterThan(30);
    bench.editor.undo();
    expect([bench.editor.changes.value, bench.editor.working.value]).toEqual([[], held]);
    expect(notice(bench), 'nothing is loaded over it any more').toBeUndefined();
    expect(bench.session.drafts.edited.value.map(({ working }) => working.positions[1]?.[3])).toEqual([70]);
  });

  it('is loaded over the earlier edits of that memory, which undo brings back', async () => {
    const bench = await connectedBench();
    bench.editor.type(S2, '7');
    bench.editor.leave(S2);
    await idle();
    await run(bench.session.timer.disconnect());
    bench.session.onScreen.make(newProgram(USUAL));
    await run(bench.session.timer.connect());
    expect(bench.editor.textOf(S2)).toBe('65');
    bench.editor.undo();
    expect(bench.editor.textOf(S2)).toBe('7');
  });

  it.each([
    ['of another class', newProgram({ ...USUAL, timerClass: 'B' })],
    ['of another layout', newProgram({ ...USUAL, servos: 2 })],
  ])('%s than the timer is closed and kept', async (_, program) => {
    const bench = await made(program);
    await run(bench.session.timer.connect());
    expect([notice(bench), bench.editor.changes.value, bench.editor.working.value?.memory]).toEqual(['kept', [], 0]);
    await idle();
    expect(kept(bench).map(({ working, shelved }) => [working, shelved])).toEqual([[program, true]]);
  });

  it('with a field without a value is closed, because nothing unwanted may be written', async () => {
    const bench = await made();
    bench.editor.type(S2, 'x');
    await run(bench.session.timer.connect());
    await idle();
    expect([notice(bench), bench.editor.changes.value.length]).toEqual(['kept', 0]);
    expect(kept(bench).map(({ texts }) => texts)).toEqual([{ 'position:1:3': 'x' }]);
  });

  it('is closed for another one, and each of the two can be opened again', async () => {
    const bench = await made();
    bench.editor.type(S2, '70');
    bench.session.onScreen.make(newProgram({ ...USUAL, timerClass: 'E' }));
    await idle();
    bench.session.onScreen.closeProgram();
    await idle();
    expect(bench.editor.working.value).toBeNull();
    const again = await reloaded(bench);
    expect(again.editor.working.value, 'a closed program stays closed after a reload').toBeNull();
    const list = again.session.drafts.edited.value;
    expect(list.map(({ working }) => working.identity.timerClass).sort()).toEqual(['E', 'Q']);
    const first = list.find(({ working }) => working.identity.timerClass === 'Q');
    if (!first) throw new Error('it is gone');
    again.session.onScreen.showKept(first);
    expect(again.editor.textOf(S2)).toBe('70');
    again.editor.type(S2, '71');
    await idle();
    const last = await reloaded(again);
    expect(last.editor.textOf(S2), 'a program that was opened again comes back after a reload').toBe('71');
  });

  it('is deleted for good', async () => {
    const bench = await made();
    bench.session.onScreen.closeProgram();
    const [draft] = bench.session.drafts.edited.value;
    if (!draft) throw new Error('it is not kept');
    await bench.session.drafts.remove(draft);
    expect([kept(bench), bench.session.drafts.edited.value]).toEqual([[], []]);
  });

  it('never takes the place of a timer that is connected', async () => {
    const bench = await connectedBench();
    const { value } = bench.editor.working;
    bench.session.onScreen.make(newProgram(USUAL));
    bench.session.onScreen.closeProgram();
    expect(bench.editor.working.value).toBe(value);
  });
});
