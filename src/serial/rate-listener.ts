import type { LineEntry } from '../client/index.js';
import { type Bytes, commandOf, FrameDecoder } from '../protocol/index.js';

/** What was heard on a port in place of a timer. */
export interface Heard {
  /**
   * `text`: readable lines, as from a receiver, a printer or a terminal. `echo`: only our own bytes came back. `noise`:
   * any other bytes that belong to no frame. `slow`: bytes that make whole replies of a timer, but come too slowly.
   */
  readonly kind: 'slow' | 'text' | 'noise' | 'echo';
  /** The last bytes, 64 at most; none for an echo. */
  readonly sample: Bytes;
  /** The rate at which it was heard, in bits a second. */
  readonly baudRate: number;
}

/** How many bytes are kept. */
const SAMPLE = 64;
/** Plugging in, or a flash of light, gives fewer bytes or line errors than this. */
const ENOUGH = 8;
/** From this share of readable bytes on, they count as text. Of random bytes about one in three is readable. */
const READABLE = 0.9;
/** After this many questions in a row without a byte, earlier bytes are forgotten. */
const FORGET_AFTER = 8;

/** Listens at one rate to what comes in place of a timer's answer. */
export class RateListener {
  readonly #baudRate: number;
  #sample = new Uint8Array(0);
  /**
   * Counts bytes that belong to no frame, the readable ones among them, line errors, and our own bytes that came back.
   */
  #bytes = 0;
  #readable = 0;
  #errors = 0;
  #echoes = 0;
  /** Puts together what came so slowly that each reply was given up before it was whole. */
  readonly #decoder = new FrameDecoder();
  #slow = 0;
  /** Whether nothing has come since the last question, and for how many questions in a row. */
  #isQuiet = true;
  #quiet = 0;

  constructor(baudRate: number) {
    this.#baudRate = baudRate;
  }

  /**
   * Whether the last bytes begin like a reply of a timer and may become one. Where they come slowly, another rate now
   * would lose the rest.
   */
  get isReplyBegun(): boolean {
    const tail = this.#sample;
    return this.#quiet === 0 && tail.some((letter, at) => isReplyHeader(letter, tail.subarray(0, at)));
  }

  /** What was heard, all together; null for nothing, or too little to tell. */
  get heard(): Heard | null {
    const sample = this.#sample;
    const baudRate = this.#baudRate;
    if (this.#slow > 0) return { kind: 'slow', sample, baudRate };
    if (this.#bytes >= ENOUGH) {
      return { kind: this.#readable >= READABLE * this.#bytes ? 'text' : 'noise', sample, baudRate };
    }
    if (this.#errors >= ENOUGH) return { kind: 'noise', sample, baudRate };
    return this.#echoes > 0 ? { kind: 'echo', sample: new Uint8Array(0), baudRate } : null;
  }

  note({ direction, frame, bytes, error }: LineEntry): void {
    if (direction === 'out') return;
    if (error) this.#errors++;
    else if (!frame) this.#add(bytes);
    else if (commandOf(frame.code)?.direction === 'request') this.#echoes++;
    else return;
    this.#isQuiet = false;
  }

  /** Begins the next question. */
  next(): void {
    this.#quiet = this.#isQuiet ? this.#quiet + 1 : 0;
    this.#isQuiet = true;
    if (this.#quiet < FORGET_AFTER) return;
    this.#sample = new Uint8Array(0);
    this.#bytes = this.#readable = this.#errors = this.#echoes = this.#slow = 0;
  }

  #add(bytes: Uint8Array): void {
    const frames = this.#decoder.push(bytes);
    this.#slow += frames.filter(({ code }) => commandOf(code)?.direction === 'reply').length;
    this.#bytes += bytes.length;
    this.#readable += bytes.filter(isReadable).length;
    this.#sample = Uint8Array.from([...this.#sample, ...bytes].slice(-SAMPLE));
  }
}

/** Whether four zeros and a length come right before the letter of a reply. */
function isReplyHeader(letter: number, before: Uint8Array): boolean {
  const isReply = commandOf(letter)?.direction === 'reply';
  return isReply && before.length >= 5 && before.at(-1) !== 0 && before.slice(-5, -1).every((byte) => byte === 0);
}

/** Printable ASCII, tab and line ends. */
function isReadable(byte: number): boolean {
  return (byte >= 0x20 && byte < 0x7f) || byte === 0x09 || byte === 0x0a || byte === 0x0d;
}

const ORDER = ['slow', 'text', 'noise', 'echo'] as const;

/** The most telling of what was heard at several rates. Text shows that the rate is right. */
export function clearest(heard: readonly (Heard | null)[]): Heard | null {
  for (const kind of ORDER) {
    const found = heard.find((each) => each?.kind === kind);
    if (found) return found;
  }
  return null;
}
