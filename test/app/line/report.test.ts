import { signal } from '@preact/signals';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { version } from '../../../src/app/browser/version.js';
import { reportText } from '../../../src/app/line/report.js';
import { LineLog } from '../../../src/app/timer/line-log.js';
import type { Session } from '../../../src/app/work/session.js';
import type { TimerClient } from '../../../src/client/index.js';
import { parseCapture } from '../../../src/protocol/index.js';
import { DEFAULT_SETTINGS } from '../../../src/serial/index.js';
import { B536 } from '../../protocol/vectors.js';
import { appBench, connectedBench, run } from '../bench/bench.js';
import { recordingOf } from './line.js';

beforeEach(() => vi.stubGlobal('navigator', { userAgent: 'Mozilla/5.0', platform: 'Win32' }));
function reportOf(connection: object | null, simulated = false): string[] {
  const parts = { log: new LineLog(), link: { simulated: signal(simulated) }, connection: signal(connection) };
  return reportText(parts as unknown as Session).split('\n');
}

describe('a report', () => {
  it('says what a maintainer needs first', () => {
    const client = {
      identity: B536,
      quirksFound: new Map<string, object>([
        ['memory-unknown', {}],
        ['times-rounded', { slot: 3, sent: 1005, held: 1000 }],
      ]),
      quirksAssumed: { bigEndianTimes: false },
      lineErrors: new Map([['framing', 1]]),
      repeats: 3,
      strays: 2,
      delay: 903.4,
    };
    const settings = { ...DEFAULT_SETTINGS, baudRate: 19200, rts: false };
    expect(reportOf({ client, kind: 'ftdi', portKey: 'usb:0403:6001', settings })).toEqual([
      '# Sidus capture 1',
      `# Sidus Timer ${version}`,
      '# Browser: Mozilla/5.0, Win32',
      '# Page: in a browser tab',
      '# Port: ftdi, usb:0403:6001, 19200 8N1, RTS low',
      '# Timer: F1B, firmware 536, 9 functions and DT, 4 memories, 3 servos',
      '# Found: memory-unknown; times-rounded slot 3 sent 1005 held 1000',
      '# Assumed: bigEndianTimes false',
      '# Line: out 0, in 0, damaged 0, errors 0, repeats 3',
      '# Line errors: framing 1',
      '# Unasked frames: 2; latest reply: after 903 ms',
      '',
      '',
    ]);
  });

  it('says what is not known', () => {
    expect(reportOf(null, true).slice(4, 11)).toEqual([
      '# Port: none',
      '# Timer: not identified, simulated',
      '# Found: nothing unusual',
      '# Assumed: nothing',
      '# Line: out 0, in 0, damaged 0, errors 0',
      '# Line errors: none',
      '# Unasked frames: 0; latest reply: in time',
    ]);
  });

  it('has the last 60 entries, and before them the identity of the timer', async () => {
    const { session, editor } = await connectedBench({ quirks: { memoryReplyEmpty: true } });
    const program = editor.working.value;
    for (let i = 0; i < 20; i++) await run(session.reader.read());
    const text = reportText(session);
    expect(text).toContain('# Timer: F1Q, firmware 536, 9 functions and DT, 4 memories, 3 servos\n');
    expect(text).toContain('# Found: memory-unknown\n');
    const { entries, replayable } = recordingOf(text);
    expect(entries).toHaveLength(60);
    expect(replayable).toBe(true);
    const client = session.connection.value?.client as TimerClient;
    for (let i = 0; i < 30; i++) await run(client.send(0x71));
    const later = recordingOf(reportText(session));
    expect(later.entries, '30 requests and their replies, and the exchange that identifies the timer').toHaveLength(62);
    expect(later.replayable).toBe(true);
    await run(session.timer.disconnect());

    const again = await appBench();
    await run(again.session.timer.tryRecording(entries));
    expect(again.editor.working.value, 'a report can be replayed').toEqual(program);
  });

  it('names the port by its kind, also the timer once the line is cut, and contains no times of day', async () => {
    const { session } = await connectedBench({ info: { usbVendorId: 0x0403, usbProductId: 0x6001 } });
    expect(reportText(session)).toContain('# Port: ftdi, usb:0403:6001, 9600 8N1\n');
    expect(reportText(session)).toContain('# Line: out 7, in 7, damaged 0, errors 0, repeats 0\n');
    await run(session.timer.disconnect());
    const text = reportText(session);
    expect(text).toContain('# Timer: F1Q');
    expect(parseCapture(text)[0]?.time).toBe(0);
    expect(text).not.toMatch(/20\d\d-|\d\d:\d\d:\d\d/);
  });
});
