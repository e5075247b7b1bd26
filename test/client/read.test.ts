import { describe, expect, it } from 'vitest';
import { TimerError } from '../../src/client/index.js';
import { wireTime } from '../../src/line/index.js';
import { exchangeSize } from '../../src/protocol/index.js';
import { B536, CAPTURE, CAPTURE_PIECES, CAPTURED_POSITIONS } from '../protocol/vectors.js';
import { toHex } from '../tools/bytes.js';
import { bench, contentOf, names } from './bench.js';

describe('identify', () => {
  it('asks for the version and gives what the timer says', async () => {
    const { client, run, line } = bench();
    expect(await run(client.identify())).toEqual(B536);
    expect(line.map(({ direction, bytes }) => `${direction} ${toHex(bytes)}`)).toEqual([
      'out 00 00 00 00 00 03 6b 6b 45',
      'in 00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45',
    ]);
  });

  it('says after three requests that a sleeping timer did not answer, when no reply can come any more', async () => {
    const { client, timer, run, clock, line } = bench();
    timer.core.sleep();
    const begin = clock.now();
    const error = await run(client.identify().catch((e: unknown) => e));
    expect(error).toBeInstanceOf(TimerError);
    expect(error).toMatchObject({ code: 'no-answer', details: { request: 'GETSWVER' } });
    expect(line.filter(({ direction }) => direction === 'out')).toHaveLength(3);
    expect(clock.now() - begin).toBe(3000);
  });

  it('asks only as often as it is told to, and says that no answer came', async () => {
    const { client, timer, run } = bench();
    timer.core.sleep();
    await expect(run(client.identify({ tries: 1 }))).rejects.toMatchObject({ code: 'no-answer', details: { sent: 1 } });
  });
});

describe('read program', () => {
  it('gives the captured positions for each servo, however the reply is cut', async () => {
    const { client, run, line } = bench({ fromTimer: { chunks: CAPTURE_PIECES } });
    const program = await run(client.readProgram());
    expect(program.positions).toEqual([CAPTURED_POSITIONS, CAPTURED_POSITIONS, CAPTURED_POSITIONS]);
    expect(line.map(({ bytes }) => toHex(bytes))).toContain(CAPTURE);
  });

  it('asks B for memory, times and positions, and Q for the idle throttle too', async () => {
    const b = bench();
    const programB = await b.run(b.client.readProgram());
    expect(names(b.timer.core.answered)).toEqual([
      'GETSWVER',
      'GETMEMORY',
      'GETTIMERS',
      'GETSERVOPOS',
      'GETMEMORY',
      'GETSWVER',
    ]);
    expect(programB).toEqual(contentOf(b.timer));
    expect(programB.idleThrottle).toBeNull();

    const q = bench({ identity: { timerClass: 'Q' } });
    const programQ = await q.run(q.client.readProgram());
    expect(names(q.timer.core.answered).slice(3)).toEqual(['GETSERVOPOS', 'GETLOWRPM', 'GETMEMORY', 'GETSWVER']);
    expect(programQ).toEqual(contentOf(q.timer));
    expect(programQ.idleThrottle).toBe(30);
  });

  it('fits any layout', async () => {
    for (const identity of [
      { functions: 1, memories: 1, servos: 1 },
      { functions: 20, memories: 5, servos: 2 },
      { functions: 125, memories: 9, servos: 2 },
    ]) {
      const { client, timer, run } = bench({ identity });
      expect(await run(client.readProgram())).toEqual(contentOf(timer));
    }
  });

  it('reports progress in bytes, from nothing to all', async () => {
    const { client, run } = bench();
    const seen: string[] = [];
    await run(client.readProgram({ onProgress: ({ stage, done, total }) => seen.push(`${stage} ${done}/${total}`) }));
    expect(seen).toEqual(['read 0/156', 'read 19/156', 'read 59/156', 'read 110/156', 'read 129/156', 'read 156/156']);
  });

  it.each([9600, 115_200])('takes no longer at %i baud than its bytes do', async (baudRate) => {
    const { client, run, clock } = bench({ baudRate }, { baudRate });
    const identity = await run(client.identify());
    const begin = clock.now();
    await run(client.readProgram());
    const bytes = (['GETMEMORY', 'GETTIMERS', 'GETSERVOPOS', 'GETMEMORY', 'GETSWVER'] as const)
      .map((name) => exchangeSize(name, identity))
      .reduce((sum, { request, reply }) => sum + request + reply, 0);
    expect((clock.now() - begin) / wireTime(bytes, baudRate)).toBeLessThan(1.05);
  });

  it('is refused when stopped before it begins, and stops within one reply during the reading', async () => {
    const { client, timer, run } = bench({ latency: 50 });
    await run(client.identify());
    const before = AbortSignal.abort();
    await expect(run(client.readProgram({ signal: before }))).rejects.toMatchObject({ code: 'aborted' });
    expect(names(timer.core.answered)).toEqual(['GETSWVER']);

    const onTheWay = new AbortController();
    timer.core.onAnswer = ({ name }) => name === 'GETTIMERS' && onTheWay.abort();
    await expect(run(client.readProgram({ signal: onTheWay.signal }))).rejects.toMatchObject({ code: 'aborted' });
    expect(names(timer.core.answered)).toEqual(['GETSWVER', 'GETMEMORY', 'GETTIMERS']);
    timer.core.onAnswer = undefined;
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
  });

  it('tells everyone who waits that the port is lost when the cable is pulled', async () => {
    const { client, timer, run, clock } = bench({ latency: 20 });
    await run(client.identify());
    timer.core.onAnswer = ({ name }) => name === 'GETTIMERS' && timer.cut();
    const begin = clock.now();
    const both = Promise.allSettled([client.readProgram(), client.identify()]);
    expect(await run(both)).toMatchObject([{ reason: { code: 'port-lost' } }, { reason: { code: 'port-lost' } }]);
    expect(clock.now() - begin, 'both fail at once').toBeLessThan(100);
  });
});
