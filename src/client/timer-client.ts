import { realClock } from '../line/index.js';
import { requireShape, sameKind, type TimerProgram } from '../program/index.js';
import {
  COMMANDS,
  CodecError,
  encodeRequest,
  type Frame,
  type Identity,
  type ReplyOf,
  type Request,
} from '../protocol/index.js';
import { requireAgreed } from './despite.js';
import { TimerError, throwIfAborted } from './errors.js';
import { Exchange } from './exchange.js';
import { SET_IDLE_THROTTLE, setIdleThrottle } from './idle-throttle.js';
import type { ClientJob } from './job.js';
import { LearnedTiming } from './line-timing.js';
import type { LineErrorKind } from './log.js';
import { type MemoriesRead, type MemoriesReport, readMemories, writeMemories } from './memories.js';
import { SELECT, select } from './memory-round-trip.js';
import type {
  IdentifyOptions,
  JobOptions,
  ReadMemoriesOptions,
  ReadOptions,
  TimerClientOptions,
  WriteMemoriesOptions,
  WriteOptions,
} from './options.js';
import { type BytePort, requirePort } from './port.js';
import { type AssumedQuirks, type QuirkCode, type QuirkParams, Quirks } from './quirks.js';
import { type ProgramRead, readContent, readingPlan } from './read-program.js';
import type { RetryPolicy } from './retry-policy.js';
import type { JobPart } from './schedule.js';
import { Wire } from './wire.js';
import { planWrite, writeParts } from './write-plan.js';
import { writeContent } from './write-program.js';
import type { WriteReport } from './write-report.js';

declare global {
  // Older versions of TypeScript's library do not declare it.
  interface SymbolConstructor {
    readonly asyncDispose: unique symbol;
  }
}

/** Gives a class what `await using` calls. Engines have it since 2023 or later; without it nobody can use it. */
export function asyncDisposable<T extends object>(prototype: T, end: (it: T) => Promise<void>): void {
  if (!Symbol.asyncDispose) return;
  Object.defineProperty(prototype, Symbol.asyncDispose, {
    value(this: T) {
      return end(this);
    },
  });
}

/**
 * One timer over one pair of byte streams. Every method waits for the one before it, so you may call them at any time.
 *
 * Each rejects with a {@link TimerError} and leaves the port usable. Any method may reject with `no-answer`,
 * `bad-reply`, `unstable`, `crowded`, `stood-still`, `busy`, `port-lost`, `aborted` or `closed`. A method that depends
 * on the layout of the timer identifies it first, once; it may also reject with `other-timer`. Each method lists its
 * further codes. A value that the timer or the wire cannot carry is refused with a CodecError before anything is sent.
 * Where nothing answers from the beginning, `no-answer` comes after three seconds.
 *
 * `await using timer = new TimerClient(port)` closes it at the end of the block.
 * @example
 * ```ts
 * import { TimerClient } from 'sidus-timer/client';
 * import { seconds, withValue } from 'sidus-timer/program';
 * import { VirtualTimer } from 'sidus-timer/simulator';
 *
 * const timer = new TimerClient(new VirtualTimer());
 * const baseline = await timer.readProgram();
 * const edited = withValue(baseline, { kind: 'time', slot: 10 }, seconds(180)); // DT
 * console.log((await timer.writeProgram(edited, { baseline })).result); // verified
 * await timer.close();
 * ```
 */
export class TimerClient {
  static {
    asyncDisposable(TimerClient.prototype, (client) => client.close());
  }

  /** The same as {@link close}, for `await using`. */
  declare readonly [Symbol.asyncDispose]: () => Promise<void>;
  readonly #wire: Wire;
  readonly #exchange: Exchange;
  readonly #quirks: Quirks;
  readonly #timing: LearnedTiming;
  #queue: Promise<unknown> = Promise.resolve();

  /**
   * @param port the streams of the timer. The client reads them from its first request on.
   * @param options the speed of the line, what is known of the timer, and whom to tell.
   * @throws TypeError when the port has no streams of bytes, such as a stream of Node; CodecError `out-of-range` when
   * the rate or the margin is negative or no number. A port that is not open rejects the first job with `port-lost`.
   */
  constructor(port: BytePort, options: TimerClientOptions = {}) {
    requirePort(port);
    const { baudRate = 9600, clock = realClock, margin = 600, onLine, onLost } = options;
    // A margin such as NaN or '600' would end every wait before the reply comes.
    for (const [field, value] of Object.entries({ baudRate, margin })) {
      if (typeof value !== 'number' || !(value >= 0))
        throw new CodecError('out-of-range', field, `${field} must be a number of at least 0`, { value });
    }
    this.#quirks = new Quirks(options.quirks ?? {});
    this.#timing = new LearnedTiming({ baudRate, margin });
    this.#wire = new Wire(port, this.#quirks, { timing: this.#timing, clock, onLine, onLost });
    this.#exchange = new Exchange(this.#wire, clock, this.#timing);
  }

  /** What the timer said about itself; null until it has been identified. */
  get identity(): Identity | null {
    return this.#exchange.identity;
  }

  /** The differences found in this timer, each with the facts of the first time. */
  get quirksFound(): ReadonlyMap<QuirkCode, QuirkParams> {
    return this.#quirks.found;
  }

  /** What this client assumes about this timer. */
  get quirksAssumed(): AssumedQuirks {
    return this.#quirks.assumed;
  }

  /** Whether the pilot still has to choose how times are written (error `undecided`): see quirk `times-big-endian`. */
  get byteOrderOpen(): boolean {
    return this.#quirks.byteOrderOpen;
  }

  /**
   * Tells the client what this timer does, from the next request on.
   * Read a program again if it was read with another byte order.
   */
  assume(quirks: AssumedQuirks): void {
    this.#quirks.assume(quirks);
  }

  /** Forgets what was found and what is assumed about this timer, from the next request on. */
  forgetQuirks(): void {
    this.#quirks.forget();
  }

  /**
   * Whether there was damage since the first request: bytes that belong to no frame, an error of the line, or an
   * impossible reply. From then on a read is believed only when two agree.
   */
  get damageSeen(): boolean {
    return this.#wire.damage > 0;
  }

  /**
   * How many frames came that nobody asked for, such as those of a second timer in the beam. From the first one on, a
   * read is believed only when two agree.
   */
  get strays(): number {
    return this.#wire.strays;
  }

  /**
   * How often this program stood still: a reply, or the end of a wait, came more than ten seconds after its time, or
   * the clock of the computer jumped by as much.
   */
  get standstills(): number {
    return this.#wire.standstill.count;
  }

  /**
   * How late the latest reply came, in milliseconds beyond the time of its bytes; null while all replies came in time.
   * Later requests wait that much longer.
   */
  get delay(): number | null {
    return this.#timing.delay;
  }

  /** How long a reply may take by now beyond the time of its bytes, in milliseconds; see {@link TimerClientOptions}. */
  get margin(): number {
    return this.#timing.margin;
  }

  /** How often the port reported each kind of line error. Reading went on after all of them. */
  get lineErrors(): ReadonlyMap<LineErrorKind, number> {
    return this.#wire.lineErrors;
  }

  /** How many requests were repeated since this client began, fences included. */
  get repeats(): number {
    return this.#exchange.schedule.repeats;
  }

  /**
   * Asks the timer what it is (GETSWVER).
   * @param options how often to ask, and a signal to stop.
   */
  identify({ signal, ...policy }: IdentifyOptions = {}): Promise<Identity> {
    return this.#inTurn(() => this.#identify(signal, policy));
  }

  /**
   * Sends one request and gives the values of its reply. A request that the table of commands calls repeatable is sent
   * again when no answer comes. The answer to a question is believed as in {@link readProgram}. Any other request goes
   * out once.
   * @throws CodecError when a value cannot be carried; TimerError as any job.
   */
  request<R extends Request>(request: R, options: JobOptions = {}): Promise<ReplyOf<R['name']>> {
    return this.#inTurn(async () => {
      // A caller without types may pass anything; no part of a wrong request may reach the wire.
      encodeRequest(request);
      const { exchange, signal } = await this.#job(options, () => ({ names: [request.name] }));
      return COMMANDS[request.name].effect === 'reads' ? exchange.read(request, signal) : exchange.ask(request, signal);
    });
  }

  /**
   * Sends one frame once, whatever it may do. Works before {@link identify}, too.
   * @param code the command's letter, 0..255.
   * @param data 0 to 252 bytes. Length and checksum are filled in.
   * @param options a signal to stop.
   * @returns the answer, which is a frame with the next letter; null when none came in time.
   * @throws CodecError when there is no such frame; TimerError `port-lost`, `closed`, or `aborted` before it went out.
   */
  send(code: number, data: ArrayLike<number> = [], { signal }: JobOptions = {}): Promise<Frame | null> {
    return this.#inTurn(() => {
      this.#exchange.begin({ parts: [] });
      return this.#exchange.send(code, data, signal);
    });
  }

  /**
   * Reads what the current memory holds: GETMEMORY, GETTIMERS, GETSERVOPOS, on class Q GETLOWRPM, then GETMEMORY again
   * and GETSWVER, to notice another memory or another timer. When anything speaks against one reading, it reads until
   * two agree.
   * @returns the program; `byteOrderOpen` says that its times may be wrong.
   * @throws TimerError `other-timer` when another timer answers than the one that was identified.
   */
  readProgram(options: ReadOptions = {}): Promise<ProgramRead> {
    const { idleThrottle = false } = options;
    return this.#inTurn(async () => {
      const job = await this.#job(options, (identity) => ({ names: readingPlan(identity, { idleThrottle }) }));
      return readContent(job, 'read', { idleThrottle });
    });
  }

  /**
   * Reads what several memories hold, one after the other. It selects each of them, and at the end makes the first one
   * current again, even after an abort or an error. So an abort takes longer.
   * @throws CodecError when the timer has no such memory; TimerError `memory-unknown` before anything is selected,
   * `memory-left` when the first memory could not be made current again; `other-timer`, after which nothing more is
   * sent.
   */
  readMemories(options: ReadMemoriesOptions = {}): Promise<MemoriesRead> {
    return this.#inTurn(async () => readMemories(await this.#job(options), options));
  }

  /**
   * Writes several memories, one after the other; each goal names its memory. Each memory is first read afresh; then
   * only what differs is written and read back, as by {@link writeProgram}. At the end the first memory is current
   * again, even after an abort or an error. The idle throttle may belong to the timer and not to a memory (row 17), so
   * all goals should have the same.
   * @throws before anything is selected: TimerError `memory-unknown`, `other-timer`, `serious`; CodecError when a goal
   * cannot be carried. Later it throws only what a hook throws: the report names everything else.
   */
  writeMemories(goals: readonly TimerProgram[], options: WriteMemoriesOptions = {}): Promise<MemoriesReport> {
    return this.#inTurn(async () => writeMemories(await this.#job(options), goals, options));
  }

  /**
   * Reads everything afresh and compares it with the baseline. Only if timer, memory and every value are the same, it
   * writes what differs, reads everything back and compares again. {@link WriteReport} says what the timer holds
   * afterwards. To finish a write that was stopped, write again with what the timer holds as baseline.
   * @throws CodecError when a value cannot be carried, TimerError `serious` (details.findings) when the program may
   * cost a model and `despite` does not allow it, `other-timer`, `other-memory`, `memory-unknown`, `stale`
   * (details.held), `undecided` or `aborted`: all before anything is written. After that, the report says what stopped
   * the write.
   */
  writeProgram(edited: TimerProgram, options: WriteOptions): Promise<WriteReport> {
    const { baseline } = options;
    return this.#inTurn(async () => {
      requireShape(baseline);
      requireShape(edited);
      requireAgreed(edited, options, baseline);
      const job = await this.#job(options);
      const { identity } = job;
      if (!sameKind(identity, baseline.identity) || !sameKind(identity, edited.identity)) {
        throw new TimerError('other-timer', 'the program is for another kind of timer', { identity });
      }
      const plan = planWrite(baseline, edited, options.moveServos);
      job.exchange.begin({ parts: writeParts(plan), onProgress: options.onProgress });
      return writeContent(job, plan);
    });
  }

  /**
   * Makes a memory current (SETMEMORY) and asks whether it is (GETMEMORY). The current memory flies next. Does not fail
   * when the timer does not say which one is current.
   * @param memory counted from 0.
   * @throws CodecError when the timer has no such memory; TimerError `other-memory` when another one is current
   * afterwards; `no-answer` with `request` SETMEMORY when the timer did not answer that request.
   */
  selectMemory(memory: number, options: JobOptions = {}): Promise<void> {
    return this.#inTurn(async () => {
      await select(await this.#job(options, () => ({ names: SELECT })), memory);
    });
  }

  /**
   * Moves the servos to a slot (MOVETOFUNC). Sent once. After `no-answer` they may have moved.
   * @param slot 0 start, 1 .. NF-1 functions, NF is DT.
   */
  moveToFunction(slot: number, options: JobOptions = {}): Promise<void> {
    return this.#command({ name: 'MOVETOFUNC', function: slot }, options);
  }

  /**
   * Unlocks the motor (UNLOCK). The propeller may start after that. Sent once.
   * After `no-answer` the motor may be unlocked.
   */
  unlockMotor(options: JobOptions = {}): Promise<void> {
    return this.#command({ name: 'UNLOCK' }, options);
  }

  /** Jumps to the function after an early DT (JUMP2). Its effect is not documented. Sent once; servos may move. */
  jump(options: JobOptions = {}): Promise<void> {
    return this.#command({ name: 'JUMP2' }, options);
  }

  /**
   * Stores one position in the current memory (SETSERVO). Until the next read, only the acknowledgement says that it
   * was stored.
   * @param field the servo, counted from 0, and the slot: 0 start, 1 .. NF-1 functions, NF is DT.
   * @param position steps, 0..130.
   * @throws CodecError before anything is sent when the value cannot be carried; otherwise TimerError, after which the
   * position may have been stored.
   */
  setPosition(
    { servo, slot }: { readonly servo: number; readonly slot: number },
    position: number,
    options: JobOptions = {},
  ): Promise<void> {
    return this.#command({ name: 'SETSERVO', servo, function: slot, position }, options);
  }

  /**
   * Sets the idle throttle (SETLOWRPM) and reads it back (GETLOWRPM) until two answers agree.
   * @param idleThrottle 0..255, unit unknown.
   * @returns what the timer holds now.
   * @throws CodecError before anything is sent when the value cannot be carried; TimerError `other-timer`: nothing more
   * was sent. After any other code it may have been set.
   */
  setIdleThrottle(idleThrottle: number, options: JobOptions = {}): Promise<number> {
    return this.#inTurn(async () =>
      setIdleThrottle(await this.#job(options, () => ({ names: SET_IDLE_THROTTLE })), idleThrottle),
    );
  }

  /**
   * Releases the streams: the request in progress comes to its end, waiting calls reject with `closed`, both locks are
   * released. The port itself stays open, for another client, too. In older versions of Chrome and Edge its `readable`
   * ends; a SerialPort has a new one then.
   */
  async close(): Promise<void> {
    await this.#exchange.close();
    await this.#wire.close();
  }

  /** One job after another: two jobs that mix their requests could read half of one memory and half of another. */
  #inTurn<T>(work: () => Promise<T>): Promise<T> {
    const turn = this.#queue.then(work);
    // An error goes to its own caller only; the next job starts all the same.
    this.#queue = turn.catch(() => {});
    return turn;
  }

  async #command(request: Request, options: JobOptions): Promise<void> {
    await this.request(request, options);
  }

  async #identify(signal: AbortSignal | undefined, policy: RetryPolicy = {}): Promise<Identity> {
    this.#exchange.begin({ parts: [{ names: ['GETSWVER'] }] });
    const before = this.identity;
    const { identity } = await this.#exchange.identify(signal, policy);
    // What was found of another timer is not true of this one.
    if (before && !sameKind(before, identity)) this.#quirks.reset();
    return identity;
  }

  /** @param part all exchanges that the job will need. Left out by a job that plans for itself. */
  async #job({ signal, onProgress }: JobOptions, part?: (identity: Identity) => JobPart): Promise<ClientJob> {
    throwIfAborted(signal);
    const identity = this.identity ?? (await this.#identify(signal));
    if (part) this.#exchange.begin({ parts: [part(identity)], onProgress });
    return {
      exchange: this.#exchange,
      identity,
      signal,
      quirks: this.#quirks,
    };
  }
}
