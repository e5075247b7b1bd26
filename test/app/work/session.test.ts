import { describe, expect, it, vi } from 'vitest';
import { setValues } from '../../../src/app/editing/edit.js';
import { groupOf } from '../../../src/app/editing/history.js';
import { type ProgramField, type TimerProgram, withValue } from '../../../src/program/index.js';
import { CAPTURED_POSITIONS } from '../../protocol/vectors.js';
import {
  type AppBench,
  appBench,
  connectedBench,
  goOn,
  idle,
  MemoryStore,
  reloaded,
  review,
  run,
} from '../bench/bench.js';
import { FaultyStore } from '../faults.js';

const DT: ProgramField = { kind: 'time', slot: 10 };
const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };

function status({ session }: AppBench): string {
  return session.link.state.value.status;
}

function notice({ session }: AppBench): string | undefined {
  return session.notices.current.value?.code;
}

/** The requests that the timer has answered. */
function answered({ timer }: AppBench): string[] {
  return timer.core.answered.map(({ name }) => name);
}

/** The questions of one reading. */
const READ_ALL = ['GETMEMORY', 'GETTIMERS', 'GETSERVOPOS', 'GETLOWRPM', 'GETMEMORY', 'GETSWVER'];

describe('connect', () => {
  it('lets the pilot choose, opens the port, identifies the timer, and shows what it holds', async () => {
    const bench = await connectedBench();
    expect([status(bench), notice(bench), bench.session.runner.busy.value]).toEqual(['on', undefined, false]);
    expect(bench.editor.baseline.value?.positions).toEqual([
      CAPTURED_POSITIONS,
      CAPTURED_POSITIONS,
      CAPTURED_POSITIONS,
    ]);
    expect(bench.editor.dirty.value).toBe(false);
    expect(answered(bench)).toEqual(['GETSWVER', ...READ_ALL]);
    expect(bench.session.log.entries.value).toHaveLength(14);
  });

  it('takes the port of the last time without asking', async () => {
    const bench = await appBench({ plug: { granted: true } });
    bench.serial.choose(null);
    await run(bench.session.timer.connect());
    expect(status(bench)).toBe('on');
  });

  it('asks when the browser has not listed its ports within a second', async () => {
    const bench = await appBench();
    vi.spyOn(bench.serial, 'getPorts').mockImplementation(() => new Promise(() => {}));
    const asked = vi.spyOn(bench.serial, 'requestPort');
    void bench.session.timer.connect();
    await idle(999);
    expect(asked).not.toHaveBeenCalled();
    await idle(1);
    expect(asked).toHaveBeenCalled();
  });

  it('asks when more than one port is remembered, or when the pilot wants to choose', async () => {
    const bench = await appBench({ plug: { granted: true } });
    bench.serial.choose(null);
    await run(bench.session.timer.connect(true));
    expect([status(bench), notice(bench)]).toEqual(['off', 'nothing-chosen']);
    bench.serial.plug({}, { granted: true });
    await run(bench.session.timer.connect());
    expect([status(bench), notice(bench)]).toEqual(['off', 'nothing-chosen']);
  });

  const troubles: [code: string, set: (bench: AppBench, trouble: boolean) => void][] = [
    ['nothing-chosen', ({ serial, port }, trouble) => serial.choose(trouble ? null : port)],
    ['busy', ({ port }, trouble) => Object.assign(port.device, { busy: trouble })],
    ['not-allowed', ({ serial }, trouble) => Object.assign(serial, { userActivation: !trouble })],
  ];

  it.each(troubles)('says %s, and works when that is repaired', async (code, set) => {
    const bench = await appBench();
    set(bench, true);
    await run(bench.session.timer.connect());
    expect([status(bench), notice(bench), bench.session.runner.busy.value]).toEqual(['off', code, false]);
    expect(bench.port.device.opened).toBeNull();
    set(bench, false);
    await run(bench.session.timer.connect());
    expect([status(bench), notice(bench)]).toEqual(['on', undefined]);
  });

  const waits: [why: string, wanted: string, set: (bench: AppBench, trouble: boolean) => void][] = [
    ['does not answer', 'waiting', ({ timer: { core } }, trouble) => (trouble ? core.sleep() : core.press())],
    ['is unplugged', 'away', ({ adapter }, trouble) => (trouble ? adapter.unplugAfter(3) : adapter.replug())],
  ];

  it.each(waits)('waits for a timer that %s, and reads it as soon as that is over', async (_, wanted, set) => {
    const bench = await appBench();
    set(bench, true);
    await run(bench.session.timer.connect());
    await idle();
    expect([status(bench), notice(bench), bench.session.runner.busy.value]).toEqual([wanted, undefined, false]);
    expect(bench.editor.working.value).toBeNull();
    set(bench, false);
    await idle();
    expect([status(bench), notice(bench), bench.session.runner.busy.value]).toEqual(['on', undefined, false]);
    expect(answered(bench).filter((name) => name !== 'GETSWVER')).toEqual(READ_ALL.slice(0, -1));
  });

  it('does nothing the second time of a double click', async () => {
    const bench = await appBench();
    await run(
      Promise.all([
        bench.session.timer.connect(),
        bench.session.timer.connect(),
        bench.session.timer.trySimulated('B'),
      ]),
    );
    expect(answered(bench)).toEqual(['GETSWVER', ...READ_ALL]);
    expect(bench.session.simulated.value).toBe(false);
  });

  it('knows when a connection is impossible here', async () => {
    const bench = await appBench({ webSerial: false });
    expect(bench.session.link.unavailable).toBe('unsupported');
    await run(bench.session.timer.connect());
    expect(status(bench)).toBe('off');
    await run(bench.session.timer.trySimulated('B'));
    expect([status(bench), bench.editor.working.value?.identity.timerClass]).toEqual(['on', 'B']);
  });
});

describe('when the first read does not come to its end', () => {
  it.each([
    ['the timer fell asleep', ({ timer }: AppBench) => timer.core.sleep(), ({ timer }: AppBench) => timer.core.press()],
    ['the pilot stopped it', ({ session }: AppBench) => session.runner.stop(), () => {}],
  ])('because %s, the timer is read when it is back or by Connect', async (_, hinder, mend) => {
    const bench = await appBench();
    bench.timer.core.onAnswer = ({ name }) => {
      if (name === 'GETMEMORY') hinder(bench);
    };
    await run(bench.session.timer.connect());
    expect([bench.editor.working.value, bench.session.nextFlight.open.value]).toEqual([null, true]);
    bench.timer.core.onAnswer = undefined;
    mend(bench);
    await run(bench.session.timer.connect());
    await idle();
    expect([status(bench), notice(bench)]).toEqual(['on', undefined]);
    expect(bench.editor.working.value?.times[10]).toBe(18000);
  });

  it('trying a simulated timer gives the port back', async () => {
    const bench = await appBench();
    bench.timer.core.onAnswer = () => bench.session.runner.stop();
    await run(bench.session.timer.connect());
    await run(bench.session.timer.trySimulated('Q'));
    expect(bench.session.simulated.value).toBe(true);
    expect(bench.port.device.opened).toBeNull();
  });
});

describe('a lost port', () => {
  it('is waited for without a message, comes back without a click, and is read', async () => {
    const bench = await connectedBench();
    bench.session.safety.confirm();
    bench.adapter.unplug();
    await idle();
    expect([status(bench), notice(bench), bench.session.runner.busy.value]).toEqual(['away', undefined, false]);
    expect(bench.editor.working.value, 'the program stays on the screen').not.toBeNull();
    bench.timer.core.answered.length = 0;
    bench.adapter.replug();
    await idle();
    expect([status(bench), notice(bench)]).toEqual(['on', undefined]);
    expect(answered(bench)).toEqual(['GETSWVER', ...READ_ALL]);
    expect(bench.session.safety.confirmed.value, 'it may be another timer').toBe(false);
    await run(bench.session.reader.read());
    expect(notice(bench), 'the notice of the return is gone after a reading').toBeUndefined();
  });

  it('keeps what was typed', async () => {
    const bench = await connectedBench();
    bench.editor.type(S1, '7');
    bench.editor.type(DT, 'x');
    bench.adapter.unplug();
    await idle();
    expect([bench.editor.textOf(S1), bench.editor.textOf(DT)]).toEqual(['7', 'x']);
    bench.adapter.replug();
    await idle();
    expect([status(bench), notice(bench)]).toEqual(['on', undefined]);
    expect([bench.editor.textOf(S1), bench.editor.textOf(DT)]).toEqual(['7', 'x']);
    expect(bench.editor.changes.value).toEqual([{ field: S1, from: 35, to: 7 }]);
  });

  it('says what has changed meanwhile, with and without edits', async () => {
    const bench = await connectedBench();
    const elsewhere = async (position: number): Promise<void> => {
      bench.adapter.unplug();
      await idle();
      (bench.timer.core.content.positions[2] as number[])[4] = position;
      bench.adapter.replug();
      await idle();
    };
    await elsewhere(98);
    expect([status(bench), notice(bench)]).toEqual(['on', 'timer-moved']);
    bench.editor.type(S1, '7');
    await elsewhere(99);
    expect([status(bench), notice(bench)]).toEqual(['on', 'moved']);
    expect([bench.editor.textOf(S1), bench.editor.working.value?.positions[2]?.[4]]).toEqual(['7', 99]);
    bench.editor.revertAll();
    expect(notice(bench), 'no change is kept or marked any more').toBeUndefined();
  });

  it.each([3, 20, 60])('is waited for when it goes %i bytes into a read', async (bytes) => {
    const bench = await connectedBench();
    bench.editor.type(S1, '7');
    bench.adapter.unplugAfter(bytes);
    expect(await run(bench.session.reader.read())).toBe(false);
    await idle();
    expect([status(bench), notice(bench), bench.session.runner.busy.value]).toEqual(['away', undefined, false]);
    expect(bench.editor.textOf(S1)).toBe('7');
    bench.adapter.replug();
    await idle();
    expect([status(bench), notice(bench), bench.session.runner.busy.value]).toEqual(['on', undefined, false]);
    expect(bench.editor.textOf(S1)).toBe('7');
  });
});

describe('disconnect', () => {
  it('closes the port, and keeps what was typed', async () => {
    const bench = await connectedBench();
    bench.editor.type(S1, '7');
    bench.session.notices.say('write-completed');
    await run(bench.session.timer.disconnect());
    expect([status(bench), notice(bench), bench.port.device.opened]).toEqual(['off', undefined, null]);
    expect(bench.editor.textOf(S1)).toBe('7');
  });

  it('keeps the program on the screen as it was read last, with its time', async () => {
    const bench = await connectedBench();
    const { working } = bench.editor;
    const { value } = working;
    await run(bench.session.timer.disconnect());
    expect(working.value).toBe(value);
    expect(bench.session.standing.value).toEqual({ sure: 'once', at: expect.any(Number) });
  });

  it('leaves what was read last on the screen when it only ends the waiting', async () => {
    const bench = await connectedBench();
    bench.adapter.unplug();
    await idle();
    await run(bench.session.timer.disconnect());
    expect([status(bench), bench.editor.textOf(S1)]).toEqual(['off', '35']);
    bench.adapter.replug();
    await run(bench.session.timer.connect());
    expect([status(bench), notice(bench)], 'after Disconnect, a new connection is not called a return').toEqual([
      'on',
      undefined,
    ]);
  });

  it('and Connect work without a pause, where a port takes long to close', async () => {
    const bench = await connectedBench();
    const close = bench.port.close.bind(bench.port);
    bench.port.close = async () => {
      await new Promise((resolve) => setTimeout(resolve, 300));
      await close();
    };
    bench.editor.type(S1, '7');
    const closing = bench.session.timer.disconnect();
    await run(bench.session.timer.connect());
    await run(closing);
    expect([status(bench), notice(bench)]).toEqual(['on', undefined]);
    expect(bench.editor.working.value).not.toBeNull();
    expect(bench.editor.textOf(S1)).toBe('7');
  });
});

describe('a backup', () => {
  it('is shown as edits, with the idle throttle as it is where that is not known', async () => {
    const bench = await connectedBench();
    const working = bench.editor.working.value as TimerProgram;
    const program = { ...withValue(working, S1, 7), memory: 2, idleThrottle: null };
    bench.session.onScreen.showBackup({ key: 'k', savedAt: 0, reason: 'write', simulated: false, program });
    expect(bench.editor.changes.value).toEqual([{ field: S1, from: 35, to: 7 }]);
    expect(bench.editor.working.value?.memory).toBe(0);
    bench.editor.undo();
    expect(bench.editor.working.value).toEqual(working);
  });

  it('of a timer of another layout is not shown', async () => {
    const bench = await connectedBench();
    const working = bench.editor.working.value as TimerProgram;
    const program = { ...working, identity: { ...working.identity, servos: 1 }, positions: [[]] };
    bench.session.onScreen.showBackup({ key: 'k', savedAt: 0, reason: 'write', simulated: false, program });
    expect(bench.editor.working.value).toEqual(working);
  });
});

describe('another memory', () => {
  it('is selected and read, and edits of the old one are kept', async () => {
    const bench = await connectedBench();
    bench.editor.type(S1, '7');
    bench.editor.type(DT, 'x');
    await run(bench.session.reader.selectMemory(1));
    expect(bench.timer.core.memory).toBe(1);
    expect([bench.editor.working.value?.memory, bench.editor.textOf(DT)]).toEqual([1, '3:30']);
    expect([bench.editor.textOf(S1), bench.editor.dirty.value, notice(bench)]).toEqual(['35', false, 'kept']);

    bench.editor.type(S1, '8');
    await run(bench.session.reader.selectMemory(0));
    expect([bench.editor.textOf(S1), bench.editor.textOf(DT), notice(bench)]).toEqual(['7', 'x', 'back']);
    await run(bench.session.reader.selectMemory(1));
    expect(bench.editor.textOf(S1)).toBe('8');
  });

  it('says nothing of edits that were undone', async () => {
    const bench = await connectedBench();
    bench.editor.type(S1, '7');
    bench.editor.undo();
    await run(bench.session.reader.selectMemory(1));
    await run(bench.session.reader.selectMemory(0));
    expect([notice(bench), bench.editor.redoStep.value?.code]).toEqual([undefined, 'change']);
  });

  it('keeps the edits of the old one when the browser stores nothing', async () => {
    const store = new MemoryStore();
    store.broken = true;
    const bench = await connectedBench({ store });
    bench.editor.type(S1, '7');
    await idle();
    expect(bench.keeping.kept.value).toBe(false);
    await run(bench.session.reader.selectMemory(1));
    await run(bench.session.reader.selectMemory(0));
    expect(bench.editor.textOf(S1)).toBe('7');
  });

  it('is reported when the timer does not select it, and the screen stays with the current one', async () => {
    const bench = await connectedBench();
    bench.timer.core.onAnswer = ({ name }) => {
      if (name === 'SETMEMORY') bench.timer.core.memory = 0;
    };
    bench.editor.type(S1, '7');
    await run(bench.session.reader.selectMemory(1));
    expect([notice(bench), bench.editor.working.value?.memory, bench.editor.textOf(S1)]).toEqual([
      'other-memory',
      0,
      '7',
    ]);
  });
});

describe('read again', () => {
  it('keeps the edits and says when the timer holds something else', async () => {
    const bench = await connectedBench();
    bench.editor.type(S1, '7');
    (bench.timer.core.content.positions[2] as number[])[4] = 99;
    await run(bench.session.reader.read());
    expect([notice(bench), bench.editor.textOf(S1)]).toEqual(['moved', '7']);
    expect(bench.editor.working.value?.positions[2]?.[4]).toBe(99);
  });

  it('waits when nobody answers, and reads without a click when the switch is pressed', async () => {
    const bench = await connectedBench();
    bench.editor.type(S1, '7');
    bench.timer.core.sleep();
    expect(await run(bench.session.reader.read())).toBe(false);
    expect([status(bench), notice(bench), bench.session.runner.busy.value]).toEqual(['waiting', undefined, false]);
    await idle();
    expect([status(bench), notice(bench)]).toEqual(['waiting', undefined]);
    bench.timer.core.answered.length = 0;
    bench.timer.core.press();
    await idle();
    expect([status(bench), notice(bench), bench.editor.textOf(S1)]).toEqual(['on', undefined, '7']);
    expect(answered(bench)).toEqual(['GETSWVER', ...READ_ALL]);
  });

  it('twice in a row reads once', async () => {
    const bench = await connectedBench();
    bench.timer.core.answered.length = 0;
    await run(
      Promise.all([bench.session.reader.read(), bench.session.reader.read(), bench.session.reader.selectMemory(2)]),
    );
    expect(answered(bench)).toEqual(READ_ALL);
  });

  it('shows nothing when it is stopped, and the connection still works', async () => {
    const bench = await connectedBench();
    bench.timer.core.onAnswer = () => bench.session.runner.stop();
    await run(bench.session.reader.read());
    expect([status(bench), notice(bench), bench.session.runner.job.value]).toEqual(['on', undefined, null]);
    bench.timer.core.onAnswer = undefined;
    await run(bench.session.reader.read());
    expect(notice(bench)).toBeUndefined();
  });
});

describe('after a reload', () => {
  it('what was typed is back before the connection, and is then put on top of what the timer holds', async () => {
    const store = new MemoryStore();
    const before = await connectedBench({ store });
    before.editor.type(S1, '7');
    before.editor.type(DT, 'soon');
    await idle();

    const after = await appBench({ store });
    expect([notice(after), status(after)]).toEqual(['back', 'off']);
    expect([after.editor.textOf(S1), after.editor.textOf(DT), after.editor.blocked.value]).toEqual(['7', 'soon', true]);
    await run(after.session.timer.connect());
    expect([after.editor.textOf(S1), after.editor.textOf(DT)]).toEqual(['7', 'soon']);
  });

  it('the memory that was edited last is back', async () => {
    const store = new MemoryStore();
    const before = await connectedBench({ store });
    before.editor.type(S1, '7');
    await run(before.session.reader.selectMemory(1));
    before.editor.type(S1, '8');
    await idle();
    [...store.drafts.records.values()].forEach((draft, at) => {
      store.drafts.records.set(draft.key, { ...draft, savedAt: at });
    });
    const after = await appBench({ store });
    expect([after.editor.working.value?.memory, after.editor.textOf(S1)]).toEqual([1, '8']);
  });

  it('edits that were undone or written do not come back, but can be redone or undone', async () => {
    const store = new MemoryStore();
    const bench = await connectedBench({ store });
    bench.editor.type(S1, '7');
    await idle();
    expect(store.drafts.records.size).toBe(1);
    bench.editor.undo();
    await idle();
    const undone = await reloaded(bench);
    expect([notice(undone), undone.editor.working.value]).toEqual([undefined, null]);
    await run(undone.session.timer.connect());
    undone.editor.redo();
    expect(undone.editor.textOf(S1)).toBe('7');
    undone.editor.undo();

    bench.editor.type(S1, '8');
    bench.session.safety.confirm();
    await review(bench);
    await goOn(bench);
    await idle();
    const written = await reloaded(bench);
    expect([notice(written), written.editor.working.value]).toEqual([undefined, null]);
    await run(written.session.timer.connect());
    written.editor.undo();
    expect([written.editor.textOf(S1), written.editor.dirty.value]).toEqual(['35', true]);
  });

  it('the last typed letter is back, though the browser was still storing the one before', async () => {
    const store = new FaultyStore();
    const before = await connectedBench({ store });
    let stores = (): void => {};
    store.before = () =>
      new Promise<void>((resolve) => {
        stores = resolve;
      });
    before.editor.type(S1, '8');
    await idle(0);
    store.before = () => undefined;
    before.editor.type(S1, '9');
    before.session.keptWork.keepNow();
    // From here on the page does nothing more: the browser has all of it, and makes it in its order.
    before.session.drafts.keep = () => {};
    stores();
    await idle(0);
    const after = await appBench({ store: store.next() });
    expect(after.editor.textOf(S1)).toBe('9');
  });

  it('a dragged handle is kept now and then, on release, and when the page is left', async () => {
    const bench = await connectedBench();
    const move = (value: number): void => {
      bench.editor.apply(setValues({ code: 'change', params: {} }, [{ field: S1, value }], groupOf('move', 'S1')));
    };
    const kept = (): unknown => [...bench.store.drafts.records.values()][0]?.working.positions[0]?.[2];
    const saved = vi.spyOn(bench.store.drafts, 'save');
    for (let value = 40; value < 60; value++) {
      move(value);
      await idle(10);
    }
    expect([saved.mock.calls.length, kept()], 'not every step of the drag is kept').toEqual([0, undefined]);
    await idle(500);
    expect([saved.mock.calls.length, kept()], 'the value is kept during a long drag').toEqual([1, 59]);
    move(60);
    bench.editor.settle();
    await idle(0);
    expect(kept(), 'the value is kept on release').toBe(60);
    move(61);
    bench.session.keptWork.keepNow();
    await idle(0);
    expect(kept(), 'the value is kept when the page is left').toBe(61);
  });

  it('edits of the simulated timer are not put onto a real one', async () => {
    const store = new MemoryStore();
    const before = await appBench({ store });
    await run(before.session.timer.trySimulated('Q'));
    before.editor.type(S1, '7');
    await idle();

    const after = await appBench({ store });
    expect([after.session.simulated.value, after.editor.textOf(S1)]).toEqual([true, '7']);
    await run(after.session.timer.connect());
    expect([after.session.simulated.value, after.editor.textOf(S1), notice(after)]).toEqual([false, '35', 'kept']);
    await run(after.session.timer.disconnect());
    await run(after.session.timer.trySimulated('Q'));
    expect(after.editor.textOf(S1)).toBe('7');
  });

  it('starts without storage, and says that nothing is kept', async () => {
    const store = new MemoryStore();
    store.broken = true;
    const bench = await appBench({ store });
    expect(bench.keeping.kept.value).toBe(false);
    await run(bench.session.timer.connect());
    expect(status(bench)).toBe('on');
  });

  it('starts with a draft whose two programs do not fit together', async () => {
    const store = new MemoryStore();
    const bench = await connectedBench({ store });
    bench.editor.type(S1, '7');
    await idle();
    const [draft] = [...store.drafts.records.values()];
    if (!draft) throw new Error('nothing was kept');
    const { working } = draft;
    const fewer = { ...working, identity: { ...working.identity, functions: 9 }, times: working.times.slice(1) };
    const small = { ...fewer, positions: working.positions.map((row) => row.slice(1)) };
    store.drafts.records.set(draft.key, { ...draft, working: small });
    store.drafts.records.set('older', { ...draft, key: 'older', savedAt: 0 });
    const after = await appBench({ store });
    expect(after.editor.textOf(S1), 'an older draft that fits is used').toBe('7');
    await run(after.session.timer.connect());
    expect(status(after)).toBe('on');
  });
});
