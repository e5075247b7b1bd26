import { describe, expect, it } from 'vitest';
import { TimerClient, TimerError } from '../../src/client/index.js';
import { bench, contentOf, edited, names } from './bench.js';
import { everyValueChanged } from './matrix.js';

const COMMAND_NAMES = ['a reading', 'a write', 'a memory round trip'] as const;

describe.each([900, 2000, 2900])('a timer that answers after %i ms', (latency) => {
  const slow = () => bench({ identity: { timerClass: 'Q' }, latency, baudRate: 9600 });

  it('is found, and read without being called noisy', async () => {
    const { client, timer, run } = slow();
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
    expect(client.damageSeen).toBe(false);
    expect(client.strays).toBe(0);
    expect(client.delay).toBeGreaterThanOrEqual(latency);
    expect(client.delay).toBeLessThan(latency + 100);
    expect(client.margin).toBe(Math.min(3000, Math.ceil(1.5 * (client.delay as number))));
  });

  it('gets no question twice once its delay is known', async () => {
    const { client, timer, run, clock } = slow();
    await run(client.readProgram());
    const { repeats } = client;
    timer.core.answered.length = 0;
    const begin = clock.now();
    await run(client.readProgram());
    expect(client.repeats).toBe(repeats);
    expect(clock.now() - begin).toBeLessThan((latency + 300) * timer.core.answered.length);
  });

  it.each(COMMAND_NAMES)('%s ends well, within the predicted time', async (name) => {
    const { client, timer, run, clock } = slow();
    const baseline = await run(client.readProgram());
    let endsBy = 0;
    const onProgress = (progress: { readonly endsBy: number }): void => {
      endsBy = progress.endsBy;
    };
    const goal = everyValueChanged(baseline);
    if (name === 'a write') {
      const report = await run(client.writeProgram(goal, { baseline, onProgress }));
      expect(report).toMatchObject({ result: 'verified', stopped: null, held: contentOf(timer) });
      expect(contentOf(timer)).toEqual(goal);
    } else if (name === 'a reading') await run(client.readProgram({ onProgress }));
    else expect((await run(client.readMemories({ onProgress }))).programs).toHaveLength(4);
    expect(clock.now()).toBeLessThanOrEqual(endsBy);
  });

  it('lets a write end in a verdict although it became slow only after the reading', async () => {
    let late = false;
    const { clock, timer, run } = bench();
    const replies = new TransformStream<Uint8Array, Uint8Array>({
      transform(bytes, controller) {
        if (late) clock.after(latency, () => controller.enqueue(bytes));
        else controller.enqueue(bytes);
      },
    });
    const client = new TimerClient(
      { readable: timer.readable.pipeThrough(replies), writable: timer.writable },
      { clock },
    );
    const baseline = await run(client.readProgram());
    late = true;
    const told: number[] = [];
    const onProgress = ({ endsBy }: { readonly endsBy: number }): void => void told.push(endsBy);
    const goal = edited(baseline, [10, 30000], [1, 4, 99]);
    const report = await run(client.writeProgram(goal, { baseline, onProgress }));
    expect(report).toMatchObject({ result: 'verified', stopped: null });
    expect(contentOf(timer)).toEqual(goal);
    expect(clock.now()).toBeLessThanOrEqual(told.at(-1) as number);
  });
});

it('a timer is not taken for slow while it sleeps, or on a line that loses bytes', async () => {
  const fault = (byte: number, index: number): number[] => (index % 97 === 50 ? [] : [byte]);
  const { client, timer, run } = bench({ fromTimer: { fault } });
  await run(client.readProgram());
  timer.core.sleep();
  await expect(run(client.readProgram())).rejects.toBeInstanceOf(TimerError);
  timer.core.press();
  await run(client.readProgram());
  expect(client).toMatchObject({ delay: null, margin: 600 });
  expect(names(timer.core.answered).length).toBeGreaterThan(8);
});
