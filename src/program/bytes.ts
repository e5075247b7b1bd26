/* The parts of a packed text. This room uses ES2022 alone, which has neither UTF-8 nor base64. */

/** Appends values one after another. */
export class PackedWriter {
  readonly #bytes: number[] = [];

  get bytes(): Uint8Array {
    return Uint8Array.from(this.#bytes);
  }

  byte(value: number): void {
    this.#bytes.push(value);
  }

  /** Two bytes, low byte first. */
  pair(value: number): void {
    this.#bytes.push(value & 0xff, value >> 8);
  }

  /**
   * A whole number from 0 to 2^53 - 1: seven bits in each byte, lowest first.
   * The highest bit of a byte says that more follow.
   */
  number(value: number): void {
    let rest = value;
    while (rest >= 0x80) {
      this.#bytes.push((rest % 0x80) + 0x80);
      rest = Math.floor(rest / 0x80);
    }
    this.#bytes.push(rest);
  }

  /** The length of its UTF-8 form in bytes, then those bytes. */
  text(value: string): void {
    const bytes = utf8(value);
    this.number(bytes.length);
    for (const byte of bytes) this.#bytes.push(byte);
  }
}

/** Bytes that {@link PackedWriter} cannot have written. */
export class BytesError extends Error {}

/** Reads the values back. Accepts only the one form that {@link PackedWriter} writes. @throws BytesError */
export class PackedReader {
  readonly #bytes: Uint8Array;
  #at = 0;

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }

  /** How many bytes are left. */
  get left(): number {
    return this.#bytes.length - this.#at;
  }

  byte(): number {
    return this.take(1)[0] as number;
  }

  pair(): number {
    const [low = 0, high = 0] = this.take(2);
    return low + 0x100 * high;
  }

  number(): number {
    let value = 0;
    for (let factor = 1; ; factor *= 0x80) {
      const byte = this.byte();
      value += (byte % 0x80) * factor;
      if (!Number.isSafeInteger(value)) throw new BytesError('a number is too large');
      if (byte === 0 && factor > 1) throw new BytesError('a number is longer than it has to be');
      if (byte < 0x80) return value;
    }
  }

  text(): string {
    return fromUtf8(this.take(this.number()));
  }

  take(count: number): Uint8Array {
    if (count > this.left) throw new BytesError('it ends too early');
    this.#at += count;
    return this.#bytes.subarray(this.#at - count, this.#at);
  }
}

/** Half of a UTF-16 pair is no character. It is packed in three bytes all the same, so that it comes back unchanged. */
function utf8(text: string): number[] {
  const bytes: number[] = [];
  for (const character of text) {
    const code = character.codePointAt(0) as number;
    const more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x1_0000 ? 2 : 3;
    bytes.push((FIRST[more] as number) + (code >> (6 * more)));
    bytes.push(...Array.from({ length: more }, (_, at) => 0x80 + ((code >> (6 * (more - 1 - at))) & 0x3f)));
  }
  return bytes;
}

/** By how many bytes follow the first: its mark, and the lowest character of that length. */
const FIRST = [0, 0xc0, 0xe0, 0xf0];
const LOWEST = [0, 0x80, 0x800, 0x1_0000];

function fromUtf8(bytes: Uint8Array): string {
  let text = '';
  let at = 0;
  while (at < bytes.length) {
    const first = bytes[at++] as number;
    // A byte that cannot begin a character gives a code that is too low or too high, and is refused below.
    const more = first < 0x80 ? 0 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
    let code = first - (FIRST[more] as number);
    for (let count = 0; count < more; count++) {
      const byte = bytes[at++] ?? 0;
      if (byte < 0x80 || byte > 0xbf) throw new BytesError('a character is not whole');
      code = code * 0x40 + (byte - 0x80);
    }
    if (code < (LOWEST[more] as number) || code > 0x10_ffff) throw new BytesError('a character has no such form');
    text += String.fromCodePoint(code);
  }
  return text;
}

const ALPHABET = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
const DIGITS = new Map([...ALPHABET].map((character, value) => [character, value]));

/** base64url of RFC 4648, without padding: it stands in an address as it is. */
export function base64url(bytes: Uint8Array): string {
  let text = '';
  for (let at = 0; at < bytes.length; at += 3) {
    const [a = 0, b = 0, c = 0] = bytes.subarray(at, at + 3);
    const group = [a >> 2, ((a & 3) << 4) | (b >> 4), ((b & 15) << 2) | (c >> 6), c & 63];
    text += group
      .slice(0, Math.min(bytes.length - at, 3) + 1)
      .map((digit) => ALPHABET[digit])
      .join('');
  }
  return text;
}

/** @throws BytesError when the text holds other characters, or has a length that no bytes give. */
export function fromBase64url(text: string): Uint8Array {
  if (text.length % 4 === 1) throw new BytesError('no bytes have this length');
  const bytes = new Uint8Array(Math.floor((text.length * 3) / 4));
  let held = 0;
  let bits = 0;
  let at = 0;
  for (const character of text) {
    const digit = DIGITS.get(character);
    if (digit === undefined) throw new BytesError(`“${character}” stands in no such text`);
    held = ((held << 6) | digit) & 0xfff;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes[at++] = (held >> bits) & 0xff;
  }
  if ((held & ((1 << bits) - 1)) !== 0) throw new BytesError('the last character has bits that belong to nothing');
  return bytes;
}

/** CRC-32 as in zip and png (ISO-HDLC). It notices every error that spans at most 32 bits. */
export function crc32(bytes: Uint8Array): number {
  let crc = 0xffff_ffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb8_8320 : 0);
  }
  return ~crc >>> 0;
}
