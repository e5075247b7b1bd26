import { type Clock, wireTime } from '../line/index.js';
import {
  answers,
  type CommandName,
  commandOf,
  decodeReply,
  encodeRequest,
  exchangeSize,
  type Frame,
  FrameDecoder,
  frameSize,
  type Identity,
  MAX_DATA,
  type Reply,
  type Request,
  ZEROS_SENT,
} from '../protocol/index.js';
import { TimerError } from './errors.js';
import type { LineEntry } from './log.js';
import type { BytePort } from './port.js';
import type { Quirks } from './quirks.js';

export interface WireOptions {
  readonly clock: Clock;
  /** Bits a second, to know how long bytes take. */
  readonly baudRate: number;
  /** Milliseconds beyond the time of the bytes that a reply may take. */
  readonly margin: number;
  readonly onLine: ((entry: LineEntry) => void) | undefined;
  readonly onLost: ((error: TimerError) => void) | undefined;
}

interface Waiting {
  readonly request: Request;
  readonly identity: Identity | null;
  /** A misprinted letter may be taken: no earlier request can still be answered. */
  readonly misprints: boolean;
  readonly settle: (reply: Reply | undefined) => void;
}

/** Milliseconds without a byte after which the line counts as silent. */
const SILENCE = 60;
/** Milliseconds after which draining a line that never falls silent is given up. */
const LONGEST_DRAIN = 1000;

/**
 * One request at a time on a pair of byte streams: sends it, waits for its own reply or until its time is up, and tells what else
 * was on the line. It never repeats anything; see Exchange for that.
 */
export class Wire {
  readonly #port: BytePort;
  readonly #quirks: Quirks;
  readonly #options: WireOptions;
  readonly #decoder: FrameDecoder;
  #reader: ReadableStreamDefaultReader<Uint8Array> | undefined;
  #writer: WritableStreamDefaultWriter<Uint8Array> | undefined;
  #reading: Promise<void> | undefined;
  #waiting: Waiting | undefined;
  #lost: TimerError | undefined;
  #lastByteAt = Number.NEGATIVE_INFINITY;
  #asked = false;
  #damage = 0;
  #badReply: unknown;

  constructor(port: BytePort, quirks: Quirks, options: WireOptions) {
    this.#port = port;
    this.#quirks = quirks;
    this.#options = options;
    this.#decoder = new FrameDecoder({
      onFrame: (frame, bytes, bare) => {
        if (bare) quirks.note('bare-checksum');
        this.#log({ direction: 'in', bytes, frame, rejected: null });
      },
      onRejected: ({ reason, bytes }) => {
        this.#log({ direction: 'in', bytes, frame: null, rejected: reason });
        this.#noteDamage();
      },
    });
  }

  /** How often damage was seen since the first request: bytes that belong to no frame, errors of the line, impossible replies. */
  get damage(): number {
    return this.#damage;
  }

  /** What was wrong with the last reply whose content could not be; cleared by asking. */
  get badReply(): unknown {
    return this.#badReply;
  }

  /**
   * Sends a request once and waits for its reply.
   * @param misprints whether a letter that belongs to another command may be taken for the reply's.
   * @returns undefined when no reply came in time.
   * @throws TimerError `port-lost` or `closed`; CodecError when the request cannot be encoded.
   */
  async ask(request: Request, identity: Identity | null, misprints: boolean): Promise<Reply | undefined> {
    const bytes = encodeRequest(request, {
      identity: identity ?? undefined,
      quirks: this.#quirks.assumed,
      bareChecksum: this.#quirks.isBare(request),
    });
    this.#start();
    if (this.#lost) throw this.#lost;
    this.#asked = true;
    this.#badReply = undefined;
    this.#decoder.quirks.bareChecksum = request.name === 'GETLOWRPM';
    const answered = new Promise<Reply | undefined>((settle) => {
      this.#waiting = { request, identity, misprints, settle };
    });
    const cancel = this.#waitFor(this.#budget(request.name, identity));
    try {
      await Promise.race([this.#send(bytes), answered]);
      const reply = await answered;
      if (!reply && this.#lost) throw this.#lost;
      return reply;
    } finally {
      cancel();
      this.#waiting = undefined;
    }
  }

  /** Settles once nothing has come for a moment, or on a line that never falls silent after a second; looks into an unfinished frame then. */
  async silence(signal: AbortSignal | undefined): Promise<void> {
    const { clock } = this.#options;
    const latest = clock.now() + LONGEST_DRAIN;
    for (;;) {
      const left = SILENCE - (clock.now() - this.#lastByteAt);
      if (left <= 0 || this.#lost || signal?.aborted || clock.now() > latest) break;
      await this.pause(left, signal);
    }
    this.#dispatch(this.#decoder.idle());
  }

  /** Settles after so many milliseconds, or at once when the port is lost or the signal asks to stop. */
  pause(ms: number, signal: AbortSignal | undefined): Promise<void> {
    if (this.#lost || signal?.aborted) return Promise.resolve();
    return new Promise((resolve) => {
      const settle = (): void => {
        cancel();
        signal?.removeEventListener('abort', settle);
        resolve();
      };
      const cancel = this.#options.clock.after(ms, settle);
      signal?.addEventListener('abort', settle);
    });
  }

  /** Lets go of the port: cancels reading, releases the locks. The port itself stays open. */
  async close(): Promise<void> {
    this.#lose(new TimerError('closed', 'this client was closed'));
    // A stream that has failed refuses to be cancelled; its lock is released all the same.
    await this.#reader?.cancel().catch(() => {});
    // A port that has not taken the last request by now keeps its lock no longer.
    this.#writer?.releaseLock();
    await this.#reading;
  }

  #start(): void {
    this.#reading ??= this.#read().then(
      () => this.#lose(new TimerError('port-lost', 'the stream of bytes ended')),
      (error: unknown) => this.#lose(new TimerError('port-lost', 'the port gives no more bytes', {}, error)),
    );
  }

  /**
   * Reads until the stream ends or the client is closed. A SerialPort replaces its stream after a framing error: take the new one.
   * @throws what the stream failed with when there is no new one.
   */
  async #read(): Promise<void> {
    let failed: ReadableStream<Uint8Array> | undefined;
    let cause: unknown;
    while (!this.#lost) {
      const { readable } = this.#port;
      if (!readable || readable === failed) throw cause;
      const reader = readable.getReader();
      this.#reader = reader;
      try {
        for (;;) {
          const { value, done } = await reader.read();
          if (done) return;
          this.#receive(value);
        }
      } catch (error) {
        failed = readable;
        cause = error;
        this.#noteDamage();
      } finally {
        reader.releaseLock();
      }
    }
  }

  async #send(bytes: Uint8Array): Promise<void> {
    const { writable } = this.#port;
    if (!writable) return this.#lose(new TimerError('port-lost', 'the port takes no more bytes'));
    // The port has not taken the last request yet: this one is not sent, and so not answered.
    if (writable.locked) return;
    const writer = writable.getWriter();
    this.#writer = writer;
    try {
      const frame = { code: bytes[ZEROS_SENT + 1] as number, data: bytes.slice(ZEROS_SENT + 2, -2) };
      this.#log({ direction: 'out', bytes, frame, rejected: null });
      await writer.write(bytes);
    } catch (error) {
      this.#lose(new TimerError('port-lost', 'the port takes no more bytes', {}, error));
    } finally {
      writer.releaseLock();
    }
  }

  #budget(name: CommandName, identity: Identity | null): number {
    // Before the timer is known only requests of known size are asked: GETSWVER, or a fence whose reply may be the longest.
    const size = identity
      ? exchangeSize(name, identity)
      : { request: frameSize(0), reply: frameSize(name === 'GETSWVER' ? 9 : MAX_DATA) };
    return wireTime(size.request + size.reply, this.#options.baudRate) + this.#options.margin;
  }

  /** Ends the wait when the time is up; while bytes are still coming it lasts until they stop, one longest frame at most. */
  #waitFor(budget: number): () => void {
    const { clock, baudRate } = this.#options;
    const latest = clock.now() + budget + wireTime(frameSize(MAX_DATA), baudRate) + SILENCE;
    let cancel: () => void = () => {};
    const look = (): void => {
      const now = clock.now();
      const quietFor = now - this.#lastByteAt;
      if (quietFor < SILENCE && now < latest) {
        cancel = clock.after(SILENCE - quietFor, look);
        return;
      }
      this.#dispatch(this.#decoder.idle());
      this.#waiting?.settle(undefined);
    };
    cancel = clock.after(budget, look);
    return () => cancel();
  }

  #receive(bytes: Uint8Array): void {
    this.#lastByteAt = this.#options.clock.now();
    this.#dispatch(this.#decoder.push(bytes));
  }

  #dispatch(frames: readonly Frame[]): void {
    for (const frame of frames) {
      if (commandOf(frame.code)?.direction === 'request') this.#quirks.note('echo');
      else this.#match(frame);
    }
  }

  #match(frame: Frame): void {
    const waiting = this.#waiting;
    const match = waiting && answers(frame.code, waiting.request.name);
    if (!waiting || !match || (match === 'misprint' && !waiting.misprints)) return;
    let reply: Reply;
    try {
      const identity = waiting.identity ?? undefined;
      reply = decodeReply(frame, { identity, quirks: this.#quirks.assumed, pending: waiting.request });
    } catch (error) {
      this.#badReply = error;
      this.#noteDamage();
      return;
    }
    if (match === 'misprint') this.#quirks.note(reply.name === 'UNLOCK' ? 'unlock-reply-6a' : 'timers-reply-66');
    this.#waiting = undefined;
    waiting.settle(reply);
  }

  /** What was on the line before the first request, such as the noise of plugging in, says nothing about replies. */
  #noteDamage(): void {
    if (this.#asked) this.#damage++;
  }

  #lose(error: TimerError): void {
    if (this.#lost) return;
    this.#lost = error;
    this.#waiting?.settle(undefined);
    if (error.code === 'port-lost') this.#options.onLost?.(error);
  }

  #log(entry: Omit<LineEntry, 'time'>): void {
    this.#options.onLine?.({ time: this.#options.clock.now(), ...entry });
  }
}
