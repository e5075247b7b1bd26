import type { Clock } from '../line/index.js';
import {
  type Bytes,
  COMMANDS,
  CodecError,
  type CommandName,
  checksum,
  decodeRequest,
  encodeFrame,
  encodeReply,
  type Frame,
  type Identity,
  MIN_LENGTH,
  type Reply,
  type Request,
  ZEROS_SENT,
} from '../protocol/index.js';
import { firstContent, type MemoryContent, requireContent } from './memory.js';
import type { TimerQuirks } from './quirks.js';

/** How many requests it keeps: those of some thirty readings. More would grow for as long as a page is open. */
const KEPT = 1000;

/** How the core of a timer is made. */
export interface TimerCoreOptions {
  /** What it says about itself. It gives the layout of its memories. */
  readonly identity: Identity;
  /** How it differs from the usual reading of the protocol. */
  readonly quirks: TimerQuirks;
  /** Tells when it falls asleep. */
  readonly clock: Clock;
  /** Milliseconds without a request after which it falls asleep. Default: never. */
  readonly sleepAfter?: number | undefined;
  /** What its memories hold, from M1 on. Missing ones hold rising times. */
  readonly memories?: readonly MemoryContent[] | undefined;
}

/**
 * The timer itself, without the line: memories, servos, motor lock, sleep, and the answer to each request. A bad frame
 * or a value out of range gets no answer, because the protocol has none for it.
 */
export class TimerCore {
  /** What it says about itself. */
  readonly identity: Identity;
  /** What each memory holds, M1 first. */
  readonly memories: MemoryContent[];
  /** The current memory, counted from 0: requests act on it, and it flies next. */
  memory = 0;
  /** Idle throttle, 0..255, unit unknown. Nobody knows whether each memory has its own (row 17); here none has. */
  idleThrottle = 30;
  /** Class Q: locked after a flight, by rule and for safety. */
  motorLocked: boolean;
  /** Whether it sleeps, and answers nothing. */
  isAsleep = false;
  /** Where each servo stands, in steps. Connecting the battery moves them to their DT positions. */
  servos: number[];
  /** The slot to which the servos were last moved. */
  slot: number;
  /** The latest requests that it has answered, a thousand at most, oldest first. */
  readonly answered: Request[] = [];
  /** Called with every request that it answers. */
  onAnswer: ((request: Request) => void) | undefined;
  readonly #quirks: TimerQuirks;
  readonly #clock: Clock;
  readonly #sleepAfter: number;
  #awakeSince: number;

  /**
   * @param options its identity, its quirks, and what it holds.
   * @throws CodecError `wrong-count`, `not-an-integer` or `out-of-range` when a memory does not fit the identity, or a
   * step or a time of the options is none.
   */
  constructor({ identity, quirks, clock, memories = [], sleepAfter = Number.POSITIVE_INFINITY }: TimerCoreOptions) {
    const { timeStep = 1 } = quirks;
    if (!(Number.isInteger(timeStep) && timeStep > 0))
      throw new CodecError('out-of-range', 'quirks.timeStep', 'timeStep must be a whole number above 0');
    if (!(sleepAfter >= 0)) throw new CodecError('out-of-range', 'sleepAfter', 'sleepAfter must be 0 or more');
    this.identity = identity;
    this.#quirks = quirks;
    this.#clock = clock;
    this.#sleepAfter = sleepAfter;
    this.#awakeSince = clock.now();
    this.memories = Array.from({ length: identity.memories }, (_, memory) => {
      const { times, positions } = memories[memory] ?? firstContent(identity, memory);
      return { times: [...times], positions: positions.map((row) => [...row]) };
    });
    for (const content of this.memories) requireContent(content, identity);
    this.motorLocked = identity.timerClass === 'Q';
    this.slot = identity.functions;
    this.servos = this.#positionsAt(this.slot);
  }

  /** What the current memory holds. */
  get content(): MemoryContent {
    return this.memories[this.memory] as MemoryContent;
  }

  /** Puts it to sleep at once. It keeps everything. */
  sleep(): void {
    this.isAsleep = true;
  }

  /** Presses the start switch briefly, which wakes it. */
  press(): void {
    this.isAsleep = false;
    this.#awakeSince = this.#clock.now();
  }

  /**
   * The reply to a frame, as bytes for the line; undefined when it stays silent.
   * @param bare whether the frame carried its command byte in place of its checksum.
   */
  answer(frame: Frame, bare = false): Bytes | undefined {
    if (this.#clock.now() - this.#awakeSince > this.#sleepAfter) this.sleep();
    if (this.isAsleep) return undefined;
    const request = this.#understand(frame);
    if (!request || !this.#takes(request, frame, bare)) return undefined;
    this.#awakeSince = this.#clock.now();
    const reply = this.#perform(request);
    if (this.answered.push(request) > KEPT) this.answered.shift();
    this.onAnswer?.(request);
    return this.#wrap(reply);
  }

  #understand(frame: Frame): Request | undefined {
    try {
      return decodeRequest(frame, { identity: this.identity, quirks: this.#quirks });
    } catch (error) {
      if (error instanceof CodecError) return undefined;
      throw error;
    }
  }

  #takes(request: Request, { code, data }: Frame, bare: boolean): boolean {
    const { bareChecksumRequests, idleThrottleOnQOnly } = this.#quirks;
    if (request.name === 'GETLOWRPM') return !idleThrottleOnQOnly || this.identity.timerClass === 'Q';
    if (request.name !== 'SETMEMORY' && request.name !== 'SETLOWRPM') return true;
    // With a data byte of 0 the bare checksum is the right one.
    return !bareChecksumRequests || bare || checksum(code, data) === code;
  }

  #perform(request: Request): Reply {
    const { content } = this;
    switch (request.name) {
      case 'GETTIMERS':
        return { name: 'GETTIMERS', times: content.times };
      case 'SETTIMERS':
        content.times = request.times.map((time) => time - (time % (this.#quirks.timeStep ?? 1)));
        return { name: 'SETTIMERS', times: content.times };
      case 'GETSERVOPOS':
        return { name: 'GETSERVOPOS', positions: content.positions };
      case 'SETSERVO':
        this.#setServo(request.servo, request.function, request.position);
        return { name: 'SETSERVO' };
      case 'MOVETOFUNC':
        this.slot = request.function;
        this.servos = this.#positionsAt(this.slot);
        return { name: 'MOVETOFUNC' };
      case 'GETSWVER':
        return { name: 'GETSWVER', identity: this.identity };
      case 'UNLOCK':
        this.motorLocked = false;
        return { name: 'UNLOCK' };
      case 'JUMP2':
        return { name: 'JUMP2' };
      case 'GETMEMORY':
        return { name: 'GETMEMORY', memory: this.#quirks.memoryReplyEmpty ? null : this.memory };
      case 'SETMEMORY':
        this.memory = request.memory;
        return { name: 'SETMEMORY' };
      case 'GETLOWRPM':
        return { name: 'GETLOWRPM', idleThrottle: this.idleThrottle };
      case 'SETLOWRPM':
        this.idleThrottle = request.idleThrottle;
        return { name: 'SETLOWRPM' };
    }
  }

  #setServo(servo: number, slot: number, position: number): void {
    if (this.#quirks.servoIgnored || (this.#quirks.servoNeedsMove && this.slot !== slot)) return;
    const row = this.content.positions[servo] as number[];
    row[slot] = position;
    const { setMoves = 'there' } = this.#quirks;
    if (setMoves === 'always' || (setMoves === 'there' && this.slot === slot)) this.servos[servo] = position;
  }

  #positionsAt(slot: number): number[] {
    return this.content.positions.map((row) => row[slot] as number);
  }

  #wrap(reply: Reply): Bytes {
    const quirks = this.#quirks;
    const bareChecksum = quirks.bareChecksumReply === true && reply.name === 'GETLOWRPM';
    const bytes = encodeReply(reply, { identity: this.identity, quirks, bareChecksum });
    const code = this.#misprint(reply.name);
    const frame = code === undefined ? bytes : encodeFrame(code, bytes.subarray(7, -2));
    const length = frame[ZEROS_SENT] as number;
    if (quirks.idleThrottleLength3 && reply.name === 'GETLOWRPM') frame[ZEROS_SENT] = MIN_LENGTH;
    if (quirks.lengthInSum?.includes(reply.name)) frame[ZEROS_SENT + length - 1] = (frame.at(-2) as number) + length;
    return frame.subarray(5 - (quirks.zeros ?? 5));
  }

  /** The letter that this timer uses in place of the right one. */
  #misprint(name: CommandName): number | undefined {
    if (name === 'GETTIMERS' && this.#quirks.timersReplyAs66) return COMMANDS.GETTIMERS.misprint;
    if (name === 'UNLOCK' && this.#quirks.unlockReplyAs6A) return COMMANDS.UNLOCK.misprint;
    return undefined;
  }
}
