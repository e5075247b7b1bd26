import type { LineEntry } from '../client/index.js';
import { commandOf } from '../protocol/index.js';

/** What was heard on a port in place of a timer. */
export interface Heard {
  /**
   * `text`: readable lines, as of a receiver, a printer or a terminal. `echo`: only what was sent came back. `noise`:
   * anything else that belongs to no frame.
   */
  readonly kind: 'text' | 'noise' | 'echo';
  /** The last of it, 64 bytes at most; none of an echo. */
  readonly sample: Uint8Array;
  /** The rate at which it was heard, bits a second. */
  readonly baudRate: number;
}

/** Bytes that are kept. */
const SAMPLE = 64;
/** So many bytes, or errors of the line, are more than plugging in and a flash of light leave behind. */
const ENOUGH = 8;
/**
 * The share of readable bytes from which on they are text. Of bytes that mean nothing about one in three is readable.
 */
const READABLE = 0.9;
/** Questions in a row in which nothing came, after which what came before is forgotten. */
const FORGET_AFTER = 8;

/** Listens at one rate to what comes in place of a timer's answer. */
export class RateListener {
  readonly #baudRate: number;
  #sample = new Uint8Array(0);
  /**
   * Bytes that belong to no frame, those of them that can be read, errors of the line, and what came back of what was
   * sent.
   */
  #bytes = 0;
  #readable = 0;
  #errors = 0;
  #echoes = 0;
  /** Whether anything came since the last question, and in how many in a row nothing has. */
  #isQuiet = true;
  #quiet = 0;

  constructor(baudRate: number) {
    this.#baudRate = baudRate;
  }

  /** What it was, best taken together; null for nothing, or too little to tell. */
  get heard(): Heard | null {
    const sample = this.#sample;
    const baudRate = this.#baudRate;
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

  /** Another question begins. */
  next(): void {
    this.#quiet = this.#isQuiet ? this.#quiet + 1 : 0;
    this.#isQuiet = true;
    if (this.#quiet < FORGET_AFTER) return;
    this.#sample = new Uint8Array(0);
    this.#bytes = this.#readable = this.#errors = this.#echoes = 0;
  }

  #add(bytes: Uint8Array): void {
    this.#bytes += bytes.length;
    this.#readable += bytes.filter(isReadable).length;
    this.#sample = Uint8Array.from([...this.#sample, ...bytes].slice(-SAMPLE));
  }
}

/** Printable ASCII, tab and the ends of lines. */
function isReadable(byte: number): boolean {
  return (byte >= 0x20 && byte < 0x7f) || byte === 0x09 || byte === 0x0a || byte === 0x0d;
}

const ORDER = ['text', 'noise', 'echo'] as const;

/** What tells most of what was heard at several rates: text says that the rate is right. */
export function clearest(heard: readonly (Heard | null)[]): Heard | null {
  for (const kind of ORDER) {
    const found = heard.find((each) => each?.kind === kind);
    if (found) return found;
  }
  return null;
}
