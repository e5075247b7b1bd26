import { describe, expect, it, vi } from 'vitest';
import type { ValueReport, WriteReport } from '../../../src/client/index.js';
import type { ProgramField, TimerProgram } from '../../../src/program/index.js';
import { type AppBench, asked, connectedBench, goOn, idle, reloaded, review, run, sets } from '../bench/bench.js';

const DT: ProgramField = { kind: 'time', slot: 10 };
const STOP: ProgramField = { kind: 'time', slot: 0 };
const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };
const S3: ProgramField = { kind: 'position', servo: 2, slot: 4 };

/** The pilot has edited a time and two positions, has opened the dialog and ticked the safety. */
async function reviewed(): Promise<AppBench> {
  const bench = await connectedBench();
  bench.editor.type(DT, '4:00');
  bench.editor.type(S1, '7');
  bench.editor.type(S3, '8');
  await review(bench);
  bench.session.safety.confirm();
  return bench;
}

describe('a write', () => {
  it('sends the difference, reads back, and has no changes left', async () => {
    const bench = await reviewed();
    bench.write.goOn();
    await idle(0);
    expect([bench.write.current.value?.step, bench.write.held]).toEqual(['running', true]);
    await asked(bench);
    expect(bench.write.held, 'the result of a verified write may be left').toBe(false);
    expect(bench.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
    expect(sets(bench)).toEqual(['SETTIMERS', 'SETSERVO', 'SETSERVO']);
    expect(bench.timer.core.content.times[10]).toBe(24000);
    expect([bench.editor.dirty.value, bench.editor.textOf(S1)]).toEqual([false, '7']);
    bench.write.dismiss();
    expect(bench.write.current.value).toBeNull();
  });

  it('is compared with what the timer holds now, not with the last reading', async () => {
    const bench = await connectedBench();
    bench.editor.type(S1, '7');
    (bench.timer.core.content.positions[2] as number[])[4] = 99;
    await review(bench);
    expect(bench.editor.changes.value).toEqual([{ field: S1, from: 35, to: 7 }]);
    expect(bench.editor.textOf(S3)).toBe('99');
    expect(bench.session.notices.current.value?.code).toBe('moved');
  });

  it('ends the conflicts', async () => {
    const bench = await connectedBench();
    bench.editor.type(S1, '7');
    (bench.timer.core.content.positions[0] as number[])[2] = 99;
    await review(bench);
    expect(bench.editor.conflicts.value.size).toBe(1);
    bench.session.safety.confirm();
    await goOn(bench);
    bench.editor.type(S1, '8');
    expect([bench.editor.changes.value.length, bench.editor.conflicts.value.size]).toEqual([1, 0]);
  });

  it('does not open with no changes when another memory is current by now', async () => {
    const bench = await connectedBench();
    bench.editor.type(S1, '7');
    bench.timer.core.memory = 2;
    await review(bench);
    expect(bench.session.notices.current.value?.code).toBe('kept');
    expect(bench.write.current.value).toBeNull();
  });

  it('does not begin without the safety', async () => {
    const bench = await reviewed();
    bench.session.safety.withdraw();
    expect(bench.write.ready.value).toBe(false);
    await goOn(bench);
    expect(sets(bench)).toEqual([]);
  });

  it('asks for the safety once in each connection', async () => {
    const bench = await reviewed();
    await goOn(bench);
    bench.write.dismiss();
    await review(bench);
    expect(bench.write.ready.value).toBe(true);
    bench.write.dismiss();
    await run(bench.session.timer.disconnect());
    await run(bench.session.timer.connect());
    await review(bench);
    expect(bench.write.ready.value).toBe(false);
  });

  it('with something serious begins only after a tick, each time', async () => {
    const bench = await reviewed();
    bench.editor.type(STOP, '5:00');
    expect(bench.write.serious.value).toMatchObject([{ code: 'motor-stop-after-dt' }]);
    await goOn(bench);
    expect(sets(bench)).toEqual([]);
    bench.write.tick('warnings', true);
    bench.write.dismiss();
    await review(bench);
    expect(bench.write.ready.value).toBe(false);
    bench.write.tick('warnings', true);
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
  });

  it('cannot be opened while a text is not a value, during a reading, or without a timer', async () => {
    const bench = await connectedBench();
    bench.editor.type(S1, 'x');
    await review(bench);
    expect(bench.write.current.value).toBeNull();
    bench.editor.revertAll();
    const reading = bench.session.reader.read();
    await review(bench);
    expect(bench.write.current.value).toBeNull();
    await run(reading);
    void bench.write.open();
    bench.editor.type(S1, 'x');
    await asked(bench);
    expect(bench.write.current.value, 'a text without a value, typed during the reading, stops the write').toBeNull();
    bench.editor.revertAll();
    bench.adapter.unplug();
    await idle();
    await review(bench);
    expect(bench.write.current.value).toBeNull();
  });

  it('is done once by a double click', async () => {
    const bench = await reviewed();
    bench.write.goOn();
    await goOn(bench);
    expect(sets(bench)).toEqual(['SETTIMERS', 'SETSERVO', 'SETSERVO']);
  });

  it('is not called verified when it is stopped, and can be finished later', async () => {
    const bench = await reviewed();
    bench.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && bench.write.dismiss();
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({
      step: 'done',
      ends: [{ state: 'unknown' }],
      stopped: { code: 'aborted' },
    });
    expect(sets(bench)).toEqual(['SETTIMERS']);
    bench.write.dismiss();
    await run(bench.session.reader.read());
    expect(bench.editor.changes.value.map(({ field }) => field)).toEqual([S1, S3]);
    await review(bench);
    await goOn(bench);
    expect(sets(bench)).toEqual(['SETTIMERS', 'SETSERVO', 'SETSERVO']);
    expect(bench.write.current.value).toMatchObject({ ends: [{ state: 'verified' }] });
  });

  it('is verified when it is stopped after its end, and the result stays visible', async () => {
    const bench = await reviewed();
    let asked = 0;
    bench.timer.core.onAnswer = ({ name }) => {
      // Behind the last value: who is there, and at the very end once more.
      if (name === 'GETSWVER' && sets(bench).length === 3) asked++;
      if (asked === 2) bench.write.dismiss();
    };
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ step: 'done', stays: true, ends: [{ state: 'verified' }] });
  });

  it('that is stopped before its first byte says that nothing was written', async () => {
    const bench = await reviewed();
    bench.timer.core.onAnswer = ({ name }) => name === 'GETMEMORY' && bench.write.dismiss();
    await goOn(bench);
    expect([bench.write.current.value, bench.session.notices.current.value]).toEqual([
      null,
      { kind: 'note', code: 'nothing-written' },
    ]);
    expect([sets(bench), bench.session.recovery.offer.value, bench.editor.changes.value.length]).toEqual([[], null, 3]);
  });

  it('leaves nothing but the edits when the plug is pulled before its first value went out', async () => {
    const bench = await reviewed();
    bench.timer.core.onAnswer = ({ name }) => name === 'GETMEMORY' && bench.adapter.unplug();
    await goOn(bench);
    await idle();
    expect([bench.session.link.state.value.status, bench.session.notices.current.value]).toEqual(['away', null]);
    expect([sets(bench), bench.write.current.value], 'there is no result of a write').toEqual([[], null]);
    bench.timer.core.onAnswer = undefined;
    bench.adapter.replug();
    await idle();
    expect(bench.session.link.state.value.status, 'the connection comes back without a click').toBe('on');
    expect([bench.session.recovery.offer.value, bench.editor.changes.value.length]).toEqual([null, 3]);
  });

  it.each([
    ['GETMEMORY', [], { ends: [{ state: 'untouched' }], stopped: { code: 'stood-still' } }],
    ['SETTIMERS', ['SETTIMERS'], { step: 'done', ends: [{ state: 'unknown' }], stopped: { code: 'stood-still' } }],
  ] as const)('sends nothing more when the page stands still at %s, and can be finished', async (name, sent, end) => {
    const bench = await reviewed();
    const { core } = bench.timer;
    const now = performance.now.bind(performance);
    core.onAnswer = (request) => {
      if (request.name === name) vi.spyOn(performance, 'now').mockImplementation(() => now() + 60_000);
    };
    await goOn(bench);
    core.onAnswer = undefined;
    expect(bench.write.current.value).toMatchObject(end);
    expect([sets(bench), bench.session.link.state.value.status]).toEqual([sent, 'on']);
    expect(bench.session.standing.value.sure).toBe(sent.length > 0 ? 'not' : 'now');
    bench.write.dismiss();
    await review(bench);
    bench.session.safety.confirm();
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ ends: [{ state: 'verified' }] });
    expect([core.content.times[10], bench.editor.changes.value]).toEqual([24000, []]);
  });

  it('into another memory than the one on the screen is refused', async () => {
    const bench = await reviewed();
    bench.timer.core.memory = 2;
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({
      ends: [{ state: 'untouched' }],
      stopped: { code: 'other-memory' },
    });
    expect(sets(bench)).toEqual([]);
    expect(bench.editor.changes.value).toHaveLength(3);
  });

  it('during which another memory becomes current names that memory, of which nothing is known any more', async () => {
    const bench = await reviewed();
    const { core } = bench.timer;
    const { knowledge, editor } = bench.session;
    for (const memory of [1, 2]) knowledge.remember({ ...(editor.baseline.value as TimerProgram), memory }, 1);
    core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS') core.memory = 1;
    };
    await goOn(bench);
    expect(core.memories[1]?.positions[0]?.[2], 'the position is in the other memory').toBe(7);
    expect([0, 1, 2].map((memory) => knowledge.of(memory).state)).toEqual(['uncertain', 'unread', 'read']);
  });

  it('that the timer does not take shows what it holds, and keeps the edit', async () => {
    const bench = await connectedBench({ quirks: { servoNeedsMove: true } });
    bench.editor.type(S1, '7');
    await review(bench);
    bench.session.safety.confirm();
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({
      ends: [{ state: 'differs', report: { values: [{ field: S1, wanted: 7, held: 35, status: 'differs' }] } }],
    });
    expect([bench.editor.textOf(S1), bench.editor.confirmed.value.size]).toEqual(['7', 0]);
  });
});

describe('a write to a timer that keeps positions only where its servos stand', () => {
  const moves = ({ timer }: AppBench): number => timer.core.answered.filter(({ name }) => name === 'MOVETOFUNC').length;

  /** One write has shown what it does. */
  async function notHeld(): Promise<AppBench> {
    const bench = await connectedBench({ quirks: { servoNeedsMove: true } });
    bench.editor.type(S1, '7');
    await review(bench);
    expect(bench.session.servoMoves.needed, 'before the write nothing says that positions need a move').toBe(false);
    bench.session.safety.confirm();
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ step: 'done', notHeld: true });
    return bench;
  }

  it('moves nothing unasked, also when the timer is known to need it', async () => {
    const bench = await notHeld();
    await goOn(bench);
    expect([bench.write.current.value?.step, bench.session.servoMoves.allowed.value]).toEqual(['review', false]);
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ ends: [{ state: 'differs' }], notHeld: true });
    expect(moves(bench)).toBe(0);
  });

  it('moves them once when the pilot wants it', async () => {
    const bench = await notHeld();
    bench.write.dismiss();
    await run(bench.models.bench.moveTo(9));
    expect(bench.models.bench.done.value).not.toBeNull();
    const before = moves(bench);
    await review(bench);
    bench.session.servoMoves.allow(true);
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ ends: [{ state: 'verified' }], notHeld: false });
    expect([moves(bench) - before, bench.timer.core.content.positions[0]?.[2]]).toEqual([1, 7]);
    expect(bench.models.bench.done.value, 'the bench no longer says where the servos stand').toBeNull();
    bench.write.dismiss();
    bench.editor.type(S1, '8');
    await review(bench);
    expect(bench.session.servoMoves.allowed.value).toBe(false);
  });

  it('does not begin, and moves nothing, without the safety', async () => {
    const bench = await notHeld();
    await goOn(bench);
    bench.session.servoMoves.allow(true);
    bench.session.safety.withdraw();
    await goOn(bench);
    expect([bench.write.current.value?.step, moves(bench), bench.session.servoMoves.take()]).toEqual([
      'review',
      0,
      false,
    ]);
  });

  it('moves nothing when the pilot had agreed and the connected timer does not need it', async () => {
    const bench = await reviewed();
    bench.session.servoMoves.allow(true);
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
    expect([moves(bench), bench.session.servoMoves.allowed.value]).toEqual([0, false]);
  });

  it.each<[why: string, value: Partial<ValueReport>, moved: boolean]>([
    ['a time', { field: DT }, false],
    ['a position that nobody wanted to change', { asked: false }, false],
    ['a position that was kept', { status: 'verified' }, false],
    ['a position to which the servo was moved', {}, true],
  ])('was not wanted by %s', async (_, value, moved) => {
    const { session } = await notHeld();
    const lost: ValueReport = { field: S1, wanted: 7, held: 35, status: 'differs', asked: true };
    const reportOf = (given: ValueReport) => ({ values: [given] }) as unknown as WriteReport;
    expect(session.servoMoves.wanted(false, [reportOf(lost)])).toBe(true);
    expect(session.servoMoves.wanted(moved, [reportOf({ ...lost, ...value })])).toBe(false);
  });

  it('is known again after a reload, for this port and kind of timer', async () => {
    const after = await reloaded(await notHeld());
    await run(after.session.timer.connect());
    expect(after.session.servoMoves.needed).toBe(true);
    const other = await connectedBench({ store: after.store, identity: { timerClass: 'B' } });
    expect(other.session.servoMoves.needed).toBe(false);
    await idle();
    const again = await connectedBench({ store: other.store });
    expect(again.session.servoMoves.needed, 'it is still known after another kind of timer was on this port').toBe(
      true,
    );
  });
});

describe('what was confirmed is what is written', () => {
  /** The storage answers only when it is told to. */
  function heldUp({ store }: AppBench): () => void {
    let release = (): void => {};
    const gate = new Promise<void>((resolve) => {
      release = resolve;
    });
    const save = store.unfinished.save.bind(store.unfinished);
    store.unfinished.save = async (record) => {
      await gate;
      await save(record);
    };
    return release;
  }

  it('on the connection where it was shown: a write delayed by the storage does not go out on another one', async () => {
    const bench = await reviewed();
    const release = heldUp(bench);
    bench.write.goOn();
    await idle(10);
    bench.adapter.unplug();
    await idle(10);
    bench.adapter.replug();
    await idle(4000);
    expect(bench.session.link.state.value.status).toBe('on');
    release();
    await asked(bench);
    await idle();
    expect([sets(bench), bench.session.knowledge.uncertain.value]).toEqual([[], []]);
    expect(bench.editor.changes.value).toHaveLength(3);
  });

  it('and nothing is, when the pilot stops it or unticks the safety during the wait for the storage', async () => {
    for (const change of [(b: AppBench) => b.write.dismiss(), (b: AppBench) => b.session.safety.withdraw()]) {
      const bench = await reviewed();
      const release = heldUp(bench);
      bench.write.goOn();
      await idle(10);
      change(bench);
      release();
      await asked(bench);
      expect([bench.session.notices.current.value?.code, sets(bench)]).toEqual(['nothing-written', []]);
      expect([bench.session.knowledge.uncertain.value, bench.store.unfinished.records.size]).toEqual([[], 0]);
    }
  });

  it('and it is shown once more when the program has changed', async () => {
    const bench = await reviewed();
    bench.editor.type(S1, '9');
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ step: 'review', moved: 'edits' });
    expect(sets(bench)).toEqual([]);
    await goOn(bench);
    expect(bench.timer.core.content.positions[0]?.[2]).toBe(9);
  });

  it('of the timer whose content was shown: other content is shown, and asked again', async () => {
    const bench = await reviewed();
    (bench.timer.core.content.positions[0] as number[])[2] = 99;
    await goOn(bench);
    const { value } = bench.write.current;
    expect(value).toMatchObject({ step: 'review', moved: 'timer' });
    expect([sets(bench), bench.session.knowledge.uncertain.value, bench.store.unfinished.records.size]).toEqual([
      [],
      [],
      0,
    ]);
    expect(value?.step === 'review' && value.changes[0]?.changes).toContainEqual({ field: S1, from: 99, to: 7 });
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
  });

  it('of the kind of timer that was shown: another one is identified and read', async () => {
    const bench = await reviewed();
    Object.assign(bench.timer.core.identity, { timerClass: 'B' });
    await goOn(bench);
    await idle();
    expect(bench.write.current.value).toMatchObject({
      ends: [{ state: 'untouched' }],
      stopped: { code: 'other-timer' },
    });
    expect([sets(bench), bench.session.connection.value?.identity.timerClass]).toEqual([[], 'B']);
    expect(bench.editor.identity.value?.timerClass).toBe('B');
    expect(bench.session.notices.current.value?.code).toBe('other-kind');
  });

  it('leaves the dialog when the connection is another by then', async () => {
    const bench = await reviewed();
    bench.adapter.unplug();
    bench.adapter.replug();
    await idle();
    expect([bench.session.link.state.value.status, bench.write.current.value]).toEqual(['on', null]);
  });
});

describe('where this device keeps no copy of what the timer holds', () => {
  async function unkept(): Promise<AppBench> {
    const bench = await reviewed();
    bench.store.broken = true;
    bench.write.goOn();
    await idle();
    expect([bench.session.runner.job.value?.asking, sets(bench)]).toEqual([true, []]);
    return bench;
  }

  it('the page says so, and writes without one only when the pilot agrees', async () => {
    const bench = await unkept();
    bench.session.runner.answer(true);
    await asked(bench);
    expect(bench.write.current.value).toMatchObject({ ends: [{ state: 'verified' }] });
  });

  it.each<[string, (bench: AppBench) => void]>([
    ['refuses', ({ session }) => session.runner.answer(false)],
    ['presses Escape', ({ write }) => write.dismiss()],
    ['pulls the plug', ({ adapter }) => adapter.unplug()],
  ])('nothing is written when the pilot %s, and nothing is uncertain', async (_, act) => {
    const bench = await unkept();
    act(bench);
    await asked(bench);
    await idle();
    expect([sets(bench), bench.session.knowledge.uncertain.value, bench.write.current.value]).toEqual([[], [], null]);
    expect(bench.editor.changes.value).toHaveLength(3);
  });

  it('the page waits 5 s for a storage that hangs', async () => {
    const bench = await reviewed();
    bench.store.backups.save = () => new Promise(() => {});
    bench.write.goOn();
    await idle(4990);
    expect(bench.write.current.value?.step).toBe('running');
    await idle(20);
    expect([bench.session.runner.job.value?.asking, sets(bench)]).toEqual([true, []]);
    bench.session.runner.answer(false);
    await asked(bench);
  });
});

describe('what a write leaves unknown', () => {
  it('is anything after an unexpected error', async () => {
    const bench = await reviewed();
    const { client } = bench.session.connection.value ?? {};
    if (client) vi.spyOn(client, 'writeProgram').mockRejectedValue(new RangeError('not foreseen'));
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ stays: true, stopped: { code: 'unexpected' } });
    expect([bench.session.knowledge.of(0).state, bench.editor.textOf(S1)]).toEqual(['uncertain', '7']);
  });

  it('is nothing after a verified write', async () => {
    const bench = await reviewed();
    await goOn(bench);
    expect(bench.session.knowledge.of(0)).toMatchObject({ state: 'read', verified: true });
    await run(bench.session.reader.read());
    expect(bench.session.knowledge.of(0), 'a plain reading after the write is not called verified').toMatchObject({
      verified: false,
    });
  });
});
