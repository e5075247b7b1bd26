import { describe, expect, it } from 'vitest';
import { MockSerial } from '../../src/mock-serial/index.js';
import { DEFAULT_SETTINGS, RATES } from '../../src/serial/index.js';
import { known } from '../../src/serial/ports.js';
import { quietRate, ratesToTry } from '../../src/serial/settings.js';

describe('a port', () => {
  const uuid = '00001101-0000-1000-8000-00805f9b34fb';
  it.each([
    [{ usbVendorId: 0x0403, usbProductId: 0x6001 }, 'ftdi', 'usb:0403:6001'],
    [{ usbVendorId: 0x10c4, usbProductId: 0xea60 }, 'cp210x', 'usb:10c4:ea60'],
    [{ usbVendorId: 0x1a86, usbProductId: 0x7523 }, 'ch340', 'usb:1a86:7523'],
    [{ usbVendorId: 0x067b, usbProductId: 0x2303 }, 'pl2303', 'usb:067b:2303'],
    [{ usbVendorId: 0x0001, usbProductId: 0x000a }, 'usb', 'usb:0001:000a'],
    [{ usbVendorId: 0x0403 }, 'ftdi', 'usb:0403:0000'],
    [{ bluetoothServiceClassId: uuid.toUpperCase() }, 'bluetooth', `bluetooth:${uuid}`],
    [{ bluetoothServiceClassId: 0x1101 }, 'bluetooth', `bluetooth:${uuid}`],
    [{}, 'other', 'other'],
  ] as const)('%o is called %s and remembered as %s', (info, kind, key) => {
    const port = Object.assign(new MockSerial().plug(), { getInfo: () => info });
    expect(known(port)).toEqual({ port, info, kind, key });
  });
});

describe('the rates to try', () => {
  const fixed = { ...DEFAULT_SETTINGS, baudRate: 38400 };

  it.each([
    ['the likeliest first', ratesToTry(DEFAULT_SETTINGS, false), [9600, 19200, 38400, 57600, 115200, 4800]],
    [
      'a known one before all others',
      ratesToTry(DEFAULT_SETTINGS, false, 57600),
      [57600, 9600, 19200, 38400, 115200, 4800],
    ],
    ['an unusual known one before all others', ratesToTry(DEFAULT_SETTINGS, false, 31250), [31250, ...RATES]],
    ['only the one that is set', ratesToTry(fixed, false, 9600), [38400]],
    ['only one over Bluetooth', ratesToTry(DEFAULT_SETTINGS, true), [9600]],
    ['the known one over Bluetooth', ratesToTry(DEFAULT_SETTINGS, true, 19200), [19200]],
  ])('are %s', (_, rates, expected) => {
    expect(rates).toEqual(expected);
  });

  it('are mostly the likeliest one in the first quiet questions, and all of them within 24 questions', () => {
    const rates = ratesToTry(DEFAULT_SETTINGS, false, 31250);
    const asked = Array.from({ length: 24 }, (__, i) => quietRate(rates, i));
    expect(new Set(asked)).toEqual(new Set(rates));
    expect(asked.filter((rate) => rate === 31250)).toHaveLength(18);
  });

  it('stay for five questions later, at the likeliest and at one of the others in turn', () => {
    const rates = ratesToTry(DEFAULT_SETTINGS, false);
    for (let begin = 20; begin < 120; begin += 50) {
      const asked = Array.from({ length: 50 }, (__, i) => quietRate(rates, begin + i));
      const turns = RATES.slice(1).flatMap((rate) => [...Array(5).fill(9600), ...Array(5).fill(rate)]);
      expect(asked).toEqual(turns);
    }
  });

  it('are the only one in quiet questions where there is no other', () => {
    for (let asked = 0; asked < 10; asked++) expect(quietRate([9600], asked)).toBe(9600);
  });
});
