import { describe, expect, test } from 'vitest';
import {
  MockSerial,
  type MockSerialPort,
  type PortInfo,
  type PortRequestOptions,
} from '../../src/mock-serial/index.js';
import { failure } from './helper.js';

/** A page that has just been clicked, with a port that the user is about to choose. */
function clicked(info: PortInfo = {}): { serial: MockSerial; port: MockSerialPort } {
  const serial = new MockSerial({ userActivation: true });
  const port = serial.plug(info);
  serial.choose(port);
  return { serial, port };
}

const SERIAL_PORT_PROFILE = '00001101-0000-1000-8000-00805f9b34fb';
const CUSTOM = '01234567-89ab-cdef-0123-456789abcdef';

describe('requestPort() method', () => {
  test('step 3: user activation is not used up, and the same port is the same object', async () => {
    const { serial, port } = clicked();
    expect(await serial.requestPort()).toBe(port);
    expect(await serial.requestPort()).toBe(port);
  });

  test('step 5: the user may take time to choose', async () => {
    const { serial, port } = clicked();
    serial.choose(null);
    const chosen = serial.requestPort();
    serial.choose(port);
    expect(await chosen).toBe(port);
  });

  test('step 5: NotFoundError when the port is unplugged', async () => {
    const { serial, port } = clicked();
    serial.unplug(port);
    expect(await failure(serial.requestPort())).toBe('NotFoundError');
  });

  test('step 5: NotFoundError when the port belongs to another object', async () => {
    const { serial } = clicked();
    serial.choose(new MockSerial().plug());
    expect(await failure(serial.requestPort())).toBe('NotFoundError');
  });

  const usb = { usbVendorId: 0x0403, usbProductId: 0x6001 };
  const spp = { bluetoothServiceClassId: 0x1101 };
  const own = { bluetoothServiceClassId: CUSTOM };
  const allowed = { allowedBluetoothServiceClassIds: [CUSTOM] };
  const rows: readonly (readonly [string, PortInfo, PortRequestOptions, boolean])[] = [
    ['no filters', usb, {}, true],
    ['an empty list', usb, { filters: [] }, true],
    ['its vendor', usb, { filters: [{ usbVendorId: 0x0403 }] }, true],
    ['its vendor and product', usb, { filters: [usb] }, true],
    ['another vendor', usb, { filters: [{ usbVendorId: 1 }] }, false],
    ['another product', usb, { filters: [{ usbVendorId: 0x0403, usbProductId: 1 }] }, false],
    ['one of several', usb, { filters: [{ usbVendorId: 1 }, usb] }, true],
    ['a port that is no USB device, USB filters', {}, { filters: [usb] }, false],
    ['a service class on USB', usb, { filters: [spp] }, false],
    ['the Serial Port Profile, no filters', spp, {}, true],
    ['the Serial Port Profile, USB filters', spp, { filters: [usb] }, false],
    ['the same among them', spp, { filters: [usb, { bluetoothServiceClassId: SERIAL_PORT_PROFILE }] }, true],
    ['a service class of one’s own', own, {}, false],
    ['a service class of one’s own, filtered for only', own, { filters: [own] }, false],
    ['a service class of one’s own, allowed', own, allowed, true],
    ['a service class of one’s own, allowed and filtered for', own, { filters: [own], ...allowed }, true],
    ['another service class of one’s own', own, { filters: [spp], ...allowed }, false],
    [
      'another class of the Bluetooth standard, blocked though allowed',
      { bluetoothServiceClassId: 0x1108 },
      { allowedBluetoothServiceClassIds: [0x1108] },
      false,
    ],
  ];
  test.each(rows)('step 5 and "matches the filter": %s', async (_, info, options, offered) => {
    const { serial, port } = clicked(info);
    if (offered) expect(await serial.requestPort(options)).toBe(port);
    else expect(await failure(serial.requestPort(options))).toBe('NotFoundError');
  });
});

describe('getPorts() method', () => {
  test('gives the ports the site may use, the same objects each time', async () => {
    const { serial, port } = clicked();
    const remembered = serial.plug({}, { granted: true });
    expect(await serial.getPorts()).toEqual([remembered]);
    await serial.requestPort();
    const ports = await serial.getPorts();
    expect(ports).toHaveLength(2);
    expect(ports[0]).toBe(port);
    expect(ports[1]).toBe(remembered);
    expect((await serial.getPorts())[0]).toBe(port);
  });
});

describe('getInfo() method', () => {
  test.each([
    [{}, {}],
    [{ usbVendorId: 1 }, { usbVendorId: 1 }],
    [{ usbProductId: 2 }, { usbProductId: 2 }],
    [
      { usbVendorId: 1, usbProductId: 2, bluetoothServiceClassId: undefined },
      { usbVendorId: 1, usbProductId: 2 },
    ],
    [{ bluetoothServiceClassId: 0x1101 }, { bluetoothServiceClassId: SERIAL_PORT_PROFILE }],
    [{ bluetoothServiceClassId: CUSTOM }, { bluetoothServiceClassId: CUSTOM }],
  ])('of %o is %o, without members that do not apply', (info, expected) => {
    const port = new MockSerial().plug(info);
    expect(port.getInfo()).toStrictEqual(expected);
    expect(port.getInfo()).not.toBe(port.getInfo());
  });
});
