import { describe, expect, it } from 'vitest';
import { finishWrite, takeGoal } from '../../../src/app/memories/finish-write.js';
import type { ProgramField, TimerProgram } from '../../../src/program/index.js';
import {
  type AppBench,
  appBench,
  asked,
  connectedBench,
  goOn,
  idle,
  reloaded,
  review,
  run,
  sets,
} from '../bench/bench.js';

const DT: ProgramField = { kind: 'time', slot: 10 };
const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };
const S3: ProgramField = { kind: 'position', servo: 2, slot: 4 };

type Name = 'GETSWVER' | 'SETTIMERS' | 'SETSERVO';

function notice({ session }: AppBench): string | undefined {
  return session.notices.current.value?.code;
}

function offer({ session }: AppBench) {
  return session.recovery.offer.value;
}

/** What the three values are that the pilot has edited. */
function held({ timer }: AppBench) {
  const { times, positions } = timer.core.content;
  return [times[10], positions[0]?.[2], positions[2]?.[4]];
}

const BEFORE = [18000, 35, 55];
const GOAL = [24000, 7, 8];

/** The pilot has edited a time and two positions, and the timer falls asleep after the answer to such a request. */
async function writing(last: Name): Promise<AppBench> {
  const bench = await connectedBench();
  expect(held(bench)).toEqual(BEFORE);
  bench.editor.type(DT, '4:00');
  bench.editor.type(S1, '7');
  bench.editor.type(S3, '8');
  await review(bench);
  bench.session.safety.confirm();
  let questions = 0;
  bench.timer.core.onAnswer = ({ name }) => {
    if (name === 'GETSWVER') questions++;
    // Who is there is asked before and after the reading that comes before the first value.
    if (name === last && (name !== 'GETSWVER' || questions === 2)) bench.timer.core.sleep();
  };
  bench.write.goOn();
  return bench;
}

/** The timer has fallen asleep in a write, and its switch was pressed. */
async function interrupted(last: Name, meanwhile?: (bench: AppBench) => void): Promise<AppBench> {
  const bench = await writing(last);
  await asked(bench);
  expect(bench.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'unknown' }] });
  bench.write.dismiss();
  bench.timer.core.onAnswer = undefined;
  meanwhile?.(bench);
  bench.timer.core.press();
  await idle();
  expect(bench.session.link.state.value.status).toBe('on');
  return bench;
}

async function finishDialog(bench: AppBench): Promise<void> {
  expect(bench.write.current.value?.step).toBe('review');
  bench.session.safety.confirm();
  await goOn(bench);
  expect(bench.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
  await idle();
}

describe('a write of which a part arrived', () => {
  it('is offered with what is written and what is missing, and nothing is written without a click', async () => {
    const bench = await interrupted('SETTIMERS');
    expect(offer(bench)).toMatchObject({
      kind: 'write',
      part: {
        extent: 'part',
        written: [{ field: DT, from: 18000, to: 24000 }],
        missing: [
          { field: S1, from: 35, to: 7 },
          { field: S3, from: 55, to: 8 },
        ],
        foreign: [],
      },
    });
    await idle();
    expect(sets(bench)).toEqual(['SETTIMERS']);
    expect(notice(bench), 'there is no notice beside the offer').toBeUndefined();
  });

  it('can be finished by a write of what is missing', async () => {
    const bench = await interrupted('SETTIMERS');
    void finishWrite(bench.session, bench.write, 'goal');
    await asked(bench);
    expect(bench.editor.changes.value.map(({ field }) => field)).toEqual([S1, S3]);
    await finishDialog(bench);
    expect(held(bench)).toEqual(GOAL);
    expect(sets(bench)).toEqual(['SETTIMERS', 'SETSERVO', 'SETSERVO']);
    expect([offer(bench), bench.store.unfinished.records.size]).toEqual([null, 0]);
    await run(bench.session.reader.read());
    expect([offer(bench), bench.editor.dirty.value]).toEqual([null, false]);
  });

  it('can be put back to what was there before', async () => {
    const bench = await interrupted('SETTIMERS');
    void finishWrite(bench.session, bench.write, 'before');
    await asked(bench);
    expect(bench.editor.changes.value).toEqual([{ field: DT, from: 24000, to: 18000 }]);
    await finishDialog(bench);
    expect(held(bench)).toEqual(BEFORE);
    expect([offer(bench), bench.store.unfinished.records.size]).toEqual([null, 0]);
  });

  it('can be left as it is for good, and the backup stays', async () => {
    const bench = await interrupted('SETTIMERS');
    await bench.session.recovery.settle();
    await run(bench.session.reader.read());
    expect(offer(bench)).toBeNull();
    expect([bench.store.unfinished.records.size, bench.store.backups.records.size]).toEqual([0, 1]);
    expect(bench.session.backups.list.value[0]).toMatchObject({ reason: 'write', program: { memory: 0 } });
    expect(bench.session.backups.list.value[0]?.program.times[10]).toBe(18000);
  });

  it.each<[how: string, meet: (bench: AppBench) => Promise<void>]>([
    [
      'by Connect',
      async ({ session }) => {
        await run(session.timer.disconnect());
        await run(session.timer.connect());
      },
    ],
    [
      'by its plug',
      async ({ adapter }) => {
        adapter.unplug();
        await idle();
        adapter.replug();
        await idle();
      },
    ],
  ])('is not shown again once the pilot has said “another timer”, until the next one comes %s', async (_, meet) => {
    const bench = await interrupted('SETTIMERS');
    bench.session.recovery.setAside();
    await run(bench.session.reader.read());
    expect([offer(bench), bench.store.unfinished.records.size]).toEqual([null, 1]);
    await meet(bench);
    expect(offer(bench)).toMatchObject({ kind: 'write', part: { extent: 'part' } });
  });

  it('is not offered while nothing is connected', async () => {
    const bench = await interrupted('SETTIMERS');
    await run(bench.session.timer.disconnect());
    expect(offer(bench)).toBeNull();
  });
});

describe('another way in which a write can end', () => {
  it('of which nothing arrived is offered, and can be finished', async () => {
    const bench = await interrupted('GETSWVER');
    expect(sets(bench)).toEqual([]);
    expect(offer(bench)).toMatchObject({ kind: 'write', part: { extent: 'nothing', written: [], foreign: [] } });
    void finishWrite(bench.session, bench.write, 'goal');
    await asked(bench);
    await finishDialog(bench);
    expect(held(bench)).toEqual(GOAL);
    expect([offer(bench), bench.store.unfinished.records.size]).toEqual([null, 0]);
  });

  it('is only reported when the write turns out to be complete', async () => {
    const bench = await connectedBench();
    bench.editor.type(DT, '4:00');
    await review(bench);
    bench.session.safety.confirm();
    bench.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && bench.adapter.unplug();
    await goOn(bench);
    bench.timer.core.onAnswer = undefined;
    expect(bench.store.unfinished.records.size).toBe(1);
    bench.adapter.replug();
    await idle();
    expect([notice(bench), offer(bench)]).toEqual(['write-completed', null]);
    expect([bench.store.unfinished.records.size, bench.store.backups.records.size]).toEqual([0, 1]);
    expect(bench.editor.dirty.value).toBe(false);
  });

  const strange = ({ timer }: AppBench): void => {
    (timer.core.content.positions[1] as number[])[5] = 77;
  };

  it('asks the pilot when a value is not explained: it is another timer', async () => {
    const bench = await interrupted('SETTIMERS', strange);
    expect(offer(bench)).toMatchObject({
      kind: 'write',
      part: { extent: 'foreign', foreign: [{ field: { kind: 'position', servo: 1, slot: 5 }, to: 77 }] },
    });
    bench.session.recovery.setAside();
    expect([offer(bench), bench.store.unfinished.records.size]).toEqual([null, 1]);
    expect(sets(bench)).toEqual(['SETTIMERS']);
  });

  it('asks the pilot at once when the timer holds values that were not written', async () => {
    const bench = await writing('SETTIMERS');
    bench.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && bench.timer.core.content.positions[1]?.fill(77);
    await asked(bench);
    expect(bench.write.current.value).toMatchObject({ step: 'done', stopped: { code: 'changed' } });
    expect(offer(bench)).toMatchObject({ kind: 'write', part: { extent: 'foreign' } });
    expect(bench.store.unfinished.records.size).toBe(1);
  });

  it('is the only message, also when the value is one that was to be written', async () => {
    const bench = await interrupted('SETTIMERS', ({ timer }) => {
      (timer.core.content.positions[0] as number[])[2] = 9;
    });
    expect(offer(bench)).toMatchObject({ kind: 'write', part: { extent: 'foreign' } });
    expect(notice(bench)).toBeUndefined();
  });

  it('at another kind of timer is not offered', async () => {
    const bench = await interrupted('SETTIMERS');
    await run(bench.session.timer.trySimulated('Q'));
    expect(offer(bench)).toBeNull();
    expect(bench.store.unfinished.records.size).toBe(1);
  });

  it('shows the goal as edits when the pilot says that it is the same timer, and writes nothing', async () => {
    const bench = await interrupted('SETTIMERS', strange);
    await run(takeGoal(bench.session));
    expect([offer(bench), bench.store.unfinished.records.size, bench.write.current.value]).toEqual([null, 0, null]);
    expect(bench.editor.changes.value.map(({ field, to }) => [field, to])).toEqual([
      [S1, 7],
      [{ kind: 'position', servo: 1, slot: 5 }, 65],
      [S3, 8],
    ]);
    expect(sets(bench)).toEqual(['SETTIMERS']);
  });

  it('in another memory is offered with its name, and shown when that memory is current', async () => {
    const bench = await interrupted('SETTIMERS', ({ timer }) => {
      timer.core.memory = 2;
    });
    expect(offer(bench)).toMatchObject({ kind: 'elsewhere', memory: 0 });
    expect(sets(bench), 'no memory is selected unasked').toEqual(['SETTIMERS']);
    await run(bench.session.reader.selectMemory(0));
    expect(offer(bench)).toMatchObject({ kind: 'write', part: { extent: 'part' } });
    expect(notice(bench), 'there is no notice of edits: they are those of the interrupted write').toBeUndefined();
  });
});

it.each(['goal', 'before'] as const)(
  'after a reload in the middle of a write it is offered once the timer is read: %s',
  async (end) => {
    const before = await writing('SETTIMERS');
    await idle(100);
    expect(before.write.current.value?.step).toBe('running');
    const after = await reloaded(before);
    expect(offer(after)).toBeNull();
    await run(after.session.timer.connect());
    expect(offer(after)).toMatchObject({ kind: 'write', part: { extent: 'part' } });
    expect(notice(after)).toBeUndefined();
    void finishWrite(after.session, after.write, end);
    await asked(after);
    await finishDialog(after);
    expect(held(after)).toEqual(end === 'goal' ? GOAL : BEFORE);
    expect(after.store.unfinished.records.size).toBe(0);
    expect(after.session.backups.list.value.map(({ program }) => program.times[10])).toEqual([24000, 18000]);
  },
);

it('before the first byte of a write its goal and a backup are stored, however long that takes', async () => {
  const bench = await connectedBench();
  for (const shelf of [bench.store.unfinished, bench.store.backups]) {
    const save = shelf.save.bind(shelf) as (record: { key: string }) => Promise<void>;
    shelf.save = async (record: { key: string }) => {
      await new Promise((resolve) => setTimeout(resolve, 700));
      await save(record);
    };
  }
  bench.editor.type(DT, '4:00');
  await review(bench);
  bench.session.safety.confirm();
  const kept: unknown[] = [];
  bench.timer.core.onAnswer = ({ name }) => {
    if (!name.startsWith('SET')) return;
    const [unfinished] = [...bench.store.unfinished.records.values()];
    const [backup] = [...bench.store.backups.records.values()];
    kept.push(unfinished, backup);
  };
  bench.write.goOn();
  await idle(1000);
  await asked(bench);
  expect(kept).toMatchObject([
    { kind: 'write', before: { memory: 0 }, goal: { memory: 0 } },
    { reason: 'write', simulated: false, program: { memory: 0 } },
  ]);
  const [unfinished, backup] = kept as [{ before: unknown; goal: { times: number[] } }, { program: unknown }];
  expect(unfinished.goal.times[10]).toBe(24000);
  expect(backup.program).toEqual(unfinished.before);
});

it('a write into a simulated timer stays unfinished after Disconnect, because that timer keeps what it holds', async () => {
  const bench = await appBench();
  const { session, editor } = bench;
  await run(session.timer.trySimulated('Q'));
  editor.type(DT, '4:00');
  const { baseline, working } = editor;
  await session.recovery.begin(baseline.value as TimerProgram, working.value as TimerProgram, true);
  session.knowledge.jobOver();
  await run(session.timer.disconnect());
  expect(session.knowledge.writes.value).toHaveLength(1);
  await run(session.timer.trySimulated('B'));
  expect(session.knowledge.writes.value).toHaveLength(1);
});
