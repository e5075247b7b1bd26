import { describe, expect, it } from 'vitest';
import { BytesError, base64url, crc32, fromBase64url, PackedReader, PackedWriter } from '../../src/program/bytes.js';
import { fromHex, toHex } from '../tools/bytes.js';

function written(write: (to: PackedWriter) => void): string {
  const to = new PackedWriter();
  write(to);
  return toHex(to.bytes);
}

/** The message of a refusal, or what was read. */
function readAs<T>(hex: string, read: (from: PackedReader) => T): T | string {
  try {
    return read(new PackedReader(fromHex(hex)));
  } catch (error) {
    if (error instanceof BytesError) return `refused: ${error.message}`;
    throw error;
  }
}

describe('a text as bytes', () => {
  it.each([
    ['7f', '\x7f'],
    ['f4 8f bf bf', '\u{10ffff}'],
  ])('%s is one character, in both directions', (hex, character) => {
    const length = hex.split(' ').length.toString(16).padStart(2, '0');
    expect(written((to) => to.text(character))).toBe(`${length} ${hex}`);
    expect(readAs(`${length} ${hex}`, (from) => from.text())).toBe(character);
  });

  it('has half of a pair replaced, which is no character', () => {
    expect(written((to) => to.text('\ud800'))).toBe('03 ef bf bd');
  });

  it('keeps a byte order mark', () => {
    expect(readAs('03 ef bb bf', (from) => from.text())).toBe('\ufeff');
  });

  it.each([
    ['03 ed a0 80', 'half of a pair'],
    ['01 c2', 'no whole one'],
  ])('%s is not valid: %s', (hex) => {
    expect(readAs(hex, (from) => from.text())).toBe('refused: a text is not UTF-8');
  });

  it('that ends too early is told from one that is not valid', () => {
    expect(readAs('02 61', (from) => from.text())).toBe('refused: it ends too early');
  });
});

describe('numbers as bytes', () => {
  it.each([
    ['00', 0],
    ['7f', 127],
    ['80 01', 128],
    ['ff 7f', 16_383],
    ['ff ff ff ff ff ff ff 0f', Number.MAX_SAFE_INTEGER],
  ])('%s, as long as they have to be', (hex, value) => {
    expect(written((to) => to.number(value))).toBe(hex);
    expect(readAs(hex, (from) => from.number())).toBe(value);
  });

  it.each([
    ['80 00', 'a number is longer than it has to be'],
    ['ff ff ff ff ff ff ff 10', 'a number is too large'],
    ['80', 'it ends too early'],
  ])('%s is not valid: %s', (hex, message) => {
    expect(readAs(hex, (from) => from.number())).toBe(`refused: ${message}`);
  });

  it('are low byte first in a pair', () => {
    expect(written((to) => to.pair(0x1234))).toBe('34 12');
    expect(readAs('34 12', (from) => from.pair())).toBe(0x1234);
    expect(readAs('34', (from) => from.pair())).toBe('refused: it ends too early');
  });

  it('say how many are left', () => {
    expect(
      readAs('01 02 03', (from) => [from.left, [...from.take(2)], from.left, [...from.take(1)], from.left]),
    ).toEqual([3, [1, 2], 1, [3], 0]);
  });
});

describe('bytes in the characters of an address', () => {
  it.each([
    ['', ''],
    ['66 6f 6f', 'Zm9v'],
    ['66 6f 6f 62', 'Zm9vYg'],
    ['fb ff fe', '-__-'],
  ])('%s is %s, in both directions', (hex, text) => {
    const bytes = hex === '' ? new Uint8Array() : fromHex(hex);
    expect(base64url(bytes)).toBe(text);
    expect(fromBase64url(text)).toEqual(bytes);
  });

  it.each([
    ['A', 'no bytes have this length'],
    ['AAAAA', 'no bytes have this length'],
    ['Zm9=', 'a character stands in no such text'],
    ['Zm+v', 'a character stands in no such text'],
    ['Zm 9', 'a character stands in no such text'],
    ['Zh', 'the last character has bits that belong to nothing'],
    ['Zm9', 'the last character has bits that belong to nothing'],
  ])('%s is not valid: %s', (text, message) => {
    expect(() => fromBase64url(text)).toThrow(new BytesError(message));
  });

  it('have the same checksum as in zip and png', () => {
    expect(crc32(new TextEncoder().encode('123456789'))).toBe(0xcbf4_3926);
  });
});
