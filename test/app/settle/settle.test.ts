import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import type { Answers } from '../../../src/app/storage/records.js';
import type { TimerQuirks } from '../../../src/simulator/index.js';
import { runsOf } from '../../tools/share.js';
import { type AppBench, appBench, type BenchOptions, connectedBench, idle, run } from '../bench/bench.js';
import { judged, type Person, rises, truth, walk, walkOn } from './walk.js';

async function settled(options: BenchOptions = {}, person: Person = {}): Promise<{ app: AppBench; answers: Answers }> {
  const app = await connectedBench(options);
  const { answers } = await walk(app, walkOn(app), person);
  return { app, answers: answers.value };
}

const KINDS: readonly [name: string, quirks: TimerQuirks, open: readonly (keyof Answers)[]][] = [
  ['as the docs have it', {}, []],
  ['of the other byte order', { bigEndianTimes: true }, []],
  ['that takes the servo first', { servoFirst: true }, []],
  ['that keeps positions only where its servos stand', { servoNeedsMove: true }, ['moves']],
  ['that keeps no position', { servoIgnored: true }, ['layout']],
  ['whose servos follow each position', { setMoves: 'always' }, []],
  ['whose servos follow no position', { setMoves: 'never' }, []],
  ['that gives no index', { memoryReplyEmpty: true }, []],
  ['that answers with other letters and four zeros', { unlockReplyAs6A: true, timersReplyAs66: true, zeros: 4 }, []],
  ['behind an adapter with an echo', { echo: true }, []],
  [
    'that takes the servo first, and keeps it only where they stand',
    { servoFirst: true, servoNeedsMove: true },
    ['layout', 'stores', 'moves'],
  ],
];

describe('a timer', () => {
  it.each(KINDS)('%s: what is settled is so, and all is as before', async (_, quirks, open) => {
    const app = await connectedBench({ quirks });
    const before = structuredClone(app.timer.core.memories);
    const { answers } = await walk(app, walkOn(app));
    const isOpen = (name: string): boolean => open.some((each) => each === name);
    const expected = Object.entries(truth({ timerClass: 'Q' }, quirks)).filter(([name]) => !isOpen(name));
    expect(judged(answers.value)).toEqual(Object.fromEntries(expected));
    expect([app.timer.core.memories, app.session.unfinished.value]).toEqual([before, []]);
    expect(app.session.settled.of(app.timer.core.identity, false)).toEqual(answers.value);
  });

  it('that does not understand four zeros is not called silent: it answers five', async () => {
    let zeros = 0;
    let isShort = false;
    const toDevice = (byte: number): number[] => {
      if (byte !== 0 && zeros >= 4) isShort = zeros === 4;
      zeros = byte === 0 ? zeros + 1 : 0;
      return isShort && byte !== 0 ? [] : [byte];
    };
    const { answers } = await settled({ plug: { fault: { toDevice } } });
    expect(answers.zeros).toBe('unanswered');
  });

  it('whose line is damaged meanwhile says nothing about zeros', async () => {
    let isSpoilt = false;
    const toPage = (byte: number): number[] => (isSpoilt && byte === 0x6c ? [byte, 0x33] : [byte]);
    const app = await connectedBench({ plug: { fault: { toPage } } });
    const settle = await walk(app, walkOn(app), {}, 'zeros');
    isSpoilt = true;
    await run(settle.act());
    isSpoilt = false;
    expect(settle.answers.value.zeros).toBeUndefined();
  });

  it('of class B or E: its reserved time is noted as it came', async () => {
    const { answers } = await settled({ identity: { timerClass: 'E' }, quirks: { bigEndianTimes: true } });
    expect([answers.reserved, answers.unlock, answers.order]).toEqual([0, undefined, 'high-first']);
  });

  it('says how long it takes to answer', async () => {
    const { answers } = await settled({ latency: 70 });
    expect(answers.delay).toBeGreaterThanOrEqual(70);
    expect(answers.delay).toBeLessThan(100);
  });
});

describe('whatever a timer does and a person knows', () => {
  const quirks = fc.record(
    {
      bigEndianTimes: fc.boolean(),
      servoFirst: fc.boolean(),
      memoriesFromOne: fc.boolean(),
      memoryReplyEmpty: fc.boolean(),
      servoNeedsMove: fc.boolean(),
      servoIgnored: fc.boolean(),
      setMoves: fc.constantFrom('never' as const, 'there' as const, 'always' as const),
      unlockReplyAs6A: fc.boolean(),
      timersReplyAs66: fc.boolean(),
      bareChecksumReply: fc.boolean(),
      idleThrottleLength3: fc.boolean(),
      idleThrottleOnQOnly: fc.boolean(),
      echo: fc.boolean(),
      zeros: fc.constantFrom(4 as const, 5 as const),
    },
    { requiredKeys: [] },
  );
  const timer = fc.record({
    timerClass: fc.constantFrom('Q' as const, 'B' as const, 'E' as const),
    functions: fc.constantFrom(1, 2, 10),
    servos: fc.constantFrom(1, 2, 3),
    memory: fc.nat({ max: 3 }),
    times: fc.array(fc.nat({ max: 20_000 }), { minLength: 11, maxLength: 11 }),
    positions: fc.array(fc.nat({ max: 255 }), { minLength: 33, maxLength: 33 }),
  });
  const damage = fc.constantFrom(0, 0, 0.005, 0.02);
  const knows = fc.subarray(['times', 'count', 'memory', 'away', 'there'] as const);

  it('nothing is settled wrongly, and the timer holds what it held, or the page says what it may hold', {
    timeout: 600_000,
  }, async () => {
    const law = fc.asyncProperty(
      quirks,
      timer,
      knows,
      damage,
      fc.infiniteStream(fc.double({ min: 0, max: 0.999, noNaN: true })),
      async (given, made, known, share, chance) => {
        vi.useRealTimers();
        localStorage.clear();
        const { timerClass, functions, servos } = made;
        const slots = functions + 1;
        const times = [made.times[0] as number, ...rises(made.times.slice(1, slots))];
        const row = (servo: number): number[] => made.positions.slice(servo * slots, (servo + 1) * slots);
        const positions = Array.from({ length: servos }, (_, servo) => row(servo));
        let isSpoilt = false;
        const random = (): number => chance.next().value as number;
        const spoil = (byte: number): number[] => {
          if (!isSpoilt || random() >= share) return [byte];
          return [[], [byte, byte], [byte ^ (1 << Math.floor(8 * random()))]][Math.floor(3 * random())] as number[];
        };
        const app = await appBench({
          identity: { timerClass, functions, servos },
          memories: Array.from({ length: 4 }, () => ({ times, positions })),
          quirks: given,
          plug: { fault: { toDevice: spoil, toPage: spoil } },
        });
        const { core } = app.timer;
        core.memory = made.memory;
        await run(app.session.timer.connect());
        isSpoilt = share > 0;
        const before = structuredClone(core.memories);
        const { answers } = await walk(app, walkOn(app), { knows: known });
        const isTrue = { ...truth({ timerClass }, given), reserved: undefined };
        for (const [name, answer] of Object.entries(judged(answers.value))) {
          expect([name, answer]).toEqual([name, isTrue[name as keyof typeof isTrue]]);
        }
        isSpoilt = false;
        if (app.session.unfinished.value.length === 0) expect(core.memories).toEqual(before);
        else expect(share).toBeGreaterThan(0);
      },
    );
    await fc.assert(law, { numRuns: runsOf(400) });
  });
});

describe('a walk', () => {
  it('sends nothing before the tick, and none of what moves without a press', async () => {
    const app = await connectedBench();
    const settle = walkOn(app);
    settle.saySafe(false);
    app.timer.core.answered.length = 0;
    await run(settle.act());
    expect([app.timer.core.answered, settle.isDone.value]).toEqual([[], false]);
    settle.saySafe(true);
    await walk(app, settle, {}, 'away');
    await idle();
    expect(app.timer.core.answered.filter(({ name }) => !name.startsWith('GET'))).toEqual([]);
  });

  it('asks for the tick again after the connection', async () => {
    const app = await connectedBench();
    const settle = await walk(app, walkOn(app), {}, 'away');
    await run(app.session.timer.disconnect());
    await run(app.session.timer.connect());
    app.session.safety.confirm();
    expect([settle.isSafe.value, settle.ready.value, settle.step.value.name]).toEqual([false, false, 'away']);
  });

  it('begins again with a timer of another kind, and goes on with the same one', async () => {
    const app = await connectedBench();
    const settle = await walk(app, walkOn(app), {}, 'away');
    app.adapter.unplug();
    await idle();
    app.adapter.replug({ samePort: true });
    await idle();
    expect(settle.step.value.name).toBe('away');
    (app.timer.core.identity as { firmware: string }).firmware = '600';
    await run(app.session.timer.disconnect());
    await run(app.session.timer.connect());
    expect([settle.step.value.name, settle.seen.value]).toEqual(['read', null]);
  });

  it('waits until what is unfinished is settled', async () => {
    const app = await connectedBench();
    const settle = walkOn(app);
    expect(settle.ready.value).toBe(true);
    await app.session.knowledge.begin(app.editor.baseline.value as never, app.editor.baseline.value as never);
    app.session.knowledge.jobOver();
    expect([settle.isBlocked.value, settle.ready.value]).toEqual([true, false]);
  });

  it('keeps a backup, and tries no position without one', async () => {
    const app = await connectedBench();
    const settle = await walk(app, walkOn(app), {}, 'away');
    expect(app.store.backups.records.size).toBe(1);
    app.store.broken = true;
    await run(app.bench.moveTo(10));
    app.timer.core.answered.length = 0;
    await run(settle.act());
    expect(app.timer.core.answered.filter(({ name }) => name.startsWith('SET'))).toEqual([]);
    expect([settle.isDone.value, app.session.notices.current.value]).toMatchObject([false, { code: 'not-backed-up' }]);
    expect(app.session.unfinished.value).toEqual([]);
  });

  it('adds to an earlier one, and drops what contradicts it', async () => {
    const app = await connectedBench({ identity: { timerClass: 'B' } });
    const first = await walk(app, walkOn(app));
    const { answers } = await walk(app, walkOn(app), { says: { count: 'previous' } });
    expect([first.answers.value.count, answers.value.count, answers.value.layout]).toEqual([
      'launch',
      undefined,
      'function-first',
    ]);
  });
});
