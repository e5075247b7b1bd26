import { describe, expect, test } from 'vitest';
import { MockSerial, type MockSerialPort, type OpenOptions } from '../../src/mock-serial/index.js';
import { failure, isPending, openPort, reading, writing } from './helper.js';

const plugged = (): MockSerialPort => new MockSerial().plug();

/** What no type would let through, but a page can. */
const open = (port: MockSerialPort, options: Record<string, unknown>): Promise<void> =>
  port.open(options as unknown as OpenOptions);

describe('open() method', () => {
  test('step 2: InvalidStateError when the port is open', async () => {
    const { port } = await openPort();
    expect(await failure(port.open({ baudRate: 9600 }))).toBe('InvalidStateError');
  });

  test('step 2: InvalidStateError when the port is being opened', async () => {
    const port = plugged();
    const first = port.open({ baudRate: 9600 });
    expect(await failure(port.open({ baudRate: 9600 }))).toBe('InvalidStateError');
    await first;
  });

  test('step 2 comes before the checks of the options, Web IDL before either', async () => {
    const { port } = await openPort();
    expect(await failure(open(port, { baudRate: 0 }))).toBe('InvalidStateError');
    expect(await failure(open(port, {}))).toBe('TypeError');
    expect(await failure(open(port, { baudRate: 9600, parity: 'mark' }))).toBe('TypeError');
  });

  test('SerialOptions: baudRate is required', async () => {
    await expect(open(plugged(), {})).rejects.toThrow(new TypeError('baudRate is required.'));
    expect(await failure((plugged() as unknown as { open(): Promise<void> }).open())).toBe('TypeError');
  });

  const wrong: Record<string, readonly unknown[]> = {
    baudRate: [-1, 0, 2 ** 32, Number.NaN, Number.POSITIVE_INFINITY, 'fast'],
    dataBits: [-1, 0, 6, 9, 256 + 8, null],
    stopBits: [-1, 0, 3, 4, null],
    parity: [0, null, 'cats', 'NONE'],
    bufferSize: [-1, 0, 16 * 1024 * 1024 + 1, 2 ** 30, 2 ** 32 + 1],
    flowControl: [0, null, 'software'],
  };
  for (const [name, values] of Object.entries(wrong)) {
    test.each(values)(`steps 3 to 6 and SerialOptions: ${name} cannot be %s, and nothing is opened`, async (value) => {
      const port = plugged();
      let openings = 0;
      port.device.onopenchange = () => {
        openings++;
      };
      expect(await failure(open(port, { baudRate: 9600, [name]: value }))).toBe('TypeError');
      expect(openings).toBe(0);
      await port.open({ baudRate: 9600 });
    });
  }

  const right: Record<string, readonly unknown[]> = {
    baudRate: [1, 9600, '9600', 115200.7, 2 ** 32 - 1],
    dataBits: [undefined, 7, 8],
    stopBits: [undefined, 1, 2],
    parity: [undefined, 'none', 'even', 'odd'],
    bufferSize: [undefined, 1, 16 * 1024 * 1024],
    flowControl: [undefined, 'none', 'hardware'],
  };
  for (const [name, values] of Object.entries(right)) {
    test.each(values)(`SerialOptions: ${name} can be %s`, async (value) => {
      const port = plugged();
      await open(port, { baudRate: 9600, [name]: value });
      await port.close();
    });
  }

  test('step 8: the port is opened with the defaults of SerialOptions', async () => {
    const { device } = await openPort({ baudRate: 115200.7, dataBits: 7 });
    expect(device.opened).toEqual({
      baudRate: 115200,
      dataBits: 7,
      stopBits: 1,
      parity: 'none',
      bufferSize: 255,
      flowControl: 'none',
    });
  });

  test('step 8: NetworkError when another program holds the port; it can be opened once that releases it', async () => {
    const port = new MockSerial().plug({}, { busy: true });
    expect(await failure(port.open({ baudRate: 9600 }))).toBe('NetworkError');
    expect(port.readable).toBeNull();
    port.device.busy = false;
    await port.open({ baudRate: 9600 });
  });

  test('step 8: NetworkError when the device is unplugged', async () => {
    const serial = new MockSerial();
    const port = serial.plug();
    serial.unplug(port);
    expect(await failure(port.open({ baudRate: 9600 }))).toBe('NetworkError');
  });

  test('step 8: opening raises DTR, and RTS under hardware flow control', async () => {
    expect(plugged().device.signals).toEqual({ dataTerminalReady: false, requestToSend: false, break: false });
    const { port, device } = await openPort();
    expect(device.signals).toEqual({ dataTerminalReady: true, requestToSend: false, break: false });
    await port.close();
    await port.open({ baudRate: 9600, flowControl: 'hardware' });
    expect(device.signals).toEqual({ dataTerminalReady: true, requestToSend: true, break: false });
  });

  test('the streams are null before, and streams after', async () => {
    const port = plugged();
    expect(port.readable).toBeNull();
    expect(port.writable).toBeNull();
    const opening = port.open({ baudRate: 9600 });
    expect(port.readable).toBeNull();
    expect(port.writable).toBeNull();
    await opening;
    expect(port.readable).toBeInstanceOf(ReadableStream);
    expect(port.writable).toBeInstanceOf(WritableStream);
    expect(port.readable).toBe(port.readable);
    expect(port.writable).toBe(port.writable);
  });
});

describe('close() method', () => {
  test('step 2: InvalidStateError when the port was never opened', async () => {
    expect(await failure(plugged().close())).toBe('InvalidStateError');
  });

  test('step 2: InvalidStateError when the port is closed already', async () => {
    const { port } = await openPort();
    await port.close();
    expect(await failure(port.close())).toBe('InvalidStateError');
  });

  test('step 2: InvalidStateError when the port is being closed', async () => {
    const { port } = await openPort();
    const closing = port.close();
    await expect(port.close()).rejects.toMatchObject({ name: 'InvalidStateError', message: 'The port is closing.' });
    await closing;
  });

  test('step 3: TypeError while readable is locked, and the port stays usable', async () => {
    const { port, device } = await openPort();
    const reader = reading(port);
    expect(await failure(port.close())).toBe('TypeError');
    device.write([1]);
    expect((await reader.read()).value).toEqual(Uint8Array.of(1));
    expect(device.signals.dataTerminalReady).toBe(true);
    reader.releaseLock();
    await port.close();
    expect(port.readable).toBeNull();
  });

  test('step 4: TypeError while writable is locked, and the port stays usable', async () => {
    const { port, device } = await openPort();
    const writer = writing(port);
    expect(await failure(port.close())).toBe('TypeError');
    await writer.write(Uint8Array.of(1));
    expect(await device.read()).toEqual(Uint8Array.of(1));
    expect(port.readable).toBeInstanceOf(ReadableStream);
    writer.releaseLock();
    await port.close();
    expect(port.writable).toBeNull();
  });

  test('step 3: what has not been read is discarded, and the old stream ends', async () => {
    const { port, device } = await openPort();
    const readable = port.readable;
    device.write([1, 2, 3]);
    await port.close();
    expect(await readable?.getReader().read()).toEqual({ done: true, value: undefined });
    await port.open({ baudRate: 9600 });
    device.write([4]);
    expect((await reading(port).read()).value).toEqual(Uint8Array.of(4));
  });

  test('step 4: what has not been sent is discarded, and the old stream rejects with InvalidStateError', async () => {
    const { port, device } = await openPort();
    const writable = port.writable as WritableStream<Uint8Array>;
    const writer = writable.getWriter();
    await writer.write(Uint8Array.of(1, 2, 3));
    writer.releaseLock();
    await port.close();
    expect(await failure(writable.getWriter().write(Uint8Array.of(4)))).toBe('InvalidStateError');
    await port.open({ baudRate: 9600 });
    await writing(port).write(Uint8Array.of(5));
    expect(await device.read()).toEqual(Uint8Array.of(5));
  });

  test('step 4: a write that waits for room is given up', async () => {
    const { port } = await openPort({ bufferSize: 1 });
    const writer = writing(port);
    const written = writer.write(Uint8Array.of(1, 2));
    writer.releaseLock();
    await Promise.all([port.close(), expect(written).rejects.toThrow('closed')]);
  });

  test('step 8: a stream that has failed does not keep the port open', async () => {
    const { port, device } = await openPort();
    const writer = writing(port);
    device.failNextWrite();
    expect(await failure(writer.write(Uint8Array.of(1)))).toBe('UnknownError');
    writer.releaseLock();
    await port.close();
    await port.open({ baudRate: 9600 });
    await writing(port).write(Uint8Array.of(1));
  });

  test('step 9: what a failed write left behind is discarded', async () => {
    const { port, device } = await openPort();
    device.failNextWrite('system', 2);
    expect(await failure(writing(port).write(Uint8Array.of(1, 2, 3)))).toBe('UnknownError');
    await port.close();
    await port.open({ baudRate: 9600 });
    expect(await isPending(device.read())).toBe(true);
  });

  test('step 9: closing drops all signals', async () => {
    const { port, device } = await openPort();
    await port.setSignals({ requestToSend: true, break: true });
    await port.close();
    expect(device.signals).toEqual({ dataTerminalReady: false, requestToSend: false, break: false });
  });

  test('the streams are null while the port is being closed', async () => {
    const { port } = await openPort();
    const closing = port.close();
    expect(port.readable).toBeNull();
    expect(port.writable).toBeNull();
    await closing;
  });
});

describe('device.opened', () => {
  test('tells the device of each opening and closing, once', async () => {
    const port = plugged();
    const rates: (number | undefined)[] = [];
    port.device.onopenchange = (opened) => rates.push(opened?.baudRate);
    await port.open({ baudRate: 9600 });
    expect(port.device.opened?.baudRate).toBe(9600);
    await port.close();
    expect(port.device.opened).toBeNull();
    await port.open({ baudRate: 115200 });
    await port.forget();
    await port.forget();
    expect(rates).toEqual([9600, undefined, 115200, undefined]);
  });
});
