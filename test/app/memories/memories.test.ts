import { describe, expect, it } from 'vitest';
import { takeGoal } from '../../../src/app/memories/finish-write.js';
import type { Plan } from '../../../src/app/write/plan.js';
import type { ProgramField } from '../../../src/program/index.js';
import { type AppBench, type BenchOptions, connectedBench, goOn, idle, review, run, selected } from '../bench/bench.js';

const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };

/** A timer whose second memory is current and whose memories differ. */
async function bench(options: BenchOptions = {}): Promise<AppBench> {
  const made = await connectedBench(options);
  made.timer.core.memory = 1;
  made.timer.core.memories.forEach(({ positions }, memory) => {
    (positions[0] as number[])[2] = 50 + memory;
  });
  await run(made.session.reader.read());
  made.timer.core.answered.length = 0;
  return made;
}

async function job(app: AppBench, plan: Plan): Promise<void> {
  app.session.safety.confirm();
  await review(app, plan);
  expect(app.write.current.value).toMatchObject({ step: 'review', plan });
  await goOn(app);
}

/** What became of each memory that was to be written. */
function ends({ write }: AppBench): unknown {
  const { value } = write.current;
  return value?.step === 'done' ? value.ends.map(({ memory, state }) => [memory, state]) : value?.step;
}

function contents({ timer }: AppBench) {
  return structuredClone(timer.core.memories);
}

function kept({ session }: AppBench) {
  return session.backups.list.value.map(({ reason, program: { memory, times, positions } }) => ({
    reason,
    memory,
    times,
    positions,
  }));
}

/** What is known of each memory. */
function known({ session }: AppBench): string[] {
  return [0, 1, 2, 3].map((memory) => session.knowledge.of(memory).state);
}

describe('the memories at a glance', () => {
  it('are as last read, also when another one is current by now', async () => {
    const made = await bench();
    await run(made.memories.backUp());
    made.timer.core.memories[1]?.times.fill(100);
    await run(made.session.reader.read());
    await run(made.session.reader.selectMemory(0));
    expect(made.session.knowledge.of(1)).toMatchObject({
      state: 'read',
      program: { times: made.timer.core.memories[1]?.times },
    });
  });

  it('are as last read on the screen, too, with the edits on top', async () => {
    const made = await bench();
    const { editor, session, timer } = made;
    editor.type(S1, '7');
    const [positions] = timer.core.content.positions as [number[]];
    positions[2] = 60;
    positions[3] = 61;
    await run(made.memories.backUp());
    expect(editor.baseline.value?.positions[0]?.slice(2, 4)).toEqual([60, 61]);
    expect(editor.working.value?.positions[0]?.slice(2, 4)).toEqual([7, 61]);
    expect(session.standing.value.sure).toBe('now');
    expect(session.notices.current.value).toEqual({ kind: 'note', code: 'moved' });
  });
});

describe('backing up all memories', () => {
  it('keeps what each holds, and the former current one is current again', async () => {
    const made = await bench();
    const before = contents(made);
    await run(made.memories.backUp());
    expect(made.session.notices.current.value).toEqual({ kind: 'note', code: 'backed-up' });
    expect(kept(made).reverse()).toEqual(before.map((content, memory) => ({ reason: 'memories', memory, ...content })));
    expect(
      new Set(made.session.backups.list.value.map(({ savedAt }) => savedAt)).size,
      'all backups of one job have the same time',
    ).toBe(1);
    expect(made.store.backups.records.size).toBe(4);
    expect([made.timer.core.memory, selected(made).at(-1)]).toEqual([1, 1]);
    expect([contents(made), made.store.unfinished.records.size]).toEqual([before, 0]);
    expect([made.editor.working.value?.memory, made.session.runner.busy.value]).toEqual([1, false]);
  });

  it('goes back when stopped, and does not say that all were kept', async () => {
    const made = await bench();
    made.timer.core.onAnswer = ({ name }) => {
      if (name === 'GETTIMERS' && made.timer.core.memory === 2) void made.session.runner.stop();
    };
    await run(made.memories.backUp());
    expect([made.session.notices.current.value, made.timer.core.memory]).toEqual([null, 1]);
    expect([kept(made), made.store.unfinished.records.size]).toEqual([[], 0]);
  });

  it('says when the browser keeps nothing, whatever was said of that before', async () => {
    const made = await bench();
    made.store.broken = true;
    await run(made.memories.backUp());
    expect(made.keeping.kept.value).toBe(false);
    expect(made.session.notices.current.value).toEqual({ kind: 'note', code: 'not-backed-up' });
    expect(kept(made)).toHaveLength(4);
  });

  it('is refused for a timer that does not say which memory is current', async () => {
    const made = await connectedBench({ quirks: { memoryReplyEmpty: true } });
    await run(made.memories.backUp());
    expect([selected(made), kept(made)]).toEqual([[], []]);
    expect(made.session.notices.current.value).toEqual({ kind: 'timer', code: 'memory-unknown' });
  });
});

describe('copying a memory', () => {
  it('reads the source again, because it may have changed since all were read', async () => {
    const made = await bench();
    await run(made.memories.backUp());
    made.timer.core.memories[2]?.times.fill(1234);
    await job(made, { kind: 'copy', from: 2, to: 3 });
    expect(made.timer.core.memories[3]?.times).toEqual(made.timer.core.memories[2]?.times);
    expect([made.timer.core.memory, made.store.unfinished.records.size]).toEqual([1, 0]);
  });

  it('writes what the current one holds into another, verified, and keeps what that held', async () => {
    const made = await bench();
    const before = contents(made);
    await job(made, { kind: 'copy', from: 1, to: 3 });
    expect(made.write.current.value).toMatchObject({
      step: 'done',
      stopped: null,
      ends: [{ memory: 3, state: 'verified' }],
    });
    expect(contents(made)).toEqual([before[0], before[1], before[2], before[1]]);
    expect(
      [made.timer.core.memory, selected(made)],
      'the memory is selected to read the difference, and again to write',
    ).toEqual([1, [3, 1, 3, 1]]);
    expect(kept(made)).toEqual([{ reason: 'write', memory: 3, ...before[3] }]);
    expect(made.store.unfinished.records.size).toBe(0);
    expect(made.timer.core.idleThrottle).toBe(30);
    expect(known(made), 'the memories that were selected on the way count as read').toEqual([
      'read',
      'read',
      'unread',
      'read',
    ]);
  });

  it('leaves the idle throttle alone, also where each memory has its own', async () => {
    const made = await bench();
    made.timer.core.onAnswer = (request) => {
      if (request.name === 'SETMEMORY') made.timer.core.idleThrottle = 40 + request.memory;
    };
    await job(made, { kind: 'copy', from: 1, to: 3 });
    expect(made.write.current.value).toMatchObject({ ends: [{ state: 'verified' }] });
    expect(made.timer.core.answered.map(({ name }) => name)).not.toContain('SETLOWRPM');
  });

  it('is not complete when the target holds values that were not written', async () => {
    const made = await bench();
    made.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && made.timer.core.content.positions[1]?.fill(77);
    await job(made, { kind: 'copy', from: 1, to: 3 });
    expect(made.write.current.value).toMatchObject({ stopped: { code: 'changed' } });
    expect(made.session.recovery.offer.value).toMatchObject({ kind: 'elsewhere', memory: 3 });
  });

  it('does not copy the edits', async () => {
    const made = await bench();
    made.editor.type(S1, '7');
    await job(made, { kind: 'copy', from: 1, to: 3 });
    expect(made.timer.core.memories[3]?.positions[0]?.[2]).toBe(51);
    expect(made.editor.textOf(S1)).toBe('7');
  });
});

describe('a copy that fails early says so', () => {
  const COPY: Plan = { kind: 'copy', from: 1, to: 3 };

  it('before anything is compared', async () => {
    const made = await bench();
    made.timer.core.onAnswer = ({ name }) => name === 'GETTIMERS' && made.adapter.unplug();
    await review(made, COPY);
    expect(made.write.current.value).toMatchObject({ step: 'done', stopped: { code: 'memory-left' } });
    expect([ends(made), made.write.held]).toEqual([[[3, 'untouched']], true]);
  });

  it('before the first value goes out', async () => {
    const made = await bench();
    made.session.safety.confirm();
    await review(made, COPY);
    made.timer.core.onAnswer = ({ name }) => name === 'GETMEMORY' && made.timer.core.sleep();
    await goOn(made);
    expect(made.write.current.value).toMatchObject({ step: 'done' });
    expect(ends(made)).toEqual([[3, 'untouched']]);
    const { value } = made.write.current;
    expect(value?.step === 'done' && value.stopped).toBeTruthy();
  });

  it('when another memory becomes current: it may have taken values, also if it was verified before', async () => {
    const made = await bench();
    await run(made.memories.backUp());
    const backups = [...made.session.backups.list.value].reverse();
    for (const { times, positions } of made.timer.core.memories) {
      times.splice(10, 1, 36_000);
      positions[0]?.splice(2, 1, 7);
    }
    made.timer.core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS' && made.timer.core.memory === 2) made.timer.core.memory = 0;
    };
    await job(made, { kind: 'restore', backups });
    expect(ends(made)).toEqual([
      [0, 'unknown'],
      [1, 'verified'],
      [2, 'unknown'],
      [3, 'untouched'],
    ]);
    expect(made.write.current.value).toMatchObject({ stopped: { code: 'other-memory' }, strayed: 0 });
  });
});

it('restoring a set writes each memory as it was, keeps what they held, and goes back', async () => {
  const made = await bench();
  const before = contents(made);
  await run(made.memories.backUp());
  const backups = [...made.session.backups.list.value].reverse();
  made.timer.core.memories.forEach(({ positions }, memory) => {
    (positions[2] as number[])[5] = 90 + memory;
  });
  const changed = contents(made);
  await job(made, { kind: 'restore', backups });
  expect(made.write.current.value).toMatchObject({
    stopped: null,
    ends: [0, 1, 2, 3].map((memory) => ({ memory, state: 'verified' })),
  });
  expect([contents(made), made.timer.core.memory]).toEqual([before, 1]);
  const written = kept(made).filter(({ reason }) => reason === 'write');
  expect(written.reverse().map(({ positions }) => positions)).toEqual(changed.map(({ positions }) => positions));
  expect(made.store.unfinished.records.size).toBe(0);
  expect(made.editor.working.value?.positions[2]?.[5]).toBe(before[1]?.positions[2]?.[5]);
});

describe('a plug that is pulled in the middle', () => {
  const COPY: Plan = { kind: 'copy', from: 1, to: 3 };
  const SCREEN: Plan = { kind: 'screen', to: 3, own: false };
  const pulled: [name: string, plan: Plan | null, at: (bench: AppBench, name: string) => boolean, rest: unknown][] = [
    ['a backup', null, ({ timer }, name) => name === 'GETTIMERS' && timer.core.memory === 2, null],
    // The times are there and the position is not: only that memory can tell.
    ['a copy', COPY, (_, name) => name === 'SETTIMERS', { kind: 'elsewhere', memory: 3 }],
    // All is there: the first reading tells.
    ['a copy that was complete', COPY, (_, name) => name === 'SETSERVO', null],
    ['a write of the screen', SCREEN, (_, name) => name === 'SETTIMERS', { kind: 'elsewhere', memory: 3 }],
    ['a write of the screen that was complete', SCREEN, (_, name) => name === 'SETSERVO', null],
  ];

  it.each(pulled)(
    'during %s is reported; the way back is offered at the next connection',
    async (_, plan, at, rest) => {
      const made = await bench();
      made.timer.core.onAnswer = ({ name }) => at(made, name) && made.adapter.unplug();
      await (plan ? job(made, plan) : run(made.memories.backUp()));
      expect(made.session.notices.current.value).toEqual({ kind: 'timer', code: 'memory-left' });
      made.timer.core.onAnswer = undefined;
      made.write.dismiss();
      const left = made.timer.core.memory;
      made.adapter.replug();
      await idle();
      await run(made.session.reader.read());
      expect(made.session.recovery.offer.value).toMatchObject({
        kind: 'memories',
        record: { original: 1 },
        current: left,
      });
      expect(made.timer.core.memory, 'no memory is selected unasked').toBe(left);
      await run(made.session.reader.selectMemory(1));
      expect(made.timer.core.memory).toBe(1);
      if (rest) expect(made.session.recovery.offer.value).toMatchObject(rest as object);
      else expect([made.session.recovery.offer.value, made.store.unfinished.records.size]).toEqual([null, 0]);
    },
  );

  it('during a restore leaves no older reading on the screen than the last one', async () => {
    const made = await bench();
    const { editor, session, timer, adapter } = made;
    await run(made.memories.backUp());
    const backups = session.backups.list.value.filter(({ program }) => [1, 2].includes(program.memory ?? 0)).reverse();
    expect(backups.map(({ program }) => program.memory)).toEqual([1, 2]);
    for (const { positions } of timer.core.memories) (positions[0] as number[])[2] = 70;
    await run(session.reader.read());
    timer.core.onAnswer = ({ name }) => name === 'SETSERVO' && timer.core.memory === 2 && adapter.unplug();
    await job(made, { kind: 'restore', backups });
    expect(ends(made)).toEqual([
      [1, 'verified'],
      [2, 'unknown'],
    ]);
    expect([editor.baseline.value?.memory, editor.baseline.value?.positions[0]?.[2]]).toEqual([1, 51]);
    timer.core.onAnswer = undefined;
    timer.core.memory = 1;
    adapter.replug();
    await idle();
    // It was this page that changed it.
    expect(session.notices.current.value).toBeNull();
  });

  it('never lends its readings to the timer that comes next, however slow the storage is', async () => {
    const made = await bench();
    const { session, store, timer, adapter } = made;
    session.safety.confirm();
    await review(made, COPY);
    const remove = store.unfinished.remove.bind(store.unfinished);
    store.unfinished.remove = async (key) => {
      await new Promise((resolve) => setTimeout(resolve, 4000));
      await remove(key);
    };
    timer.core.onAnswer = ({ name }) => {
      if (name !== 'SETMEMORY' || timer.core.memory !== 1) return;
      timer.core.onAnswer = undefined;
      adapter.unplug();
      adapter.replug();
    };
    await goOn(made);
    await idle();
    expect(known(made)).toEqual(['unread', 'read', 'unread', 'unread']);
  });

  it('during a copy leaves the idle throttle alone when the rest is shown', async () => {
    const made = await bench();
    made.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && made.adapter.unplug();
    await job(made, COPY);
    made.timer.core.onAnswer = undefined;
    made.write.dismiss();
    made.adapter.replug();
    await idle();
    await run(made.session.reader.selectMemory(1));
    await run(made.session.reader.selectMemory(3));
    await run(takeGoal(made.session));
    expect([made.editor.textOf(S1), made.editor.working.value?.idleThrottle]).toEqual(['51', 30]);
  });
});

it('no memory is made current unasked', async () => {
  const made = await bench();
  made.editor.type(S1, '7');
  await review(made);
  made.session.safety.confirm();
  await goOn(made);
  made.write.dismiss();
  await run(made.session.reader.read());
  made.adapter.unplug();
  await idle();
  made.adapter.replug();
  await idle();
  made.timer.core.sleep();
  await run(made.session.reader.read());
  made.timer.core.press();
  await idle();
  await run(made.session.timer.disconnect());
  await run(made.session.timer.connect());
  expect([made.session.link.state.value.status, selected(made), made.timer.core.memory]).toEqual(['on', [], 1]);
});

it('a copy to a timer that keeps positions where its servos stand moves them only when that is wanted', async () => {
  const made = await bench({ quirks: { servoNeedsMove: true } });
  const moves = () => made.timer.core.answered.filter(({ name }) => name === 'MOVETOFUNC').length;
  const copy: Plan = { kind: 'copy', from: 1, to: 3 };
  await job(made, copy);
  expect(made.write.current.value).toMatchObject({ step: 'done', notHeld: true });
  expect(moves()).toBe(0);
  made.session.servoMoves.allow(true);
  made.write.dismiss();
  await review(made, copy);
  expect([made.session.servoMoves.needed, made.session.servoMoves.allowed.value]).toEqual([true, false]);
  made.session.servoMoves.allow(true);
  await goOn(made);
  expect(made.write.current.value).toMatchObject({ step: 'done', notHeld: false });
  expect(made.timer.core.memories[3]?.positions[0]?.[2]).toBe(51);
  expect(moves()).toBe(1);
});
