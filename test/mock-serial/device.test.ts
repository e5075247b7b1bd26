import { describe, expect, test } from 'vitest';
import { realClock, VirtualClock, wireTime } from '../../src/line/index.js';
import {
  type InputSignals,
  MockSerial,
  type MockSerialPort,
  type ReadErrorKind,
  type WriteErrorKind,
} from '../../src/mock-serial/index.js';
import { collect, counted, failure, isPending, openPort, reading, settled, timed, writing } from './helper.js';

describe('a pair of streams that answers at the device', () => {
  /** Answers each chunk with the same bytes. */
  const echo = () => new TransformStream<Uint8Array, Uint8Array>();

  test('gets what the page writes, and gives it what it sends; also after the port was plugged in again', async () => {
    const { serial, port, device } = await openPort();
    device.join(echo());
    const said = async (at: MockSerialPort, byte: number) => {
      await writing(at).write(Uint8Array.of(byte));
      return (await reading(at).read()).value;
    };
    expect(await said(port, 1)).toEqual(Uint8Array.of(1));
    serial.unplug(port);
    await settled();
    const again = serial.replug(port);
    await again.open({ baudRate: 9600 });
    expect(await said(again, 2)).toEqual(Uint8Array.of(2));
  });

  test('may fail: then the device is silent, and nothing is thrown', async () => {
    const { port, device } = await openPort();
    const pair = echo();
    device.join({
      readable: pair.readable,
      writable: new WritableStream({ start: (it) => it.error(new Error('cut')) }),
    });
    await writing(port).write(Uint8Array.of(1));
    expect(await isPending(reading(port).read())).toBe(true);
  });
});

describe('device', () => {
  test('reads are served in the order of their calls, and no byte is lost between them', async () => {
    const { port, device } = await openPort();
    const first = device.read();
    const second = device.read();
    const writer = writing(port);
    for (const value of [1, 2, 3]) await writer.write(Uint8Array.of(value));
    expect(await first).toEqual(Uint8Array.of(1));
    expect(await second).toEqual(Uint8Array.of(2));
    expect(await device.read()).toEqual(Uint8Array.of(3));
  });

  test('a read waits on while the page closes the port and opens it again', async () => {
    const { port, device } = await openPort();
    const read = device.read();
    await port.close();
    expect(await isPending(read)).toBe(true);
    await port.open({ baudRate: 9600 });
    await writing(port).write(Uint8Array.of(1));
    expect(await read).toEqual(Uint8Array.of(1));
  });

  test('what it writes to a closed port is lost and counted', async () => {
    const { port, device } = await openPort();
    await port.close();
    device.write([1, 2, 3]);
    await settled();
    expect(device.lost).toBe(3);
    await port.open({ baudRate: 9600 });
    expect(await isPending(reading(port).read())).toBe(true);
  });

  test('needs no clock unless it is asked to keep time', async () => {
    const serial = new MockSerial({ clock: { now: () => Number.NaN, after: () => expect.unreachable() } });
    const port = serial.plug();
    await port.open({ baudRate: 9600 });
    port.device.write([1]);
    expect((await reading(port).read()).value).toEqual(Uint8Array.of(1));
    await writing(port).write(Uint8Array.of(2));
    expect(await port.device.read()).toEqual(Uint8Array.of(2));
  });

  test('works on the real clock', async () => {
    const { port, device } = await openPort({}, { clock: realClock, latency: 1 });
    device.write([1]);
    expect((await reading(port).read()).value).toEqual(Uint8Array.of(1));
  });
});

describe('timing', () => {
  test('a byte has as many bits as the page has asked for', async () => {
    const clock = new VirtualClock();
    const port = new MockSerial({ clock }).plug({}, { timing: true });
    await port.open({ baudRate: 9600, parity: 'even', stopBits: 2, bufferSize: 1000 });
    port.device.write(counted(800));
    await clock.run(reading(port).read());
    expect(clock.now()).toBeCloseTo(1000);
  });

  test('latency comes on top, in either direction, once', async () => {
    const { clock, port, device } = await timed({ latency: 30 });
    const reader = reading(port);
    void writing(port).write(counted(96));
    device.write(await clock.run(device.read()));
    expect(clock.now()).toBeCloseTo(130);
    await clock.run(reader.read());
    expect(clock.now()).toBeCloseTo(260);
  });

  test('latency without timing is all the time there is', async () => {
    const { clock, port, device } = await timed({ timing: false, latency: 1 });
    device.write(counted(96));
    await clock.run(reading(port).read());
    expect(clock.now()).toBe(1);
  });

  test('no time is lost between chunks, nor by a buffer smaller than a chunk', async () => {
    const { clock, port, device } = await timed({ latency: 30 }, 115200, 16);
    const writer = writing(port);
    const done = (async () => {
      for (let i = 0; i < 10; i++) await writer.write(counted(100));
    })();
    await clock.run(collect(() => device.read(), 1000));
    await done;
    expect(clock.now()).toBeCloseTo(wireTime(1000, 115200) + 30);
  });

  test('a write resolves when the buffer has taken it, close() when the last byte has left, read or not', async () => {
    const { clock, port } = await timed({ latency: 30 }, 9600, 96);
    const writer = writing(port);
    await writer.write(counted(96));
    const second = writer.write(counted(96));
    expect(await isPending(second)).toBe(true);
    await clock.run(second);
    expect(clock.now()).toBeCloseTo(100);
    await clock.run(writer.close());
    expect(clock.now()).toBeCloseTo(200);
  });

  test('an abort takes back what has not left', async () => {
    const { clock, port, device } = await timed();
    const writer = writing(port);
    await writer.write(counted(96));
    await writer.abort();
    const next = writing(port);
    await next.write(Uint8Array.of(9));
    expect(await clock.run(device.read())).toEqual(Uint8Array.of(9));
    expect(clock.now()).toBeCloseTo(wireTime(1, 9600));
  });

  test('what has left arrives even if the page then closes the port', async () => {
    const { clock, port, device } = await timed({ latency: 30 });
    const aborted = writing(port);
    await aborted.write(counted(96));
    await aborted.abort();
    const writer = writing(port);
    await writer.write(Uint8Array.of(9));
    await clock.run(writer.close());
    await port.close();
    expect(await clock.run(device.read())).toEqual(Uint8Array.of(9));
  });

  test('an error with nothing before it comes at once', async () => {
    const { clock, port, device } = await timed();
    device.error('parity');
    expect(await clock.run(failure(reading(port).read()))).toBe('ParityError');
    expect(clock.now()).toBe(0);
  });

  test('an error comes after the bytes written before it, also with timing', async () => {
    const { clock, port, device } = await timed({ latency: 3, chunks: [5] });
    const reader = reading(port);
    device.write(counted(96));
    await clock.advance(40);
    device.error('parity');
    expect(await clock.run(collect(async () => (await reader.read()).value, 96))).toHaveLength(96);
    expect(await clock.run(failure(reader.read()))).toBe('ParityError');
    expect(clock.now()).toBeCloseTo(103);
  });

  test('an error on its way when the plug is pulled does not arrive, a later one does', async () => {
    const { clock, serial, port, device } = await timed();
    device.write(counted(48));
    await clock.advance(50);
    device.write(counted(96));
    device.error('break');
    await clock.advance(50);
    serial.unplug(port);
    await port.close();
    serial.replug(port, { samePort: true });
    await port.open({ baudRate: 9600 });
    const reader = reading(port);
    device.write(counted(8));
    device.error('framing');
    expect((await clock.run(reader.read())).value).toEqual(counted(8));
    expect(await clock.run(failure(reader.read()))).toBe('FramingError');
  });

  test('bytes on their way when the plug is pulled do not arrive, also not after it is back', async () => {
    const { clock, serial, port, device } = await timed();
    device.write(counted(96));
    void writing(port).write(counted(96));
    await clock.advance(50);
    serial.unplug(port);
    serial.replug(port, { samePort: true });
    await port.readable?.cancel().catch(() => {});
    const read = device.read();
    await clock.advance(1000);
    expect(await isPending(read)).toBe(true);
    expect(device.lost).toBe(0);
  });
});

describe('chunks', () => {
  test('cut what the device writes', async () => {
    const { port, device } = await openPort({}, { chunks: [1, 3] });
    const reader = reading(port);
    device.write(counted(9));
    const sizes: (number | undefined)[] = [];
    for (let i = 0; i < 5; i++) sizes.push((await reader.read()).value?.length);
    expect(sizes).toEqual([1, 3, 1, 3, 1]);
  });
});

describe('fault', () => {
  test('damages what goes to the page', async () => {
    const toPage = (byte: number, index: number) => (index === 1 ? [] : index === 2 ? [byte, byte] : [byte ^ 0x80]);
    const { port, device } = await openPort({}, { fault: { toPage } });
    const reader = reading(port);
    device.write([1, 2, 3, 4]);
    device.error('framing');
    expect((await reader.read()).value).toEqual(Uint8Array.of(0x81, 3, 3, 0x84));
    expect(await failure(reader.read())).toBe('FramingError');
  });

  test('damages what goes to the device, which need not wait for what is lost', async () => {
    const { port, device } = await openPort({}, { fault: { toDevice: (byte) => (byte === 1 ? [] : [byte]) } });
    const writer = writing(port);
    void writer.write(Uint8Array.of(1, 1));
    void writer.write(Uint8Array.of(1, 2));
    const closed = writer.close();
    expect(await device.read()).toEqual(Uint8Array.of(2));
    await closed;
  });
});

describe('a wrong argument is refused at once', () => {
  test('a kind of error that is none', async () => {
    const { port, device } = await openPort();
    const read = reading(port).read();
    for (const kind of ['FramingError', 'toString', undefined] as unknown as ReadErrorKind[])
      expect(() => device.error(kind)).toThrow('kind must be one of break, framing, parity, overrun, system, lost.');
    device.write([1]);
    expect((await read).value).toEqual(Uint8Array.of(1));
  });

  test('an error of writing that is none', async () => {
    const { port, device } = await openPort();
    for (const kind of ['framing', 5, null] as unknown as WriteErrorKind[])
      expect(() => device.failNextWrite(kind)).toThrow('kind must be one of system, lost.');
    await writing(port).write(Uint8Array.of(1));
    expect(await device.read()).toEqual(Uint8Array.of(1));
  });

  test('what is no list of bytes', async () => {
    const { device } = await openPort();
    for (const bytes of [undefined, null, 5, {}, 'abc', [256], [-1], [1.5], [Number.NaN], ['1']] as never[])
      expect(() => device.write(bytes), String(bytes)).toThrow('bytes must be a list of whole numbers from 0 to 255.');
    device.write([0, 255]);
  });

  test('a USB number that is none', () => {
    for (const usbVendorId of ['0403', Number.NaN, -1, 0x10000] as number[]) {
      expect(() => new MockSerial().plug({ usbVendorId })).toThrow(TypeError);
      expect(() => new MockSerial().plug({ usbProductId: usbVendorId })).toThrow(TypeError);
    }
    expect(new MockSerial().plug({ usbVendorId: 0, usbProductId: 0xffff }).getInfo().usbProductId).toBe(0xffff);
  });

  test('a delay that is none', () => {
    for (const latency of [Number.NaN, -1]) expect(() => new MockSerial().plug({}, { latency })).toThrow(RangeError);
  });

  test('a signal that is undefined keeps its value', async () => {
    const { port, device } = await openPort();
    device.setSignals({ clearToSend: true });
    device.setSignals({ clearToSend: undefined } as unknown as InputSignals);
    expect((await port.getSignals()).clearToSend).toBe(true);
  });
});
