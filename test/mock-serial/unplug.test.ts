import { describe, expect, test } from 'vitest';
import { MockSerial } from '../../src/mock-serial/index.js';
import { failure, isPending, openPort, reading, settled, timed, writing } from './helper.js';

describe('an open port whose device is unplugged', () => {
  test('writable: a write that waits fails with NetworkError; then null', async () => {
    const { serial, port } = await timed({}, 9600, 1);
    const written = failure(writing(port).write(Uint8Array.of(1, 2)));
    await settled();
    serial.unplug(port);
    expect(await written).toBe('NetworkError');
    expect(port.writable).toBeNull();
  });

  test('writable: closing that waits for bytes to leave fails with NetworkError; then null', async () => {
    const before = await timed();
    const writer = writing(before.port);
    await writer.write(Uint8Array.of(1));
    const closed = failure(writer.close());
    await settled();
    before.serial.unplug(before.port);
    expect(await closed).toBe('NetworkError');
    expect(before.port.writable).toBeNull();
  });

  test('does not recover by itself when the device is back', async () => {
    const { serial, port } = await openPort();
    const read = failure(reading(port).read());
    await settled();
    serial.unplug(port);
    serial.replug(port, { samePort: true });
    expect(await read).toBe('NetworkError');
    expect(port.readable).toBeNull();
    expect(port.connected).toBe(true);
    await port.close();
  });

  test('can be opened though it was unplugged while closed', async () => {
    const serial = new MockSerial();
    const port = serial.plug();
    serial.unplug(port);
    serial.replug(port, { samePort: true });
    await port.open({ baudRate: 9600 });
    await writing(port).write(Uint8Array.of(1));
    expect(await port.device.read()).toEqual(Uint8Array.of(1));
    port.device.write([2]);
    expect((await reading(port).read()).value).toEqual(Uint8Array.of(2));
  });
});

test('a Bluetooth port stays the same object, and is known while it is off', async () => {
  const serial = new MockSerial();
  const port = serial.plug({ bluetoothServiceClassId: 0x1101 }, { granted: true });
  serial.unplug(port);
  expect(await serial.getPorts()).toEqual([port]);
  expect(serial.replug(port)).toBe(port);
  await port.open({ baudRate: 9600 });
});

test('events are fired only for a port that the site may use, and once', async () => {
  const serial = new MockSerial({ userActivation: true });
  const seen: string[] = [];
  serial.onconnect = serial.ondisconnect = ({ type }) => seen.push(type);
  const port = serial.plug();
  serial.choose(port);
  await serial.requestPort();
  serial.replug(port, { samePort: true });
  await settled();
  expect(seen).toEqual([]);
  serial.unplug(port);
  serial.unplug(port);
  expect(seen).toEqual([]);
  await settled();
  expect(seen).toEqual(['disconnect']);
});

describe('the device that is unplugged', () => {
  test('reads what had arrived, then empty arrays, until it is plugged in again', async () => {
    const { serial, port, device } = await openPort();
    const waiting = device.read();
    const writer = writing(port);
    await writer.write(Uint8Array.of(1));
    expect(await waiting).toEqual(Uint8Array.of(1));
    const ended = device.read();
    serial.unplug(port);
    expect((await ended).length).toBe(0);
    expect((await device.read()).length).toBe(0);
    serial.replug(port, { samePort: true });
    const again = device.read();
    expect(await isPending(again)).toBe(true);
    writer.releaseLock();
    await port.close();
    await port.open({ baudRate: 9600 });
    await writing(port).write(Uint8Array.of(2));
    expect(await again).toEqual(Uint8Array.of(2));
  });

  test('loses what it writes, and what is on its way', async () => {
    const { serial, port, device } = await openPort();
    const reader = reading(port);
    device.write([1]);
    serial.unplug(port);
    device.write([2, 3]);
    await settled();
    expect(device.lost).toBe(2);
    expect(await failure(reader.read())).toBe('NetworkError');
  });

  test('is not known to another MockSerial', async () => {
    const port = new MockSerial().plug();
    const other = new MockSerial();
    const refusal = new TypeError('The port was not plugged in here.');
    expect(() => other.unplug(port)).toThrow(refusal);
    expect(() => other.replug(port)).toThrow(refusal);
  });
});
