import { describe, expect, it } from 'vitest';
import type { Progress } from '../../src/client/index.js';
import type { TimerProgram } from '../../src/program/index.js';
import { bench, contentOf, edited, memoriesOf, memoryOf, names } from './bench.js';
import { everyValueChanged } from './matrix.js';

const isSelect = (name: string): boolean => name === 'SETMEMORY';

describe('reading several memories', () => {
  it('gives what each holds, and makes the first one current again', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' } });
    timer.core.memory = 2;
    const told: number[] = [];
    const onOriginal = (original: number): void => {
      expect(names(timer.core.answered)).not.toContain('SETMEMORY');
      told.push(original);
    };
    expect(await run(client.readMemories({ onOriginal }))).toEqual({ original: 2, programs: memoriesOf(timer) });
    expect(timer.core.memory).toBe(2);
    expect(told).toEqual([2]);
    const selected = timer.core.answered.flatMap((request) => (request.name === 'SETMEMORY' ? [request.memory] : []));
    expect(selected).toEqual([0, 1, 2, 3, 2]);
  });

  it('gives those that are asked for in their order, and selects nothing when the current one is enough', async () => {
    const { client, timer, run } = bench();
    const { programs } = await run(client.readMemories({ memories: [3, 1] }));
    expect(programs).toEqual([memoryOf(timer, 3), memoryOf(timer, 1)]);
    expect(timer.core.memory).toBe(0);
    timer.core.answered.length = 0;
    const onOriginal = (): void => expect.unreachable();
    expect(await run(client.readMemories({ memories: [0], onOriginal }))).toEqual({
      original: 0,
      programs: [memoryOf(timer, 0)],
    });
    expect(names(timer.core.answered).some(isSelect)).toBe(false);
  });

  it('selects nothing when the timer does not say which memory is current', async () => {
    const { client, timer, run } = bench({ quirks: { memoryReplyEmpty: true } });
    await expect(run(client.readMemories())).rejects.toMatchObject({ code: 'memory-unknown' });
    const goal = { ...(await run(client.readProgram())), memory: 1 };
    await expect(run(client.writeMemories([goal]))).rejects.toMatchObject({ code: 'memory-unknown' });
    expect(names(timer.core.answered).some((name) => name.startsWith('SET'))).toBe(false);
  });

  it('selects nothing when the timer has no such memory, and nothing when the memory to come back to could not be kept', async () => {
    const { client, timer, run } = bench();
    await expect(run(client.readMemories({ memories: [1, 4] }))).rejects.toMatchObject({ code: 'out-of-range' });
    const onOriginal = (): Promise<void> => Promise.reject(new Error('the store is full'));
    await expect(run(client.readMemories({ onOriginal }))).rejects.toThrow('the store is full');
    expect(names(timer.core.answered).some(isSelect)).toBe(false);
  });

  it('works with a timer that counts its memories from 1, once that is known', async () => {
    const { client, timer, run } = bench({ quirks: { memoriesFromOne: true } });
    timer.core.memory = 3;
    expect(await run(client.readMemories())).toEqual({ original: 3, programs: memoriesOf(timer) });
  });

  it('goes back when asked to stop, and says that it was stopped', async () => {
    const { client, timer, run } = bench();
    const stop = new AbortController();
    timer.core.onAnswer = (request) => {
      if (request.name === 'GETTIMERS' && timer.core.memory === 2) stop.abort();
    };
    await expect(run(client.readMemories({ signal: stop.signal }))).rejects.toMatchObject({ code: 'aborted' });
    expect(timer.core.memory).toBe(0);
    expect(names(timer.core.answered).slice(-6)).toEqual([
      'GETTIMERS',
      'GETSWVER',
      'SETMEMORY',
      'GETSWVER',
      'GETMEMORY',
      'GETMEMORY',
    ]);
  });

  it('repeats the single readings from before the first damage', async () => {
    const { client, timer, run } = bench({ fromTimer: { fault: (byte, index) => (index === 2 * 150 ? [] : [byte]) } });
    const told: Progress[] = [];
    const { programs } = await run(client.readMemories({ onProgress: (progress) => told.push(progress) }));
    expect(programs).toEqual(memoriesOf(timer));
    expect(client.damageSeen).toBe(true);
    const times = { first: 0, last: 0 };
    let memory = 0;
    for (const request of timer.core.answered) {
      if (request.name === 'SETMEMORY') memory = request.memory;
      if (request.name === 'GETTIMERS' && memory === 0) times.first++;
      if (request.name === 'GETTIMERS' && memory === 3) times.last++;
    }
    // Once, and then twice; twice from the beginning.
    expect(times).toEqual({ first: 3, last: 2 });
    for (const { done, total } of told) expect(done).toBeLessThanOrEqual(total);
  });

  it('says which memory is left behind when the cable is pulled, and why', async () => {
    const { client, timer, run } = bench();
    timer.core.memory = 1;
    timer.core.onAnswer = ({ name }) => {
      if (name === 'GETSERVOPOS' && timer.core.memory === 3) timer.cut();
    };
    await expect(run(client.readMemories())).rejects.toMatchObject({
      code: 'memory-left',
      details: { expected: 1, found: 3 },
      cause: { code: 'port-lost' },
    });
  });

  it('knows which memory is current when the selection of another never went out', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' } });
    timer.core.onAnswer = ({ name }) => {
      if (name === 'GETSERVOPOS' && timer.core.memory === 2) timer.core.sleep();
    };
    await expect(run(client.readMemories())).rejects.toMatchObject({
      code: 'memory-left',
      details: { expected: 0, found: 2 },
      cause: { code: 'no-answer' },
    });
    expect(names(timer.core.answered).filter(isSelect)).toHaveLength(2);
  });

  it('reads nothing from a memory that something else has selected, and goes back', async () => {
    const { client, timer, run } = bench();
    timer.core.memory = 1;
    let asked = 0;
    timer.core.onAnswer = ({ name }) => {
      if (name === 'GETMEMORY') asked++;
      // Behind the question that follows selecting.
      if (asked === 2) timer.core.memory = 3;
      if (asked === 3) timer.core.onAnswer = undefined;
    };
    await expect(run(client.readMemories({ memories: [2] }))).rejects.toMatchObject({
      code: 'other-memory',
      details: { expected: 2, found: 3 },
    });
    expect(timer.core.memory).toBe(1);
  });

  it('says why when all was read and only the way back failed', async () => {
    const { client, timer, run } = bench();
    let asked = 0;
    timer.core.onAnswer = ({ name }) => {
      if (name !== 'GETSWVER' || timer.core.memory !== 3) return;
      asked++;
      // Behind selecting, at the end of the reading, before going back.
      if (asked === 3) timer.core.sleep();
    };
    await expect(run(client.readMemories())).rejects.toMatchObject({
      code: 'memory-left',
      details: { expected: 0, found: null, request: 'SETMEMORY' },
      cause: { code: 'no-answer', details: { request: 'SETMEMORY' } },
    });
  });
});

describe('writing several memories', () => {
  it('moves the servos to each function where that was asked for, and nowhere else', async () => {
    const { client, timer, run } = bench({ quirks: { servoNeedsMove: true } });
    const goals = [1, 2].map((memory) => edited(memoryOf(timer, memory), [0, 3, 90 + memory]));
    const still = await run(client.writeMemories(goals));
    expect(still.memories.map(({ report }) => report.result)).toEqual(['differs', 'differs']);
    expect(names(timer.core.answered)).not.toContain('MOVETOFUNC');
    const moved = await run(client.writeMemories(goals, { moveServos: true }));
    expect(moved.memories.map(({ report }) => report.result)).toEqual(['verified', 'verified']);
    expect(timer.core.answered.filter(({ name }) => name === 'MOVETOFUNC')).toHaveLength(2);
  });

  it('writes each program into its memory, gives the caller what was there before, and goes back', async () => {
    const { client, timer, run } = bench();
    timer.core.memory = 1;
    const before = memoriesOf(timer);
    const copy = (memory: number): TimerProgram => ({ ...(before[1] as TimerProgram), memory });
    const goals = [edited(copy(0), [10, 30000]), copy(3)];
    const backups: [TimerProgram, TimerProgram][] = [];
    const onMemory = async (read: TimerProgram, goal: TimerProgram): Promise<void> => {
      await Promise.resolve();
      expect(timer.core.memories[read.memory as number]).toEqual({ times: read.times, positions: read.positions });
      backups.push([read, goal]);
    };
    const report = await run(client.writeMemories(goals, { onMemory }));
    expect(report).toMatchObject({ original: 1, restored: true, stopped: null });
    expect(report.memories).toMatchObject([
      { memory: 0, before: before[0], report: { result: 'verified', acknowledged: 1 } },
      { memory: 3, before: before[3], report: { result: 'verified', acknowledged: 1 } },
    ]);
    expect(backups).toEqual([
      [before[0], goals[0]],
      [before[3], goals[1]],
    ]);
    expect(memoriesOf(timer).map((program) => ({ ...program, memory: 0 }))).toEqual(
      [goals[0], before[1], before[2], goals[1]].map((program) => ({ ...program, memory: 0 })),
    );
    expect(timer.core.memory).toBe(1);
  });

  it('writes nothing into a memory that holds other values than expected, and gives what it holds', async () => {
    const { client, timer, run } = bench();
    const [, first, second] = memoriesOf(timer) as [TimerProgram, TimerProgram, TimerProgram];
    const baselines = [second, first];
    timer.core.memories[2]?.times.splice(10, 1, 12345);
    const before = memoriesOf(timer);
    const report = await run(client.writeMemories([first, second].map(everyValueChanged), { baselines }));
    expect(report).toMatchObject({
      restored: true,
      memories: [{ memory: 1, report: { result: 'verified' } }],
      stopped: { code: 'stale', details: { held: before[2] } },
    });
    expect(memoriesOf(timer)).toEqual([before[0], everyValueChanged(first), before[2], before[3]]);
    const other = { ...first, identity: { ...first.identity, firmware: '537' } };
    await expect(run(client.writeMemories([first], { baselines: [other] }))).rejects.toMatchObject({
      code: 'other-timer',
    });
  });

  it('writes nothing into a memory that changed while its backup was kept', async () => {
    const { client, timer, run } = bench();
    const before = memoriesOf(timer);
    const onMemory = (): void => void timer.core.content.positions[0]?.splice(0, 1, 99);
    const goal = everyValueChanged(before[1] as TimerProgram);
    const report = await run(client.writeMemories([goal], { onMemory }));
    expect(report).toMatchObject({ restored: true, memories: [], stopped: { code: 'stale' } });
    expect(timer.core.memories[1]?.positions[0]?.[0]).toBe(99);
    expect(timer.core.memories[1]?.times).toEqual(before[1]?.times);
  });

  it('writes nothing into a memory whose backup could not be kept, and goes back', async () => {
    const { client, timer, run } = bench();
    const before = memoriesOf(timer);
    const goals = before.slice(1, 3).map(everyValueChanged);
    let kept = 0;
    const onMemory = (): void => {
      kept++;
      if (kept === 2) throw new Error('the store is full');
    };
    await expect(run(client.writeMemories(goals, { onMemory }))).rejects.toThrow('the store is full');
    expect(memoriesOf(timer)).toEqual([before[0], goals[0], before[2], before[3]]);
    expect(timer.core.memory).toBe(0);
  });

  it('writes nothing when any goal cannot be written', async () => {
    const { client, timer, run } = bench();
    const [, first, second] = memoriesOf(timer) as [TimerProgram, TimerProgram, TimerProgram, TimerProgram];
    await run(client.identify());
    timer.core.answered.length = 0;
    for (const [wrong, error] of [
      [
        { ...second, memory: 4 },
        { code: 'out-of-range', field: 'memory' },
      ],
      [{ ...second, memory: null }, { code: 'memory-unknown' }],
      [edited(second, [1, 65536]), { code: 'out-of-range', field: 'times[1]' }],
      [edited(second, [1, 2, 256]), { code: 'out-of-range', field: 'positions[1][2]' }],
      [
        { ...second, idleThrottle: 256 },
        { code: 'out-of-range', field: 'idleThrottle' },
      ],
      [{ ...second, times: [1] }, { code: 'wrong-count' }],
      [{ ...second, identity: { ...second.identity, timerClass: 'E' } }, { code: 'other-timer' }],
    ] as const) {
      await expect(run(client.writeMemories([first, wrong]))).rejects.toMatchObject(error);
    }
    expect(timer.core.answered).toEqual([]);
  });

  it('says what was written when a later goal cannot be written, and when it is asked to stop', async () => {
    const { client, timer, run } = bench();
    const [, first, second] = memoriesOf(timer).map(everyValueChanged) as [TimerProgram, TimerProgram, TimerProgram];
    // Past the last step: only where the timer holds the same.
    const report = await run(client.writeMemories([first, edited(second, [0, 0, 200])]));
    expect(report).toMatchObject({
      restored: true,
      memories: [{ memory: 1, report: { result: 'verified' } }],
      stopped: { name: 'CodecError', code: 'out-of-range' },
    });
    const stop = new AbortController();
    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETSERVO' && timer.core.memory === 2) stop.abort();
    };
    const stopped = await run(client.writeMemories([first, second], { signal: stop.signal }));
    expect(stopped).toMatchObject({
      restored: true,
      memories: [
        { memory: 1, report: { result: 'verified', values: [] } },
        { memory: 2, report: { result: 'unknown', stopped: { code: 'aborted' } } },
      ],
      stopped: { code: 'aborted' },
    });
    expect(timer.core.memory).toBe(0);
  });

  it('goes on to the next memory when the timer rounds, and stops at one that was changed by something else', async () => {
    const { client, timer, run } = bench({ quirks: { timeStep: 10 } });
    const before = memoriesOf(timer);
    const goals = before.slice(1, 3).map((program) => edited(program, [1, 123]));
    const rounded = await run(client.writeMemories(goals));
    expect(rounded.memories.map(({ report }) => report.result)).toEqual(['differs', 'differs']);
    expect(rounded.stopped).toBeNull();

    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS')
        timer.core.content.positions = [...everyValueChanged(contentOf(timer)).positions] as never;
    };
    const changed = await run(client.writeMemories(before.slice(1, 3).map((program) => edited(program, [2, 400]))));
    expect(changed).toMatchObject({ restored: true, stopped: { code: 'changed' } });
    expect(changed.memories).toHaveLength(1);
  });

  it('makes the first memory current again also when something else has selected another one', async () => {
    const { client, timer, run } = bench();
    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS') timer.core.memory = 3;
    };
    const report = await run(client.writeMemories([edited(memoryOf(timer, 0), [10, 30000])]));
    expect(report).toMatchObject({
      restored: true,
      memories: [{ report: { result: 'unknown' } }],
      stopped: { code: 'other-memory' },
    });
    expect(timer.core.memory).toBe(0);
  });

  it('reports which memory is left current when the cable is pulled, and what is known of each', async () => {
    const { client, timer, run } = bench();
    const goals = memoriesOf(timer).slice(1, 3).map(everyValueChanged);
    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS' && timer.core.memory === 2) timer.cut();
    };
    const report = await run(client.writeMemories(goals));
    expect(report).toMatchObject({
      original: 0,
      restored: false,
      memories: [{ report: { result: 'verified' } }, { report: { result: 'unknown' } }],
      stopped: { code: 'memory-left', details: { expected: 0, found: 2 }, cause: { code: 'port-lost' } },
    });
  });
});

describe('the progress of several memories', () => {
  it('covers the whole job: it never falls, comes to its end, and says the memory and the time', async () => {
    const { client, timer, run, clock } = bench();
    const goals = memoriesOf(timer).map((program) => edited(program, [10, 40000]));
    const jobs: ((onProgress: (progress: Progress) => void) => Promise<unknown>)[] = [
      (onProgress) => client.readMemories({ onProgress }),
      (onProgress) => client.writeMemories(goals, { onProgress }),
    ];
    for (const job of jobs) {
      const told: Progress[] = [];
      await run(job((progress) => told.push(progress)));
      const done = told.map((progress) => progress.done);
      expect(done).toEqual([...done].sort((a, b) => a - b));
      const last = told.at(-1) as Progress;
      expect(
        told.filter(({ done, total }) => done === total),
        'only at the end',
      ).toEqual([last]);
      expect(new Set(told.map(({ total }) => total)).size).toBe(1);
      expect(new Set(told.map(({ endsBy }) => endsBy)).size).toBe(1);
      expect(last.endsBy).toBeGreaterThan(clock.now());
      expect([...new Set(told.map(({ memory }) => memory))]).toEqual([0, 1, 2, 3]);
    }
  });

  it.each([
    ['reading all, the current one last', 3, undefined],
    ['reading only the current one', 2, [2]],
  ])('comes to its end where no way back is needed: %s', async (_, current, memories) => {
    const { client, timer, run } = bench();
    timer.core.memory = current;
    const told: Progress[] = [];
    const onProgress = (progress: Progress): void => void told.push(progress);
    await run(client.readMemories({ memories, onProgress }));
    expect(told.at(-1)).toMatchObject({ stage: 'read', memory: current, fraction: 1 });
    await run(client.writeMemories([edited(memoryOf(timer, current), [10, 40000])], { onProgress }));
    expect(told.at(-1)).toMatchObject({ stage: 'verify', memory: current, fraction: 1 });
  });

  it('moves its end by the time that the caller takes for a backup', async () => {
    const { client, timer, run, clock } = bench();
    const told: Progress[] = [];
    await run(
      client.writeMemories([memoryOf(timer, 1)], {
        onMemory: () => new Promise<void>((resolve) => void clock.after(90_000, resolve)),
        onProgress: (progress) => told.push(progress),
      }),
    );
    expect((told.at(-1) as Progress).endsBy - (told[0] as Progress).endsBy).toBe(90_000);
  });
});
