import type { Clock } from '../line/index.js';
import {
  type Bytes,
  COMMANDS,
  commandOf,
  encodeFrame,
  encodeRequest,
  type Frame,
  FrameDecoder,
  type Identity,
  type Reply,
  ZEROS_SENT,
} from '../protocol/index.js';
import { tell } from './callback.js';
import { TimerError } from './errors.js';
import type { LearnedTiming } from './line-timing.js';
import type { LineEntry, LineErrorKind } from './log.js';
import { type AnswerOutcome, asReply, type Outcome, type Question, replySize } from './outcome.js';
import type { BytePort, ByteWriter } from './port.js';
import { PortReader } from './port-reader.js';
import type { Quirks } from './quirks.js';
import { DRAIN, LONGEST_FRAME, overtime, replyTime, SILENCE } from './retry-policy.js';
import { StandstillWatch } from './standstill.js';
import { UnansweredRequests } from './unanswered.js';

export interface WireOptions {
  readonly timing: LearnedTiming;
  readonly clock: Clock;
  readonly onLine: ((entry: LineEntry) => void) | undefined;
  readonly onLost: ((error: TimerError) => void) | undefined;
}

/** A request that waits for its answer. */
interface Waiting {
  /** Whether this frame is a reply to it. The wait ends with a reply that makes sense. */
  readonly take: (frame: Frame) => boolean;
  readonly note: (kind: Sign) => void;
  readonly giveUp: () => void;
  readonly fail: (error: TimerError) => void;
}

/** What an exchange comes to when no answer comes in time. */
type Came<T> = Exclude<Outcome<T>, { kind: 'answer' | 'damaged' }> | { readonly kind: 'damaged' };

/** A sign that somebody is there. */
type Sign = 'stray' | 'damaged';

/** A wait for time to pass. */
interface Pause {
  readonly hear: () => void;
  readonly fail: (error: TimerError) => void;
}

const NO_BYTES = new Uint8Array(0);
/** How many bytes are kept of what comes after a request: an echo and a reply. */
const HEARD = 2 * LONGEST_FRAME;

/**
 * Handles one request at a time on a pair of byte streams: sends it, waits until its own reply comes or its time is up,
 * and reports what else was on the line. It never repeats anything; Exchange does.
 */
export class Wire {
  /** How often the port reported each kind of line error. */
  readonly lineErrors = new Map<LineErrorKind, number>();
  readonly unanswered: UnansweredRequests;
  readonly standstill: StandstillWatch;
  readonly quirks: Quirks;
  /**
   * How often there was damage since the first request: bytes that belong to no frame, line errors, impossible replies,
   * and accepted replies that turned out to be wrong.
   */
  damage = 0;
  /**
   * How many frames came that nobody asked for: no echo of the last request, not the awaited reply, and no late reply.
   * They come from a second timer or programmer in the beam, or from a line that doubles frames. Then an accepted reply
   * need not belong to its request.
   */
  strays = 0;
  readonly #port: BytePort;
  readonly #options: WireOptions;
  readonly #decoder: FrameDecoder;
  readonly #reader: PortReader;
  /** Holds the lock of the port while a request goes out. */
  #writer: ByteWriter | undefined;
  #waiting: Waiting | undefined;
  #lost: TimerError | undefined;
  #lastByteAt = Number.NEGATIVE_INFINITY;
  #lastSent: Frame | undefined;
  /** What has come since the last request went out. */
  #heard: number[] = [];
  #pause: Pause | undefined;
  /** The last frame whose command byte stands in place of its checksum. */
  #bare: Frame | undefined;

  constructor(port: BytePort, quirks: Quirks, options: WireOptions) {
    this.#port = port;
    this.quirks = quirks;
    this.#options = options;
    this.unanswered = new UnansweredRequests(options.clock, options.timing);
    this.standstill = new StandstillWatch(options.clock);
    this.#decoder = new FrameDecoder({
      onFrame: (frame, bytes, bare) => {
        if (bare) this.#bare = frame;
        this.#log({ direction: 'in', bytes, frame });
      },
      onRejected: ({ reason, bytes }) => {
        this.#log({ direction: 'in', bytes, rejected: reason });
        this.#noteDamage();
      },
    });
    this.#reader = new PortReader(port, {
      onBytes: (bytes) => this.#receive(bytes),
      onLineError: (kind) => this.#noteLineError(kind),
      onEnd: (cause) => this.#lose(new TimerError('port-lost', 'the port gives no more bytes', {}, cause)),
    });
  }

  /**
   * Sends a request once and waits for its reply.
   * @throws TimerError `busy`, `port-lost` or `closed`; CodecError when the request cannot be encoded.
   */
  async ask(question: Question): Promise<Outcome<Reply>> {
    const { request, identity } = question;
    const bytes = encodeRequest(request, {
      identity: identity ?? undefined,
      quirks: this.quirks.assumed,
      bareChecksum: this.quirks.isBare(request),
    });
    return this.#exchange(bytes, replySize(request.name, identity), (frame) =>
      asReply(frame, question, this.quirks, frame === this.#bare),
    );
  }

  /**
   * Sends any frame once and waits for one with the next letter.
   * @throws TimerError `busy`, `port-lost` or `closed`; CodecError when the frame cannot be encoded.
   */
  async send(code: number, data: ArrayLike<number>, identity: Identity | null): Promise<Outcome<Frame>> {
    const bytes = encodeFrame(code, data);
    const command = commandOf(code);
    const size = command?.direction === 'request' ? replySize(command.name, identity) : LONGEST_FRAME;
    return this.#exchange(bytes, size, (frame) =>
      frame.code === code + 1 ? { kind: 'answer', answer: frame } : undefined,
    );
  }

  /**
   * Settles once nothing has come for a moment; on a line that never falls silent, after a second. Then it looks for
   * frames inside an unfinished one.
   * @throws TimerError `port-lost` or `closed`.
   */
  async silence(signal: AbortSignal | undefined): Promise<void> {
    const { clock } = this.#options;
    const latest = clock.now() + DRAIN;
    for (;;) {
      const left = Math.min(this.#lastByteAt + SILENCE, latest) - clock.now();
      if (left <= 0 || signal?.aborted) break;
      await this.pause(left, signal);
    }
    this.#dispatch(this.#decoder.idle(), false);
  }

  /**
   * Settles after `ms` milliseconds, or at once when the signal asks to stop.
   * @param untilHeard settles also when there is a sign that somebody is there.
   * @returns whether such a sign came.
   * @throws TimerError `port-lost` or `closed`, as soon as it happens.
   */
  async pause(ms: number, signal: AbortSignal | undefined, untilHeard = false): Promise<boolean> {
    if (this.#lost) throw this.#lost;
    if (signal?.aborted) return false;
    const due = this.#options.clock.now() + Math.max(0, ms);
    return new Promise((resolve, reject) => {
      const end = (): void => {
        cancel();
        this.standstill.noteDue(due);
        signal?.removeEventListener('abort', stop);
        this.#pause = undefined;
      };
      const settle = (isHeard: boolean): void => {
        end();
        resolve(isHeard);
      };
      const stop = (): void => settle(false);
      const hear = (): void => {
        if (untilHeard) settle(true);
      };
      const fail = (error: TimerError): void => {
        end();
        reject(error);
      };
      this.#pause = { hear, fail };
      const cancel = this.#options.clock.after(ms, stop);
      signal?.addEventListener('abort', stop);
    });
  }

  /** Releases the port: stops reading, releases the locks. The port itself stays open. */
  async close(): Promise<void> {
    this.#lose(new TimerError('closed', 'this client was closed'));
    const stopped = this.#reader.stop();
    // A port that has not accepted the last request by now may not keep its lock.
    this.#writer?.releaseLock();
    await stopped;
  }

  async #exchange<T>(
    bytes: Bytes,
    size: number,
    judge: (frame: Frame) => AnswerOutcome<T> | undefined,
  ): Promise<Outcome<T>> {
    if (this.#lost) throw this.#lost;
    this.#requireFree();
    this.#reader.start();
    this.#decoder.quirks.bareChecksum = bytes[ZEROS_SENT + 1] === COMMANDS.GETLOWRPM.request;
    this.#heard = [];
    const ended = new Promise<Outcome<T>>((settle, fail) => {
      // The most telling of the signs that came.
      let came: Came<T> = { kind: 'silent' };
      const note = (kind: Sign): void => {
        if (came.kind === 'silent' || came.kind === 'stray') came = { kind };
      };
      const take = (frame: Frame): boolean => {
        const outcome = judge(frame);
        if (!outcome) return false;
        if (outcome.kind === 'answer') {
          this.#waiting = undefined;
          settle(outcome);
        } else {
          this.#noteDamage();
          came = outcome;
        }
        return true;
      };
      const giveUp = (): void =>
        settle(came.kind === 'damaged' ? { kind: 'damaged', bytes: Uint8Array.from(this.#heard) } : came);
      this.#waiting = { take, note, giveUp, fail };
    });
    const sentAt = this.#options.clock.now();
    const cancel = this.#waitFor(bytes.length + size);
    try {
      await Promise.race([this.#send(bytes), ended]);
      const outcome = await ended;
      const { timing } = this.#options;
      this.standstill.noteDue(sentAt + replyTime(bytes.length + size, timing) + overtime(timing));
      this.unanswered.note(bytes, sentAt, outcome.kind !== 'answer');
      return outcome;
    } finally {
      cancel();
      this.#waiting = undefined;
    }
  }

  async #send(bytes: Bytes): Promise<void> {
    const { writable } = this.#port;
    if (!writable) return this.#lose(new TimerError('port-lost', 'the port takes no more bytes'));
    // The port has not accepted the last request yet. So this one is not sent and gets no answer.
    if (writable.locked) return;
    const writer = writable.getWriter();
    this.#writer = writer;
    try {
      const frame = { code: bytes[ZEROS_SENT + 1] as number, data: bytes.slice(ZEROS_SENT + 2, -2) };
      this.#lastSent = frame;
      const sent = this.quirks.assumed.fourZeros ? bytes.subarray(1) : bytes;
      this.#log({ direction: 'out', bytes: sent, frame });
      await writer.write(sent);
    } catch (error) {
      this.#lose(new TimerError('port-lost', 'the port takes no more bytes', {}, error));
    } finally {
      writer.releaseLock();
      this.#writer = undefined;
    }
  }

  /**
   * @throws TimerError `busy` when somebody else reads from the port or writes to it, `port-lost` when it was never
   * open.
   */
  #requireFree(): void {
    const { readable, writable } = this.#port;
    if (!this.#reader.started && !(readable && writable)) {
      this.#lose(new TimerError('port-lost', 'the port is not open: open it before the first job'));
      throw this.#lost;
    }
    const isReadElsewhere = !this.#reader.started && readable?.locked;
    if (!isReadElsewhere && (this.#writer || !writable?.locked)) return;
    const what = isReadElsewhere ? 'reads from' : 'writes to';
    throw new TimerError('busy', `somebody else ${what} the port and holds its lock`);
  }

  /**
   * Ends the wait when the time is up.
   * While bytes still come, it goes on until they stop, but at most for one longest frame.
   */
  #waitFor(size: number): () => void {
    const { clock, timing } = this.#options;
    const begin = clock.now();
    let cancel: () => void = () => {};
    const look = (): void => {
      // A late reply to another request may have shown by now that this timer takes longer.
      const until = begin + replyTime(size, timing);
      const quiet = Math.min(this.#lastByteAt + SILENCE, until + overtime(timing));
      const left = Math.max(until, quiet) - clock.now();
      if (left > 0) {
        cancel = clock.after(left, look);
        return;
      }
      this.#dispatch(this.#decoder.idle(), false);
      this.#waiting?.giveUp();
    };
    cancel = clock.after(replyTime(size, timing), look);
    return () => cancel();
  }

  #receive(bytes: Uint8Array): void {
    this.#lastByteAt = this.#options.clock.now();
    this.#heard.push(...bytes.subarray(0, HEARD - this.#heard.length));
    this.#dispatch(this.#decoder.push(bytes), true);
  }

  /** @param inTime whether the frames have only just become whole, and did not hide behind a false header. */
  #dispatch(frames: readonly Frame[], inTime: boolean): void {
    for (const frame of frames) {
      if (commandOf(frame.code)?.direction !== 'request') this.#noteSign('stray');
      if (this.#waiting?.take(frame)) continue;
      if (this.#lastSent && sameFrame(frame, this.#lastSent)) this.quirks.note('echo');
      else if (!this.unanswered.take(frame, inTime)) this.strays++;
    }
  }

  #noteSign(kind: Sign): void {
    this.#waiting?.note(kind);
    this.#pause?.hear();
  }

  #noteDamage(): void {
    this.#noteSign('damaged');
    this.damage++;
  }

  #noteLineError(error: LineErrorKind): void {
    this.lineErrors.set(error, (this.lineErrors.get(error) ?? 0) + 1);
    this.#log({ direction: 'in', error });
    this.#noteDamage();
  }

  #lose(error: TimerError): void {
    if (this.#lost) return;
    this.#lost = error;
    this.#waiting?.fail(error);
    this.#pause?.fail(error);
    if (error.code === 'port-lost') tell(this.#options.onLost, error);
  }

  #log(entry: Pick<LineEntry, 'direction'> & Partial<LineEntry>): void {
    const { time } = this.standstill;
    tell(this.#options.onLine, { time, bytes: NO_BYTES, frame: null, rejected: null, error: null, ...entry });
  }
}

function sameFrame(a: Frame, b: Frame): boolean {
  return a.code === b.code && a.data.join() === b.data.join();
}
