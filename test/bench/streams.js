// What the decoders are fed: the same payloads for all, each in its own framing; whole, damaged, hostile.

/**
 * Numbers that look random and are the same in every run.
 * @param {number} seed
 * @returns {(below: number) => number} whole numbers from 0 on
 */
export function randomNumbers(seed) {
  let state = seed;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

/** The one value that no payload has: serialport's delimiter parser has no way to carry its delimiter. */
export const NOT_IN_PAYLOADS = 0x0a;

/**
 * @param {number} count
 * @param {number} size bytes in each
 * @returns {Uint8Array[]} of any bytes but one; all different, if they have any
 */
export function payloads(count, size) {
  const random = randomNumbers(1);
  const byte = () => {
    const value = random(255);
    return value < NOT_IN_PAYLOADS ? value : value + 1;
  };
  return Array.from({ length: count }, () => Uint8Array.from({ length: size }, byte));
}

/**
 * @typedef {object} Stream
 * @property {Uint8Array} bytes
 * @property {boolean[]} intact for each frame in turn whether it arrives as it was sent
 */

/**
 * @param {readonly Uint8Array[]} frames
 * @returns {Stream}
 */
export function cleanStream(frames) {
  return { bytes: Buffer.concat(frames), intact: frames.map(() => true) };
}

/**
 * One byte in a hundred becomes another one.
 * @param {readonly Uint8Array[]} frames
 * @param {number} spare bytes at the front of each frame that it can do without
 * @returns {Stream}
 */
export function damagedStream(frames, spare) {
  const random = randomNumbers(2);
  const { bytes, intact } = cleanStream(frames);
  let at = 0;
  for (const [index, frame] of frames.entries()) {
    for (let i = 0; i < frame.length; i++, at++) {
      if (random(100) > 0) continue;
      bytes[at] = /** @type {number} */ (bytes[at]) ^ (1 + random(255));
      if (i >= spare) intact[index] = false;
    }
  }
  return { bytes, intact };
}

const MEGABYTE = 1_000_000;

/** @param {readonly number[]} pattern */
function megabyteOf(pattern) {
  return Uint8Array.from({ length: MEGABYTE }, (_, at) => pattern[at % pattern.length] ?? 0);
}

/** The megabytes that cost a decoder of our frames the most, by name. */
export const HOSTILE = {
  zeros: megabyteOf([0]),
  'false headers': megabyteOf([0, 0, 0, 0, 0xff]),
  // Right in all but the sum, one after another.
  'almost-frames': megabyteOf([0, 0, 0, 0, 0, 0x24, 0x68, ...Array(33).fill(7), 1, 0x45]),
  // The dearest that we know: a header every six bytes, and what looks like its terminator 253 bytes on, so that each
  // is summed.
  'almost-frames inside one another': megabyteOf([0, 0, 0, 0, 0xfd, 0x45]),
};

/**
 * @template {Uint8Array} T
 * @param {Uint8Array} bytes
 * @param {number} size of the chunks
 * @param {(bytes: Uint8Array) => T} make the kind of array that a decoder is used to; it copies
 * @returns {T[]}
 */
export function chunksOf(bytes, size, make) {
  if (size > 1) {
    return Array.from({ length: Math.ceil(bytes.length / size) }, (_, i) =>
      make(bytes.subarray(i * size, (i + 1) * size)),
    );
  }
  // Single bytes are 256 arrays used again and again: it is the decoders that are to be measured, not a memory full of
  // tiny arrays.
  const singles = Array.from({ length: 256 }, (_, value) => make(Uint8Array.of(value)));
  return Array.from(bytes, (value) => /** @type {T} */ (singles[value]));
}
