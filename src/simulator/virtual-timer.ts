import { ByteLine, type ByteLineOptions, type Clock, realClock } from '../line/index.js';
import { type Bytes, COMMANDS, FrameDecoder, type Identity, requireIdentity } from '../protocol/index.js';
import { FarEnd } from './far-end.js';
import type { MemoryContent } from './memory.js';
import type { TimerQuirks } from './quirks.js';
import { RequestReader } from './request-reader.js';
import { TimerCore } from './timer-core.js';

/** One direction of the line to a virtual timer, see {@link ByteLineOptions}. */
export type LineFaults = Omit<ByteLineOptions, 'clock' | 'baudRate' | 'latency'>;

/** How a virtual timer is made. Whatever is left out has its default. */
export interface VirtualTimerOptions {
  /**
   * Its identity, or a part of it. What is left out is as in the example of the source: class B, firmware 536, 10
   * functions, 4 memories, 3 servos.
   */
  readonly identity?: Partial<Identity>;
  /** What its memories hold, from M1 on, in the layout of its identity. Missing ones hold rising times. */
  readonly memories?: readonly MemoryContent[];
  /** How it differs from the usual reading of the protocol. Default: not at all. */
  readonly quirks?: TimerQuirks;
  /** Default: the real clock. */
  readonly clock?: Clock;
  /** Bits a second of the line, in both directions. Default 0: the line takes no time. */
  readonly baudRate?: number;
  /** Milliseconds from a whole request to the first byte of its reply. Default 0. */
  readonly latency?: number;
  /**
   * Milliseconds without a request after which it falls asleep. Default: never. By the manuals a real timer falls
   * asleep after about 60 s on B and 2 min on Q.
   */
  readonly sleepAfter?: number;
  /** Pieces and faults on the way to the timer. */
  readonly toTimer?: LineFaults;
  /** Pieces and faults on the way back. */
  readonly fromTimer?: LineFaults;
}

/** The requests that the source prints with a bare checksum. */
const BARE_REQUESTS = [COMMANDS.SETMEMORY.request, COMMANDS.SETLOWRPM.request];

const EXAMPLE: Identity = { timerClass: 'B', firmware: '536', functions: 10, memories: 4, servos: 3 };

/**
 * A simulated timer at the far end of a pair of byte streams: read its replies from `readable`, write requests to
 * `writable`. It answers as docs/protocol.md reads the source. Memories, positions, motor lock and sleep are in
 * {@link TimerCore | core}, where tests may read and change them.
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
  /** What the timer holds and does. Tests may read and change it. */
  readonly core: TimerCore;
  /** The bytes that the timer sends. */
  readonly readable: ReadableStream<Bytes>;
  /** Takes the bytes for the timer. */
  readonly writable: WritableStream<Uint8Array>;
  readonly #toTimer: ByteLine;
  readonly #fromTimer: ByteLine;
  readonly #end: FarEnd;
  readonly #reader: RequestReader;
  readonly #echo: boolean;

  /** @throws CodecError `bad-identity`, and as {@link TimerCore}; RangeError as `ByteLine`. */
  constructor(options: VirtualTimerOptions = {}) {
    const identity: Identity = { ...EXAMPLE, ...options.identity };
    requireIdentity(identity);
    const clock = options.clock ?? realClock;
    const { baudRate = 0, latency = 0, quirks = {} } = options;
    this.#echo = quirks.echo === true;
    const { sleepAfter, memories } = options;
    this.core = new TimerCore({ identity, quirks, clock, sleepAfter, memories });
    const decoder = new FrameDecoder({
      quirks: { bareChecksum: quirks.bareChecksumRequests ? BARE_REQUESTS : false },
      onFrame: (frame, _, bare) => {
        const reply = this.core.answer(frame, bare);
        if (reply) this.#fromTimer.send(reply);
      },
    });
    this.#reader = new RequestReader(decoder, clock);
    this.#toTimer = new ByteLine((bytes) => this.#receive(bytes), { ...options.toTimer, clock, baudRate });
    this.#fromTimer = new ByteLine((bytes) => this.#end.send(bytes), {
      ...options.fromTimer,
      clock,
      baudRate,
      latency,
    });
    this.#end = new FarEnd((bytes) => void this.#toTimer.send(bytes));
    this.readable = this.#end.readable;
    this.writable = this.#end.writable;
  }

  /** Cuts the line, like a pulled cable: reading and writing fail from now on, and bytes on their way never arrive. */
  cut(reason: unknown = new Error('The line to the timer is cut.')): void {
    this.#toTimer.cut();
    this.#fromTimer.cut();
    this.#end.cut(reason);
  }

  #receive(bytes: Uint8Array): void {
    if (this.#echo) this.#fromTimer.send(bytes);
    this.#reader.push(bytes);
  }
}
