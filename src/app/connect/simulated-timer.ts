import { ByteLine, type Clock, realClock, soon } from '../../line/index.js';
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
  after: (ms, callback) => (document.hidden ? soon(callback) : realClock.after(ms, callback)),
};

/** What the timer of each class holds until the page is closed: a pilot connects again to see what was written. */
const held = new Map<SimulatedClass, TimerCore>();

/** A port whose cable ends at a timer in this page. */
class TimerPort extends EventTarget implements SerialPortLike {
  readable: ReadableStream<Uint8Array> | null = null;
  writable: WritableStream<Uint8Array> | null = null;
  readonly #hasSpeed: boolean;
  readonly #toTimer: ByteLine;
  readonly #toPage: ByteLine;
  #page: ReadableStreamDefaultController<Uint8Array> | null = null;

  /** @param speed how fast the line is: as it was opened, or no time at all. `latency` counts in each direction. */
  constructor(timer: VirtualTimer | ReplayTimer, speed: { readonly latency: number } | null) {
    super();
    this.#hasSpeed = speed !== null;
    const line = { clock: promptInBackground, latency: speed?.latency ?? 0 };
    const writer = timer.writable.getWriter();
    this.#toTimer = new ByteLine((bytes) => void writer.write(bytes), line);
    this.#toPage = new ByteLine((bytes) => this.#page?.enqueue(bytes), line);
    void timer.readable.pipeTo(new WritableStream({ write: (bytes) => void this.#toPage.send(bytes) }));
  }

  async open({ baudRate }: Parameters<SerialPortLike['open']>[0]): Promise<void> {
    for (const line of [this.#toTimer, this.#toPage]) line.baudRate = this.#hasSpeed ? baudRate : 0;
    this.readable = new ReadableStream({
      start: (page) => {
        this.#page = page;
      },
      cancel: () => {
        this.#page = null;
      },
    });
    this.writable = new WritableStream({ write: (bytes) => void this.#toTimer.send(bytes) });
  }

  async close(): Promise<void> {
    this.readable = this.writable = this.#page = null;
    for (const line of [this.#toTimer, this.#toPage]) line.clear();
  }

  getInfo() {
    return {};
  }
}

/**
 * A virtual timer with the speed of a real line. The first of its class has example memories, each later one what the
 * one before held. It takes the same path through the code as a real timer.
 */
export function plugSimulatedTimer(timerClass: SimulatedClass): SerialPortLike {
  const clock = promptInBackground;
  const last = held.get(timerClass);
  const memories = last?.memories ?? exampleMemories(timerClass);
  const timer = new VirtualTimer({ identity: { timerClass }, memories, clock });
  const { core } = timer;
  if (last) [core.memory, core.idleThrottle] = [last.memory, last.idleThrottle];
  held.set(timerClass, core);
  return new TimerPort(timer, { latency: LATENCY / 2 });
}

/** A recorded timer. The port adds no time: the recording has the times of its own line. */
export function plugRecording(entries: readonly CaptureEntry[]): SerialPortLike {
  return new TimerPort(new ReplayTimer(entries), null);
}
