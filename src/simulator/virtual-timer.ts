import { ByteLine, type ByteLineOptions, type Clock, realClock } from '../line/index.js';
import { COMMANDS, type Frame, FrameDecoder, type Identity, requireIdentity } from '../protocol/index.js';
import type { MemoryContent } from './memory.js';
import type { TimerQuirks } from './quirks.js';
import { TimerCore } from './timer-core.js';

/** One direction of the line to a virtual timer, see {@link ByteLineOptions}. */
export type LineFaults = Omit<ByteLineOptions, 'clock' | 'baudRate' | 'latency'>;

export interface VirtualTimerOptions {
  /**
   * What it says of itself. Default: class B, firmware 536, 10 functions, 4 memories, 3 servos, as in the source's
   * example.
   */
  readonly identity?: Partial<Identity>;
  /**
   * What it holds, from M1 on, in the layout of its identity. Default, and for those that are missing: {@link
   * firstContent}.
   */
  readonly memories?: readonly MemoryContent[];
  readonly quirks?: TimerQuirks;
  /** Default: the real clock. */
  readonly clock?: Clock;
  /** Bits a second of the line in both directions. Default 0: it takes no time. */
  readonly baudRate?: number;
  /** Milliseconds from a whole request to the first byte of its reply. Default 0. */
  readonly latency?: number;
  /** Milliseconds without a request after which it falls asleep. Default: never. A real one: 60 s on B, 2 min on Q. */
  readonly sleepAfter?: number;
  /** Pieces and faults on the way to the timer. */
  readonly toTimer?: LineFaults;
  /** Pieces and faults on the way back. */
  readonly fromTimer?: LineFaults;
}

/** The requests for which the source prints a bare checksum. */
const BARE_REQUESTS = [COMMANDS.SETMEMORY.request, COMMANDS.SETLOWRPM.request];

/**
 * Milliseconds of silence after which a frame that is not whole is given up, so that a damaged length does not swallow
 * what follows.
 */
const SILENCE = 100;

const EXAMPLE: Identity = { timerClass: 'B', firmware: '536', functions: 10, memories: 4, servos: 3 };

/**
 * A timer that is not there, at the far end of a pair of byte streams: `readable` gives what it sends, `writable` takes
 * what is sent to it. It answers as the protocol page reads the source, and keeps memories, positions, motor lock,
 * sleep and phase in {@link TimerCore | core}, where tests may look and change.
 * @example
 * ```ts
 * import { TimerClient } from 'sidus-timer/client';
 * import { VirtualClock } from 'sidus-timer/line';
 * import { VirtualTimer } from 'sidus-timer/simulator';
 *
 * const clock = new VirtualClock();
 * const port = new VirtualTimer({ identity: { timerClass: 'Q' }, clock });
 * const timer = new TimerClient(port, { clock });
 * console.log((await clock.run(timer.identify())).timerClass); // Q
 * await timer.close();
 * ```
 */
export class VirtualTimer {
  readonly core: TimerCore;
  readonly readable: ReadableStream<Uint8Array>;
  readonly writable: WritableStream<Uint8Array>;
  readonly #toTimer: ByteLine;
  readonly #fromTimer: ByteLine;
  readonly #decoder: FrameDecoder;
  /** Frames that came with a bare checksum. */
  readonly #bare = new WeakSet<Frame>();
  readonly #echo: boolean;
  readonly #clock: Clock;
  #cancelSilence: () => void = () => {};
  #controller: ReadableStreamDefaultController<Uint8Array> | undefined;
  #ended = false;

  /** @throws CodecError `bad-identity`, or `wrong-count` for memories of another layout. */
  constructor(options: VirtualTimerOptions = {}) {
    const identity: Identity = { ...EXAMPLE, ...options.identity };
    requireIdentity(identity);
    const clock = options.clock ?? realClock;
    const { baudRate = 0, latency = 0, quirks = {} } = options;
    this.#echo = quirks.echo === true;
    this.#clock = clock;
    const { sleepAfter, memories } = options;
    this.core = new TimerCore({ identity, quirks, clock, sleepAfter, memories });
    this.#decoder = new FrameDecoder({
      quirks: { bareChecksum: quirks.bareChecksumRequests ? BARE_REQUESTS : false },
      onFrame: (frame, _, bare) => void (bare && this.#bare.add(frame)),
    });
    this.#toTimer = new ByteLine((bytes) => this.#receive(bytes), { ...options.toTimer, clock, baudRate });
    this.#fromTimer = new ByteLine((bytes) => this.#emit(bytes), { ...options.fromTimer, clock, baudRate, latency });
    this.readable = new ReadableStream<Uint8Array>({
      start: (controller) => {
        this.#controller = controller;
      },
      cancel: () => {
        this.#controller = undefined;
      },
    });
    this.writable = new WritableStream<Uint8Array>({
      write: (bytes) => {
        if (this.#ended) throw new Error('The line to the virtual timer is cut.');
        this.#toTimer.send(bytes);
      },
    });
  }

  /**
   * Cuts the line as a pulled cable does: reading and writing fail from now on, and nothing that is under way arrives.
   */
  cut(reason: unknown = new Error('The line to the virtual timer is cut.')): void {
    this.#ended = true;
    this.#toTimer.cut();
    this.#fromTimer.cut();
    this.#controller?.error(reason);
    this.#controller = undefined;
  }

  #receive(bytes: Uint8Array): void {
    if (this.#echo) this.#fromTimer.send(bytes);
    this.#answer(this.#decoder.push(bytes));
    this.#cancelSilence();
    if (!this.#decoder.waiting) return;
    this.#cancelSilence = this.#clock.after(SILENCE, () => this.#answer(this.#decoder.idle()));
  }

  #answer(frames: readonly Frame[]): void {
    for (const frame of frames) {
      const reply = this.core.answer(frame, this.#bare.has(frame));
      if (reply) this.#fromTimer.send(reply);
    }
  }

  #emit(bytes: Uint8Array): void {
    this.#controller?.enqueue(bytes);
  }
}
