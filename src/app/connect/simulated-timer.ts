import { type Clock, realClock } from '../../line/index.js';
import { MockSerial, type PlugOptions } from '../../mock-serial/index.js';
import type { CaptureEntry } from '../../protocol/index.js';
import type { SerialPortLike } from '../../serial/index.js';
import { exampleMemories, ReplayTimer, type TimerCore, VirtualTimer } from '../../simulator/index.js';
import type { SimulatedClass } from '../work/timer-access.js';

/** How long an adapter and a timer take to answer, in milliseconds: about as long as over infrared. */
const LATENCY = 40;

/**
 * The clock of line and timer. In the background a browser calls timeouts once a second at most, but the bytes of a
 * real port come in time there, too. So there the bytes of a simulated timer take no time.
 */
const promptInBackground: Clock = {
  ...realClock,
  after(ms, callback) {
    if (!document.hidden) return realClock.after(ms, callback);
    let due = true;
    queueMicrotask(() => {
      if (due) callback();
    });
    return () => {
      due = false;
    };
  },
};

/** What the timer of each class holds until the page is closed: a pilot connects again to see what was written. */
const held = new Map<SimulatedClass, TimerCore>();

/**
 * A virtual timer behind a mock port with the speed of a real line. The first of its class has example memories, each
 * later one what the one before held. It takes the same path through the code as a real timer. Only this file puts
 * simulator and mock port together.
 */
export function plugSimulatedTimer(timerClass: SimulatedClass): SerialPortLike {
  const clock = promptInBackground;
  const last = held.get(timerClass);
  const memories = last?.memories ?? exampleMemories(timerClass);
  const timer = new VirtualTimer({ identity: { timerClass }, memories, clock });
  const { core } = timer;
  if (last) [core.memory, core.idleThrottle] = [last.memory, last.idleThrottle];
  held.set(timerClass, core);
  return plug(timer, { clock, timing: true, latency: LATENCY / 2 });
}

/** A recorded timer behind a mock port. The port adds no time: the recording has the times of its own line. */
export function plugRecording(entries: readonly CaptureEntry[]): SerialPortLike {
  return plug(new ReplayTimer(entries), {});
}

function plug(timer: VirtualTimer | ReplayTimer, options: PlugOptions): SerialPortLike {
  const port = new MockSerial().plug({}, { granted: true, ...options });
  port.device.join(timer);
  return port;
}
