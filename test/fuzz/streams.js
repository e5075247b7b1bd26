// Streams as a line makes them: frames, and everything that can happen to frames. Built with nothing of the package,
// and printed part by part in hex, so that what a failing law shrinks to can be read.

import fc from 'fast-check';

/**
 * A part of a stream and what it is.
 * @typedef {{ kind: string, bytes: Uint8Array }} Segment
 */

/** @param {Iterable<number>} bytes */
export function hex(bytes) {
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join(' ');
}

/** @param {readonly Uint8Array[]} pieces */
function joined(pieces) {
  const all = new Uint8Array(pieces.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}

/**
 * @param {number} code
 * @param {Iterable<number>} data
 * @param {number} [zeros]
 */
export function wrapped(code, data, zeros = 5) {
  const body = [code, ...data];
  const sum = body.reduce((total, byte) => total + byte, 0) % 256;
  return Uint8Array.from([...Array(zeros).fill(0), body.length + 2, ...body, sum, 0x45]);
}

/** What came on a line until it fell silent. */
export class Stream {
  /** @param {readonly Segment[]} segments */
  constructor(segments) {
    this.segments = segments;
    this.bytes = joined(segments.map(({ bytes }) => bytes));
  }

  [fc.toStringMethod]() {
    return `\n${this.segments.map(({ kind, bytes }) => `  ${kind}: ${hex(bytes)}`).join('\n')}\n`;
  }
}

/** How a stream arrives: the sizes of its pieces, and after which of them the line falls silent. */
export class Cut {
  /**
   * @param {readonly (readonly [size: number, silent: boolean])[]} pieces
   * @param {boolean} [again] used in turn and again from the first, else all that is left comes at once
   */
  constructor(pieces, again = false) {
    this.pieces = pieces;
    this.again = again;
  }

  /**
   * @param {Uint8Array} bytes
   * @returns {{ piece: Uint8Array, silent: boolean }[]}
   */
  of(bytes) {
    const all = [];
    const { length } = this.pieces;
    for (let at = 0, index = 0; at < bytes.length; index++) {
      const [size, silent] = this.pieces[this.again ? index % length : index] ?? [bytes.length - at, false];
      all.push({ piece: bytes.slice(at, at + size), silent });
      at += size;
    }
    return all;
  }

  [fc.toStringMethod]() {
    const sizes = this.pieces.map(([size, silent]) => `${size}${silent ? ' and silence' : ''}`).join(', ');
    return `pieces of ${sizes && `${sizes}, `}${this.again ? 'and so on' : 'the rest'}`;
  }
}

const byte = fc.integer({ min: 0, max: 255 });
/** Bytes as they make trouble: zeros, lengths, ends, letters. */
const trouble = fc.constantFrom(0, 0, 0, 0, 0, 1, 2, 3, 3, 4, 9, 0x24, 0x45, 0x45, 0x62, 0x6b, 0x76, 0xff);
const anyByte = fc.oneof({ weight: 3, arbitrary: trouble }, byte);
const zeros = fc.oneof({ weight: 3, arbitrary: fc.constant(5) }, fc.integer({ min: 4, max: 9 }));

const usual = fc
  .tuple(byte, fc.array(anyByte, { maxLength: 40, size: 'max' }), zeros)
  .map(([code, data, before]) => wrapped(code, data, before));
const longest = fc
  .tuple(byte, fc.array(anyByte, { minLength: 180, maxLength: 252, size: 'max' }))
  .map(([code, data]) => wrapped(code, data));
/** Data that spells a frame, whole or nearly so. */
const nested = fc
  .tuple(
    byte,
    fc.array(anyByte, { maxLength: 12, size: 'max' }),
    usual,
    fc.array(anyByte, { maxLength: 12, size: 'max' }),
    fc.boolean(),
  )
  .map(([code, before, inner, after, whole]) =>
    wrapped(code, [...before, ...(whole ? inner : inner.subarray(0, -1)), ...after]),
  );
const anyFrame = fc.oneof({ weight: 6, arbitrary: usual }, { weight: 2, arbitrary: nested }, longest);

/** @type {Record<string, (bytes: Uint8Array, at: number, count: number, value: number) => Uint8Array[]>} */
const damages = {
  drop: (bytes, at, count) => [bytes.subarray(0, at), bytes.subarray(at + count)],
  insert: (bytes, at, count, value) => [bytes.subarray(0, at), new Uint8Array(count).fill(value), bytes.subarray(at)],
  flip: (bytes, at, _, value) => [
    bytes.subarray(0, at),
    Uint8Array.of(/** @type {number} */ (bytes[at]) ^ (value || 1)),
    bytes.subarray(at + 1),
  ],
  duplicate: (bytes, at, count) => [bytes.subarray(0, at + count), bytes.subarray(at)],
  truncate: (bytes, at) => [bytes.subarray(0, at)],
  zeros: (bytes, at, count) => [bytes.subarray(0, at), new Uint8Array(count), bytes.subarray(at + count)],
};

const damage = fc.record({
  kind: fc.constantFrom(...Object.keys(damages)),
  where: fc.nat(300),
  count: fc.integer({ min: 1, max: 8 }),
  value: byte,
});

const damaged = fc.tuple(anyFrame, fc.array(damage, { minLength: 1, maxLength: 3 })).map(([whole, list]) => {
  let bytes = whole;
  const kinds = list.map(({ kind, where, count, value }) => {
    if (bytes.length === 0) return 'nothing';
    const at = where % bytes.length;
    bytes = joined(damages[kind]?.(bytes, at, Math.min(count, bytes.length - at), value) ?? []);
    return `${kind} at ${at}`;
  });
  return { kind: `frame with ${kinds.join(', ')}`, bytes };
});

/** The beginning of one frame and the end of another. */
const spliced = fc.tuple(anyFrame, anyFrame, fc.nat(300), fc.nat(300)).map(([head, tail, to, from]) => ({
  kind: 'two frames spliced',
  bytes: joined([head.subarray(0, to % head.length), tail.subarray(from % tail.length)]),
}));

/** As many bytes as the length says, the right end, and a sum that is wrong. */
const almost = anyFrame.map((bytes) => {
  const wrong = bytes.slice();
  wrong[wrong.length - 2] = 1 + Number(wrong.at(-2));
  return { kind: 'frame with a wrong sum', bytes: wrong };
});

/** What the source prints for some letters: the sum leaves the data out. */
const bare = fc.tuple(anyByte, byte).map(([code, value]) => ({
  kind: 'frame with a bare checksum',
  bytes: Uint8Array.of(0, 0, 0, 0, 0, 4, code, value, code, 0x45),
}));

const falseHeader = fc
  .tuple(zeros, fc.integer({ min: 1, max: 255 }), fc.array(anyByte, { maxLength: 4 }))
  .map(([before, length, rest]) => ({
    kind: 'false header',
    bytes: Uint8Array.from([...Array(before).fill(0), length, ...rest]),
  }));

/** @param {string} kind @returns {(bytes: Iterable<number>) => Segment} */
const named = (kind) => (bytes) => ({ kind, bytes: Uint8Array.from(bytes) });

/** @type {fc.Arbitrary<Segment>} */
const segment = fc.oneof(
  { weight: 6, arbitrary: anyFrame.map(named('frame')) },
  { weight: 4, arbitrary: damaged },
  { weight: 2, arbitrary: spliced },
  { weight: 1, arbitrary: almost },
  { weight: 1, arbitrary: bare },
  { weight: 2, arbitrary: falseHeader },
  { weight: 2, arbitrary: fc.array(anyByte, { minLength: 1, maxLength: 20, size: 'max' }).map(named('noise')) },
  { weight: 1, arbitrary: fc.integer({ min: 1, max: 300 }).map((count) => named('zeros')(new Uint8Array(count))) },
);

export const stream = fc.array(segment, { maxLength: 6, size: 'max' }).map((segments) => new Stream(segments));

const size = fc.oneof(
  { weight: 2, arbitrary: fc.constant(1) },
  { weight: 3, arbitrary: fc.integer({ min: 1, max: 12 }) },
  fc.integer({ min: 1, max: 300 }),
);

/** Pieces of any size, and no silence. */
export const pieces = fc.tuple(fc.array(size, { maxLength: 30, size: 'max' }), fc.boolean()).map(([sizes, again]) => {
  const list = sizes.map((count) => /** @type {const} */ ([count, false]));
  return new Cut(list, again && list.length > 0);
});

/** Pieces of any size with silence after some. */
export const piecesAndSilence = fc
  .array(fc.tuple(size, fc.boolean()), { maxLength: 12, size: 'max' })
  .map((list) => new Cut(list));

/** Letters for which a bare checksum is taken, as the option of the decoder. */
export const bareChecksum = fc.constantFrom(false, true, [0x73, 0x77], [0x76, 0, 0x62]);
export { anyByte, byte, usual };
