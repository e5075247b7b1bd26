import { describe, expect, test } from 'vitest';
import { collect, counted, failure, openPort, settled, timed, writing } from './helper.js';

const DATA = counted(8);

describe('writable attribute: chunks', () => {
  test('one that is detached while it waits for room ends there', async () => {
    const { clock, port, device } = await timed({}, 9600, 64);
    const bytes = counted(1024);
    const written = writing(port).write(bytes);
    await settled();
    structuredClone(bytes.buffer, { transfer: [bytes.buffer as ArrayBuffer] });
    await clock.run(written);
    expect(await clock.run(device.read())).toEqual(counted(64));
    await expect(clock.run(device.read()), 'nothing more is on its way').rejects.toThrow('Nothing is due');
  });

  test('one is read no sooner than there is room for it', async () => {
    const { clock, port, device } = await timed({}, 9600, 2);
    const bytes = Uint8Array.of(1, 2, 3, 4);
    const written = writing(port).write(bytes);
    await settled();
    bytes.fill(9);
    expect(await clock.run(collect(() => device.read(), 4))).toEqual([1, 2, 9, 9]);
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

  test('an error while the stream is being closed', async () => {
    const { port, device } = await openPort();
    device.failNextWrite('system');
    expect(await failure(writing(port).close())).toBe('UnknownError');
    expect(port.writable?.locked).toBe(false);
  });
});

describe('writable attribute: abort', () => {
  test('cuts a write and the closing after it short, with its reason', async () => {
    const { port } = await timed({}, 9600, 64);
    const writer = writing(port);
    await settled();
    const ends = [writer.write(counted(1024)), writer.close()].map((end) => expect(end).rejects.toBe('Aborting.'));
    await writer.abort('Aborting.');
    await Promise.all(ends);
    await port.close();
    expect(port.writable).toBeNull();
  });

  test('cuts the wait for the last bytes short', async () => {
    const { port } = await timed();
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
    const { port, device } = await timed();
    const writer = writing(port);
    await settled();
    device.failNextWrite('lost');
    const written = expect(writer.write(counted(1024))).rejects.toBe('Aborting');
    expect(await failure(writer.abort('Aborting'))).toBe('NetworkError');
    await written;
    await port.close();
  });
});
