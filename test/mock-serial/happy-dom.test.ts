// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { MockSerial } from '../../src/mock-serial/index.js';
import { settled } from './helper.js';

/* happy-dom asks an event for its phase and its path while it dispatches it: the mock port must not mislead it. */

test('an event goes from the port to Serial where the platform is happy-dom', async () => {
  const serial = new MockSerial();
  const port = serial.plug({}, { granted: true });
  await settled();
  const seen: unknown[] = [];
  const hear = (event: Event): void => {
    seen.push([event.target, event.currentTarget, event.eventPhase, event.composedPath()]);
  };
  serial.addEventListener('disconnect', hear, { capture: true });
  serial.ondisconnect = hear;
  port.addEventListener('disconnect', hear);
  port.addEventListener('disconnect', (event) => hear(event), { once: true });
  serial.unplug(port);
  await settled();
  const path = [port, serial];
  expect(seen).toEqual([
    [port, serial, 1, path],
    [port, port, 2, path],
    [port, port, 2, path],
    [port, serial, 3, path],
  ]);
});
