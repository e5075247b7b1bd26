import { VirtualClock } from 'sidus-timer/line';
import { MockSerial } from 'sidus-timer/mock-serial';
import { expect, it, onTestFinished, vi } from 'vitest';
import { temperature } from './thermometer.js';

/** A thermometer at a USB adapter that the user will choose. */
function thermometer(options) {
  const serial = new MockSerial({ userActivation: true });
  const port = serial.plug({ usbVendorId: 0x0403, usbProductId: 0x6001 }, options);
  serial.choose(port);
  return { serial, port, device: port.device };
}

it('reads a temperature that comes in pieces', async () => {
  const { serial, device } = thermometer({ chunks: [1, 2] });
  const asked = temperature(serial);
  expect(new TextDecoder().decode(await device.read())).toBe('T?\n');
  device.write(new TextEncoder().encode('21.5\n'));
  expect(await asked).toBe(21.5);
});

it('is found by code that asks for navigator.serial itself', async () => {
  const { serial, device } = thermometer();
  vi.stubGlobal('navigator', { serial });
  onTestFinished(() => void vi.unstubAllGlobals());
  const asked = temperature(navigator.serial);
  await device.read();
  device.write(new TextEncoder().encode('19\n'));
  expect(await asked).toBe(19);
});

it('fails when the cable is pulled', async () => {
  const { serial, port, device } = thermometer();
  const asked = temperature(serial);
  await device.read();
  serial.unplug(port);
  await expect(asked).rejects.toMatchObject({ name: 'NetworkError' });
});

it('takes the time of the line, without waiting for it', async () => {
  const clock = new VirtualClock();
  const { serial, device } = thermometer({ clock, timing: true });
  const asked = temperature(serial);
  void device.read().then(() => device.write(new TextEncoder().encode('21.5\n')));
  expect(await clock.run(asked)).toBe(21.5);
  expect(clock.now()).toBeCloseTo((8 * 10 * 1000) / 9600, 3); // eight bytes of ten bits at 9600 baud
});
