import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { messages } from '../../../src/app/messages/index.js';
import type { PortRecord } from '../../../src/app/storage/index.js';
import { encodeFrame } from '../../../src/protocol/index.js';
import { DEFAULT_SETTINGS } from '../../../src/serial/index.js';
import { en } from '../../tools/en.js';
import { type AppBench, idle, MemoryStore, run } from '../bench/bench.js';
import { connected, goTo, opened, press } from '../screen.js';

const FTDI = { usbVendorId: 0x0403, usbProductId: 0x6001 };
const KIND = 'timer/Q/536/10/3';

/** What a browser has kept of an adapter at which something was taken for true of an F1Q. */
function kept(quirks: PortRecord['quirks'] = { [KIND]: { bigEndianTimes: true } }): MemoryStore {
  const store = new MemoryStore();
  const settings = { ...DEFAULT_SETTINGS };
  store.ports.records.set('usb:0403:6001', { key: 'usb:0403:6001', usedAt: 1, settings, foundRate: 9600, quirks });
  return store;
}

function quirksKept({ store }: AppBench): unknown {
  return store.ports.records.get('usb:0403:6001')?.quirks;
}

async function about(): Promise<HTMLElement> {
  await goTo('settings');
  const summary = screen.getByText(en.aboutTimer.title);
  fireEvent.click(summary);
  return summary.closest('details') as HTMLElement;
}

describe('what is known to differ can be forgotten', () => {
  it('while no program can be shown, and the timer is then read again without it', async () => {
    const bench = await opened({ store: kept(), info: FTDI, plug: { granted: true } });
    let mute = true;
    const { core } = bench.timer;
    const answer = core.answer.bind(core);
    core.answer = (frame, bare) => (mute && frame.code === 0x67 ? encodeFrame(0x68, [1]) : answer(frame, bare));
    await press('Connect');
    expect(screen.queryByRole('table', { name: /^Time and servo/ })).toBeNull();
    expect(bench.session.connection.value?.client.quirksAssumed).toEqual({ bigEndianTimes: true });
    mute = false;
    await about();
    await press(en.aboutTimer.forget);
    expect(bench.session.connection.value?.client.quirksAssumed).toEqual({});
    expect(bench.editor.baseline.value?.times).toEqual(core.content.times);
    expect(quirksKept(bench)).not.toMatchObject({ [KIND]: { bigEndianTimes: true } });
  });
});

describe('what the line says of the timer', () => {
  it('replies about the idle throttle that are damaged in one way are named, and hide nothing else', async () => {
    const { editor, timer } = await connected({ quirks: { idleThrottleLength3: true } });
    expect(editor.baseline.value).toMatchObject({ times: timer.core.content.times, idleThrottle: null });
    expect(within(await about()).getByText(messages.value.alike.title({ request: 'GETLOWRPM' }))).toBeTruthy();
    expect(screen.queryByText(messages.value.timer.unstable.title)).toBeNull();
  });

  it('positions that are damaged in one way: says so in place of noise, and shows the times', async () => {
    const { session, timer } = await opened({ info: FTDI, quirks: { lengthInSum: ['GETSERVOPOS'] } });
    await press('Connect');
    expect(screen.getByText(messages.value.alike.title({ request: 'GETSERVOPOS' }))).toBeTruthy();
    const said = screen.getByText(/^For looking only/).textContent.replaceAll('\u00a0', ' ');
    expect(said).toMatch(/Motor stop 10\.0 s.*Function 1 time .*DT 3:00 min\. All else is not known\.$/);
    expect(session.editor.baseline.value).toBeNull();
    expect(timer.core.content.times[10]).toBe(18_000);
    expect(screen.queryByText(messages.value.timer.unstable.title)).toBeNull();
  });

  it('answers that nobody asked for bring the warning of another timer', async () => {
    const bench = await connected();
    bench.port.device.write(encodeFrame(0x62, Array<number>(22).fill(0)));
    await press('Read again');
    expect(screen.getByText(en.notes.strays.title)).toBeTruthy();
    expect(within(await about()).getByText(/^Another timer or programmer may be in the beam/)).toBeTruthy();
    expect(bench.session.connection.value?.client.strays).toBe(1);
  });
});

describe('something else than a timer', () => {
  it('is named so, with the bytes that came, and another port is one click away', async () => {
    const bench = await opened({ info: FTDI, plug: { granted: true } });
    bench.timer.core.sleep();
    await press('Connect');
    bench.port.device.write(new TextEncoder().encode('$GPGGA,0927,N\r\n$GPRMC,0928,A\r\n'));
    await idle(3000);
    expect(screen.getByText(en.link.heard.title)).toBeTruthy();
    expect(screen.getByText(/“[^”]*GPRMC,0928,A[^”]*”/)).toBeTruthy();
    const other = bench.serial.plug({ usbVendorId: 0x10c4 });
    bench.serial.choose(other);
    await press(en.header.choosePort);
    expect(bench.session.link.state.value).toMatchObject({ port: other });
  });

  it('an impossible identity is shown as it came', async () => {
    const bench = await opened({ info: FTDI, plug: { granted: true } });
    bench.timer.core.answer = () => encodeFrame(0x6c, [0x51, 0x35, 0x33, 0x36, 0x37, 0x31, 0x20, 10, 4, 3, 0x20]);
    await press('Connect');
    expect(screen.getByText(en.connection['bad-reply'].title)).toBeTruthy();
    expect(screen.getByText('What came: 51 35 33 36 37 31 20 0a 04 03 20 (“Q53671 ··· ”).')).toBeTruthy();
    expect(screen.queryByText(/noisy/)).toBeNull();
  });
});

describe('a choice of memory that is not answered', () => {
  it('is explained with what to try, and the pilot can try it without a correct checksum', async () => {
    const bench = await connected({ quirks: { bareChecksumRequests: true } });
    await run(bench.session.reader.selectMemory(2));
    await idle();
    expect(screen.getByText(en.notes['select-unanswered'].title)).toBeTruthy();
    expect(bench.session.link.state.value.status).toBe('on');
    expect(bench.editor.baseline.value?.memory).toBe(0);
    await press(en.link.trySelectBare);
    await run(bench.session.reader.selectMemory(2));
    expect(bench.timer.core.memory).toBe(2);
    expect(bench.editor.baseline.value?.memory).toBe(2);
  });
});
