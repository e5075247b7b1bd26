import { signal } from '@preact/signals';
import { describe, expect, it, vi } from 'vitest';
import type { Storage } from '../../../src/app/storage/index.js';
import { Knowledge, type TimerAtHand } from '../../../src/app/timer/knowledge.js';
import { openValues, possibleValues } from '../../../src/app/timer/known.js';
import { UnfinishedRecords } from '../../../src/app/timer/unfinished.js';
import { type ProgramField, type TimerProgram, withValue } from '../../../src/program/index.js';
import { MemoryStore } from '../bench/bench.js';
import { programOf } from '../programs.js';

const DT: ProgramField = { kind: 'time', slot: 3 };
const STOP: ProgramField = { kind: 'time', slot: 0 };
const S1: ProgramField = { kind: 'position', servo: 0, slot: 1 };

/** DT 3:00, motor stop 10 s. */
const BEFORE = programOf('Q', [1000, 30, 1200, 18_000]);
const GOAL = withValue(withValue(BEFORE, DT, 36_000), S1, 77);
const PART = withValue(BEFORE, DT, 36_000);
const STRANGE = withValue(BEFORE, STOP, 4321);
const Q: TimerAtHand = { identity: BEFORE.identity, simulated: false };

/** A page that has looked into the storage. The same store again stands for a reload. */
async function page(store = new MemoryStore(), { unfinished }: Pick<Storage, 'unfinished'> = store) {
  const timer = signal<TimerAtHand | null>(Q);
  const records = new UnfinishedRecords(unfinished);
  const knowledge = new Knowledge(records, timer);
  await records.load();
  return { knowledge, records, timer, store };
}

/** A write that begins and is cut off. */
async function cut({ knowledge }: { knowledge: Knowledge }, before: TimerProgram, goal: TimerProgram): Promise<void> {
  await knowledge.begin(before, goal);
  knowledge.jobOver();
}

/** A write of DT and S1 that was cut off, and nothing read since. */
async function cutOff() {
  const one = await page();
  one.knowledge.read(BEFORE, 5000);
  await cut(one, BEFORE, GOAL);
  return one;
}

function values({ knowledge }: { knowledge: Knowledge }, field: ProgramField): readonly number[] {
  return possibleValues(knowledge.of(0), field);
}

describe('what is known of a memory', () => {
  it('is nothing before it was read', async () => {
    const one = await page();
    expect(one.knowledge.of(0)).toEqual({ state: 'unread' });
    expect(values(one, DT)).toEqual([]);
  });

  it('is what a reading gave, and when', async () => {
    const one = await page();
    one.knowledge.read(BEFORE, 5000);
    expect(one.knowledge.of(0)).toEqual({ state: 'read', program: BEFORE, at: 5000, verified: false });
    expect([one.knowledge.of(1).state, values(one, DT)]).toEqual(['unread', [18_000]]);
    one.knowledge.read(GOAL, 6000, true);
    expect(one.knowledge.of(0)).toMatchObject({ at: 6000, verified: true });
  });

  it('is nothing again when a timer was connected, because it may be any timer', async () => {
    const { knowledge } = await page();
    knowledge.read(BEFORE);
    knowledge.anotherTimer();
    expect(knowledge.of(0)).toEqual({ state: 'unread' });
  });

  it('belongs only to the kind of the connected timer', async () => {
    const { knowledge, timer } = await cutOff();
    expect(knowledge.of(0).state).toBe('uncertain');
    timer.value = { ...Q, simulated: true };
    expect(knowledge.of(0).state).toBe('unread');
    timer.value = { identity: { ...BEFORE.identity, timerClass: 'B' }, simulated: false };
    expect(knowledge.of(0).state).toBe('unread');
    timer.value = null;
    expect(knowledge.of(0).state).toBe('unread');
    expect(knowledge.uncertain.value, 'an uncertain write stays known without a timer').toHaveLength(1);
  });
});

describe('a write', () => {
  it('leaves nothing uncertain while it runs, or when its end was seen', async () => {
    const { knowledge, store } = await page();
    knowledge.read(BEFORE, 5000);
    expect(await knowledge.begin(BEFORE, GOAL)).toBe(true);
    expect([...store.unfinished.records.values()]).toMatchObject([{ before: BEFORE, goal: GOAL, readAt: 5000 }]);
    expect([knowledge.uncertain.value, knowledge.of(0).state]).toEqual([[], 'read']);
    await knowledge.ended(BEFORE);
    knowledge.jobOver();
    expect([knowledge.uncertain.value, store.unfinished.records.size]).toEqual([[], 0]);
  });

  it('leaves two possible values for each changed field when it is cut off, and one for all others', async () => {
    const one = await cutOff();
    expect(one.knowledge.of(0)).toMatchObject({ state: 'uncertain', before: BEFORE, goal: GOAL, readAt: 5000 });
    expect([values(one, DT), values(one, S1), values(one, STOP)]).toEqual([[18_000, 36_000], [11, 77], [1000]]);
    expect(one.knowledge.uncertain.value).toMatchObject([{ key: expect.stringMatching(/^timer\//), before: BEFORE }]);
  });

  it.each([
    ['crash or a reload in the middle of it', false],
    ['crash or a reload after it was cut off', true],
  ])('survives a %s', async (_, isCut) => {
    const store = new MemoryStore();
    const { knowledge } = await page(store);
    await knowledge.begin(BEFORE, GOAL);
    if (isCut) knowledge.jobOver();
    const after = await page(store);
    expect([values(after, DT), after.knowledge.uncertain.value.length]).toEqual([[18_000, 36_000], 1]);
  });

  it.each(['the connection is lost', 'the pilot disconnects', 'a timer is connected'])(
    'that was cut off stays uncertain when %s',
    async (how) => {
      const one = await cutOff();
      one.knowledge.connectionOver();
      if (how !== 'the connection is lost') one.timer.value = null;
      if (how === 'a timer is connected') one.knowledge.anotherTimer();
      one.timer.value = Q;
      expect(values(one, DT)).toEqual([18_000, 36_000]);
    },
  );

  it('may begin when the browser keeps nothing: then this page remembers it', async () => {
    const store = new MemoryStore();
    store.broken = true;
    const { knowledge, records } = await page(store);
    expect(await knowledge.begin(BEFORE, GOAL)).toBe(false);
    knowledge.jobOver();
    await records.loadAgain();
    expect(knowledge.of(0).state).toBe('uncertain');
    knowledge.read(PART);
    await records.loadAgain();
    expect(knowledge.of(0).state).toBe('read');
  });

  it('whose end was seen while the browser could not delete its record is forgotten once it can', async () => {
    const { knowledge, records, store } = await page();
    await knowledge.begin(BEFORE, GOAL);
    store.broken = true;
    await knowledge.ended(BEFORE);
    store.broken = false;
    expect([records.list.value.length, store.unfinished.records.size]).toEqual([0, 1]);
    await records.keepAgain();
    expect(store.unfinished.records.size).toBe(0);
    await knowledge.begin(BEFORE, GOAL);
    await records.keepAgain();
    expect(store.unfinished.records.size, 'only what is still deleted').toBe(1);
  });
});

describe('a fresh reading', () => {
  it.each([
    ['nothing of it arrived', BEFORE, null, 1],
    ['a part of it arrived', PART, null, 1],
    ['all of it arrived', GOAL, 'completed', 0],
  ])('ends the uncertainty when %s', async (_, read, said, offered) => {
    const one = await cutOff();
    expect(one.knowledge.read(read, 9000)).toBe(said);
    expect(one.knowledge.of(0)).toEqual({ state: 'read', program: read, at: 9000, verified: false });
    expect([one.knowledge.uncertain.value.length, one.knowledge.writes.value.length]).toEqual([0, offered]);
    const after = await page(one.store);
    expect([after.knowledge.uncertain.value.length, after.knowledge.writes.value.length]).toEqual([0, offered]);
  });

  it('ends nothing when it holds what the write does not explain', async () => {
    const one = await cutOff();
    one.knowledge.read(STRANGE);
    expect(values(one, DT)).toEqual([18_000, 36_000]);
    expect((await page(one.store)).knowledge.uncertain.value).toHaveLength(1);
  });

  it('of another memory ends nothing', async () => {
    const one = await cutOff();
    one.knowledge.read({ ...BEFORE, memory: 1 });
    expect([one.knowledge.of(0).state, one.knowledge.of(1).state]).toEqual(['uncertain', 'read']);
  });

  it('leaves the first timer uncertain when the pilot has said that this is another one', async () => {
    const one = await cutOff();
    one.knowledge.read(PART);
    const [{ key } = { key: '' }] = one.knowledge.writes.value;
    one.knowledge.notThisTimer(key);
    expect([one.knowledge.of(0).state, one.knowledge.uncertain.value.length]).toEqual(['read', 1]);
    one.knowledge.read(GOAL);
    expect(
      one.knowledge.uncertain.value,
      'a reading of another timer does not explain the write to the first',
    ).toHaveLength(1);
    one.knowledge.anotherTimer();
    expect(one.knowledge.of(0).state).toBe('uncertain');
    expect((await page(one.store)).knowledge.uncertain.value).toHaveLength(1);
  });

  it('of one of two equal timers leaves the other uncertain when it does not explain the write', async () => {
    const one = await cutOff();
    one.knowledge.notThisTimer(one.knowledge.uncertain.value[0]?.key ?? '');
    const other = withValue(STRANGE, DT, 12_000);
    await cut(one, STRANGE, other);
    expect(one.knowledge.uncertain.value, 'both writes stay uncertain').toHaveLength(2);
    one.knowledge.anotherTimer();
    one.knowledge.read(other);
    expect(one.knowledge.uncertain.value).toMatchObject([{ before: BEFORE }]);
  });

  it('is not needed when an explained write is followed by another', async () => {
    const one = await cutOff();
    one.knowledge.read(PART);
    const next = withValue(PART, DT, 24_000);
    await cut(one, PART, next);
    expect(values(one, DT)).toEqual([36_000, 24_000]);
    expect([one.knowledge.writes.value.length, one.store.unfinished.records.size]).toEqual([1, 1]);
  });
});

describe('single values, sent one after the other', () => {
  const step = (value: number): TimerProgram => withValue(BEFORE, S1, value);

  it('are not uncertain while each is acknowledged, but are when the connection is lost before a reading', async () => {
    const one = await page();
    one.knowledge.read(BEFORE);
    await one.knowledge.begin(BEFORE, step(40));
    one.knowledge.acknowledged(0);
    one.knowledge.jobOver();
    expect(one.knowledge.of(0).state).toBe('read');
    await one.knowledge.begin(step(40), step(45));
    one.knowledge.acknowledged(0);
    one.knowledge.jobOver();
    expect(one.store.unfinished.records.size).toBe(1);
    one.knowledge.connectionOver();
    expect(values(one, S1)).toEqual([40, 45]);
  });

  it('are uncertain when one has no answer', async () => {
    const one = await page();
    await one.knowledge.begin(BEFORE, step(40));
    one.knowledge.acknowledged(0);
    await one.knowledge.begin(step(40), step(45));
    one.knowledge.jobOver();
    expect(values(one, S1)).toEqual([40, 45]);
  });

  it('are known after a reading at the end', async () => {
    const one = await page();
    await one.knowledge.begin(BEFORE, step(40));
    one.knowledge.acknowledged(0);
    one.knowledge.jobOver();
    expect(one.knowledge.read(step(40)), 'nothing was interrupted, so the reading explains nothing').toBeNull();
    one.knowledge.connectionOver();
    expect([one.knowledge.uncertain.value, one.store.unfinished.records.size]).toEqual([[], 0]);
  });

  it('may be uncertain without a reading before', async () => {
    const one = await page();
    await cut(one, BEFORE, { ...BEFORE, idleThrottle: 7 });
    expect(values(one, { kind: 'idleThrottle' })).toEqual([7]);
    expect(one.knowledge.of(0).state).toBe('uncertain');
  });
});

describe("the pilot's word", () => {
  it('to forget it ends the uncertainty for good, and then nothing is known', async () => {
    const one = await cutOff();
    await one.knowledge.forget(one.knowledge.uncertain.value[0]?.key ?? '');
    expect(one.knowledge.of(0)).toEqual({ state: 'unread' });
    expect((await page(one.store)).knowledge.uncertain.value).toEqual([]);
  });
});

describe('a slow reading of the storage', () => {
  /** What the storage held before is on its way, and comes when the function is called. */
  async function slow(keep: (one: Awaited<ReturnType<typeof page>>) => Promise<unknown>) {
    const one = await page();
    await keep(one);
    const { unfinished } = one.store;
    const all = await unfinished.all();
    let come = (): void => {};
    const coming = new Promise<void>((resolve) => {
      come = resolve;
    });
    vi.spyOn(unfinished, 'all').mockImplementationOnce(() => coming.then(() => all));
    const looking = one.records.loadAgain();
    return {
      ...one,
      arrive: async () => {
        come();
        await looking;
      },
    };
  }

  it('does not lose what was cut off meanwhile', async () => {
    const { knowledge, arrive } = await slow(async () => {});
    await cut({ knowledge }, BEFORE, GOAL);
    await arrive();
    expect(knowledge.uncertain.value).toHaveLength(1);
  });

  it('does not bring back what a reading has settled meanwhile', async () => {
    const { knowledge, arrive } = await slow((one) => cut(one, BEFORE, GOAL));
    expect(knowledge.read(GOAL)).toBe('completed');
    await arrive();
    expect([knowledge.uncertain.value, knowledge.writes.value]).toEqual([[], []]);
  });
});

describe('the uncertain values', () => {
  it('begin with DT and the motor stop', () => {
    const goal = withValue(withValue(withValue(GOAL, STOP, 900), { kind: 'time', slot: 1 }, 40), DT, 1);
    expect(openValues({ before: BEFORE, goal }).map(({ field }) => field)).toEqual([
      DT,
      STOP,
      { kind: 'time', slot: 1 },
      S1,
    ]);
  });

  it('do not include a value that the write did not change', () => {
    expect(openValues({ before: { ...BEFORE, idleThrottle: 5 }, goal: { ...BEFORE, idleThrottle: null } })).toEqual([]);
  });
});
