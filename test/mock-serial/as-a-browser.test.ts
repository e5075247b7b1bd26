import { describe, expect, test } from 'vitest';
import { type ChromiumWays, MockSerial } from '../../src/mock-serial/index.js';
import { collect, counted, failure, isPending, type OpenPort, openPort, reading, settled, writing } from './helper.js';

/* What a real Chromium does, seen with 160 small programs, where the mock port once did something else. */

describe('a loss', () => {
  test('is not forgotten by a cancel: there is no stream after it', async () => {
    const { serial, port, device } = await openPort();
    device.write([1, 2, 3]);
    const reader = reading(port);
    serial.unplug(port);
    await reader.cancel();
    reader.releaseLock();
    expect(port.readable).toBeNull();
  });

  test('does not disturb a writer that closes with nothing to send: it resolves, and writable is a new stream', async () => {
    const { serial, port } = await openPort();
    const { writable } = port;
    const writer = writing(port);
    serial.unplug(port);
    await writer.close();
    expect(port.writable).not.toBe(writable);
    expect(await failure(writing(port).write(Uint8Array.of(1)))).toBe('NetworkError');
    expect(port.writable).toBeNull();
  });
});

describe('bytes', () => {
  test('are copied inside write(): the page may use its array again', async () => {
    const { port, device } = await openPort();
    const bytes = Uint8Array.of(1, 2, 3);
    const writer = writing(port);
    for (const _ of ['the first write', 'a later one']) {
      bytes.set([1, 2, 3]);
      const written = writer.write(bytes);
      bytes.fill(9);
      expect(await device.read()).toEqual(Uint8Array.of(1, 2, 3));
      await written;
    }
  });

  test('of a resizable buffer are refused, and of a view on one', async () => {
    const Resizable = ArrayBuffer as unknown as new (length: number, of: { maxByteLength: number }) => ArrayBuffer;
    for (const make of [(of: ArrayBuffer) => of, (of: ArrayBuffer) => new Uint8Array(of)]) {
      const { port } = await openPort();
      const chunk = make(new Resizable(4, { maxByteLength: 8 })) as Uint8Array;
      expect(await failure(writing(port).write(chunk))).toBe('TypeError');
    }
  });

  test('that the device wrote in the tick of a cancel are discarded', async () => {
    const { port, device } = await openPort();
    const reader = reading(port);
    const written = failure(device.write([1, 2, 3]));
    const cancelled = reader.cancel();
    expect(await written).toBe('NetworkError');
    await cancelled;
    reader.releaseLock();
    void device.write([4]);
    expect((await reading(port).read()).value).toEqual(Uint8Array.of(4));
  });

  test('of a burst larger than the buffer all reach a page that waits', async () => {
    const { port, device } = await openPort();
    const reader = reading(port);
    const first = reader.read();
    await settled();
    device.write(counted(300));
    const begin = [...((await first).value ?? [])];
    const rest = await collect(async () => (await reader.read()).value, 300 - begin.length);
    expect(Uint8Array.from([...begin, ...rest])).toEqual(counted(300));
    expect(device.lost).toBe(0);
  });
});

describe('Web IDL', () => {
  test('takes null for no list', async () => {
    const serial = new MockSerial({ userActivation: true });
    const options = { allowedBluetoothServiceClassIds: null } as unknown as object;
    expect(await failure(serial.requestPort(options))).toBe('TypeError');
  });

  test('gives the members of a dictionary in the order of their names', async () => {
    const serial = new MockSerial();
    const port = serial.plug({ usbVendorId: 1, usbProductId: 2 });
    expect(Object.keys(port.getInfo())).toEqual(['usbProductId', 'usbVendorId']);
    const opened = await openPort();
    const names = ['clearToSend', 'dataCarrierDetect', 'dataSetReady', 'ringIndicator'];
    opened.device.setSignals({ ringIndicator: true, clearToSend: true });
    expect(Object.keys(await opened.port.getSignals())).toEqual(names);
    const looped = await openPort({}, { loopback: true });
    expect(Object.keys(await looped.port.getSignals())).toEqual(names);
  });

  test('lets a handler be an object that cannot be called, and one that returns false cancel', () => {
    const serial = new MockSerial();
    const port = serial.plug();
    const handler = {};
    port.onconnect = handler as never;
    expect(port.onconnect).toBe(handler);
    expect(port.dispatchEvent(new Event('connect', { cancelable: true }))).toBe(true);
    port.onconnect = (() => false) as never;
    expect(port.dispatchEvent(new Event('connect', { cancelable: true }))).toBe(false);
  });

  test('gives each object its name, and members that are seen', () => {
    const serial = new MockSerial();
    const port = serial.plug();
    expect([`${serial}`, `${port}`]).toEqual(['[object Serial]', '[object SerialPort]']);
    expect(Object.keys(MockSerial.prototype).sort()).toEqual(['getPorts', 'onconnect', 'ondisconnect', 'requestPort']);
    for (const member of ['onconnect', 'connected', 'readable', 'writable', 'open', 'close', 'forget', 'getInfo']) {
      expect(Object.keys(Object.getPrototypeOf(port)), member).toContain(member);
    }
  });
});

test('connected does not change any more after forget()', async () => {
  const { serial, port } = await openPort();
  await port.forget();
  serial.unplug(port);
  expect(port.connected).toBe(true);
});

describe('ways of Chromium, each by its name', () => {
  async function ported(ways: ChromiumWays | boolean): Promise<OpenPort> {
    const serial = new MockSerial({ chromium: ways, userActivation: true });
    const port = serial.plug({}, { granted: true });
    await port.open({ baudRate: 9600 });
    return { serial, port, device: port.device };
  }

  test.each([true, false])(
    'lostWriteEndsStream %s: the stream fails by itself after the first lost write',
    async (lostWriteEndsStream) => {
      const { serial, port } = await ported({ firstLostWriteResolves: true, lostWriteEndsStream });
      const writer = writing(port);
      const closed = writer.closed.then(
        () => 'closed',
        ({ name }) => name,
      );
      serial.unplug(port);
      await writer.write(Uint8Array.of(1));
      if (lostWriteEndsStream) expect(await closed).toBe('NetworkError');
      else expect(await isPending(closed)).toBe(true);
      expect(port.writable === null).toBe(lostWriteEndsStream);
      expect(await failure(writer.write(Uint8Array.of(1)))).toBe('NetworkError');
    },
  );

  test.each([true, false])(
    'onceNeverFires %s: once misses the events of the browser, not those of the page',
    async (onceNeverFires) => {
      const { serial, port } = await ported({ onceNeverFires });
      const heard: string[] = [];
      serial.addEventListener('disconnect', () => heard.push('of the browser'), { once: true });
      serial.addEventListener('connect', () => heard.push('of the page'), { once: true });
      port.addEventListener('disconnect', () => heard.push('at the port'), { once: true });
      serial.unplug(port);
      await settled();
      serial.dispatchEvent(new Event('connect'));
      expect(heard).toEqual(['at the port', ...(onceNeverFires ? [] : ['of the browser']), 'of the page']);
    },
  );

  test.each([true, false])('failedCloseKills %s: readable after a close that failed', async (failedCloseKills) => {
    const { port } = await ported({ failedCloseKills });
    expect(port.readable).not.toBeNull();
    const writer = writing(port);
    expect(await failure(port.close())).toBe('TypeError');
    if (failedCloseKills) expect(() => port.readable).toThrow('kills the tab');
    else expect(port.readable).not.toBeNull();
    writer.releaseLock();
    await port.close();
    expect(port.readable).toBeNull();
  });

  test.each([true, false])('closingHidesReadable %s: readable during close', async (closingHidesReadable) => {
    const { port } = await ported({ closingHidesReadable });
    expect(port.readable && port.writable).not.toBeNull();
    const closed = port.close();
    expect(port.readable === null).toBe(closingHidesReadable);
    await closed;
  });

  test.each([true, false])('breakComesLast %s: bytes after a break in the same burst', async (breakComesLast) => {
    const { port, device } = await ported({ breakComesLast });
    device.write([1]);
    device.error('break');
    device.write([2]);
    await settled();
    const reader = reading(port);
    const bytes: number[] = [];
    let name = '';
    while (name === '') {
      try {
        bytes.push(...((await reader.read()).value ?? []));
      } catch (error) {
        name = (error as Error).name;
      }
    }
    expect([name, bytes]).toEqual(['BreakError', breakComesLast ? [1, 2] : [1]]);
  });

  test.each([true, false])(
    'forgottenStreamReturns %s: the stream after forget and a new grant',
    async (forgottenStreamReturns) => {
      const { serial, port, device } = await ported({ forgottenStreamReturns });
      const { readable } = port;
      device.write([1, 2]);
      await settled();
      await port.forget();
      serial.choose(port);
      await serial.requestPort();
      await port.open({ baudRate: 9600 });
      expect(port.readable === readable).toBe(forgottenStreamReturns);
      const read = reading(port).read();
      if (forgottenStreamReturns) expect((await read).value).toEqual(Uint8Array.of(1, 2));
      else expect(await isPending(read)).toBe(true);
    },
  );

  test('bufferNeverOverruns: bytes wait for room', async () => {
    const { port, device } = await ported({ bufferNeverOverruns: true });
    void device.write(counted(1000));
    await settled();
    const reader = reading(port);
    expect(await collect(async () => (await reader.read()).value, 1000)).toEqual([...counted(1000)]);
    expect(device.lost).toBe(0);
  });

  test.each([true, false])('openRaisesRts %s', async (openRaisesRts) => {
    const { device } = await ported({ openRaisesRts });
    expect(device.signals.requestToSend).toBe(openRaisesRts);
  });

  test('are all on with true, and none with false', async () => {
    expect((await ported(true)).device.signals.requestToSend).toBe(true);
    expect((await ported(false)).device.signals.requestToSend).toBe(false);
  });
});
