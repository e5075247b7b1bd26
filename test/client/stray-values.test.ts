import { describe, expect, it } from 'vitest';
import { type Bench, contentOf, edited, names, readBench } from './bench.js';

/** Lets the timer change something else once, with its first reply to a request of this name. */
function disturbOnce({ core }: Bench['timer'], name: string, change: () => void): void {
  let isDone = false;
  core.onAnswer = (request) => {
    if (isDone || request.name !== name) return;
    isDone = true;
    change();
  };
}

describe('a position that changed without being asked', () => {
  // 99 is sent for servo 2, function 1: exchanged, that is servo 1, function 2.
  it.each<[string, servo: number, slot: number, position: number]>([
    ['has another value than the one that was sent', 1, 2, 98],
    ['is at another function', 1, 3, 99],
    ['is at another servo', 0, 2, 99],
  ])(
    'is no exchange of servo and function when it %s: it is put back, and nothing is assumed',
    async (_, s, slot, to) => {
      const { client, timer, run, baseline } = await readBench();
      const goal = edited(baseline, [2, 1, 99]);
      disturbOnce(timer, 'SETSERVO', () => void timer.core.content.positions[s]?.splice(slot, 1, to));
      const report = await run(client.writeProgram(goal, { baseline }));
      expect(report.result).toBe('verified');
      expect(report.values.filter(({ asked }) => !asked)).toMatchObject([
        { field: { kind: 'position', servo: s, slot }, status: 'verified' },
      ]);
      expect(client.quirksFound.has('servo-first')).toBe(false);
      expect(contentOf(timer)).toEqual(goal);
    },
  );

  it('does not count as exchanged where servo and function have the same number', async () => {
    const { client, timer, run, baseline } = await readBench();
    const goal = edited(baseline, [1, 1, 99]);
    disturbOnce(timer, 'SETSERVO', () => void timer.core.content.positions[0]?.splice(5, 1, 99));
    const report = await run(client.writeProgram(goal, { baseline }));
    expect(report.result).toBe('verified');
    expect(client.quirksFound.has('servo-first')).toBe(false);
    expect(names(timer.core.answered).filter((name) => name === 'SETSERVO')).toHaveLength(2);
  });
});

it('a time that changed unasked is put back by one more SETTIMERS, also when only a position was to change', async () => {
  const { client, timer, run, baseline } = await readBench();
  const goal = edited(baseline, [2, 4, 99]);
  disturbOnce(timer, 'SETSERVO', () => void timer.core.content.times.splice(7, 1, 4321));
  const report = await run(client.writeProgram(goal, { baseline }));
  expect(report.result).toBe('verified');
  expect(report.values).toContainEqual({
    field: { kind: 'time', slot: 7 },
    wanted: baseline.times[7],
    held: baseline.times[7],
    status: 'verified',
    asked: false,
  });
  expect(names(timer.core.answered).filter((name) => name.startsWith('SET'))).toEqual(['SETSERVO', 'SETTIMERS']);
  expect(contentOf(timer)).toEqual(goal);
});

it('an exception that is not an error of the line ends a write as it is', async () => {
  const { client, timer, run, baseline } = await readBench();
  const broken = { ...baseline, positions: baseline.positions.map((row) => [...row]) };
  // Such as a program that somebody takes away while it is written.
  const goal = edited(broken, [10, 30_000]);
  let reads = 0;
  const times = new Proxy(goal.times, {
    get(target, name) {
      if (name === 'findIndex' && ++reads > 0) throw new RangeError('taken away');
      return Reflect.get(target, name);
    },
  });
  await expect(run(client.writeProgram({ ...goal, times }, { baseline }))).rejects.toThrow(RangeError);
  expect(timer.core.content.times[10]).toBe(30_000);
  expect((await run(client.readProgram())).times[10], 'the client can still be used').toBe(30_000);
});

describe('what is counted and noted for each write', () => {
  it('repeats are those of this write alone, not of the ones before', async () => {
    let isDeaf = false;
    const { client, timer, run, baseline } = await readBench({
      fromTimer: { fault: (byte) => (isDeaf ? [] : [byte]) },
    });
    const first = edited(baseline, [0, 3, 40]);
    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETSERVO') isDeaf = true;
      if (name === 'GETSWVER') isDeaf = false;
    };
    const disturbed = await run(client.writeProgram(first, { baseline }));
    timer.core.onAnswer = undefined;
    isDeaf = false;
    expect(disturbed.repeats).toBeGreaterThan(0);
    const quiet = await run(client.writeProgram(edited(first, [0, 3, 41]), { baseline: first }));
    expect([quiet.result, quiet.repeats]).toEqual(['verified', 0]);
  });

  it('a rounded time is noted at the first slot, too', async () => {
    const { client, run, baseline } = await readBench({ identity: { timerClass: 'Q' }, quirks: { timeStep: 10 } });
    // A position after it says nothing of times.
    await run(client.writeProgram(edited(baseline, [0, 1005], [0, 3, 70]), { baseline }));
    expect(client.quirksFound.get('times-rounded')).toEqual({ slot: 0, sent: 1005, held: 1000 });
  });
});
