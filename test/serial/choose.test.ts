import { describe, expect, it } from 'vitest';
import { MockSerial } from '../../src/mock-serial/index.js';
import { availability, ConnectionError, choosePort, rememberedPorts } from '../../src/serial/index.js';

describe('availability', () => {
  it.each([
    { serial: new MockSerial(), isSecureContext: true, expected: null },
    { serial: undefined, isSecureContext: true, expected: 'unsupported' },
    { serial: undefined, isSecureContext: false, expected: 'insecure' },
    { serial: new MockSerial(), isSecureContext: true, policyAllows: true, expected: null },
    { serial: new MockSerial(), isSecureContext: true, policyAllows: false, expected: 'policy' },
    { serial: undefined, isSecureContext: true, policyAllows: false, expected: 'policy' },
    { serial: undefined, isSecureContext: false, policyAllows: false, expected: 'insecure' },
  ])(
    'is $expected when the context is secure: $isSecureContext, and the policy allows: $policyAllows',
    ({ expected, ...surroundings }) => {
      expect(availability(surroundings)).toBe(expected);
    },
  );
});

describe('choosing a port', () => {
  it('gives the port that the pilot picks, which is remembered from then on', async () => {
    const serial = new MockSerial({ userActivation: true });
    const port = serial.plug({ usbVendorId: 0x0403 });
    expect(await rememberedPorts(serial)).toEqual([]);
    serial.choose(port);
    expect(await choosePort(serial)).toBe(port);
    expect(await rememberedPorts(serial)).toEqual([port]);
  });

  it('offers adapters of every kind: unknown USB vendors and Bluetooth', async () => {
    const serial = new MockSerial({ userActivation: true });
    for (const info of [{}, { usbVendorId: 0xbeef, usbProductId: 1 }, { bluetoothServiceClassId: 0x1101 }]) {
      const port = serial.plug(info);
      serial.choose(port);
      expect(await choosePort(serial), `the port with ${JSON.stringify(info)} was not offered`).toBe(port);
    }
  });

  it('says that nothing was chosen when the chooser is dismissed', async () => {
    const serial = new MockSerial({ userActivation: true });
    serial.plug();
    const error = await choosePort(serial).catch((reason: unknown) => reason);
    expect(error).toBeInstanceOf(ConnectionError);
    expect(error).toMatchObject({ code: 'nothing-chosen', cause: { name: 'NotFoundError' } });
  });

  it('says that the browser wants a click', async () => {
    await expect(choosePort(new MockSerial())).rejects.toMatchObject({
      code: 'not-allowed',
      cause: { name: 'SecurityError' },
    });
  });
});

describe('remembered ports', () => {
  it('leaves out what is not plugged in, also where the browser still lists it', async () => {
    const serial = new MockSerial();
    const here = serial.plug({}, { granted: true });
    const gone = serial.plug({}, { granted: true });
    serial.plug();
    serial.unplug(gone);
    const browser = { getPorts: async () => [here, gone], requestPort: () => serial.requestPort() };
    expect(await rememberedPorts(browser)).toEqual([here]);
  });

  it('counts ports of browsers that do not say whether they are connected', async () => {
    const old = Object.create(new MockSerial().plug(), { connected: { value: undefined } });
    const browser = { getPorts: async () => [old], requestPort: async () => old };
    expect(await rememberedPorts(browser)).toEqual([old]);
  });

  it.each([
    [undefined, 'not-allowed'],
    [true, 'not-allowed'],
    [false, 'policy'],
  ] as const)('says why even asking is forbidden where the policy allows: %s', async (policyAllows, code) => {
    const forbidden = async () => {
      throw new DOMException('Blocked by permissions policy.', 'SecurityError');
    };
    const browser = { getPorts: forbidden, requestPort: forbidden };
    await expect(rememberedPorts(browser, policyAllows)).rejects.toMatchObject({ code });
    await expect(choosePort(browser, policyAllows)).rejects.toMatchObject({ code });
  });
});
