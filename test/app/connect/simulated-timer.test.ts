import { describe, expect, it, vi } from 'vitest';
import { plugRecording, plugSimulatedTimer } from '../../../src/app/connect/simulated-timer.js';
import { TimerClient } from '../../../src/client/index.js';
import { withValue } from '../../../src/program/index.js';
import { parseCapture } from '../../../src/protocol/index.js';
import { fromHex } from '../../tools/bytes.js';

describe('a simulated timer', () => {
  it('answers in the background, where timeouts are not called in time', async () => {
    vi.spyOn(document, 'hidden', 'get').mockReturnValue(true);
    vi.stubGlobal('setTimeout', () => 0);
    const port = plugSimulatedTimer('Q');
    await port.open({ baudRate: 9600 });
    const timer = new TimerClient(port);
    expect(await timer.identify()).toMatchObject({ timerClass: 'Q' });
    expect((await timer.readProgram()).times).toHaveLength(11);
    await timer.close();
    await port.close();
  });

  it('holds what was written to it when it is connected again, and the others hold their own', async () => {
    const connected = async (timerClass: 'Q' | 'B') => {
      const port = plugSimulatedTimer(timerClass);
      await port.open({ baudRate: 9600 });
      const timer = new TimerClient(port);
      await timer.identify();
      const end = async () => {
        await timer.close();
        await port.close();
      };
      return { timer, end };
    };
    const first = await connected('Q');
    await first.timer.selectMemory(1);
    const before = await first.timer.readProgram();
    const goal = withValue(before, { kind: 'position', servo: 1, slot: 2 }, 77);
    expect((await first.timer.writeProgram(goal, { baseline: before })).result).toBe('verified');
    await first.end();
    const other = await connected('B');
    expect((await other.timer.readProgram()).memory).toBe(0);
    await other.end();
    const second = await connected('Q');
    expect(await second.timer.readProgram()).toEqual(goal);
    await second.end();
  });

  it('that was recorded answers again after its port was closed before an answer came', async () => {
    vi.useFakeTimers();
    const question = '00 00 00 00 00 03 6b 6b 45';
    const answer = '00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45';
    const port = plugRecording(parseCapture(`# Sidus capture 1\n0.000 > ${question}\n0.050 < ${answer}\n`));
    const ask = async (): Promise<void> => {
      await port.open({ baudRate: 9600 });
      await port.writable?.getWriter().write(fromHex(question));
    };
    await ask();
    await port.close();
    await vi.advanceTimersByTimeAsync(200);
    await ask();
    const read = port.readable?.getReader().read();
    await vi.advanceTimersByTimeAsync(200);
    expect((await read)?.value).toEqual(fromHex(answer));
  });
});
