import { describe, expect, it } from 'vitest';
import { TimerClient } from '../../src/client/index.js';
import { toHex } from '../tools/bytes.js';
import { bench, contentOf, names } from './bench.js';
import { FieldLine } from './field-line.js';

const outgoing = (line: readonly { direction: string; bytes: Uint8Array }[]): string[] =>
  line.filter(({ direction }) => direction === 'out').map(({ bytes }) => toHex(bytes));

describe('a frame sent by hand', () => {
  it('gets length and checksum, before the timer has said what it is, and the answer comes back', async () => {
    const { client, run, line, clock } = bench();
    const begin = clock.now();
    expect(await run(client.send(0x6b))).toMatchObject({ code: 0x6c });
    expect(outgoing(line)).toEqual(['00 00 00 00 00 03 6b 6b 45']);
    expect(client.identity).toBeNull();
    const answer = await run(client.send(0x63, [10, 2, 65]));
    expect(answer).toEqual({ code: 0x64, data: new Uint8Array(0) });
    expect(outgoing(line)[1]).toBe('00 00 00 00 00 06 63 0a 02 41 b0 45');
    expect(clock.now(), 'nothing is waited for, because no older reply can still come').toBe(begin);
  });

  it('goes out once, and null means that nobody answered', async () => {
    const { client, run, line, timer, clock } = bench();
    const begin = clock.now();
    expect(await run(client.send(0x79, [1, 2]))).toBeNull();
    timer.core.sleep();
    expect(outgoing(line)).toHaveLength(1);
    // What nobody knows may have the longest of all replies.
    expect(clock.now() - begin).toBeLessThan(600 + 300);
  });

  it.each([
    [0x6d, 'UNLOCK'],
    [0x6f, 'JUMP2'],
    [0x65, 'SETTIMERS'],
  ])('with letter %i is not repeated when the answer is lost', async (code) => {
    let deaf = false;
    const { client, run, line } = bench({ fromTimer: { fault: (byte) => (deaf ? [] : [byte]) } });
    await run(client.identify());
    deaf = true;
    line.length = 0;
    expect(await run(client.send(code, code === 0x65 ? Array(22).fill(1) : []))).toBeNull();
    expect(line.map(({ frame }) => frame?.code)).toEqual([code]);
  });

  it('does not get the late answer of an earlier frame, and a later question does not get its answer', async () => {
    for (const later of ['by hand', 'asked']) {
      const { timer, clock, run } = bench();
      const line = new FieldLine(timer, clock);
      const client = new TimerClient(line.open(), { clock });
      await run(client.identify());
      line.arm('in', 5, { delay: 900 });
      expect(await run(client.send(0x71))).toBeNull();
      // Its answer, memory 0, comes when the next one waits.
      timer.core.memory = 1;
      if (later === 'by hand') expect(await run(client.send(0x71))).toMatchObject({ data: Uint8Array.of(1) });
      else expect(await run(client.readProgram())).toEqual(contentOf(timer));
    }
  });

  it('is not answered by a late reply to an earlier request', async () => {
    const { timer, clock, run } = bench();
    const line = new FieldLine(timer, clock);
    const client = new TimerClient(line.open(), { clock });
    await run(client.identify());
    line.arm('in', 0, { delay: 900 });
    timer.core.onAnswer = () => timer.core.sleep();
    await expect(run(client.moveToFunction(3))).rejects.toMatchObject({ code: 'no-answer' });
    expect(await run(client.send(0x69, [4]))).toBeNull();
    expect(timer.core.slot).toBe(3);
  });

  it('waits for its turn, and goes out without an answered fence once no older reply can come', async () => {
    const { client, run, timer, line, clock } = bench({ latency: 10 });
    const reading = client.readProgram();
    const answer = client.send(0x71);
    await run(reading);
    expect(await run(answer)).toMatchObject({ code: 0x72 });
    expect(line.at(-1)?.frame?.code).toBe(0x72);
    timer.core.sleep();
    await run(client.send(0x71));
    const begin = clock.now();
    expect(await run(client.send(0x73, [1]))).toBeNull();
    expect(line.filter(({ frame }) => frame?.code === 0x73)).toHaveLength(1);
    expect(clock.now() - begin).toBeLessThan(5000);
  });

  it('goes out as soon as the fence before it is answered', async () => {
    const { client, run, timer, clock } = bench();
    timer.core.sleep();
    await run(client.send(0x71));
    timer.core.press();
    const begin = clock.now();
    expect(await run(client.send(0x71))).toMatchObject({ code: 0x72 });
    expect(clock.now() - begin).toBeLessThan(100);
    expect(names(timer.core.answered)).toEqual(['GETSWVER', 'GETMEMORY']);
  });

  it.each<[string, (client: TimerClient, signal: AbortSignal) => Promise<unknown>]>([
    ['by hand', (client, signal) => client.send(0x6d, [], { signal })],
    ['as a command', (client, signal) => client.unlockMotor({ signal })],
  ])('%s does not go out when asked to stop while the fence before it is answered', async (_, unlock) => {
    const { client, run, timer } = bench({ identity: { timerClass: 'Q' } });
    await run(client.identify());
    timer.core.sleep();
    await run(client.send(0x71));
    timer.core.press();
    const stop = new AbortController();
    timer.core.onAnswer = () => stop.abort();
    await expect(run(unlock(client, stop.signal))).rejects.toMatchObject({ code: 'aborted' });
    expect(names(timer.core.answered)).toEqual(['GETSWVER', 'GETSWVER']);
    expect(timer.core.motorLocked).toBe(true);
  });

  it('is refused when it is no frame, or when asked to stop before', async () => {
    const { client, run, line } = bench();
    await expect(run(client.send(256))).rejects.toMatchObject({ name: 'CodecError', code: 'out-of-range' });
    await expect(run(client.send(1, Array(253).fill(0)))).rejects.toMatchObject({ code: 'wrong-length' });
    await expect(run(client.send(0x6b, [], { signal: AbortSignal.abort() }))).rejects.toMatchObject({
      code: 'aborted',
    });
    expect(outgoing(line)).toEqual([]);
  });
});
