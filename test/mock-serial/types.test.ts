import { describe, expect, expectTypeOf, test } from 'vitest';
import {
  MockSerial,
  type MockSerialPort,
  type OpenOptions,
  type OutputSignals,
  type PortRequestOptions,
} from '../../src/mock-serial/index.js';

describe('the types of the standard', () => {
  test('a MockSerial is a Serial, a MockSerialPort a SerialPort', () => {
    expectTypeOf<MockSerial>().toExtend<Serial>();
    expectTypeOf<MockSerialPort>().toExtend<SerialPort>();
    const serial: Serial = new MockSerial();
    expect(serial).toBeInstanceOf(EventTarget);
  });

  test('a page can pass values of the standard’s types', () => {
    expectTypeOf<SerialOptions>().toExtend<OpenOptions>();
    expectTypeOf<SerialOutputSignals>().toExtend<OutputSignals>();
    expectTypeOf<SerialPortRequestOptions>().toExtend<PortRequestOptions>();
  });

  test('can stand in for navigator.serial', async () => {
    const serial = new MockSerial();
    const navigator: Pick<Navigator, 'serial'> = { serial };
    expect(await navigator.serial.getPorts()).toEqual([]);
  });
});
