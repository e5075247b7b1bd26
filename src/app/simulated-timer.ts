import { MockSerial } from '../mock-serial/index.js';
import type { SerialPortLike } from '../serial/index.js';
import { VirtualTimer } from '../simulator/index.js';

/** Milliseconds that an adapter and a timer take to answer, about as long as over infra-red. */
const LATENCY = 40;

/**
 * A virtual timer behind a mock port that takes the time of a real line, for the same code path as a real one. This is the one
 * place in the program where simulator and mock port meet.
 */
export function plugSimulatedTimer(timerClass: 'Q' | 'B'): SerialPortLike {
  const serial = new MockSerial();
  const port = serial.plug({}, { granted: true, timing: true, latency: LATENCY / 2 });
  const timer = new VirtualTimer({ identity: { timerClass } });
  const { device } = port;
  void (async () => {
    const writer = timer.writable.getWriter();
    for (;;) await writer.write(await device.read());
  })();
  void timer.readable.pipeTo(new WritableStream({ write: (bytes) => device.write(bytes) }));
  return port;
}
