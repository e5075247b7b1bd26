import { describe, expect, test } from 'vitest';
import { MockSerial } from '../../src/mock-serial/index.js';
import { collect, counted, failure, openPort, reading, settled, writing } from './helper.js';

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

  test('ends the loop of the standard', async () => {
    const { serial, port } = await openPort();
    let turns = 0;
    const loop = async (): Promise<void> => {
      while (port.readable && turns++ < 5) {
        const reader = port.readable.getReader();
        serial.unplug(port);
        await reader.cancel().catch(() => {});
        reader.releaseLock();
      }
    };
    await loop();
    expect(turns).toBe(1);
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
