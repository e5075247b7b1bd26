import { describe, expect, test } from 'vitest';
import { collect, counted, detach, failure, isPending, openPort, settled, writing } from './helper.js';

const DATA = counted(8);

describe('writable attribute: writing', () => {
  test('resolves as soon as the buffer has taken the chunk', async () => {
    const { port, device } = await openPort({ bufferSize: 8 });
    const writer = writing(port);
    await writer.write(DATA);
    const second = writer.write(DATA);
    expect(await isPending(second)).toBe(true);
    await device.read();
    await second;
  });

  test('more than the buffer holds goes on as the device reads', async () => {
    const { port, device } = await openPort({ bufferSize: 64 });
    const writer = writing(port);
    const written = writer.write(counted(1024));
    writer.releaseLock();
    expect(await isPending(written)).toBe(true);
    const read = await collect(() => device.read(), 1024);
    expect(Uint8Array.from(read)).toEqual(counted(1024));
    await written;
    await port.close();
  });

  test('the stream wants as many bytes as the buffer has', async () => {
    const { port } = await openPort({ bufferSize: 100 });
    expect(writing(port).desiredSize).toBe(100);
  });
});

describe('writable attribute: chunks', () => {
  test.each([
    ['an array', (bytes: Uint8Array) => bytes],
    ['a DataView', (bytes: Uint8Array) => new DataView(bytes.buffer)],
    ['an ArrayBuffer', (bytes: Uint8Array) => bytes.buffer],
  ])('a detached one is as empty: %s (Web IDL, copy of a buffer source)', async (_, make) => {
    const { port } = await openPort({ bufferSize: 64 });
    const bytes = counted(64);
    const chunk = make(bytes);
    detach(bytes);
    await writing(port).write(chunk as Uint8Array);
  });

  test('one that is detached while it waits for room ends there', async () => {
    const { port, device } = await openPort({ bufferSize: 64 });
    const bytes = counted(1024);
    const written = writing(port).write(bytes);
    const read = await collect(() => device.read(), 512);
    detach(bytes);
    expect(Uint8Array.from(read)).toEqual(counted(512));
    await device.read();
    await written;
    expect(await isPending(device.read())).toBe(true);
  });

  test('one is read no sooner than there is room for it', async () => {
    const { port, device } = await openPort({ bufferSize: 2 });
    const bytes = Uint8Array.of(1, 2, 3, 4);
    const written = writing(port).write(bytes);
    await settled();
    bytes.fill(9);
    expect(await collect(() => device.read(), 4)).toEqual([1, 2, 9, 9]);
    await written;
  });
});

describe('writable attribute: errors', () => {
  test('an operating system error: UnknownError, then a new stream', async () => {
    const { port, device } = await openPort();
    const { writable } = port;
    device.failNextWrite();
    const error = await writing(port)
      .write(DATA)
      .catch((reason) => reason);
    expect(error).toBeInstanceOf(DOMException);
    expect(error.name).toBe('UnknownError');
    expect(port.writable).toBeInstanceOf(WritableStream);
    expect(port.writable).not.toBe(writable);
    await writing(port).write(Uint8Array.of(9));
    expect(await device.read()).toEqual(Uint8Array.of(9));
  });

  test('the loss of the device: NetworkError, then null until the port is opened again', async () => {
    const { port, device } = await openPort();
    device.failNextWrite('lost');
    expect(await failure(writing(port).write(DATA))).toBe('NetworkError');
    expect(port.writable).toBeNull();
    expect(port.readable).toBeInstanceOf(ReadableStream);
    await port.close();
    await port.open({ baudRate: 9600 });
    expect(port.writable).toBeInstanceOf(WritableStream);
  });

  test('an error of the test’s own', async () => {
    const { port, device } = await openPort();
    const error = new RangeError('mine');
    device.failNextWrite(error);
    await expect(writing(port).write(DATA)).rejects.toBe(error);
  });

  test('an error after some bytes: they get through, the rest does not', async () => {
    const { port, device } = await openPort();
    device.failNextWrite('lost', 10);
    const writer = writing(port);
    await writer.write(DATA);
    expect(await failure(writer.write(DATA))).toBe('NetworkError');
    expect(await collect(() => device.read(), 10)).toEqual([...DATA, 0, 1]);
    expect(await isPending(device.read())).toBe(true);
  });

  test('an error while the stream is being closed', async () => {
    const { port, device } = await openPort();
    device.failNextWrite('system');
    expect(await failure(writing(port).close())).toBe('UnknownError');
    expect(port.writable?.locked).toBe(false);
  });
});

describe('writable attribute: abort', () => {
  test('discards what has not left, and brings a new stream', async () => {
    const { port, device } = await openPort({ bufferSize: 8 });
    const { writable } = port;
    const writer = writing(port);
    await writer.write(DATA);
    await writer.abort();
    expect(port.writable).toBeInstanceOf(WritableStream);
    expect(port.writable).not.toBe(writable);
    const next = DATA.map((byte) => byte + 8);
    await writing(port).write(next);
    expect(await device.read()).toEqual(next);
  });

  test('does not wait for the buffer to empty: the write rejects with the reason', async () => {
    const { port } = await openPort({ bufferSize: 64 });
    const writer = writing(port);
    await settled();
    const written = expect(writer.write(counted(1024))).rejects.toBe('Aborting.');
    await writer.abort('Aborting.');
    await written;
    await port.close();
    expect(port.writable).toBeNull();
  });

  test('cuts closing short', async () => {
    const { port } = await openPort({ bufferSize: 64 });
    const writer = writing(port);
    await settled();
    const written = expect(writer.write(counted(1024))).rejects.toBe('Aborting.');
    const closed = expect(writer.close()).rejects.toBe('Aborting.');
    await writer.abort('Aborting.');
    await Promise.all([written, closed]);
    await port.close();
  });

  test('cuts the wait for the device short', async () => {
    const { port } = await openPort();
    const writer = writing(port);
    await writer.write(DATA);
    const closed = expect(writer.close()).rejects.toBe('Aborting.');
    await settled();
    // The Streams standard rejects both when closing has begun.
    const aborted = expect(writer.abort('Aborting.')).rejects.toBe('Aborting.');
    await Promise.all([closed, aborted]);
    expect(port.writable?.locked).toBe(false);
    await port.close();
  });

  test('is itself rejected when the device is lost meanwhile', async () => {
    const { port, device } = await openPort();
    const writer = writing(port);
    await settled();
    device.failNextWrite('lost');
    const written = expect(writer.write(counted(1024))).rejects.toBe('Aborting');
    expect(await failure(writer.abort('Aborting'))).toBe('NetworkError');
    await written;
    await port.close();
  });
});

describe('writable attribute: close', () => {
  test('waits until the device has all bytes, then brings a new stream', async () => {
    const { port, device } = await openPort({ bufferSize: 64 });
    const { writable } = port;
    const writer = writing(port);
    void writer.write(counted(1024));
    const closed = writer.close();
    await collect(() => device.read(), 960);
    expect(await isPending(closed)).toBe(true);
    await collect(() => device.read(), 64);
    await closed;
    expect(port.writable).toBeInstanceOf(WritableStream);
    expect(port.writable).not.toBe(writable);
    await port.close();
  });
});
