import { runInNewContext } from 'node:vm';
import { describe, expect, test, vi } from 'vitest';
import { VirtualClock } from '../../src/line/index.js';
import { MockSerial } from '../../src/mock-serial/index.js';
import { failure, isPending, openPort, reading, settled, writing } from './helper.js';

/*
 * Where a mock mostly differs from a browser in some small thing that a page can stumble over. Each was seen in a real
 * Chromium, or stands in the Web Serial standard or in Web IDL.
 */

describe('after an unplug', () => {
  test('a stream that nobody had fetched is there, and its read rejects', async () => {
    const { serial, port } = await openPort();
    serial.unplug(port);
    const { readable, writable } = port;
    expect(readable && writable).not.toBeNull();
    expect(await failure(reading(port).read())).toBe('NetworkError');
    expect(port.readable).toBeNull();
    expect(port.writable).toBe(writable);
    expect(await failure(writing(port).write(Uint8Array.of(1)))).toBe('NetworkError');
    expect(port.writable).toBeNull();
  });

  test('writable lives on when only reading has failed', async () => {
    const { port, device } = await openPort();
    const { writable } = port;
    const read = failure(reading(port).read());
    device.error('lost');
    expect(await read).toBe('NetworkError');
    expect([port.readable, port.writable]).toEqual([null, writable]);
    await writing(port).write(Uint8Array.of(1));
    expect(await device.read()).toEqual(Uint8Array.of(1));
  });

  test('a wired port comes back as another object, and the old one cannot be opened any more', async () => {
    const { serial, port, device } = await openPort();
    serial.unplug(port);
    const again = serial.replug(port);
    expect(again).not.toBe(port);
    expect(again.getInfo()).toEqual(port.getInfo());
    expect(await serial.getPorts()).toEqual([again]);
    await port.close();
    expect(await failure(port.open({ baudRate: 9600 }))).toBe('NetworkError');
    expect([port.connected, again.connected]).toEqual([false, true]);
    await again.open({ baudRate: 9600 });
    expect(again.device, 'the new port object has the same device').toBe(device);
    device.write([7]);
    expect((await reading(again).read()).value).toEqual(Uint8Array.of(7));
  });

  test('a Bluetooth port stays the same object, and is known while it is off', async () => {
    const serial = new MockSerial();
    const port = serial.plug({ bluetoothServiceClassId: 0x1101 }, { granted: true });
    serial.unplug(port);
    expect(await serial.getPorts()).toEqual([port]);
    expect(port.connected).toBe(false);
    expect(serial.replug(port)).toBe(port);
    await port.open({ baudRate: 9600 });
  });
});

describe('a chunk', () => {
  test('of another realm is taken', async () => {
    const { port, device } = await openPort();
    const writer = writing(port);
    await writer.write(runInNewContext('new Uint8Array([1, 2])') as Uint8Array);
    await writer.write(runInNewContext('new Uint8Array([3, 4]).buffer') as Uint8Array);
    expect([...(await device.read()), ...(await device.read())]).toEqual([1, 2, 3, 4]);
  });

  test('that was refused prevents the port from closing, for ever', async () => {
    const { port, device } = await openPort();
    const writer = writing(port);
    await failure(writer.write('ab' as unknown as Uint8Array));
    writer.releaseLock();
    const closing = port.close();
    expect(await isPending(closing)).toBe(true);
    expect(device.opened).not.toBeNull();
    expect(await failure(port.open({ baudRate: 9600 }))).toBe('InvalidStateError');
  });
});

describe('what was not read', () => {
  test('is delivered after forget(), before the read rejects', async () => {
    const { port, device } = await openPort();
    const reader = reading(port);
    device.write([1, 2]);
    await settled();
    await port.forget();
    expect((await reader.read()).value).toEqual(Uint8Array.of(1, 2));
    expect(await failure(reader.read())).toBe('NetworkError');
    expect(port.readable).toBeNull();
  });

  test('and was held back, counts as lost', async () => {
    const serial = new MockSerial();
    const port = serial.plug({}, { backpressure: true });
    await port.open({ baudRate: 9600, bufferSize: 4 });
    port.device.write([1, 2, 3, 4, 5, 6]);
    await settled();
    expect(port.device.lost).toBe(0);
    serial.unplug(port);
    expect(port.device.lost).toBe(2);
  });
});

describe('what the device has written', () => {
  test('is kept: the promise resolves once the bytes are in the buffer of the port', async () => {
    const clock = new VirtualClock();
    const serial = new MockSerial({ clock });
    const port = serial.plug({}, { timing: true });
    await port.open({ baudRate: 1000 });
    const written = port.device.write([1, 2]);
    await clock.advance(19);
    expect(await isPending(written)).toBe(true);
    await clock.advance(1);
    await written;
  });

  test.each<[string, (serial: MockSerial, port: Awaited<ReturnType<typeof openPort>>['port']) => unknown]>([
    ['the port is unplugged', (serial, port) => serial.unplug(port)],
    ['the port is closed', (_, port) => port.close()],
    ['the buffer is full', () => {}],
  ])('is not: the promise rejects when %s', async (_, harm) => {
    const { serial, port, device } = await openPort({ bufferSize: 4 });
    await harm(serial, port);
    const written = device.write([1, 2, 3, 4, 5]);
    await expect(written).rejects.toMatchObject({ name: 'NetworkError' });
    expect(device.lost).toBeGreaterThan(0);
  });

  test('waits while the device is held back, and rejects for what is cut off then', async () => {
    const serial = new MockSerial();
    const port = serial.plug({}, { backpressure: true });
    await port.open({ baudRate: 9600, bufferSize: 2 });
    const first = port.device.write([1, 2]);
    const second = port.device.write([3]);
    const third = port.device.write([4, 5]);
    await first;
    expect(await isPending(second)).toBe(true);
    await reading(port).read();
    await second;
    serial.unplug(port);
    await expect(third).rejects.toMatchObject({ name: 'NetworkError' });
  });

  test('does no harm when nobody reads the promise', async () => {
    const { serial, port, device } = await openPort();
    serial.unplug(port);
    void device.write([1]);
    await settled();
  });
});

describe('as Web IDL has it', () => {
  const seen: string[] = [];
  /** Says in which order it is looked at. */
  const watched = <T extends object>(values: T): T =>
    new Proxy(values, {
      get: (target, name) => {
        if (typeof name === 'string') seen.push(name);
        return Reflect.get(target, name);
      },
    });

  test('dictionaries are read in the order of their keys', async () => {
    const { serial, port } = await openPort();
    serial.userActivation = true;
    seen.length = 0;
    await port.setSignals(watched({ requestToSend: true, dataTerminalReady: true, break: false }));
    expect(seen.splice(0)).toEqual(['break', 'dataTerminalReady', 'requestToSend']);
    await port.close();
    await port.open(watched({ stopBits: 1, parity: 'none', baudRate: 9600 }));
    expect(seen.splice(0)).toEqual(['baudRate', 'bufferSize', 'dataBits', 'flowControl', 'parity', 'stopBits']);
    serial.choose(port);
    await failure(serial.requestPort(watched({ filters: [watched({ usbVendorId: 1 })] })));
    expect(seen).toEqual([
      'allowedBluetoothServiceClassIds',
      'filters',
      'bluetoothServiceClassId',
      'usbProductId',
      'usbVendorId',
    ]);
  });

  test('a BigInt is not a number', async () => {
    const port = new MockSerial().plug();
    expect(await failure(port.open({ baudRate: 9600n as unknown as number }))).toBe('TypeError');
  });

  test('signals become true or false', async () => {
    const { port, device } = await openPort();
    await port.setSignals({ dataTerminalReady: 0, requestToSend: 'yes' } as unknown as { dataTerminalReady: boolean });
    expect(device.signals).toEqual({ dataTerminalReady: false, requestToSend: true, break: false });
    expect(await failure(port.setSignals(5 as unknown as object))).toBe('TypeError');
    expect(await failure(port.setSignals(null as unknown as object)), 'null gives no signal to set').toBe('TypeError');
  });

  test('the numbers of a filter are converted: text, and what is too large', async () => {
    const serial = new MockSerial({ userActivation: true });
    const port = serial.plug({ usbVendorId: 0x0403, usbProductId: 0x6001 });
    serial.choose(port);
    const filter = (usbVendorId: unknown) => serial.requestPort({ filters: [{ usbVendorId: usbVendorId as number }] });
    expect(await filter('0x0403')).toBe(port);
    expect(await filter(0x10403)).toBe(port);
    expect(await filter(1027.9)).toBe(port);
    expect(await failure(filter(1027n))).toBe('TypeError');
  });

  test.each([5, 'ab', {}, [5], ['ab']])(
    'filters that are not a list of filters are a TypeError: %j',
    async (filters) => {
      const serial = new MockSerial();
      expect(await failure(serial.requestPort({ filters: filters as unknown as [] }))).toBe('TypeError');
    },
  );

  test('a listener may be missing, and its options may be null', () => {
    const serial = new MockSerial();
    const heard = vi.fn();
    serial.addEventListener('connect', heard, null as unknown as undefined);
    serial.addEventListener('connect', undefined as unknown as null);
    serial.removeEventListener('connect', undefined as unknown as null);
    expect(() => serial.addEventListener('connect', 5 as unknown as null)).toThrow(TypeError);
    serial.dispatchEvent(new Event('connect'));
    expect(heard).toHaveBeenCalledOnce();
    serial.removeEventListener('connect', heard, null as unknown as undefined);
    serial.dispatchEvent(new Event('connect'));
    expect(heard).toHaveBeenCalledOnce();
  });

  test('a handler keeps its place among the listeners when another takes it', () => {
    const serial = new MockSerial();
    const heard: string[] = [];
    serial.onconnect = () => heard.push('handler');
    serial.addEventListener('connect', () => heard.push('listener'));
    serial.onconnect = () => heard.push('another handler');
    serial.dispatchEvent(new Event('connect'));
    expect(heard.splice(0)).toEqual(['another handler', 'listener']);
    serial.onconnect = null;
    serial.onconnect = () => heard.push('a late handler');
    serial.dispatchEvent(new Event('connect'));
    expect(heard).toEqual(['listener', 'a late handler']);
  });
});
