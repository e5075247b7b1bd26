import { describe, expect, it, vi } from 'vitest';
import { LineView } from '../../../src/app/line/line-view.js';
import { captureText, parseRecording, readRecording } from '../../../src/app/line/recording.js';
import { LineLog } from '../../../src/app/timer/line-log.js';
import type { TimerClient } from '../../../src/client/index.js';
import { parseCapture } from '../../../src/protocol/index.js';
import { B536, CAPTURE, CAPTURE_PIECES, CAPTURED_POSITIONS } from '../../protocol/vectors.js';
import { cut, fromHex, toHex } from '../../tools/bytes.js';
import { appBench, type BenchOptions, connectedBench, run } from '../bench/bench.js';
import { damage, IDENTIFIED, lineError, recordingOf } from './line.js';

const HEADING = '# Sidus capture 1\n';

async function recorded(...entries: readonly Parameters<LineLog['add']>[0][]) {
  const log = new LineLog();
  entries.forEach(log.add);
  await Promise.resolve();
  return log.entries.value;
}

describe('a saved line', () => {
  it('has notes at the top, what each entry means above it, and times from the first entry on', async () => {
    const [asked, said] = IDENTIFIED as [(typeof IDENTIFIED)[0], (typeof IDENTIFIED)[0]];
    const records = await recorded(
      { ...asked, time: 1_700_000_000_000 },
      { ...said, time: 1_700_000_000_052 },
      lineError('framing', 1_700_000_000_100),
      damage('noise', 'ff fe', 1_700_000_001_500),
    );
    expect(captureText(records, ['Sidus Timer 1.2.3', 'Timer: F1B']).split('\n')).toEqual([
      '# Sidus capture 1',
      '# Sidus Timer 1.2.3',
      '# Timer: F1B',
      '',
      '# Identify · GETSWVER',
      '0.000 > 00 00 00 00 00 03 6b 6b 45',
      '# Identify, reply · GETSWVER: F1B, firmware 536, 9 functions and DT, 4 memories, 3 servos',
      '0.052 < 00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45',
      '# Line error: framing',
      '# Damaged: noise',
      '1.500 < ff fe',
      '',
    ]);
  });

  it('is a capture also when there is nothing in it', () => {
    expect(parseCapture(captureText([], ['a note']))).toEqual([]);
  });
});

describe('a recording', () => {
  it('shows frames, in whatever pieces they were recorded', () => {
    const pieces = cut(fromHex(CAPTURE), CAPTURE_PIECES).map((piece, i) => `0.0${60 + 5 * i} < ${toHex(piece)}`);
    const text = `${HEADING}0.000 > 00 00 00 00 00 03 6b 6b 45
      0.020 < 00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45
      0.050 > 00 00 00 00 00 03 67 67 45\n${pieces.join('\n')}`;
    const { records, entries, replayable } = recordingOf(text);
    expect(records.map(({ time, direction, frame }) => [time, direction, frame?.code])).toEqual([
      [0, 'out', 0x6b],
      [20, 'in', 0x6c],
      [50, 'out', 0x67],
      [90, 'in', 0x68],
    ]);
    expect(toHex(records[3]?.bytes as Uint8Array)).toBe(CAPTURE);
    expect(records[3]?.layout.identity).toEqual(B536);
    expect(entries, 'the entries are the pieces that were recorded').toHaveLength(3 + CAPTURE_PIECES.length);
    expect(replayable).toBe(true);
  });

  it('shows damage, a frame that was cut off too, and never lets the time run backwards', () => {
    const text = `${HEADING}0.000 > 00 00 00 00 00 03 61 61 45
      0.020 < 00 00 00 00 00 19 62 00
      0.030 > 00 00 00 00 00 03 71 71 45
      0.200 < 00 00 00 00 00 04 72 00 72 45 ff
      0.900 > 00 00 00 00`;
    const { records } = recordingOf(text);
    expect(records.map(({ direction, frame, rejected }) => [direction, frame?.code ?? rejected])).toEqual([
      ['out', 0x61],
      ['out', 0x71],
      ['in', 'silence'],
      ['in', 0x72],
      ['in', 'noise'],
    ]);
    expect(records.map(({ time }) => time)).toEqual([0, 30, 30, 200, 200]);
    expect(() => parseCapture(captureText(records, []))).not.toThrow();
  });

  it('shows a frame that was cut off at its end', () => {
    const { records } = recordingOf(`${HEADING}0.000 < 00 00 00 00 00 19 62 00`);
    expect(records.map(({ rejected }) => rejected)).toEqual(['silence']);
  });

  it('cannot be replayed without the identity of the timer', () => {
    const answer = '0.100 < 00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45';
    const question = '0.000 > 00 00 00 00 00 03 6b 6b 45';
    expect(recordingOf(`${HEADING}${question}\n${answer}`).replayable).toBe(true);
    expect(recordingOf(`${HEADING}${answer}`).replayable).toBe(false);
    expect(recordingOf(`${HEADING}${question}`).replayable).toBe(false);
    const tooLate = question.replace('0.000', '0.200');
    expect(recordingOf(`${HEADING}${answer}\n${tooLate}`).replayable).toBe(false);
  });

  it.each<[string, string, number | null]>([
    ['another file', '{"models": []}', null],
    ['an empty file', '', null],
    ['a line of another form', `${HEADING}0.000 > 00\n0.100 = 00`, 3],
    ['half a byte', `${HEADING}\n# a note\n0.000 > 0`, 4],
    ['a time that falls', `${HEADING}2.000 > 00\n1.000 < 00`, 3],
    ['nothing in it', `${HEADING}# a note\n`, null],
  ])('is not %s', (_, text, expected) => {
    expect(parseRecording('x', text)).toEqual({ line: expected });
  });

  it('is not a file that is too large, cannot be read, or does not come within a minute', async () => {
    vi.useFakeTimers();
    const file = (size: number, arrayBuffer: () => Promise<ArrayBuffer>) =>
      readRecording({ name: 'x', size, arrayBuffer } as File);
    const refused = { line: null };
    expect(await file(20_000_000, async () => new ArrayBuffer())).toEqual(refused);
    expect(await file(1, () => Promise.reject(new Error('gone')))).toEqual(refused);
    const silent = expect(file(1, () => new Promise(() => {}))).resolves.toEqual(refused);
    await vi.advanceTimersByTimeAsync(61_000);
    await silent;
  });

  it('shows the newest rows when it is long, older ones on a click, and finds all', async () => {
    const lines = Array.from(
      { length: 1200 },
      (_, i) => `${i}.000 > 00 00 00 00 00 04 73 0${i % 4} 7${3 + (i % 4)} 45`,
    );
    const view = new LineView(new LineLog());
    await view.load(new File([HEADING, lines.join('\n')], 'long.txt'));
    expect(view.found.value).toHaveLength(1200);
    expect(view.shown.value.map(({ number }) => number)).toEqual(Array.from({ length: 100 }, (_, i) => 1200 - i));
    view.showOlder();
    expect(view.shown.value).toHaveLength(200);
    view.setSearch('m2');
    expect(view.found.value).toHaveLength(300);
    expect(view.shown.value.length, 'a search begins with the newest few rows').toBe(100);
  });
});

describe('a session that was saved', () => {
  const badLine: BenchOptions = { fromTimer: { fault: (byte, i) => (i === 40 || i === 90 ? [] : [byte]) } };

  it.each<[string, BenchOptions]>([
    ['a good line', {}],
    ['a line that lost two bytes', badLine],
    ['a timer that answers with other letters', { quirks: { timersReplyAs66: true, memoryReplyEmpty: true } }],
  ])('is the same timer when it is replayed: %s', async (_, options) => {
    const { session, editor } = await connectedBench(options);
    const program = editor.working.value;
    expect(program?.times).toHaveLength(11);
    const text = captureText(session.log.introduced(session.log.entries.value), []);
    await run(session.timer.disconnect());

    const again = await appBench();
    await run(again.session.timer.tryRecording(recordingOf(text).entries));
    expect(again.editor.working.value).toEqual(program);
    expect(again.session.simulated.value, 'a replayed timer counts as a simulated one').toBe(true);
  });

  it('answers although the log no longer has the identity of the timer', async () => {
    const { session, editor } = await connectedBench();
    const program = editor.working.value;
    const client = session.connection.value?.client as TimerClient;
    for (let i = 0; i < 70; i++) {
      for (const code of [0x71, 0x61, 0x67, 0x75]) await run(client.send(code));
    }
    const kept = session.log.entries.value;
    expect(kept.some(({ frame }) => frame?.code === 0x6b)).toBe(false);
    const text = captureText(session.log.introduced(kept), []);
    await run(session.timer.disconnect());

    const again = await appBench();
    await run(again.session.timer.tryRecording(recordingOf(text).entries));
    expect(again.editor.working.value).toEqual(program);
    expect(again.editor.working.value?.positions[0]).toEqual(CAPTURED_POSITIONS);
  });
});
