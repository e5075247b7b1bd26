import { describe, expect, it } from 'vitest';
import { plugRecording } from '../../../src/app/connect/simulated-timer.js';
import { parseCapture } from '../../../src/protocol/index.js';

const RECORDING = `# Sidus capture 1
0.000 > 00 00 00 00 00 03 6b 6b 45
0.050 < 00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45
`;
const QUESTION = Uint8Array.of(0, 0, 0, 0, 0, 3, 0x6b, 0x6b, 0x45);

/** For a busy machine. */
const PATIENT = { timeout: 60_000 };

describe('a recorded timer', () => {
  it('answers again after its port was closed before an answer came', async () => {
    const port = plugRecording(parseCapture(RECORDING));
    const ask = async (): Promise<void> => {
      await port.open({ baudRate: 9600 });
      const writer = port.writable?.getWriter();
      await writer?.write(QUESTION);
      writer?.releaseLock();
    };
    await ask();
    await port.close();
    // The answer is due 50 ms after the question, and finds nobody.
    await new Promise((resolve) => setTimeout(resolve, 200));
    await ask();
    let answer: Uint8Array | undefined;
    void port.readable
      ?.getReader()
      .read()
      .then(({ value }) => (answer = value));
    await expect.poll(() => answer?.length, PATIENT).toBe(18);
  });
});
