import { afterEach, describe, expect, it, vi } from 'vitest';
import { plugSimulatedTimer } from '../../../src/app/connect/simulated-timer.js';
import { TimerClient } from '../../../src/client/index.js';

describe('a simulated timer', () => {
  afterEach(() => {
    vi.unstubAllGlobals();
    vi.restoreAllMocks();
  });

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
});
