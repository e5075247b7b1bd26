import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { LineEntry, TimerClient, TimerClientOptions } from '../../src/client/index.js';
import type { TimerProgram } from '../../src/program/index.js';
import { bench, contentOf, edited, readBench } from './bench.js';

type Callback = Required<Pick<TimerClientOptions, 'onLine'>>['onLine'];
type OnProgress = (() => void) | undefined;
type Job = (client: TimerClient, baseline: TimerProgram, onProgress: OnProgress) => Promise<unknown>;

const JOBS: Readonly<Record<string, Job>> = {
  'a reading': (client, _, onProgress) => client.readProgram({ onProgress }),
  'a write': (client, baseline, onProgress) =>
    client.writeProgram(edited(baseline, [10, 30000], [1, 4, 99]), { baseline, onProgress }),
  'a memory round trip': (client, _, onProgress) => client.readMemories({ onProgress }),
  'a write into several memories': (client, baseline, onProgress) =>
    client.writeMemories(
      [1, 3].map((memory) => ({ ...edited(baseline, [10, 30000]), memory })),
      { onProgress },
    ),
};

/** Runs a job with these callbacks, and tells all that can be told of it. */
async function outcome(job: Job, onLine: Callback | undefined, onProgress: OnProgress) {
  const sent: number[] = [];
  const fault = (byte: number): number[] => {
    sent.push(byte);
    return [byte];
  };
  const { client, timer, run, baseline } = await readBench(
    { identity: { timerClass: 'Q' }, toTimer: { fault } },
    { onLine },
  );
  const report = await run(job(client, baseline, onProgress)).catch((error: unknown) => error);
  return { sent, report, held: contentOf(timer), memories: timer.core.memories };
}

const trouble = new Error('the trouble of the consumer');
const reported = vi.fn();

beforeEach(() => {
  reported.mockClear();
  vi.stubGlobal('reportError', reported);
});
afterEach(() => vi.unstubAllGlobals());

describe.each(Object.entries(JOBS))('%s', (_, job) => {
  it('is the same on the wire and in its report when onLine throws at any one entry', async () => {
    let entries = 0;
    const silent = await outcome(job, () => void entries++, undefined);
    expect(silent.report).not.toBeInstanceOf(Error);
    for (let at = 0; at < entries; at++) {
      let seen = 0;
      const onLine = (): void => {
        if (seen++ === at) throw trouble;
      };
      reported.mockClear();
      expect(await outcome(job, onLine, undefined)).toEqual(silent);
      expect(reported.mock.calls).toEqual([[trouble]]);
    }
  });

  it('is the same on the wire and in its report when onProgress throws each time', async () => {
    const onProgress = vi.fn(() => {
      throw trouble;
    });
    expect(await outcome(job, undefined, onProgress)).toEqual(await outcome(job, undefined, undefined));
    expect(onProgress).toHaveBeenCalled();
    expect(reported).toHaveBeenCalledTimes(onProgress.mock.calls.length);
  });
});

it('when onLost throws, the loss of the port is still reported, and the running job rejects', async () => {
  const onLost = vi.fn(() => {
    throw trouble;
  });
  const { client, timer, run } = bench({}, { onLost });
  await run(client.identify());
  timer.core.onAnswer = () => timer.cut();
  await expect(run(client.readProgram())).rejects.toMatchObject({ code: 'port-lost' });
  expect(onLost).toHaveBeenCalledTimes(1);
  expect(reported.mock.calls).toEqual([[trouble]]);
});

it('without reportError, an error of a callback is thrown after the job', async () => {
  vi.stubGlobal('reportError', undefined);
  const later: (() => void)[] = [];
  vi.stubGlobal('queueMicrotask', (work: () => void) => later.push(work));
  const onLine = vi.fn((_: LineEntry) => {
    throw trouble;
  });
  const { client, run } = bench({}, { onLine });
  await run(client.identify());
  const [first] = later.filter((work) => work.toString().includes('throw'));
  expect(first).toThrow(trouble);
});
