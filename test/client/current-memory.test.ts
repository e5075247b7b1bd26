import { describe, expect, it } from 'vitest';
import { isNoAnswer } from '../../src/client/current-memory.js';
import { TimerError } from '../../src/client/index.js';
import { COMMANDS } from '../../src/protocol/index.js';
import { answering, type Bench, bench, contentOf, edited, readBench } from './bench.js';

/** How often the timer was asked which memory is current. */
function counting({ line }: Bench): () => number {
  const asked = (): number =>
    line.filter(({ direction, frame }) => direction === 'out' && frame?.code === COMMANDS.GETMEMORY.request).length;
  let before = 0;
  return () => {
    const now = asked() - before;
    before += now;
    return now;
  };
}

describe('a timer that does not answer which memory is current', () => {
  it('is still read; the question goes out six times, and only twice from then on', async () => {
    const made = bench();
    const { client, timer, run } = made;
    await run(client.identify());
    answering(timer, 'GETMEMORY', () => null);
    const count = counting(made);
    expect(await run(client.readProgram())).toEqual({ ...contentOf(timer), memory: null });
    expect([[...client.quirksFound.keys()], count()]).toEqual([['memory-unknown'], 6]);
    await run(client.readProgram());
    expect(count()).toBe(2);
  });

  it('can be written: the reading had no current memory either', async () => {
    const { client, timer, run } = bench();
    answering(timer, 'GETMEMORY', () => null);
    const baseline = await run(client.readProgram());
    const report = await run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }));
    expect([report.result, report.held?.memory]).toEqual(['verified', null]);
  });

  it('is an error, and not a quirk, when a job has to select a memory', async () => {
    const { client, timer, run } = bench();
    await run(client.identify());
    answering(timer, 'GETMEMORY', () => null);
    const silent = { code: 'no-answer', details: { request: 'GETMEMORY', sent: 10 } };
    await expect(run(client.selectMemory(2))).rejects.toMatchObject(silent);
    await expect(run(client.readMemories())).rejects.toMatchObject(silent);
    expect([...client.quirksFound.keys()]).toEqual([]);
  });
});

describe('an answer that names another memory than the one that was read', () => {
  it('is not believed when it comes once', async () => {
    const { client, timer, run, baseline } = await readBench();
    answering(timer, 'GETMEMORY', (count) => (count === 0 ? [1] : undefined));
    const report = await run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }));
    expect(report.result).toBe('verified');
  });

  it('stops a write before its first value when it no longer names a memory', async () => {
    const { client, timer, run, baseline } = await readBench();
    answering(timer, 'GETMEMORY', () => []);
    const writing = run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }));
    await expect(writing).rejects.toMatchObject({ code: 'memory-unknown', details: { expected: 0, found: null } });
  });

  it('is asked for until two agree, when the first answer was impossible', async () => {
    const made = bench();
    const { client, timer, run } = made;
    answering(timer, 'GETMEMORY', (count) => [[200], [4]][count]);
    const count = counting(made);
    expect((await run(client.readProgram())).memory).toBe(0);
    expect([[...client.quirksFound.keys()], client.quirksAssumed]).toEqual([[], {}]);
    expect(count(), 'GETMEMORY goes out until two answers agree, and once at the end').toBe(5);
  });
});

describe('an impossible memory', () => {
  it('one beyond the last, counted from 0, is the last of a timer that counts from 1', async () => {
    const { client, timer, run } = bench();
    answering(timer, 'GETMEMORY', () => [4]);
    expect((await run(client.readProgram())).memory).toBe(3);
    expect([[...client.quirksFound.keys()], client.quirksAssumed]).toEqual([
      ['memories-from-one'],
      { memoriesFromOne: true },
    ]);
  });

  it.each([
    [5, false, 5],
    [5, true, 5],
    [6, true, 6],
  ])('%i, where memories count from 1: %s, is reported as it was on the wire', async (index, memoriesFromOne, told) => {
    const { client, timer, run } = bench({}, { quirks: { memoriesFromOne } });
    answering(timer, 'GETMEMORY', () => [index]);
    expect((await run(client.readProgram())).memory).toBeNull();
    expect(client.quirksFound.get('memory-impossible')).toEqual({ index: told });
    expect([client.quirksFound.has('memories-from-one'), client.quirksAssumed]).toEqual([false, { memoriesFromOne }]);
  });

  it('0 takes back that the timer counts from 1', async () => {
    const { client, timer, run } = bench();
    answering(timer, 'GETMEMORY', (count) => (count < 2 ? [4] : [0]));
    expect((await run(client.readProgram())).memory).toBe(0);
    expect([[...client.quirksFound.keys()], client.quirksAssumed]).toEqual([[], {}]);
  });

  it('is asked for once more where one answer would have been enough, and not where two have agreed', async () => {
    const made = bench();
    const { client, timer, run } = made;
    await run(client.identify());
    answering(timer, 'GETMEMORY', () => [200]);
    const count = counting(made);
    await run(client.request({ name: 'GETTIMERS' }));
    expect(count()).toBe(0);
    await expect(run(client.readMemories())).rejects.toMatchObject({ code: 'memory-unknown' });
    expect(count(), 'GETMEMORY goes out twice').toBe(2);
    await run(client.readProgram());
    expect(count(), 'GETMEMORY goes out twice at the beginning and twice at the end').toBe(4);
  });
});

it.each<[string, unknown, boolean, boolean]>([
  ['no answer came', new TimerError('no-answer', ''), true, true],
  ['no answer made sense', new TimerError('bad-reply', ''), true, true],
  ['only damage came: this counts where the timer is known not to answer', new TimerError('unstable', ''), false, true],
  ['the port is lost', new TimerError('port-lost', ''), false, false],
  ['something else is broken', new RangeError('no-answer'), false, false],
])('whether a question stays unanswered: %s', (_, error, unknown, known) => {
  expect([isNoAnswer(error, false), isNoAnswer(error, true)]).toEqual([unknown, known]);
});
