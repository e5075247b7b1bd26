import { describe, expect, test } from 'vitest';
import { VirtualClock } from '../../src/line/index.js';
import { MockSerial } from '../../src/mock-serial/index.js';
import { failure, isPending, openPort, reading, settled } from './helper.js';

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
    expect(port.device.lost).toBe(0);
    serial.unplug(port);
    await expect(third).rejects.toMatchObject({ name: 'NetworkError' });
    expect(port.device.lost).toBe(1);
  });

  test('is discarded when it comes in the tick of a cancel', async () => {
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

  test('does no harm when nobody reads the promise', async () => {
    const { serial, port, device } = await openPort();
    serial.unplug(port);
    void device.write([1]);
    await settled();
  });
});
