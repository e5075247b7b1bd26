import { describe, expect, it } from 'vitest';
import { bench, contentOf, edited, names, readBench } from './bench.js';
import { everyValueChanged } from './matrix.js';

describe('giving up', () => {
  it('a timer that fell asleep is reported within seconds, and the next time at once', async () => {
    const { client, timer, run, clock, line } = bench();
    await run(client.identify());
    timer.core.sleep();
    let begin = clock.now();
    await expect(run(client.readProgram())).rejects.toMatchObject({
      code: 'no-answer',
      details: { request: 'GETMEMORY' },
    });
    expect(clock.now() - begin).toBeLessThan(8500);
    begin = clock.now();
    line.length = 0;
    await expect(run(client.readProgram())).rejects.toMatchObject({ code: 'no-answer' });
    expect(line).toHaveLength(3);
    expect(clock.now() - begin).toBeLessThan(5000);
  });

  it('a timer that falls asleep before the last question does not count as one that has no idle throttle', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' } });
    timer.core.onAnswer = ({ name }) => name !== 'GETSERVOPOS' || timer.core.sleep();
    await expect(run(client.readProgram())).rejects.toMatchObject({
      code: 'no-answer',
      details: { request: 'GETLOWRPM' },
    });
    expect(client.quirksFound.size).toBe(0);
  });

  it('a question that this timer does not answer is asked six times, and twice from then on', async () => {
    const { client, timer, run, line } = bench({ quirks: { idleThrottleOnQOnly: true } });
    const asked = (): number => line.filter(({ frame }) => frame?.code === 0x75).length;
    expect((await run(client.readProgram({ idleThrottle: true }))).idleThrottle).toBeNull();
    expect(asked()).toBe(6);
    expect(await run(client.readProgram({ idleThrottle: true }))).toEqual(contentOf(timer));
    expect(asked()).toBe(8);
  });

  it('a request that this timer does not answer goes out ten times, each after a fence', async () => {
    const { client, run, timer, baseline } = await readBench({ quirks: { servoFirst: true } });
    timer.core.answered.length = 0;
    const report = await run(client.writeProgram(edited(baseline, [1, 7, 99]), { baseline }));
    expect(report).toMatchObject({
      result: 'differs',
      // Nine repeats, and a fence after each of the ten.
      repeats: 19,
      stopped: { code: 'no-answer', details: { request: 'SETSERVO', sent: 10 } },
    });
    const content = ['GETTIMERS', 'GETSERVOPOS'];
    expect(names(timer.core.answered)).toEqual([
      ...['GETSWVER', 'GETMEMORY', ...content, 'GETMEMORY', 'GETSWVER'],
      // A fence before each repeat, and a look whether it is still the same timer.
      ...Array(9)
        .fill(['GETSWVER', ...content])
        .flat(),
      // The last fence, and the reading back.
      'GETSWVER',
      ...['GETSWVER', 'GETMEMORY', ...content, ...content, 'GETMEMORY', 'GETSWVER'],
    ]);
  });

  it('a line on which everything is damaged is unstable, not a silent timer', async () => {
    let broken = false;
    const { client, run, clock } = bench({ fromTimer: { fault: (byte) => [broken && byte === 0x45 ? 0x44 : byte] } });
    await run(client.identify());
    broken = true;
    const begin = clock.now();
    await expect(run(client.readProgram())).rejects.toMatchObject({
      code: 'unstable',
      details: { request: 'GETMEMORY', sent: 3 },
    });
    expect(clock.now() - begin).toBeLessThan(20_000);
  });

  it('after a write that was given up for damage, what the timer holds is read back', async () => {
    const { client, run, timer, baseline } = await readBench({
      fromTimer: { fault: (byte) => [byte === 0x66 ? 0x67 : byte] },
    });
    const goal = edited(baseline, [10, 30000]);
    const report = await run(client.writeProgram(goal, { baseline }));
    // The timer holds it all the same.
    expect(report).toMatchObject({ result: 'verified', acknowledged: 0, stopped: null });
    expect(contentOf(timer)).toEqual(goal);
  });

  it('a write whose time is up is still read back', async () => {
    let bad = false;
    let sets = 0;
    const fault = (byte: number): number[] => [bad && byte === 0x45 ? sets % 60 : byte];
    const { client, run, timer, clock } = bench({ fromTimer: { fault } });
    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETSERVO') sets++;
      bad = name === 'SETSERVO' && sets % 15 !== 0;
    };
    const baseline = await run(client.readProgram());
    const goal = everyValueChanged(baseline);
    const told: number[] = [];
    const onProgress = ({ endsBy }: { endsBy: number }): void => void told.push(endsBy);
    const report = await run(client.writeProgram(goal, { baseline, onProgress }));
    expect(clock.now()).toBeLessThanOrEqual(told[0] as number);
    expect(report).toMatchObject({ result: 'differs', stopped: { code: 'unstable' } });
    expect(report.held).toEqual(contentOf(timer));
  });

  it('a write whose time is up before its first value reports the damage, and is read back', async () => {
    let hurt = false;
    // Only each twentieth reply that says which memory is current comes through, and the first of them says another.
    let asked = 0;
    const fault = (byte: number): number[] => [hurt && byte === 0x45 ? asked % 60 : byte];
    const { client, run, timer, line, baseline } = await readBench({ fromTimer: { fault } });
    asked = 0;
    timer.core.onAnswer = ({ name }) => {
      if (name === 'GETMEMORY') asked++;
      hurt = name === 'GETMEMORY' && asked < 80 && asked % 20 !== 0;
      timer.core.memory = asked === 19 ? 1 : 0;
    };
    line.length = 0;
    const report = await run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }));
    expect(report).toMatchObject({
      result: 'differs',
      held: baseline,
      stopped: { code: 'unstable', details: { request: 'SETTIMERS', sent: 0 } },
    });
    expect(line.some(({ frame }) => frame?.code === 0x65)).toBe(false);
  });

  it('a dangerous request does not go out when three fences in a row get no answer', async () => {
    const { client, run, timer, line } = bench({ identity: { timerClass: 'Q' } });
    await run(client.identify());
    timer.core.sleep();
    await run(client.jump().catch(() => {}));
    line.length = 0;
    await expect(run(client.unlockMotor())).rejects.toMatchObject({ code: 'no-answer', details: { sent: 0 } });
    expect(line.map(({ frame }) => frame?.code)).toEqual([0x6b, 0x71, 0x61]);
  });
});

it('the number of repeats is reported while they go on, and begins at zero with each job', async () => {
  let lost = 0;
  const fault = (byte: number): number[] => {
    if (lost === 0 || byte !== 0x61) return [byte];
    lost--;
    return [];
  };
  const { client, run } = bench({ toTimer: { fault } });
  await run(client.identify());
  const told: string[] = [];
  const onProgress = ({ done, repeats }: { done: number; repeats: number }): void => {
    told.push(`${done}: ${repeats}`);
  };
  // Both letters of the request: it is lost whole, twice.
  lost = 4;
  await run(client.readProgram({ onProgress }));
  // What had to be asked again is then not believed on one reading: the second one moves nothing.
  const after = ['59: 4', '110: 4', '110: 4', '110: 4', '129: 4', '156: 4'];
  expect(told).toEqual(['0: 0', '19: 0', '19: 1', '19: 2', '19: 3', '19: 4', ...after]);
  expect(client.repeats).toBe(4);
  told.length = 0;
  lost = 2;
  await run(client.readProgram({ onProgress }));
  expect(told.at(-1)).toBe('156: 2');
  expect(client.repeats).toBe(6);
});
