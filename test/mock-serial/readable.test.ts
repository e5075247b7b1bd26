import { describe, expect, test } from 'vitest';
import type { ReadErrorKind } from '../../src/mock-serial/index.js';
import { collect, counted, failure, isPending, openPort, reading, settled } from './helper.js';

const DATA = counted(8);

describe('readable attribute: byte stream', () => {
  test('fills a buffer that is larger than its own in several reads', async () => {
    const { port, device } = await openPort({ bufferSize: 64, flowControl: 'hardware' });
    const reader = port.readable?.getReader({ mode: 'byob' }) as ReadableStreamBYOBReader;
    for (let from = 0; from < 1024; from += 64) device.write(counted(1024).slice(from, from + 64));
    const all = await collect(async () => (await reader.read(new Uint8Array(1024))).value, 1024);
    expect(Uint8Array.from(all)).toEqual(counted(1024));
  });

  test('errors and ends for such a reader too', async () => {
    const { port, device } = await openPort();
    const reader = port.readable?.getReader({ mode: 'byob' }) as ReadableStreamBYOBReader;
    const read = failure(reader.read(new Uint8Array(8)));
    await settled();
    device.error('parity');
    expect(await read).toBe('ParityError');
    const second = port.readable?.getReader({ mode: 'byob' }) as ReadableStreamBYOBReader;
    const ended = second.read(new Uint8Array(8));
    await second.cancel();
    expect((await ended).done).toBe(true);
  });
});

const RECOVERABLE: readonly (readonly [ReadErrorKind, string])[] = [
  ['break', 'BreakError'],
  ['framing', 'FramingError'],
  ['parity', 'ParityError'],
  ['overrun', 'BufferOverrunError'],
  ['system', 'UnknownError'],
];

describe('readable attribute: errors', () => {
  test.each(RECOVERABLE)('%s: bytes first, then %s, then a new stream', async (kind, name) => {
    const { port, device } = await openPort({ bufferSize: 64 });
    const { readable } = port;
    const reader = reading(port);
    device.write(DATA);
    device.error(kind);
    device.write([9]);
    expect((await reader.read()).value).toEqual(DATA);
    const error = await reader.read().catch((reason) => reason);
    expect(error).toBeInstanceOf(DOMException);
    expect(error.name).toBe(name);
    expect(port.readable).not.toBe(readable);
    expect((await reading(port).read()).value).toEqual(Uint8Array.of(9));
  });

  test('bytes that come between two reads keep their place before an error, in a stream after an error too', async () => {
    const { port, device } = await openPort();
    const first = reading(port);
    device.write([1]);
    await first.read();
    device.write([2]);
    device.error('framing');
    await settled();
    expect((await first.read()).value).toEqual(Uint8Array.of(2));
    expect(await failure(first.read())).toBe('FramingError');
    const second = reading(port);
    device.write([3]);
    device.error('break');
    await settled();
    expect((await second.read()).value).toEqual(Uint8Array.of(3));
    expect(await failure(second.read())).toBe('BreakError');
  });

  test('lost: bytes first, then NetworkError, then null until the port is opened again', async () => {
    const { port, device } = await openPort({ bufferSize: 64 });
    const reader = reading(port);
    device.write(DATA);
    device.error('lost');
    device.write([9]);
    expect((await reader.read()).value).toEqual(DATA);
    expect(await failure(reader.read())).toBe('NetworkError');
    expect(port.readable).toBeNull();
    expect(device.lost).toBe(1);
    await port.close();
    await port.open({ baudRate: 9600 });
    device.write([10]);
    expect((await reading(port).read()).value).toEqual(Uint8Array.of(10));
  });

  test('an error while the port is closed is dropped', async () => {
    const { port, device } = await openPort();
    await port.close();
    device.error('break');
    await settled();
    await port.open({ baudRate: 9600 });
    expect(await isPending(reading(port).read())).toBe(true);
  });
});

describe('readable attribute: bufferSize', () => {
  test('an overflow gives what the buffer held, then BufferOverrunError, then a new stream', async () => {
    const { port, device } = await openPort({ bufferSize: 16 });
    const reader = reading(port);
    device.write(counted(10));
    device.write(counted(10));
    device.write(counted(3));
    await settled();
    expect(device.lost).toBe(7);
    const held = await collect(async () => (await reader.read()).value, 16);
    expect(held).toEqual([...counted(10), ...counted(6)]);
    expect(await failure(reader.read())).toBe('BufferOverrunError');
    device.write([99]);
    expect((await reading(port).read()).value).toEqual(Uint8Array.of(99));
  });

  test('hardware flow control: the device waits for room, and an error keeps its place', async () => {
    const { port, device } = await openPort({ bufferSize: 16, flowControl: 'hardware' });
    device.write(counted(40));
    device.error('parity');
    await settled();
    const reader = reading(port);
    expect((await reader.read()).value).toEqual(counted(16));
    expect(await collect(async () => (await reader.read()).value, 24)).toEqual([...counted(40).slice(16)]);
    expect(await failure(reader.read())).toBe('ParityError');
    expect(device.lost).toBe(0);
  });
});

describe('readable attribute: cancel', () => {
  test('discards what the buffer holds, errors too; a new stream takes what comes later', async () => {
    const { port, device } = await openPort({ bufferSize: 4 });
    const { readable } = port;
    device.write(counted(10));
    device.error('break');
    await settled();
    const cancelled = port.readable?.cancel();
    expect(port.readable).toBe(readable);
    await cancelled;
    expect(port.readable).not.toBe(readable);
    device.write(counted(4));
    expect((await reading(port).read()).value).toEqual(counted(4));
  });
});
