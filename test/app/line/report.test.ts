import { afterEach, describe, expect, it, vi } from 'vitest';
import { parseRecording } from '../../../src/app/line/recording.js';
import { gatherFacts, type ReportFacts, reportText } from '../../../src/app/line/report.js';
import type { TimerClient } from '../../../src/client/index.js';
import { parseCapture } from '../../../src/protocol/index.js';
import { DEFAULT_SETTINGS } from '../../../src/serial/index.js';
import { B536 } from '../../protocol/vectors.js';
import { appBench, connectedBench, run } from '../bench/bench.js';

const facts: ReportFacts = {
  version: '1.2.3',
  browser: 'Chromium 140',
  platform: 'Linux',
  installed: false,
  port: { kind: 'ftdi', key: 'usb:0403:6001', settings: { ...DEFAULT_SETTINGS, baudRate: 19200, rts: false } },
  simulated: false,
  identity: B536,
  quirksFound: new Map([
    ['memory-unknown', {}],
    ['times-rounded', { slot: 3, sent: 1005, held: 1000 }],
  ]),
  quirksAssumed: { bigEndianTimes: false },
  counts: { out: 12, in: 10, damaged: 2, errors: 1 },
  lineErrors: new Map([['framing', 1]]),
  repeats: 3,
  strays: 2,
  delay: 903.4,
  entries: [],
};

afterEach(() => vi.unstubAllGlobals());

describe('a report', () => {
  it('says what a maintainer needs first', () => {
    expect(reportText(facts).split('\n')).toEqual([
      '# Sidus capture 1',
      '# Sidus Timer 1.2.3',
      '# Browser: Chromium 140, Linux',
      '# Page: in a browser tab',
      '# Port: ftdi, usb:0403:6001, 19200 8N1, RTS low',
      '# Timer: F1B, firmware 536, 9 functions and DT, 4 memories, 3 servos',
      '# Found: memory-unknown; times-rounded slot 3 sent 1005 held 1000',
      '# Assumed: bigEndianTimes false',
      '# Line: out 12, in 10, damaged 2, errors 1, repeats 3',
      '# Line errors: framing 1',
      '# Unasked frames: 2; latest reply: after 903 ms',
      '',
      '',
    ]);
  });

  it('says what is not known', () => {
    const nothing: ReportFacts = {
      ...facts,
      installed: true,
      port: null,
      simulated: true,
      identity: null,
      quirksFound: new Map(),
      quirksAssumed: {},
      lineErrors: new Map(),
      repeats: null,
      strays: 0,
      delay: null,
    };
    expect(reportText(nothing).split('\n').slice(3, 11)).toEqual([
      '# Page: installed',
      '# Port: none',
      '# Timer: not identified, simulated',
      '# Found: nothing unusual',
      '# Assumed: nothing',
      '# Line: out 12, in 10, damaged 2, errors 1',
      '# Line errors: none',
      '# Unasked frames: 0; latest reply: in time',
    ]);
  });

  it('has the last 60 entries, and before them the identity of the timer', async () => {
    const { session, editor } = await connectedBench({ quirks: { memoryReplyEmpty: true } });
    const program = editor.working.value;
    for (let i = 0; i < 20; i++) await run(session.reader.read());
    const text = reportText(gatherFacts(session));
    expect(text).toContain('# Timer: F1Q, firmware 536, 9 functions and DT, 4 memories, 3 servos\n');
    expect(text).toContain('# Found: memory-unknown\n');
    const { entries, replayable } = parseRecording('report', text);
    expect(entries).toHaveLength(60);
    expect(replayable).toBe(true);
    const client = session.connection.value?.client as TimerClient;
    for (let i = 0; i < 30; i++) await run(client.send(0x71));
    const later = parseRecording('report', reportText(gatherFacts(session)));
    expect(later.entries, '30 requests and their replies, and the exchange that identifies the timer').toHaveLength(62);
    expect(later.replayable).toBe(true);
    await run(session.timer.disconnect());

    const again = await appBench();
    await run(again.session.timer.tryRecording(entries));
    expect(again.editor.working.value, 'a report can be replayed').toEqual(program);
  });

  it('names the port by its kind, and how it was opened', async () => {
    const { session } = await connectedBench({ info: { usbVendorId: 0x0403, usbProductId: 0x6001 } });
    const text = reportText(gatherFacts(session));
    expect(text).toContain('# Port: ftdi, usb:0403:6001, 9600 8N1\n');
    expect(text).toMatch(/^# Line: out 7, in 7, damaged 0, errors 0, repeats 0$/m);
    expect(text).toContain('# Line errors: none\n');
  });

  it('still names the timer when the line is cut, and contains no times of day', async () => {
    const { session } = await connectedBench();
    await run(session.timer.disconnect());
    const text = reportText(gatherFacts(session));
    expect(text).toContain('# Timer: F1Q');
    expect(parseCapture(text)[0]?.time).toBe(0);
    expect(text).not.toMatch(/20\d\d-|\d\d:\d\d:\d\d/);
  });

  it('names the browser by its list of brands, without the invented one', async () => {
    const { session } = await appBench();
    const brands = [
      { brand: 'Not?A_Brand', version: '24' },
      { brand: 'Chromium', version: '140' },
      { brand: 'Microsoft Edge', version: '140' },
    ];
    vi.stubGlobal('navigator', {
      userAgent: 'Mozilla/5.0',
      platform: 'Win32',
      userAgentData: { brands, platform: 'Windows' },
    });
    expect(gatherFacts(session)).toMatchObject({ browser: 'Chromium 140, Microsoft Edge 140', platform: 'Windows' });
    vi.stubGlobal('navigator', { userAgent: 'Mozilla/5.0', platform: 'Win32' });
    expect(gatherFacts(session)).toMatchObject({ browser: 'Mozilla/5.0', platform: 'Win32' });
  });
});
