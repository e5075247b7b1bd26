import { describe, expect, test } from 'vitest';
import { MockSerial, type MockSerialPort } from '../../src/mock-serial/index.js';
import { failure, openPort, timed, writing } from './helper.js';

const plugged = (): MockSerialPort => new MockSerial().plug();

describe('open() method', () => {
  test('what a pty does not have: the slowest and the fastest rate, flow control', async () => {
    const port = plugged();
    for (const baudRate of [1, 2 ** 32 - 1]) {
      await port.open({ baudRate, flowControl: 'hardware' });
      await port.close();
    }
  });

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

  test('step 8: opening raises DTR, and RTS under hardware flow control', async () => {
    expect(plugged().device.signals).toEqual({ dataTerminalReady: false, requestToSend: false, break: false });
    const { port, device } = await openPort();
    expect(device.signals).toEqual({ dataTerminalReady: true, requestToSend: false, break: false });
    await port.close();
    await port.open({ baudRate: 9600, flowControl: 'hardware' });
    expect(device.signals).toEqual({ dataTerminalReady: true, requestToSend: true, break: false });
  });
});

describe('close() method', () => {
  test('step 4: what has not been sent is discarded, and the old stream rejects with InvalidStateError', async () => {
    const { clock, port, device } = await timed();
    const writable = port.writable as WritableStream<Uint8Array>;
    const writer = writable.getWriter();
    await writer.write(Uint8Array.of(1, 2, 3));
    writer.releaseLock();
    await port.close();
    expect(await failure(writable.getWriter().write(Uint8Array.of(4)))).toBe('InvalidStateError');
    await port.open({ baudRate: 9600 });
    await writing(port).write(Uint8Array.of(5));
    expect(await clock.run(device.read())).toEqual(Uint8Array.of(5));
  });

  test('step 4: a write that waits for room is given up', async () => {
    const { port } = await timed({}, 9600, 1);
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

  test('step 9: closing drops all signals', async () => {
    const { port, device } = await openPort();
    await port.setSignals({ requestToSend: true, break: true });
    await port.close();
    expect(device.signals).toEqual({ dataTerminalReady: false, requestToSend: false, break: false });
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
