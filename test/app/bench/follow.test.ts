import { describe, expect, it, vi } from 'vitest';
import { stepValue } from '../../../src/app/editing/edits.js';
import { FrameForm } from '../../../src/app/line/frame-form.js';
import { possibleValues } from '../../../src/app/timer/known.js';
import { RepeatPress } from '../../../src/app/ui/repeat-press.js';
import type { ProgramField, TimerProgram } from '../../../src/program/index.js';
import type { Request } from '../../../src/protocol/index.js';
import type { TimerQuirks } from '../../../src/simulator/index.js';
import { type AppBench, following, goOn, idle, review, run, safeBench, set } from './bench.js';

const position = (servo: number, slot: number): ProgramField => ({ kind: 'position', servo, slot });
const S2 = position(1, 4);

/** What stores or moves, in its order: 'S4.1=70' stores, 'M4' moves. */
function told({ timer }: AppBench): string[] {
  return timer.core.answered.flatMap((request: Request) => {
    if (request.name === 'SETSERVO') return [`S${request.function}.${request.servo}=${request.position}`];
    if (request.name === 'MOVETOFUNC') return [`M${request.function}`];
    return [];
  });
}

const reads = ({ timer }: AppBench): number => timer.core.answered.filter(({ name }) => name === 'GETSERVOPOS').length;

describe('where the servos stand', () => {
  it('stays known while only times are written, and while it is read', async () => {
    const app = await safeBench();
    await run(app.bench.moveTo(4));
    set(app, [{ kind: 'time', slot: 10 }, 20_000]);
    await review(app);
    await goOn(app);
    app.write.dismiss();
    await run(app.session.reader.read());
    expect(app.bench.stand.at.value).toBe(4);
  });

  const losses: Record<string, (app: AppBench) => Promise<unknown>> = {
    'a jump': ({ bench }) => run(bench.jump()),
    'an unlocked motor': ({ bench }) => run(bench.unlock()),
    'another memory': ({ session }) => run(session.reader.selectMemory(1)),
    'a frame by hand': async ({ session }) => {
      const form = new FrameForm(session);
      form.type('69 02');
      form.ask();
      await run(form.confirm());
    },
    'a write of a position': async (app) => {
      set(app, [position(0, 7), 3]);
      await review(app);
      await goOn(app);
    },
    'a position that somebody else has changed': async ({ session, timer }) => {
      (timer.core.content.positions[2] as number[])[4] = 1;
      await run(session.reader.read());
    },
    'another connection': async ({ session }) => {
      await run(session.timer.disconnect());
      await run(session.timer.connect());
    },
  };

  it.each(Object.entries(losses))('is not known any more after %s', async (_, lose) => {
    const app = await safeBench();
    await run(app.bench.moveTo(4));
    await lose(app);
    expect(app.bench.stand.at.value).toBeNull();
  });

  it('is not known while they move, and when no answer has come', async () => {
    const { bench, timer } = await safeBench();
    await run(bench.moveTo(4));
    const moving = bench.moveTo(5);
    expect(bench.stand.at.value).toBeNull();
    timer.core.sleep();
    expect([await run(moving), bench.stand.at.value]).toEqual([false, null]);
  });
});

describe('servos that follow', () => {
  it.each<NonNullable<TimerQuirks['setMoves']>>(['never', 'there', 'always'])(
    'go to what is trimmed, whether storing moves them %s or not',
    async (setMoves) => {
      const app = await following({ quirks: { setMoves } });
      set(app, [S2, 70]);
      await idle();
      expect(told(app)).toEqual(['S4.1=70', 'M4']);
      expect([app.timer.core.slot, app.timer.core.servos]).toEqual([4, [55, 70, 55]]);
      expect(app.bench.stand.at.value).toBe(4);
    },
  );

  it('are moved once for all that changes in a function', async () => {
    const app = await following();
    set(app, [S2, 70], [position(2, 4), 71]);
    await idle();
    expect(told(app)).toEqual(['S4.1=70', 'S4.2=71', 'M4']);
  });

  it('stay where they are while another function is edited, until the pilot sends them there', async () => {
    const app = await following();
    set(app, [position(0, 6), 7]);
    await idle();
    expect([told(app), [...app.follow.awaited.value]]).toEqual([[], [6]]);
    app.follow.bring(6);
    await idle();
    expect([told(app), [...app.follow.awaited.value]]).toEqual([['M6', 'S6.0=7', 'M6'], []]);
    expect(app.timer.core.servos).toEqual([7, 75, 75]);
  });

  it('go where they are sent as soon as the running command has ended', async () => {
    const app = await following({ latency: 50 });
    set(app, [S2, 70], [position(0, 6), 7]);
    await vi.advanceTimersByTimeAsync(10);
    expect(app.session.runner.busy.value).toBe(true);
    app.follow.bring(6);
    await idle();
    expect(told(app)).toEqual(['S4.1=70', 'M4', 'M6', 'S6.0=7', 'M6']);
  });

  it('do not move when following has ended before the command, also when it begins again', async () => {
    const app = await following({ latency: 50 });
    set(app, [S2, 70], [position(0, 6), 7]);
    await vi.advanceTimersByTimeAsync(10);
    app.follow.bring(6);
    await run(app.follow.stop());
    app.follow.keep();
    await run(app.follow.start());
    await idle();
    expect([app.follow.on.value, told(app)]).toEqual([true, ['S4.1=70']]);
  });

  it('store what waited when the bench moves them there', async () => {
    const app = await following();
    set(app, [position(0, 6), 7]);
    await run(app.bench.moveTo(6));
    await idle();
    expect(told(app)).toEqual(['M6', 'S6.0=7', 'M6']);
  });

  it('skip positions that the pilot has already left', async () => {
    const app = await following({ latency: 50 });
    for (let value = 60; value <= 100; value++) {
      set(app, [S2, value]);
      await vi.advanceTimersByTimeAsync(20);
    }
    // The command under way, the last value, and the movement to it.
    await vi.advanceTimersByTimeAsync(4 * 60);
    expect(app.timer.core.servos[1]).toBe(100);
    const requests = told(app);
    expect(requests.filter((_, i) => i % 2 === 1)).toEqual(requests.filter((_, i) => i % 2 === 1).map(() => 'M4'));
    expect(requests.length).toBeLessThanOrEqual(2 * Math.ceil((41 * 20) / 100 + 1));
  });

  it('are never more than a step behind a key that is held, however slow the timer is', async () => {
    const app = await following({ latency: 200 });
    const { editor, timer, follow } = app;
    const wanted = () => editor.working.value?.positions[1]?.[4] ?? 0;
    const key = new RepeatPress(follow.isBehind);
    key.press(() => editor.apply(stepValue(editor.working.value as TimerProgram, S2, 1)));
    for (let i = 0; i < 600; i++) {
      await vi.advanceTimersByTimeAsync(10);
      expect(wanted() - (timer.core.servos[1] ?? 0)).toBeLessThanOrEqual(1);
    }
    const last = wanted();
    key.release();
    await idle();
    expect([wanted(), timer.core.servos[1], last > 60]).toEqual([last, last, true]);
    const steps = Array.from({ length: last - 55 }, (_, i) => [`S4.1=${56 + i}`, 'M4']).flat();
    expect(told(app), 'each step goes out, after the one before').toEqual(steps);
  });

  it('count what was tried, and not what waits for a write', async () => {
    const app = await following();
    set(app, [S2, 70], [position(0, 6), 7], [{ kind: 'time', slot: 10 }, 20_000]);
    await idle();
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S2, to: 70 }]);
    expect(app.editor.changes.value).toHaveLength(2);
    await review(app);
    await goOn(app);
    expect(app.follow.trials.tried.value, 'a write keeps what was tried: the pilot saw and confirmed it').toMatchObject(
      [{ field: S2, to: 70 }],
    );
  });
});

describe('following ends', () => {
  const ends: [reason: string, what: string, done: (app: AppBench) => unknown][] = [
    ['over', 'the page is out of sight', ({ follow }) => follow.stop('over')],
    ['over', 'the tick is taken away', ({ session }) => session.safety.withdraw()],
    ['over', 'the plug is pulled', ({ adapter }) => adapter.unplug()],
    ['over', 'it is disconnected', ({ session }) => session.timer.disconnect()],
  ];
  const whileFree: typeof ends = [
    [
      'memory',
      'a frame is sent by hand',
      async ({ session }) => {
        const form = new FrameForm(session);
        form.type('69 02');
        form.ask();
        await form.confirm();
      },
    ],
    ['over', 'it is read again', ({ session }) => session.reader.read()],
    ['over', 'a write is shown', (app) => review(app)],
    ['memory', 'another memory is asked for', ({ session }) => session.reader.selectMemory(1)],
    ['over', 'all memories are read', ({ memories }) => memories.backUp()],
  ];

  it.each([...ends, ...whileFree])('as “%s” when %s', async (reason, _, done) => {
    const app = await following();
    await run(Promise.resolve(done(app)));
    await idle();
    expect([app.follow.on.value, app.follow.ended.value?.reason]).toEqual([false, reason]);
    const before = told(app);
    set(app, [S2, 70]);
    await idle();
    expect(told(app)).toEqual(before);
  });

  it.each<[string, (app: AppBench) => Promise<unknown>]>([
    ['the pilot stops', ({ follow }) => follow.stop()],
    ['it is read again', ({ session }) => session.reader.read()],
    ['a third memory is selected', ({ session }) => session.reader.selectMemory(2)],
    ['another memory is looked at', ({ memories }) => memories.edit(2)],
    ['all memories are read', ({ memories }) => memories.backUp()],
  ])('as “strayed” when %s and another memory has become current, which has taken positions', async (_, end) => {
    for (const [at, stored] of [
      [1, false],
      [1, true],
      [0, true],
    ] as const) {
      const app = await following();
      app.timer.core.memory = at;
      if (stored) set(app, [S2, 70]);
      await idle();
      await run(end(app));
      await idle();
      expect(app.timer.core.memories.map(({ positions }) => positions[1]?.[4] === 70).indexOf(true)).toBe(
        stored ? at : -1,
      );
      const isStrayed = app.follow.ended.value?.reason === 'strayed';
      expect(isStrayed, `a position was stored in ${at}: ${stored}`).toBe(stored && at === 1);
      await run(app.session.timer.disconnect());
    }
  });

  it.each(ends)('as “%s” between storing and moving when %s: nothing more is moved', async (reason, _, done) => {
    const app = await following({ latency: 20 });
    app.timer.core.onAnswer = ({ name }) => {
      if (name !== 'SETSERVO') return;
      app.timer.core.onAnswer = undefined;
      void done(app);
    };
    set(app, [S2, 70]);
    await idle();
    expect(app.follow.ended.value?.reason).toBe(reason);
    expect(told(app).filter((request) => request === 'M4')).toEqual([]);
    expect(app.bench.stand.at.value).toBeNull();
  });

  it('with a reading of what the timer holds then', async () => {
    const app = await following();
    set(app, [S2, 70]);
    await idle();
    expect(app.session.standing.value.sure).toBe('once');
    await run(app.follow.stop('over'));
    expect(app.session.standing.value.sure).toBe('now');
  });

  it('when the page stood still while a position was stored: nothing moves after that', async () => {
    const app = await following();
    const now = performance.now.bind(performance);
    app.timer.core.onAnswer = ({ name }) => {
      if (name === 'SETSERVO') vi.spyOn(performance, 'now').mockImplementation(() => now() + 60_000);
    };
    set(app, [S2, 70]);
    await idle();
    vi.mocked(performance.now).mockRestore();
    expect([told(app), app.follow.on.value]).toEqual([['S4.1=70'], false]);
    expect(app.follow.ended.value?.reason).toBe('failed');
  });

  it('when a reading after its first position shows that the timer keeps none', async () => {
    const app = await following({ quirks: { servoIgnored: true } });
    const held = app.timer.core.content.positions[1]?.[4];
    set(app, [S2, 70]);
    await idle();
    expect(app.follow.ended.value).toMatchObject({
      reason: 'unlike',
      unlike: { notTaken: { field: S2, from: 70, to: held }, beside: [] },
    });
    expect(app.bench.stand.at.value).toBeNull();
    expect(told(app)).toEqual(['S4.1=70']);
    expect(app.editor.changes.value).toMatchObject([{ field: S2, from: held, to: 70 }]);
    expect([app.follow.trials.tried.value, app.session.standing.value.sure]).toEqual([[], 'now']);
  });

  it('when a reading shows that another position changed, which can be put back', async () => {
    const app = await following({ quirks: { servoFirst: true } }, 2);
    const other = app.timer.core.content.positions[2]?.[0];
    set(app, [position(0, 2), 70]);
    await idle();
    expect(app.follow.ended.value).toMatchObject({
      reason: 'unlike',
      unlike: {
        notTaken: { field: position(0, 2), from: 70 },
        beside: [{ field: position(2, 0), from: other, to: 70 }],
      },
    });
    expect(app.follow.trials.tried.value).toMatchObject([{ field: position(2, 0), from: other, to: 70 }]);
    expect(app.editor.changes.value).toMatchObject([{ field: position(0, 2), to: 70 }]);
  });

  it('also when the first position has one number for servo and function, which proves nothing', async () => {
    const app = await following({ quirks: { servoFirst: true } }, 1);
    set(app, [position(1, 1), 70]);
    await idle();
    expect(app.follow.on.value).toBe(true);
    set(app, [position(0, 1), 71]);
    await idle();
    expect(app.follow.ended.value).toMatchObject({
      reason: 'unlike',
      unlike: { beside: [{ field: position(1, 0), to: 71 }] },
    });
  });

  it('and says what was not taken although the pilot has ended it meanwhile', async () => {
    const app = await following({ quirks: { servoIgnored: true }, latency: 20 });
    set(app, [S2, 70]);
    await vi.advanceTimersByTimeAsync(5);
    await run(app.follow.stop());
    expect(app.follow.ended.value).toMatchObject({ reason: 'unlike', unlike: { notTaken: { field: S2 } } });
    expect(app.editor.changes.value).toMatchObject([{ field: S2, to: 70 }]);
  });

  it('not when the timer does as it says: only its first position is read back', async () => {
    const app = await following();
    set(app, [S2, 70]);
    await idle();
    expect([reads(app), told(app)]).toEqual([1, ['S4.1=70', 'M4']]);
    set(app, [S2, 71]);
    await idle();
    expect([reads(app), app.follow.on.value]).toEqual([1, true]);
  });

  it('when a movement is not acknowledged, which is not sent again', async () => {
    const app = await following();
    const { core } = app.timer;
    // After the reading that follows the first position.
    core.onAnswer = ({ name }) => name === 'GETSWVER' && core.sleep();
    app.session.log.clear();
    set(app, [S2, 70]);
    await idle();
    core.onAnswer = undefined;
    expect([app.follow.ended.value?.reason, app.bench.stand.at.value]).toEqual(['failed', null]);
    expect(app.bench.done.value).toEqual({ action: { kind: 'move', slot: 4 }, certain: false });
    core.press();
    await idle(60_000);
    expect(app.session.connection.value).not.toBeNull();
    const sent = app.session.log.entries.value.filter(
      ({ direction, frame }) => direction === 'out' && frame?.code === 0x69,
    );
    expect(sent).toHaveLength(1);
    expect(app.bench.done.value?.certain, 'the servos may have moved, also once the timer is back').toBe(false);
  });

  it('and what is not confirmed to be stored is uncertain until a reading', async () => {
    const app = await following();
    app.timer.core.onAnswer = ({ name }) => name === 'SETSERVO' && app.adapter.unplug();
    set(app, [S2, 70]);
    await idle();
    const { knowledge } = app.session;
    expect(possibleValues(knowledge.of(0), S2)).toEqual([55, 70]);
    expect(knowledge.of(0).state).toBe('uncertain');
    app.timer.core.onAnswer = undefined;
    app.adapter.replug();
    await idle(60_000);
    expect(knowledge.of(0).state).toBe('read');
    expect(app.editor.baseline.value?.positions[1]?.[4]).toBe(70);
    expect(app.follow.trials.tried.value).toMatchObject([{ field: S2, to: 70 }]);
  });
});

describe('nothing begins', () => {
  it.each<[string, (app: AppBench) => void]>([
    ['the storage is full', ({ store }) => (store.broken = true)],
    ['the storage does not answer', ({ store }) => (store.backups.save = () => new Promise(() => {}))],
  ])('without a backup, and the page says so, when %s', async (_, fail) => {
    const app = await safeBench();
    fail(app);
    void app.follow.start();
    await idle();
    expect([app.follow.on.value, app.follow.starting.value]).toEqual([false, false]);
    expect(app.session.notices.current.value).toMatchObject({ code: 'not-backed-up' });
  });

  it.each<[string, (app: AppBench) => unknown]>([
    ['the page was hidden', ({ follow }) => follow.stop('over')],
    ['it was read again', ({ session }) => session.reader.read()],
    [
      'the timer was disconnected and connected again',
      async ({ session }) => {
        await session.timer.disconnect();
        await session.timer.connect();
        session.safety.confirm();
      },
    ],
  ])('when %s during the wait for the storage', async (_, done) => {
    const app = await safeBench();
    const { save } = app.store.backups;
    app.store.backups.save = async (backup) => {
      await new Promise((resolve) => setTimeout(resolve, 3000));
      await save.call(app.store.backups, backup);
    };
    const starting = app.follow.start();
    await vi.advanceTimersByTimeAsync(2000);
    expect(app.follow.starting.value).toBe(true);
    await run(Promise.resolve(done(app)));
    await run(starting);
    expect([app.follow.on.value, app.follow.starting.value]).toEqual([false, false]);
  });
});
