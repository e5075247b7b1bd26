import { describe, expect, it } from 'vitest';
import { type JobKind, stoppedBy } from '../../../src/app/timer/job-runner.js';
import { TimerError } from '../../../src/client/index.js';
import { type AppBench, connectedBench, idle, run } from '../bench/bench.js';

function notice({ session }: AppBench): string | undefined {
  return session.notices.current.value?.code;
}

describe('a job', () => {
  it('returns the error that ended it, and shows no message', async () => {
    const bench = await connectedBench();
    const failure = new RangeError('not foreseen');
    const end = await run(
      bench.session.runner.perform('bench', async () => {
        throw failure;
      }),
    );
    expect([end, notice(bench)]).toEqual([{ good: false, error: failure, lost: false }, undefined]);
    expect(await run(bench.session.runner.perform('bench', async () => {}))).toEqual({ good: true });
  });

  it('does not begin while another one uses the line, or without a connection', async () => {
    const bench = await connectedBench();
    const reading = bench.session.reader.read();
    const begun: string[] = [];
    const work = async () => void begun.push('work');
    expect(await bench.session.runner.perform('bench', work)).toEqual({ good: false, error: null, lost: false });
    await run(reading);
    await run(bench.session.timer.disconnect());
    expect(await bench.session.runner.perform('bench', work)).toEqual({ good: false, error: null, lost: true });
    expect(begun).toEqual([]);
  });

  it('must not continue when the connection is new, it was stopped, or it is no longer safe', async () => {
    const bench = await connectedBench();
    const stillOn = async (change: () => void): Promise<unknown> => {
      bench.session.safety.confirm();
      let fault: unknown = null;
      await run(
        bench.session.runner.perform('bench', async (_, options) => {
          options.stillOn();
          change();
          await idle(10);
          try {
            options.stillOn();
          } catch (error) {
            fault = error;
          }
        }),
      );
      return fault;
    };
    expect(await stillOn(() => {})).toBeNull();
    expect(await stillOn(() => bench.session.runner.stop())).toMatchObject({ code: 'aborted' });
    expect(await stillOn(() => bench.session.safety.withdraw())).toMatchObject({ code: 'aborted' });
    expect(await stillOn(() => bench.adapter.unplug())).toMatchObject({ code: 'closed' });
  });

  it('is shown from its beginning to its end, with its progress', async () => {
    const bench = await connectedBench();
    const { runner } = bench.session;
    const seen: unknown[] = [];
    runner.job.subscribe((job) => seen.push(job && [job.kind, job.memory, job.progress?.done ?? null, job.stopping]));
    const progress = { stage: 'read', done: 2, total: 4, fraction: 0.5, repeats: 0, endsBy: 100, memory: 3 } as const;
    let late = (): void => {};
    const job = runner.run(
      'look',
      async (_, { onProgress }) => {
        onProgress(progress);
        late = () => onProgress({ ...progress, done: 3 });
      },
      3,
    );
    expect([await run(job), runner.ready.value]).toEqual([true, true]);
    const next = runner.run('read', async () => late());
    await run(next);
    expect(seen, 'progress that comes late is not shown for the next job').toEqual([
      null,
      ['look', 3, null, false],
      ['look', 3, 2, false],
      null,
      ['read', null, null, false],
      null,
    ]);
  });

  it.each<[JobKind, boolean]>([
    ['read', false],
    ['select', false],
    ['look', false],
    ['bench', false],
    ['frame', false],
    ['write', true],
    ['memories', true],
  ])('is busy as %s, and must not be cut off: %s', async (kind, writing) => {
    const { runner } = (await connectedBench()).session;
    const job = runner.run(kind, () => idle(100));
    expect([runner.busy.value, runner.ready.value, runner.writing.value]).toEqual([true, false, writing]);
    await run(job);
    expect([runner.busy.value, runner.ready.value, runner.writing.value]).toEqual([false, true, false]);
  });

  it('ends before the caller of stop continues', async () => {
    const { runner } = (await connectedBench()).session;
    const order: string[] = [];
    const job = runner.perform('memories', async (_, { signal, stillOn }) => {
      await new Promise((resolve) => signal.addEventListener('abort', resolve));
      order.push(`stopping ${runner.job.value?.stopping}`);
      stillOn();
    });
    const stopped = runner.stop().then(() => order.push(`over ${runner.busy.value}`));
    expect(await run(job)).toMatchObject({ good: false, error: { code: 'aborted' }, lost: false });
    await stopped;
    expect(order).toEqual(['stopping true', 'over false']);
    await run(runner.stop());
  });

  const answers: [string, boolean, (bench: AppBench) => void][] = [
    ['the pilot agrees', true, ({ session }) => session.runner.answer(true)],
    ['the pilot does not', false, ({ session }) => session.runner.answer(false)],
    ['it is asked to stop', false, ({ session }) => void session.runner.stop()],
    ['the plug is pulled', false, ({ adapter }) => adapter.unplug()],
  ];

  it.each(answers)('with a question waits, and may be cut off, until %s: %s', async (_, goesOn, answer) => {
    const bench = await connectedBench();
    const { runner } = bench.session;
    const job = runner.perform('write', (_, { ask }) => ask());
    expect([runner.job.value?.asking, runner.busy.value, runner.writing.value]).toEqual([true, true, false]);
    answer(bench);
    await idle(100);
    expect(await job).toEqual({ good: true, value: goesOn });
    runner.answer(true);
    expect(runner.job.value).toBeNull();
  });

  it('asks no question about a lost connection', async () => {
    const bench = await connectedBench();
    const job = bench.session.runner.perform('write', async (_, { ask }) => {
      bench.adapter.unplug();
      await idle(100);
      return await ask();
    });
    expect(await run(job)).toEqual({ good: true, value: false });
  });

  it('gets the code of what stopped it, and a lost connection is not a stop by the pilot', () => {
    const aborted = new TimerError('aborted', 'stopped on request');
    const end = { good: false } as const;
    expect(stoppedBy({ ...end, error: aborted, lost: false })).toBe('aborted');
    expect(stoppedBy({ ...end, error: aborted, lost: true })).toBe('port-lost');
    expect(stoppedBy({ ...end, error: new RangeError('?'), lost: false })).toBe('unexpected');
    expect(stoppedBy({ ...end, error: null, lost: true })).toBe('closed');
  });
});

it('a dialog that shows what is about to be sent keeps the bench from sending anything', async () => {
  const { bench, session } = await connectedBench();
  session.safety.confirm();
  expect(bench.ready.value).toBe(true);
  session.runner.claim(true);
  expect([bench.ready.value, await bench.moveTo(3), session.runner.busy.value]).toEqual([false, false, false]);
  session.runner.claim(false);
  expect(bench.ready.value).toBe(true);
});

it('the message of a job is shown again after a reading without a message of its own', async () => {
  const { notices } = (await connectedBench()).session;
  const again = async (work: () => void) => {
    notices.say('nothing-written');
    await notices.keepThrough(async () => {
      notices.dismiss();
      work();
    });
    return notices.current.value?.code;
  };
  expect([await again(() => {}), await again(() => notices.say('timer-moved'))]).toEqual([
    'nothing-written',
    'timer-moved',
  ]);
  notices.sayIfSilent('strays');
  expect(notices.current.value?.code).toBe('timer-moved');
});
