import { MockSerial, type PlugOptions } from '../../mock-serial/index.js';
import type { CaptureEntry } from '../../protocol/index.js';
import type { SerialPortLike } from '../../serial/index.js';
import { exampleMemories, ReplayTimer, VirtualTimer } from '../../simulator/index.js';
import type { SimulatedClass } from '../session/session.js';

/** Milliseconds that an adapter and a timer take to answer, about as long as over infra-red. */
const LATENCY = 40;

/**
 * A virtual timer that holds what a flown one may hold, behind a mock port that takes the time of a real line: for the
 * same code path as a real one. This is the one place in the program where simulator and mock port meet.
 */
export function plugSimulatedTimer(timerClass: SimulatedClass): SerialPortLike {
  const timer = new VirtualTimer({ identity: { timerClass }, memories: exampleMemories(timerClass) });
  return plug(timer, { timing: true, latency: LATENCY / 2 });
}

/** A recorded timer behind a mock port, which takes no time of its own: the recording has that of its line. */
export function plugRecording(entries: readonly CaptureEntry[]): SerialPortLike {
  return plug(new ReplayTimer(entries), {});
}

function plug(timer: VirtualTimer | ReplayTimer, options: PlugOptions): SerialPortLike {
  const port = new MockSerial().plug({}, { granted: true, ...options });
  const { device } = port;
  void (async () => {
    const writer = timer.writable.getWriter();
    for (;;) await writer.write(await device.read());
  })();
  void timer.readable.pipeTo(new WritableStream({ write: (bytes) => device.write(bytes) }));
  return port;
}
