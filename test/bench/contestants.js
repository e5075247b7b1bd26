// The decoders, each used as its authors mean it to be, or cheaper: where a decoder is made to stand in a web stream it
// is called directly, which saves it the 2 to 4 microseconds that a web stream takes for each chunk. Each such decoder
// has a loop of its own: one that several share would be compiled for none.

import { createRequire } from 'node:module';
import { encodeFrame, FrameDecoder, ZEROS_NEEDED, ZEROS_SENT } from '../../dist/lib/protocol/index.js';
import { NOT_IN_PAYLOADS } from './streams.js';

/** Takes what is delivered: counts it, or keeps it to be checked. */
export class Sink {
  frames = 0;
  bytes = 0;
  /** @type {Uint8Array[] | null} */
  kept = null;

  /** @param {Uint8Array} data */
  take(data) {
    this.frames++;
    this.bytes += data.length;
    if (this.kept) this.kept.push(Uint8Array.from(data));
  }
}

/**
 * @typedef {object} Feed
 * @property {(chunks: readonly Uint8Array[], from: number, to: number) => number} push gives it some chunks, and says
 *   how many it took: fewer when it failed for good
 * @property {(() => void)} [end] the line is silent
 *
 * @typedef {object} Contestant
 * @property {string} name
 * @property {boolean} ours
 * @property {boolean} floor
 * @property {number} spare bytes at the front of a frame that it can do without
 * @property {(payload: Uint8Array) => Uint8Array} encode
 * @property {(bytes: Uint8Array) => Uint8Array} chunk makes a chunk of the kind it is used to
 * @property {(sink: Sink) => Feed} start a decoder that has seen nothing; streams begin to flow a tick later
 */

/** What a web stream reads from a port. @param {Uint8Array} bytes */
const plain = (bytes) => new Uint8Array(bytes);
/** What serialport reads from a port. @param {Uint8Array} bytes */
const buffer = (bytes) => Buffer.from(bytes);

const CODE = 0x68;
const WRONG = Uint8Array.of(0);

/** @type {Contestant} */
const ours = {
  name: 'sidus-timer',
  ours: true,
  floor: false,
  spare: ZEROS_SENT - ZEROS_NEEDED,
  encode: (payload) => encodeFrame(CODE, payload),
  chunk: plain,
  start(sink) {
    const decoder = new FrameDecoder();
    return {
      push(chunks, from, to) {
        for (let i = from; i < to; i++) {
          const frames = decoder.push(/** @type {Uint8Array} */ (chunks[i]));
          for (let k = 0; k < frames.length; k++) {
            const { code, data } = /** @type {import('../../dist/lib/protocol/index.js').Frame} */ (frames[k]);
            sink.take(code === CODE ? data : WRONG);
          }
        }
        return to - from;
      },
      end() {
        for (const { code, data } of decoder.idle()) sink.take(code === CODE ? data : WRONG);
      },
    };
  },
};

/** @type {Contestant} */
const floor = {
  ...ours,
  name: 'plain loop',
  ours: false,
  floor: true,
  start(sink) {
    return {
      push(chunks, from, to) {
        let sum = 0;
        for (let i = from; i < to; i++) {
          const chunk = /** @type {Uint8Array} */ (chunks[i]);
          for (let at = 0; at < chunk.length; at++) sum = (sum + /** @type {number} */ (chunk[at])) | 0;
        }
        sink.bytes = sum;
        return to - from;
      },
    };
  },
};

/**
 * A stream of Node, written to as by the port that pipes into it.
 * @param {import('node:stream').Transform} stream
 * @returns {Feed}
 */
function piped(stream) {
  return {
    push(chunks, from, to) {
      for (let i = from; i < to; i++) stream.write(chunks[i]);
      return to - from;
    },
  };
}

/**
 * The packages are not installed where the types are checked, and some have types that do not compile.
 * @typedef {new (options: object) => import('node:stream').Transform} StreamClass
 * @typedef {{ enqueue(data: Uint8Array): void, error(reason: unknown): void }} Controller
 * @typedef {{ transform(chunk: Uint8Array, controller: Controller): void }} Transformer
 */

const require = createRequire(import.meta.url);

/** @typedef {Omit<Contestant, 'ours' | 'floor' | 'spare'>} Peer a decoder of others: each byte of a frame counts */

/** @returns {Peer[]} */
function serialport() {
  /** @type {{ PacketLengthParser: StreamClass }} */
  const { PacketLengthParser } = require('@serialport/parser-packet-length');
  /** @type {{ DelimiterParser: StreamClass }} */
  const { DelimiterParser } = require('@serialport/parser-delimiter');
  /** @type {{ SlipDecoder: StreamClass, SlipEncoder: StreamClass }} */
  const { SlipDecoder, SlipEncoder } = require('@serialport/parser-slip-encoder');
  const slip = new SlipEncoder({});
  // A stream of bytes swallows empty frames; one of objects delivers them.
  const options = { readableObjectMode: true };
  return [
    {
      name: 'serialport packet-length',
      encode: (payload) => Uint8Array.of(0xaa, payload.length, ...payload),
      chunk: buffer,
      start(sink) {
        const parser = new PacketLengthParser(options);
        // It delivers the frame with its header, which is taken off only where the payload is looked at.
        return piped(parser.on('data', (packet) => sink.take(sink.kept ? packet.subarray(2) : packet)));
      },
    },
    {
      name: 'serialport delimiter',
      encode: (payload) => Uint8Array.of(...payload, NOT_IN_PAYLOADS),
      chunk: buffer,
      start(sink) {
        const parser = new DelimiterParser({ ...options, delimiter: [NOT_IN_PAYLOADS] });
        return piped(parser.on('data', (data) => sink.take(data)));
      },
    },
    {
      name: 'serialport SLIP',
      encode(payload) {
        slip.write(Buffer.from(payload));
        return slip.read();
      },
      chunk: buffer,
      start(sink) {
        return piped(new SlipDecoder(options).on('data', (data) => sink.take(data)));
      },
    },
  ];
}

/** @returns {Peer} */
function mavlink() {
  /** @type {{ MavLinkPacketSplitter: StreamClass }} */
  const { MavLinkPacketSplitter } = require('node-mavlink');
  /**
   * @type {{ x25crc(bytes: Buffer, start: number, trim: number, magic: number): number, MSG_ID_MAGIC_NUMBER:
   * Record<number, number> }}
   */
  const { x25crc, MSG_ID_MAGIC_NUMBER } = createRequire(require.resolve('node-mavlink'))('mavlink-mappings');
  const { 0: magic = 0 } = MSG_ID_MAGIC_NUMBER;
  return {
    name: 'node-mavlink splitter',
    // Version 1, the shorter one; message 0, of which the splitter knows a number that goes into the checksum, and no
    // length.
    encode(payload) {
      const packet = Buffer.from([0xfe, payload.length, 0, 1, 1, 0, ...payload, 0, 0]);
      packet.writeUInt16LE(x25crc(packet, 1, 2, magic), packet.length - 2);
      return packet;
    },
    chunk: buffer,
    start(sink) {
      const splitter = new MavLinkPacketSplitter({});
      return piped(splitter.on('data', ({ buffer }) => sink.take(sink.kept ? buffer.subarray(6, -2) : buffer)));
    },
  };
}

/** @returns {Promise<Peer>} */
async function zmk() {
  /** @type {{ get_decoder(): Transformer, get_encoder(): Transformer }} */
  const { get_decoder, get_encoder } = await load('@zmkfirmware/zmk-studio-ts-client/framing');
  return {
    name: 'ZMK framing',
    encode(payload) {
      /** @type {Uint8Array[]} */
      const pieces = [];
      get_encoder().transform(payload, { enqueue: (piece) => pieces.push(piece), error() {} });
      return Buffer.concat(pieces);
    },
    chunk: plain,
    // Made for a TransformStream, called without one. There an error ends the stream for ever, so it does here.
    start(sink) {
      const decoder = get_decoder();
      const controller = { enqueue: (/** @type {Uint8Array} */ data) => sink.take(data), error() {} };
      return {
        push(chunks, from, to) {
          let at = from;
          try {
            for (; at < to; at++) decoder.transform(/** @type {Uint8Array} */ (chunks[at]), controller);
          } catch {
            // It threw because it had put the stream in error.
          }
          return at - from;
        },
      };
    },
  };
}

/** @returns {Promise<Peer>} */
async function ucobs() {
  /**
   * @typedef {(bytes: Uint8Array) => void} Push
   * @type {{
   *   createStreamDecoder(emit: (data: Uint8Array, end: boolean) => void): Push,
   *   createBlockEncoder(emit: (data: Uint8Array) => void): Push,
   * }}
   */
  const { createStreamDecoder, createBlockEncoder } = await load('ucobs');
  return {
    name: 'ucobs',
    encode(payload) {
      let frame = new Uint8Array();
      createBlockEncoder((data) => {
        frame = new Uint8Array(data);
      })(payload);
      return frame;
    },
    chunk: plain,
    // The decoder of streams, the cheaper of its two. A frame of more than 512 bytes comes in pieces; only the last one
    // counts.
    start(sink) {
      const decode = createStreamDecoder((data, end) => {
        if (end) sink.take(data);
      });
      return {
        push(chunks, from, to) {
          for (let i = from; i < to; i++) decode(/** @type {Uint8Array} */ (chunks[i]));
          return to - from;
        },
      };
    },
  };
}

/**
 * Through a variable, so that types are checked without the package.
 * @param {string} name
 */
function load(name) {
  return import(name);
}

/**
 * All decoders, and in words those that could not be used.
 * @returns {Promise<{ contestants: Contestant[], missing: string[] }>}
 */
export async function contestants() {
  /** @type {Contestant[]} */
  const found = [ours, floor];
  const missing = [];
  for (const peers of [serialport, mavlink, zmk, ucobs]) {
    try {
      for (const peer of [await peers()].flat()) found.push({ ours: false, floor: false, spare: 0, ...peer });
    } catch (error) {
      missing.push(`${peers.name}: ${error}`);
    }
  }
  return { contestants: found, missing };
}
