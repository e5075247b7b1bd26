import { describe, expect, it } from 'vitest';
import { wireTime } from '../../src/line/index.js';
import type { TimerProgram } from '../../src/program/index.js';
import { exchangeSize, type Request } from '../../src/protocol/index.js';
import { type Bench, bench, contentOf, edited, names, readBench } from './bench.js';

function sets(requests: readonly Request[]): Request[] {
  return requests.filter(({ name }) => name.startsWith('SET'));
}

const CONTENT = ['GETTIMERS', 'GETSERVOPOS'] as const;
/** What is asked before the first SET and after the last one. */
const FRESH = ['GETSWVER', 'GETMEMORY', ...CONTENT, 'GETMEMORY', 'GETSWVER'] as const;
const VERIFY = ['GETSWVER', 'GETMEMORY', ...CONTENT, ...CONTENT, 'GETMEMORY', 'GETSWVER'] as const;

describe('write program', () => {
  it('sends one SETTIMERS and one SETSERVO for each position, reads back, and says verified', async () => {
    const { client, timer, run, baseline } = await readBench();
    const goal = edited(baseline, [10, 30000], [0, 3, 70], [2, 10, 0]);
    timer.core.answered.length = 0;
    const report = await run(client.writeProgram(goal, { baseline }));
    expect(sets(timer.core.answered)).toEqual([
      { name: 'SETTIMERS', times: goal.times },
      { name: 'SETSERVO', function: 3, servo: 0, position: 70 },
      { name: 'SETSERVO', function: 10, servo: 2, position: 0 },
    ]);
    const isSet = (name: string): boolean => name.startsWith('SET');
    const asked = names(timer.core.answered);
    expect(asked.slice(0, asked.findIndex(isSet))).toEqual(FRESH);
    expect(asked.slice(asked.findLastIndex(isSet) + 1)).toEqual(VERIFY);
    expect(report).toMatchObject({ result: 'verified', held: goal, acknowledged: 3, repeats: 0, stopped: null });
    expect(report.asked).toBe(3);
    expect(report.values).toEqual([
      { field: { kind: 'time', slot: 10 }, wanted: 30000, held: 30000, status: 'verified', asked: true },
      { field: { kind: 'position', servo: 0, slot: 3 }, wanted: 70, held: 70, status: 'verified', asked: true },
      { field: { kind: 'position', servo: 2, slot: 10 }, wanted: 0, held: 0, status: 'verified', asked: true },
    ]);
    expect(contentOf(timer)).toEqual(goal);
  });

  it('reads back even when nothing differs, sends no SET, and says that nothing was asked for', async () => {
    const { client, timer, run, baseline } = await readBench();
    const report = await run(client.writeProgram(baseline, { baseline }));
    expect(report).toMatchObject({ result: 'verified', asked: 0, values: [] });
    expect(sets(timer.core.answered)).toEqual([]);
  });

  it('refuses what the wire cannot carry before anything is sent', async () => {
    const { client, timer, run, baseline } = await readBench();
    timer.core.answered.length = 0;
    const bad = edited(baseline, [1, 40], [0, 0, 131]);
    await expect(run(client.writeProgram(bad, { baseline }))).rejects.toMatchObject({
      code: 'out-of-range',
      field: 'position',
    });
    const late = edited(baseline, [10, 65536]);
    await expect(run(client.writeProgram(late, { baseline }))).rejects.toMatchObject({
      code: 'out-of-range',
      field: 'times[10]',
    });
    expect(timer.core.answered).toEqual([]);
  });

  it('refuses what may cost a model before anything is sent, unless the pilot wants it all the same', async () => {
    const { client, timer, run, baseline } = await readBench();
    timer.core.answered.length = 0;
    // 180 was meant in seconds.
    const short = edited(baseline, [10, 180]);
    const refused = { code: 'serious', details: { findings: [{ severity: 'serious', code: 'dt-short' }] } };
    await expect(run(client.writeProgram(short, { baseline }))).rejects.toMatchObject(refused);
    await expect(run(client.writeProgram(short, { baseline, despite: ['time-falls'] }))).rejects.toMatchObject(refused);
    await expect(run(client.writeMemories([baseline, { ...short, memory: 1 }]))).rejects.toMatchObject(refused);
    expect(timer.core.answered).toEqual([]);
    const options = { baseline, despite: ['dt-short'] } as const;
    expect((await run(client.writeProgram(short, options))).result).toBe('verified');
    expect(contentOf(timer).times[10]).toBe(180);
    expect(await run(client.writeMemories([{ ...short, memory: 1 }], options))).toMatchObject({ stopped: null });
  });

  it('refuses to write into another memory than the one that was read', async () => {
    const { client, timer, run, baseline } = await readBench();
    timer.core.memory = 2;
    const goal = edited(baseline, [10, 30000]);
    await expect(run(client.writeProgram(goal, { baseline }))).rejects.toMatchObject({
      code: 'other-memory',
      details: { expected: 0, found: 2 },
    });
    expect(sets(timer.core.answered)).toEqual([]);
    expect(names(timer.core.answered).slice(5), 'the content of the other memory is not read').toEqual([
      'GETSWVER',
      ...['GETSWVER', 'GETMEMORY', 'GETMEMORY', 'GETSWVER'],
    ]);
  });

  it('refuses a baseline without a memory, which plain JavaScript can give', async () => {
    const { client, timer, run } = bench();
    const { memory: _, ...rest } = await run(client.readProgram());
    const baseline = rest as TimerProgram;
    await expect(run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }))).rejects.toMatchObject({
      code: 'other-memory',
      details: { expected: null, found: 0 },
    });
    expect(sets(timer.core.answered)).toEqual([]);
  });

  it('stops as soon as another memory is current after the reading', async () => {
    const { client, timer, run, baseline } = await readBench();
    timer.core.answered.length = 0;
    timer.core.onAnswer = ({ name }) => {
      if (name === 'GETSERVOPOS') timer.core.memory = 2;
    };
    await expect(run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }))).rejects.toMatchObject({
      code: 'other-memory',
      details: { expected: 0, found: 2 },
    });
    expect(names(timer.core.answered)).toEqual([
      ...['GETSWVER', 'GETMEMORY', 'GETTIMERS', 'GETSERVOPOS'],
      ...['GETMEMORY', 'GETMEMORY', 'GETSWVER'],
    ]);
  });

  it('puts nothing back when another memory was selected during the write', async () => {
    const { client, timer, run, baseline } = await readBench();
    const goal = edited(baseline, [10, 30000]);
    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS') timer.core.memory = 1;
    };
    const before = structuredClone(timer.core.memories[1]);
    const report = await run(client.writeProgram(goal, { baseline }));
    expect(report).toMatchObject({ result: 'unknown', held: null, stopped: { code: 'other-memory' } });
    expect(report.values[0]?.status).toBe('unknown');
    expect(timer.core.memories[1]).toEqual(before);
  });

  it('refuses a program for another kind of timer', async () => {
    const { client, timer, run, baseline } = await readBench();
    const other = { ...baseline, identity: { ...baseline.identity, timerClass: 'E' } };
    await expect(run(client.writeProgram(other, { baseline }))).rejects.toMatchObject({
      code: 'other-timer',
      details: { identity: timer.core.identity },
    });
  });

  it('puts back what changed without being asked, and says so', async () => {
    const { client, timer, run, baseline } = await readBench();
    let once = true;
    timer.core.onAnswer = ({ name }) => {
      if (name !== 'SETTIMERS' || !once) return;
      once = false;
      (timer.core.content.positions[1] as number[])[5] = 99;
    };
    const goal = edited(baseline, [10, 30000]);
    const stages: string[] = [];
    const onProgress = ({ stage }: { stage: string }): void => void (stages.at(-1) !== stage && stages.push(stage));
    const report = await run(client.writeProgram(goal, { baseline, onProgress }));
    expect(stages).toEqual(['read', 'write', 'verify', 'repair', 'verify']);
    expect(report.result).toBe('verified');
    expect(report.values).toContainEqual({
      field: { kind: 'position', servo: 1, slot: 5 },
      wanted: 65,
      held: 65,
      status: 'verified',
      asked: false,
    });
    expect(contentOf(timer)).toEqual(goal);
    expect(names(sets(timer.core.answered))).toEqual(['SETTIMERS', 'SETSERVO']);
  });

  it('puts nothing back when more changed than it can have disturbed: it may be another timer', async () => {
    const { client, timer, run, baseline } = await readBench();
    const foreign = timer.core.content.positions.map((row) => row.map((position) => position + 1));
    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS') timer.core.content.positions = structuredClone(foreign);
    };
    const report = await run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }));
    expect(report).toMatchObject({ result: 'differs', acknowledged: 1, stopped: { code: 'changed' } });
    expect(report.values.filter(({ asked }) => !asked)).toHaveLength(33);
    expect(timer.core.content.positions).toEqual(foreign);
  });

  it.each<[string, (core: Bench['timer']['core']) => void]>([
    ['a time', ({ content }) => void content.times.splice(10, 1, 20000)],
    ['a position', ({ content }) => void content.positions[2]?.splice(4, 1, 1)],
    ['the idle throttle', (core) => void Object.assign(core, { idleThrottle: 31 })],
  ])('writes nothing when %s has changed since the reading, and gives what the timer holds', async (_, change) => {
    const { client, timer, run, baseline } = await readBench({ identity: { timerClass: 'Q' } });
    change(timer.core);
    const held = structuredClone(contentOf(timer));
    const goal = { ...edited(baseline, [10, 30000], [2, 4, 99]), idleThrottle: 40 };
    await expect(run(client.writeProgram(goal, { baseline }))).rejects.toMatchObject({
      code: 'stale',
      details: { held },
    });
    expect(sets(timer.core.answered)).toEqual([]);
    expect((await run(client.writeProgram(goal, { baseline: held }))).result).toBe('verified');
  });

  it('does not claim what a timer holds that fell asleep, and finishes when it is awake again', async () => {
    const { client, timer, run, baseline } = await readBench();
    const goal = edited(baseline, [0, 1, 70], [1, 1, 71]);
    timer.core.onAnswer = (request) => {
      if (request.name === 'SETSERVO') timer.core.sleep();
    };
    const report = await run(client.writeProgram(goal, { baseline }));
    expect(report).toMatchObject({ result: 'unknown', held: null, stopped: { code: 'no-answer' } });

    timer.core.onAnswer = undefined;
    timer.core.press();
    const held = await run(client.readProgram());
    expect((await run(client.writeProgram(goal, { baseline: held }))).result).toBe('verified');
    expect(contentOf(timer)).toEqual(goal);
  });

  it('stops after silence when something has changed that this write cannot have changed', async () => {
    let lose = false;
    const { client, timer, run, baseline } = await readBench({ fromTimer: { fault: (byte) => (lose ? [] : [byte]) } });
    let first = true;
    timer.core.onAnswer = ({ name }) => {
      lose = name === 'SETTIMERS';
      if (!lose || !first) return;
      first = false;
      (timer.core.content.positions[2] as number[])[9] = 1;
    };
    const goal = edited(baseline, [10, 30000]);
    const report = await run(client.writeProgram(goal, { baseline }));
    expect(report).toMatchObject({ result: 'unknown', held: null, stopped: { code: 'changed' } });
    expect(names(sets(timer.core.answered))).toEqual(['SETTIMERS']);
    expect(client.quirksFound.size).toBe(0);

    timer.core.onAnswer = undefined;
    const held = await run(client.readProgram());
    expect(held).toEqual(edited(goal, [2, 9, 1]));
    expect((await run(client.writeProgram(goal, { baseline: held }))).result).toBe('verified');
  });

  it('does not take a change for its own before it has sent that value', async () => {
    let lose = false;
    const { client, timer, run, baseline } = await readBench({ fromTimer: { fault: (byte) => (lose ? [] : [byte]) } });
    timer.core.onAnswer = ({ name }) => {
      lose = name === 'SETTIMERS';
      // The value of the SETSERVO that is still to come, where a timer puts it that takes the servo first.
      if (lose) (timer.core.content.positions[1] as number[])[2] = 99;
    };
    const report = await run(client.writeProgram(edited(baseline, [10, 30000], [2, 1, 99]), { baseline }));
    expect(report).toMatchObject({ result: 'unknown', stopped: { code: 'changed' } });
    expect(names(sets(timer.core.answered))).toEqual(['SETTIMERS']);
  });

  it('goes on after silence with a timer that rounds, or takes the servo first', async () => {
    for (const quirks of [{ timeStep: 10 }, { servoFirst: true }]) {
      let lose = false;
      const { client, timer, run, baseline } = await readBench({
        quirks,
        fromTimer: { fault: (byte) => (lose ? [] : [byte]) },
      });
      let lost = 0;
      timer.core.onAnswer = ({ name }) => {
        lose = name.startsWith('SET') && lost++ % 2 === 0;
      };
      const goal = edited(baseline, [10, 30003], [0, 2, 70]);
      const report = await run(client.writeProgram(goal, { baseline }));
      expect(report, `a timer with ${JSON.stringify(quirks)}`).toMatchObject({ result: 'differs', stopped: null });
    }
  });

  it('says verified when the timer holds all that was wanted, although a reply was missing', async () => {
    // All replies to SETSERVO are lost; the timer has carried it out.
    let lose = false;
    const { client, timer, run, baseline } = await readBench({ fromTimer: { fault: (byte) => (lose ? [] : [byte]) } });
    timer.core.onAnswer = ({ name }) => {
      lose = name === 'SETSERVO';
    };
    const report = await run(client.writeProgram(edited(baseline, [0, 1, 70]), { baseline }));
    expect(names(sets(timer.core.answered))).toEqual(Array(10).fill('SETSERVO'));
    expect(report).toMatchObject({ result: 'verified', acknowledged: 0, stopped: null });
    expect(client.quirksFound.size, 'function 1 is also a servo number, so silence shows nothing').toBe(0);
  });

  it('stops within one reply when asked to, and says what is not known', async () => {
    const { client, timer, run, baseline } = await readBench();
    const goal = edited(baseline, [10, 30000], [0, 3, 70]);
    const stop = new AbortController();
    timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && stop.abort();
    const report = await run(client.writeProgram(goal, { baseline, signal: stop.signal }));
    expect(report).toMatchObject({ result: 'unknown', held: null, acknowledged: 1, stopped: { code: 'aborted' } });
    expect(report.values.map(({ status }) => status)).toEqual(['unknown', 'unknown']);
    timer.core.onAnswer = undefined;
    const held = await run(client.readProgram());
    expect((await run(client.writeProgram(goal, { baseline: held }))).result).toBe('verified');
  });

  it('is refused when stopped before the first value went out', async () => {
    const { client, timer, run, baseline } = await readBench();
    const stop = new AbortController();
    timer.core.onAnswer = ({ name }) => name === 'GETMEMORY' && stop.abort();
    const writing = client.writeProgram(edited(baseline, [10, 30000]), { baseline, signal: stop.signal });
    await expect(run(writing)).rejects.toMatchObject({ code: 'aborted' });
    expect(sets(timer.core.answered)).toEqual([]);
  });

  it('does not say verified when the cable is pulled while reading back', async () => {
    const { client, timer, run, baseline } = await readBench();
    timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && timer.cut();
    const report = await run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }));
    expect(report).toMatchObject({ result: 'unknown', stopped: { code: 'port-lost' } });
    expect(report.values.map(({ status }) => status)).toEqual(['unknown']);
  });

  it.each([9600, 115_200])('takes no longer at %i baud than its bytes do', async (baudRate) => {
    const { client, run, clock, baseline } = await readBench({ baudRate }, { baudRate });
    const positions = baseline.positions.flatMap((row, servo) =>
      row.map((p, slot): [number, number, number] => [servo, slot, p + 1]),
    );
    const goal = edited(baseline, [10, 30000], ...positions);
    const begin = clock.now();
    expect((await run(client.writeProgram(goal, { baseline }))).result).toBe('verified');
    const requests = [...FRESH, 'SETTIMERS', ...positions.map(() => 'SETSERVO'), ...VERIFY];
    const bytes = requests
      .map((name) => exchangeSize(name as 'SETSERVO', baseline.identity))
      .reduce((sum, { request, reply }) => sum + request + reply, 0);
    expect((clock.now() - begin) / wireTime(bytes, baudRate)).toBeLessThan(1.05);
  });
});

describe('other actions', () => {
  it('select a memory and check it', async () => {
    const { client, timer, run } = bench();
    await run(client.selectMemory(3));
    expect(timer.core.memory).toBe(3);
    await expect(run(client.selectMemory(4))).rejects.toMatchObject({ code: 'out-of-range' });
    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETMEMORY') timer.core.memory = 1;
    };
    await expect(run(client.selectMemory(2))).rejects.toMatchObject({
      code: 'other-memory',
      details: { expected: 2, found: 1 },
    });
  });

  it('move the servos, unlock the motor, set the idle throttle, store one position', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' } });
    await run(client.moveToFunction(0));
    expect(timer.core.servos).toEqual([15, 15, 15]);
    expect(timer.core.motorLocked).toBe(true);
    await run(client.unlockMotor());
    expect(timer.core.motorLocked).toBe(false);
    expect(await run(client.setIdleThrottle(44))).toBe(44);
    await run(client.setPosition({ servo: 1, slot: 4 }, 70));
    expect(timer.core.answered.at(-1)).toEqual({ name: 'SETSERVO', servo: 1, function: 4, position: 70 });
  });

  it('wait their turn: jobs started together run one after another', async () => {
    const { client, timer, run } = bench({ latency: 10 });
    await run(client.identify());
    const [a, b] = await run(Promise.all([client.readProgram(), client.readProgram()]));
    expect(a).toEqual(contentOf(timer));
    expect(b).toEqual(a);
  });
});
