import { type ChromiumWays, MockSerial, type MockSerialPort } from '../../../src/mock-serial/index.js';
import { collect, settled } from '../helper.js';
import { labOf, type Probe } from './lab.js';

/** What a probe gives on the mock port, as a browser tells it. */
export async function onMock(
  { run, opens }: Probe,
  userActivation: boolean,
  chromium: boolean | ChromiumWays,
): Promise<string> {
  const serial = new MockSerial({ userActivation, chromium });
  let port: MockSerialPort = serial.plug({ usbVendorId: 0x0403, usbProductId: 0x6001 }, { granted: true });
  const { device } = port;
  await settled();
  const lab = labOf(serial, port, {
    rest: settled,
    free: async () => {},
    send: async (bytes) => void device.write(bytes),
    receive: (count) => collect(() => device.read(), count),
    async order(what) {
      if (what === 'unplug') serial.unplug(port);
      else if (what === 'plug') port = serial.replug(port);
      else if (what === 'choose' || what === 'dismiss') serial.choose(what === 'choose' ? port : null);
      else if (what === 'hangup') device.error('lost');
      else if (what === 'break' || what === 'parity') device.error(what);
      else device.busy = what === 'hold';
    },
  });
  if (opens) await lab.open();
  return lab.text(await run(lab));
}
