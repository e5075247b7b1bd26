import { describe, expect, it, vi } from 'vitest';
import { setValues } from '../../../src/app/editing/edit.js';
import { HOLD, PressAndHold } from '../../../src/app/ui/press-and-hold.js';
import type { ProgramField } from '../../../src/program/index.js';
import type { Request } from '../../../src/protocol/index.js';
import { type AppBench, following, idle, reloaded, review, run, safeBench, set } from './bench.js';

const S2: ProgramField = { kind: 'position', servo: 1, slot: 4 };
const S3: ProgramField = { kind: 'position', servo: 2, slot: 4 };
const DT: ProgramField = { kind: 'time', slot: 10 };

function requests({ timer }: AppBench, name: Request['name']): Request[] {
  return timer.core.answered.filter((request) => request.name === name);
}

/** What was stored, in its order. */
function stored(app: AppBench): number[] {
  return requests(app, 'SETSERVO').map((request) => (request.name === 'SETSERVO' ? request.position : -1));
}

describe('moving to a function', () => {
  it('moves the servos, and says where they are', async () => {
    const { bench, timer } = await safeBench();
    expect(await run(bench.moveTo(4))).toBe(true);
    expect(timer.core.slot).toBe(4);
    expect(bench.done.value).toEqual({ action: { kind: 'move', slot: 4 }, certain: true });
    const moving = bench.moveTo(5);
    expect(bench.done.value, 'nothing is said while the servos move').toBeNull();
    await run(moving);
    expect(bench.done.value).toMatchObject({ action: { slot: 5 } });
  });

  it('waits until the pilot has said that it is safe', async () => {
    const { bench, follow, session, timer } = await safeBench();
    session.safety.withdraw();
    expect(await bench.moveTo(4)).toBe(false);
    expect(await bench.unlock()).toBe(false);
    expect(await bench.jump()).toBe(false);
    await run(follow.start());
    expect([follow.on.value, timer.core.answered.length]).toEqual([false, 0]);
  });

  it('does nothing while a write is open', async () => {
    const app = await safeBench();
    const { bench, timer } = app;
    await review(app);
    timer.core.answered.length = 0;
    expect(await bench.moveTo(4)).toBe(false);
    expect(timer.core.answered).toEqual([]);
  });

  it('says that they may have moved when no answer came, also after the timer is back', async () => {
    const { bench, timer } = await safeBench();
    timer.core.onAnswer = () => timer.core.sleep();
    const moving = bench.moveTo(3);
    timer.core.sleep();
    expect(await run(moving)).toBe(false);
    const maybe = { action: { kind: 'move', slot: 3 }, certain: false };
    expect(bench.done.value).toEqual(maybe);
    timer.core.onAnswer = undefined;
    timer.core.press();
    await idle(60_000);
    expect(bench.done.value).toEqual(maybe);
  });
});

describe('the motor', () => {
  it('is not reported as running when the command was stopped before its first byte', async () => {
    const { bench, session, timer } = await safeBench();
    const unlocking = bench.unlock();
    session.runner.stop();
    expect(await run(unlocking)).toBe(false);
    expect([timer.core.motorLocked, bench.done.value]).toEqual([true, null]);
  });

  it('may run when the plug was pulled before its answer came', async () => {
    const { bench, timer, adapter } = await safeBench();
    timer.core.onAnswer = () => adapter.unplug();
    expect(await run(bench.unlock())).toBe(false);
    await idle();
    expect([timer.core.motorLocked, bench.done.value?.certain]).toEqual([false, false]);
  });

  it('is said to be unlocked when the pilot disconnects before the answer', async () => {
    const { bench, session, timer } = await safeBench();
    const unlocking = bench.unlock();
    await idle(0);
    await run(session.timer.disconnect());
    await run(unlocking);
    expect([session.connection.value, timer.core.motorLocked]).toEqual([null, false]);
    expect(bench.done.value).toEqual({ action: { kind: 'unlock' }, certain: true });
    await run(session.timer.connect());
    expect(bench.done.value).toBeNull();
  });

  it('does not exist on B', async () => {
    const app = await safeBench({ identity: { timerClass: 'B' } });
    expect(await app.bench.unlock()).toBe(false);
    expect(requests(app, 'UNLOCK')).toEqual([]);
  });
});

it.each([
  ['does nothing when it was released meanwhile, which is heard only afterwards', true],
  ['acts a moment later when it is still held', false],
])('a button that is held down while the page stands still %s', async (_, isReleased) => {
  const app = await safeBench();
  const hold = new PressAndHold(() => void app.bench.unlock());
  hold.press();
  const now = performance.now();
  const clock = vi.spyOn(performance, 'now').mockReturnValue(now + 5000);
  await vi.advanceTimersByTimeAsync(HOLD);
  if (isReleased) hold.release();
  await vi.advanceTimersByTimeAsync(HOLD);
  clock.mockRestore();
  await idle();
  expect(requests(app, 'UNLOCK')).toHaveLength(isReleased ? 0 : 1);
});

describe('following', () => {
  it('reads the timer and keeps a backup before it begins, and sends no earlier edit', async () => {
    const app = await safeBench();
    set(app, [S2, 70]);
    await run(app.follow.start());
    await idle();
    expect(app.timer.core.answered.map(({ name }) => name)).toContain('GETSERVOPOS');
    expect(app.session.backups.list.value[0]?.program).toEqual(app.editor.baseline.value);
    expect(stored(app)).toEqual([]);
    expect(app.store.backups.records.size).toBe(1);
  });

  it('waits for the last digit of a typed number', async () => {
    const app = await following();
    app.editor.type(S2, '7');
    await vi.advanceTimersByTimeAsync(300);
    app.editor.type(S2, '72');
    await idle();
    expect(stored(app)).toEqual([72]);
  });

  it('sends no time, and nothing that a servo cannot do', async () => {
    const app = await following();
    set(app, [DT, 20000]);
    set(app, [S2, 131]);
    await idle();
    expect(app.timer.core.answered).toEqual([]);
    expect(app.follow.on.value).toBe(true);
  });

  it('ends after the running command', async () => {
    const app = await following({ latency: 20 });
    set(app, [S2, 70]);
    await vi.advanceTimersByTimeAsync(5);
    expect(app.session.runner.busy.value).toBe(true);
    await run(app.follow.stop());
    const reading = ['GETMEMORY', 'GETTIMERS', 'GETSERVOPOS', 'GETLOWRPM', 'GETMEMORY', 'GETSWVER'];
    // The first position is read back, and the end is a reading.
    const { answered } = app.timer.core;
    expect(answered.map(({ name }) => name)).toEqual(['SETSERVO', ...reading, ...reading]);
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S2, to: 70 }]);
  });

  it('forgets a session in which nothing was tried', async () => {
    const app = await following();
    await run(app.follow.stop());
    expect(app.follow.trials.current.value).toBeNull();
  });

  it.each<[what: string, done: (app: AppBench) => unknown]>([
    ['following was stopped', ({ follow }) => follow.stop()],
    ['the pilot took the safety back', ({ session }) => session.safety.withdraw()],
  ])('does not begin when %s while the timer is read', async (_, done) => {
    const app = await safeBench();
    const starting = app.follow.start();
    await done(app);
    await run(starting);
    expect(app.follow.on.value).toBe(false);
  });

  it('does not begin again before the pilot has decided about what was tried', async () => {
    const app = await following();
    set(app, [S2, 70]);
    await idle();
    await run(app.follow.stop());
    await run(app.follow.start());
    expect(app.follow.on.value).toBe(false);
    expect(app.follow.trials.takeBack()).toEqual([{ field: S2, value: 55 }]);
  });

  it('sends no value while a text is not a value', async () => {
    const app = await following();
    app.editor.type(S2, '6');
    app.editor.type(S2, '6x');
    await idle();
    app.editor.type(S2, '');
    await idle();
    expect(stored(app)).toEqual([]);
    app.editor.type(S2, '61');
    await idle();
    expect(stored(app)).toEqual([61]);
  });

  it('keeps a choice for each memory', async () => {
    const app = await following();
    set(app, [S2, 66]);
    await idle();
    await run(app.session.reader.selectMemory(1));
    await run(app.bench.moveTo(4));
    await run(app.follow.start());
    set(app, [S3, 7]);
    await idle();
    await run(app.follow.stop());
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S3, to: 7 }]);
    await run(app.session.reader.selectMemory(0));
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S2, to: 66 }]);
    app.follow.keep();
    await run(app.session.reader.selectMemory(1));
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S3, to: 7 }]);
  });

  it('keeps its choice beside those of other tabs', async () => {
    const app = await following();
    const kept = (): { key: string; before: object }[] =>
      JSON.parse(localStorage.getItem('sidus-timer/trials') ?? '[]');
    const [own] = kept();
    // Earlier versions had the number of a tab at the end of the key.
    const other = { ...own, before: { ...own?.before, memory: 2 }, key: 'timer/Q/536/10/3/2/4' };
    localStorage.setItem('sidus-timer/trials', JSON.stringify([own, other]));
    set(app, [S2, 66]);
    await idle();
    expect(kept().map(({ key }) => key)).toEqual(['timer/Q/536/10/3/0', 'timer/Q/536/10/3/2']);
    app.follow.keep();
    expect(kept().map(({ key }) => key)).toEqual(['timer/Q/536/10/3/2']);
  });

  it('ignores a choice that was kept for another layout', async () => {
    const app = await following();
    set(app, [S2, 66]);
    await idle();
    const [kept] = JSON.parse(localStorage.getItem('sidus-timer/trials') ?? '[]');
    const { before } = kept;
    before.identity.servos = 1;
    before.positions.length = 1;
    localStorage.setItem('sidus-timer/trials', JSON.stringify([kept]));
    const after = await reloaded(app);
    await run(after.session.timer.connect());
    expect([after.follow.trials.current.value, after.editor.working.value?.positions[1]?.[4]]).toEqual([null, 66]);
  });

  it('keeps what was tried on the screen when the write that puts it back was not done', async () => {
    const app = await following();
    set(app, [S2, 66]);
    await idle();
    await run(app.follow.stop());
    app.editor.apply(setValues({ code: 'open', params: {} }, app.follow.trials.takeBack()));
    expect(app.editor.changes.value).toHaveLength(1);
    app.follow.keep();
    expect([app.editor.changes.value, app.follow.trials.current.value]).toEqual([[], null]);
  });
});
