import { describe, expect, expectTypeOf, test } from 'vitest';
import { MockSerial, type MockSerialPort } from '../../src/mock-serial/index.js';

describe('the types of the standard', () => {
  test('a MockSerial is a Serial, a MockSerialPort a SerialPort', () => {
    expectTypeOf<MockSerial>().toExtend<Serial>();
    expectTypeOf<MockSerialPort>().toExtend<SerialPort>();
    const serial: Serial = new MockSerial();
    expect(serial).toBeInstanceOf(EventTarget);
  });

  test('a page can pass values of the standard’s types, and gets such values', async () => {
    const serial = new MockSerial({ userActivation: true });
    serial.choose(serial.plug({ usbVendorId: 1, usbProductId: 2 }));
    const request: SerialPortRequestOptions = { filters: [{ usbVendorId: 1 }], allowedBluetoothServiceClassIds: [1] };
    const port: SerialPort = await serial.requestPort(request);
    const options: SerialOptions = { baudRate: 9600, parity: 'none', stopBits: undefined };
    await port.open(options);
    const output: SerialOutputSignals = { break: false };
    await port.setSignals(output);
    const input: SerialInputSignals = await port.getSignals();
    expect(input.clearToSend).toBe(false);
    const info: SerialPortInfo = port.getInfo();
    expect(info).toEqual({ usbVendorId: 1, usbProductId: 2 });
    const readable: ReadableStream<Uint8Array> | null = port.readable;
    const writable: WritableStream<Uint8Array> | null = port.writable;
    expect(readable && writable).not.toBeNull();
    await port.close();
    await port.forget();
  });

  test('can stand in for navigator.serial', async () => {
    const serial = new MockSerial();
    const navigator: Pick<Navigator, 'serial'> = { serial };
    expect(await navigator.serial.getPorts()).toEqual([]);
  });
});
