import { afterEach, describe, expect, it, vi } from 'vitest';
import { setValues } from '../../../src/app/editing/edit.js';
import { HOLD, PressAndHold } from '../../../src/app/ui/press-and-hold.js';
import type { ProgramField } from '../../../src/program/index.js';
import type { Request } from '../../../src/protocol/index.js';
import { type AppBench, type BenchOptions, connectedBench, goOn, idle, reloaded, review, run } from './bench.js';

const S2: ProgramField = { kind: 'position', servo: 1, slot: 4 };
const S3: ProgramField = { kind: 'position', servo: 2, slot: 4 };
const DT: ProgramField = { kind: 'time', slot: 10 };

afterEach(() => localStorage.clear());

/** A bench whose pilot has said that it is safe. */
async function safeBench(options: BenchOptions = {}) {
  const app = await connectedBench(options);
  app.session.safety.confirm();
  app.timer.core.answered.length = 0;
  return { ...app, bench: app.models.bench };
}

type SafeBench = Awaited<ReturnType<typeof safeBench>>;

/** A bench whose servos stand at function 4 and follow. */
async function followingBench(options: BenchOptions = {}) {
  const app = await safeBench(options);
  await run(app.bench.moveTo(4));
  await run(app.follow.start());
  expect(app.follow.on.value).toBe(true);
  app.timer.core.answered.length = 0;
  return app;
}

function set({ editor }: AppBench, field: ProgramField, value: number): void {
  editor.apply(setValues({ code: 'change', params: {} }, [{ field, value }]));
}

function requests({ timer }: AppBench, name: Request['name']): Request[] {
  return timer.core.answered.filter((request) => request.name === name);
}

/** What was stored, in its order. */
function stored(app: AppBench): number[] {
  return requests(app, 'SETSERVO').map((request) => (request.name === 'SETSERVO' ? request.position : -1));
}

function heldBy({ timer }: SafeBench, field: ProgramField): number | undefined {
  return field.kind === 'position' ? timer.core.content.positions[field.servo]?.[field.slot] : undefined;
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

  it('is unlocked on Q', async () => {
    const { bench, timer } = await safeBench();
    expect(await run(bench.unlock())).toBe(true);
    expect(timer.core.motorLocked).toBe(false);
    expect(bench.done.value).toEqual({ action: { kind: 'unlock' }, certain: true });
  });

  it('does not exist on B', async () => {
    const app = await safeBench({ identity: { timerClass: 'B' } });
    expect(await app.bench.unlock()).toBe(false);
    expect(requests(app, 'UNLOCK')).toEqual([]);
  });
});

describe('holding a button down', () => {
  it('acts once, however long it lasts and however often the key repeats', async () => {
    const app = await safeBench();
    const hold = new PressAndHold(() => void app.bench.unlock());
    hold.press();
    await vi.advanceTimersByTimeAsync(HOLD - 1);
    hold.press();
    expect(requests(app, 'UNLOCK')).toEqual([]);
    await vi.advanceTimersByTimeAsync(1);
    hold.press();
    await idle();
    expect(requests(app, 'UNLOCK')).toHaveLength(1);
    hold.release();
    hold.press();
    await idle();
    expect(requests(app, 'UNLOCK')).toHaveLength(2);
  });

  it('does nothing when the page stood still, and hears only afterwards that it was released', async () => {
    const app = await safeBench();
    const hold = new PressAndHold(() => void app.bench.unlock());
    hold.press();
    const now = performance.now();
    const clock = vi.spyOn(performance, 'now').mockReturnValue(now + 5000);
    await vi.advanceTimersByTimeAsync(HOLD);
    clock.mockRestore();
    hold.release();
    await idle();
    expect(requests(app, 'UNLOCK')).toEqual([]);
  });

  it('acts a moment later when the page stood still and it is still held', async () => {
    const app = await safeBench();
    const hold = new PressAndHold(() => void app.bench.unlock());
    hold.press();
    const now = performance.now();
    const clock = vi.spyOn(performance, 'now').mockReturnValue(now + 5000);
    await vi.advanceTimersByTimeAsync(HOLD);
    await vi.advanceTimersByTimeAsync(HOLD);
    clock.mockRestore();
    await idle();
    expect(requests(app, 'UNLOCK')).toHaveLength(1);
  });

  it('does nothing when the pilot releases it early', async () => {
    const app = await safeBench();
    const hold = new PressAndHold(() => void app.bench.unlock());
    hold.press();
    await vi.advanceTimersByTimeAsync(HOLD - 1);
    hold.release();
    await idle();
    expect([requests(app, 'UNLOCK'), hold.holding.value]).toEqual([[], false]);
  });
});

describe('following', () => {
  it('reads the timer and keeps a backup before it begins, and sends no earlier edit', async () => {
    const app = await safeBench();
    set(app, S2, 70);
    await run(app.follow.start());
    await idle();
    expect(app.timer.core.answered.map(({ name }) => name)).toContain('GETSERVOPOS');
    expect(app.session.backups.list.value[0]?.program).toEqual(app.editor.baseline.value);
    expect(stored(app)).toEqual([]);
    expect(app.store.backups.records.size).toBe(1);
  });

  it('stores a position that changes, and an acknowledged value counts as held by the timer', async () => {
    const app = await followingBench();
    set(app, S2, 70);
    await idle();
    expect([stored(app), heldBy(app, S2)]).toEqual([[70], 70]);
    expect(app.editor.dirty.value).toBe(false);
    expect(app.follow.trials.tried.value.map(({ field, to }) => [field, to])).toEqual([[S2, 70]]);
  });

  it('sends one value at a time, skips those that are no longer wanted, and ends at the last one', async () => {
    const app = await followingBench({ latency: 50 });
    const { client } = app.session.connection.value as NonNullable<typeof app.session.connection.value>;
    let inFlight = 0;
    let most = 0;
    const send = client.setPosition.bind(client);
    vi.spyOn(client, 'setPosition').mockImplementation(async (...args) => {
      most = Math.max(most, ++inFlight);
      await send(...args).finally(() => inFlight--);
    });
    for (let value = 60; value <= 100; value++) {
      set(app, S2, value);
      set(app, S3, 130 - value);
      await vi.advanceTimersByTimeAsync(20);
    }
    await idle();
    expect(most).toBe(1);
    expect(stored(app).length).toBeLessThan(30);
    expect([heldBy(app, S2), heldBy(app, S3)]).toEqual([100, 30]);
    expect(app.editor.dirty.value).toBe(false);
  });

  it('waits for the last digit of a typed number', async () => {
    const app = await followingBench();
    app.editor.type(S2, '7');
    await vi.advanceTimersByTimeAsync(300);
    app.editor.type(S2, '72');
    await idle();
    expect(stored(app)).toEqual([72]);
  });

  it('sends no time, and nothing that a servo cannot do', async () => {
    const app = await followingBench();
    set(app, DT, 20000);
    set(app, S2, 131);
    await idle();
    expect(app.timer.core.answered).toEqual([]);
    expect(app.follow.on.value).toBe(true);
  });

  it('ends with a fresh read, and what was tried can be kept', async () => {
    const app = await followingBench();
    set(app, S2, 70);
    await idle();
    app.timer.core.answered.length = 0;
    await run(app.follow.stop());
    expect(app.timer.core.answered.map(({ name }) => name)).toContain('GETSERVOPOS');
    expect(app.follow.trials.tried.value).toHaveLength(1);
    app.follow.keep();
    expect([app.follow.trials.current.value, heldBy(app, S2)]).toEqual([null, 70]);
  });

  it('ends after the running command', async () => {
    const app = await followingBench({ latency: 20 });
    set(app, S2, 70);
    await vi.advanceTimersByTimeAsync(5);
    expect(app.session.runner.busy.value).toBe(true);
    await run(app.follow.stop());
    const reading = ['GETMEMORY', 'GETTIMERS', 'GETSERVOPOS', 'GETLOWRPM', 'GETMEMORY', 'GETSWVER'];
    // The first position is read back, and the end is a reading.
    const { answered } = app.timer.core;
    expect(answered.map(({ name }) => name)).toEqual(['SETSERVO', ...reading, ...reading]);
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S2, to: 70 }]);
  });

  it('can be put back by a write, and then nothing is left to decide', async () => {
    const app = await followingBench();
    const before = heldBy(app, S2);
    set(app, S2, 70);
    await idle();
    await run(app.follow.stop());
    app.editor.apply(setValues({ code: 'open', params: {} }, app.follow.trials.takeBack()));
    await review(app);
    await goOn(app);
    expect([heldBy(app, S2), app.follow.trials.current.value]).toEqual([before, null]);
  });

  it('leaves values out of the choice that were written in another way', async () => {
    const app = await followingBench();
    set(app, S2, 70);
    await idle();
    await run(app.follow.stop());
    set(app, S3, 20);
    set(app, DT, 20000);
    await review(app);
    await goOn(app);
    expect(app.timer.core.content.times[10]).toBe(20000);
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S2, to: 70 }]);
    expect(app.follow.trials.takeBack()).toMatchObject([{ field: S2 }]);
  });

  it('forgets a session in which nothing was tried', async () => {
    const app = await followingBench();
    await run(app.follow.stop());
    expect(app.follow.trials.current.value).toBeNull();
  });

  it('is off after every connect, and what was tried can still be decided', async () => {
    const app = await followingBench();
    set(app, S2, 70);
    await idle();
    app.adapter.unplug();
    await idle();
    expect(app.follow.on.value).toBe(false);
    app.adapter.replug();
    await idle(60_000);
    expect([app.session.connection.value !== null, app.follow.on.value]).toEqual([true, false]);
    set(app, S3, 20);
    await idle();
    expect(stored(app)).toEqual([70]);
    expect(app.follow.trials.tried.value).toHaveLength(1);
  });

  it('ends when the timer no longer answers', async () => {
    const app = await followingBench();
    app.timer.core.sleep();
    set(app, S2, 70);
    await idle();
    expect(app.follow.on.value).toBe(false);
  });

  it.each<[what: string, done: (app: SafeBench) => unknown]>([
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
    const app = await followingBench();
    const before = heldBy(app, S2);
    set(app, S2, 70);
    await idle();
    await run(app.follow.stop());
    await run(app.follow.start());
    expect(app.follow.on.value).toBe(false);
    expect(app.follow.trials.takeBack()).toEqual([{ field: S2, value: before }]);
  });

  it('is off when another memory turns out to be current, also one in which something was tried', async () => {
    const app = await safeBench();
    await run(app.session.reader.selectMemory(1));
    await run(app.bench.moveTo(4));
    await run(app.follow.start());
    set(app, S3, 7);
    await idle();
    await run(app.session.reader.selectMemory(0));
    await run(app.follow.start());
    expect(app.follow.on.value).toBe(true);
    app.timer.core.memory = 1;
    await run(app.session.reader.read());
    expect([app.editor.working.value?.memory, app.follow.on.value]).toEqual([1, false]);
  });

  it('sends no value while a text is not a value', async () => {
    const app = await followingBench();
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

  it('is off as soon as another memory is requested, also when that is stopped', async () => {
    const app = await followingBench();
    app.timer.core.onAnswer = ({ name }) => {
      if (name === 'SETMEMORY') app.session.runner.stop();
    };
    await run(app.session.reader.selectMemory(1));
    app.timer.core.onAnswer = undefined;
    const { memory } = app.timer.core;
    expect([app.follow.on.value, app.session.nextFlight.open.value]).toEqual([false, false]);
    expect(app.editor.working.value?.memory, 'the page shows the memory that is current in the timer').toBe(memory);
    set(app, S2, 66);
    await idle();
    expect(stored(app)).toEqual([]);
  });

  it('leaves the choice open for a value that may or may not be stored', async () => {
    const app = await followingBench();
    app.timer.core.onAnswer = ({ name }) => {
      if (name === 'SETSERVO') app.adapter.unplug();
    };
    set(app, S2, 66);
    await idle();
    app.timer.core.onAnswer = undefined;
    app.adapter.replug();
    await idle(60_000);
    expect(heldBy(app, S2)).toBe(66);
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S2, to: 66 }]);
  });

  it('keeps a choice for each memory', async () => {
    const app = await followingBench();
    set(app, S2, 66);
    await idle();
    await run(app.session.reader.selectMemory(1));
    await run(app.bench.moveTo(4));
    await run(app.follow.start());
    set(app, S3, 7);
    await idle();
    await run(app.follow.stop());
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S3, to: 7 }]);
    await run(app.session.reader.selectMemory(0));
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S2, to: 66 }]);
    app.follow.keep();
    await run(app.session.reader.selectMemory(1));
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S3, to: 7 }]);
  });

  it('leaves the choice open through a reload', async () => {
    const app = await followingBench();
    set(app, S2, 66);
    await idle();
    const after = await reloaded(app);
    await run(after.session.timer.connect());
    expect(after.follow.on.value).toBe(false);
    expect(after.follow.trials.tried.value).toMatchObject([{ field: S2, to: 66 }]);
    after.follow.keep();
    const later = await reloaded(after);
    await run(later.session.timer.connect());
    expect(later.follow.trials.tried.value).toEqual([]);
  });

  it('keeps its choice beside those of other tabs', async () => {
    const app = await followingBench();
    const kept = (): { key: string; before: object }[] =>
      JSON.parse(localStorage.getItem('sidus-timer/trials') ?? '[]');
    const [own] = kept();
    // Earlier versions had the number of a tab at the end of the key.
    const other = { ...own, before: { ...own?.before, memory: 2 }, key: 'timer/Q/536/10/3/2/4' };
    localStorage.setItem('sidus-timer/trials', JSON.stringify([own, other]));
    set(app, S2, 66);
    await idle();
    expect(kept().map(({ key }) => key)).toEqual(['timer/Q/536/10/3/0', 'timer/Q/536/10/3/2']);
    app.follow.keep();
    expect(kept().map(({ key }) => key)).toEqual(['timer/Q/536/10/3/2']);
  });

  it('ignores a choice that was kept for another layout', async () => {
    const app = await followingBench();
    set(app, S2, 66);
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
    const app = await followingBench();
    set(app, S2, 66);
    await idle();
    await run(app.follow.stop());
    app.editor.apply(setValues({ code: 'open', params: {} }, app.follow.trials.takeBack()));
    expect(app.editor.changes.value).toHaveLength(1);
    app.follow.keep();
    expect([app.editor.changes.value, app.follow.trials.current.value]).toEqual([[], null]);
  });
});
