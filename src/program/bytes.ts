/* The parts of a packed text. */

// Node, Deno, Bun and every browser have these, but ES2022 alone, whose types this room has, does not name them.
declare const atob: (base64: string) => string;
declare const btoa: (bytes: string) => string;
declare const TextEncoder: new () => { encode(text: string): Uint8Array };
declare const TextDecoder: new (
  label: string,
  options: { fatal: boolean; ignoreBOM: boolean },
) => { decode(bytes: Uint8Array): string };

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

  /** The length of its UTF-8 form in bytes, then those bytes. Half of a UTF-16 pair becomes U+FFFD. */
  text(value: string): void {
    const bytes = new TextEncoder().encode(value);
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
    try {
      return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(this.take(this.number()));
    } catch (cause) {
      if (cause instanceof BytesError) throw cause;
      throw new BytesError('a text is not UTF-8');
    }
  }

  take(count: number): Uint8Array {
    if (count > this.left) throw new BytesError('it ends too early');
    this.#at += count;
    return this.#bytes.subarray(this.#at - count, this.#at);
  }
}

/** base64url of RFC 4648, without padding: it stands in an address as it is. */
export function base64url(bytes: Uint8Array): string {
  const text = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  return text.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** @throws BytesError when {@link base64url} gives this text for no bytes. */
export function fromBase64url(text: string): Uint8Array {
  if (/[^\w-]/.test(text)) throw new BytesError('a character stands in no such text');
  if (text.length % 4 === 1) throw new BytesError('no bytes have this length');
  const bytes = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (each) => each.charCodeAt(0));
  if (base64url(bytes) !== text) throw new BytesError('the last character has bits that belong to nothing');
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
