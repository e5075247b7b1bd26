import { expect, it } from 'vitest';
import { VirtualClock } from '../../src/line/index.js';
import { MockSerial } from '../../src/mock-serial/index.js';
import { TimerLink } from '../../src/serial/index.js';

it('a browser that never says which ports it has: Stop ends the wait for a lost port', async () => {
  const clock = new VirtualClock();
  const serial = new MockSerial({ clock });
  const port = serial.plug({}, { granted: true });
  const link = new TimerLink({ serial, clock });
  void link.connect(port);
  await clock.advance(60_000);
  serial.getPorts = () => new Promise(() => {});
  serial.unplug(port);
  await clock.advance(10_000);
  expect(link.state.status).toBe('away');
  void link.stop();
  await clock.advance(60_000);
  expect(link.state.status).toBe('off');
});
