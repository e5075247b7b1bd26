// What holds for decoder and codecs whatever comes: each law as a property of the package that is handed in, so that
// the unit tests can try them on the source for a moment and `npm run fuzz` on the built package for minutes.

import fc from 'fast-check';
import { framesOf, isRight, PageDecoder } from '../protocol/reference.js';
import { options, replyFor, requestFor } from './messages.js';
import { anyByte, bareChecksum, byte, hex, pieces, piecesAndSilence, stream, usual } from './streams.js';

/**
 * @typedef {import('../../src/protocol/index.js').Frame<Uint8Array>} Frame
 * @typedef {Pick<typeof import('../../src/protocol/index.js'), 'CodecError' | 'decodeReply' | 'decodeRequest' |
 *   'encodeFrame' | 'encodeReply' | 'encodeRequest' | 'FrameDecoder'>} Protocol
 */

/** A frame that is not whole yet, less the byte that would make it so. */
const MOST_HELD = 255;
/** Zeros that are shown before what a decoder tells of. */
const ZEROS_SHOWN = 5;

/** @param {string} actual @param {string} expected @param {string} what */
function same(actual, expected, what) {
  if (actual !== expected) throw new Error(`${what}\n  is        ${actual}\n  should be ${expected}`);
}

/** @param {boolean} holds @param {string} what */
export function hold(holds, what) {
  if (!holds) throw new Error(what);
}

/** @param {readonly Frame[]} frames */
function shown(frames) {
  return frames.map(({ code, data }) => hex([code, ...data])).join(' / ') || 'no frame';
}

/** @param {unknown} value */
function text(value) {
  return JSON.stringify(value, (_, part) =>
    part && typeof part === 'object' && !Array.isArray(part) ? sorted(part) : part,
  );
}

/** @param {Record<string, unknown>} record */
function sorted(record) {
  return Object.fromEntries(Object.entries(record).sort(([a], [b]) => (a < b ? -1 : 1)));
}

/** The frames of a stream that comes in these pieces and then falls silent. @param {Protocol} protocol */
function decoderOf({ FrameDecoder }) {
  return (/** @type {Uint8Array} */ bytes, /** @type {import('./streams.js').Cut} */ cut) => {
    const decoder = new FrameDecoder();
    const frames = cut.of(bytes).flatMap(({ piece }) => decoder.push(piece));
    return [...frames, ...decoder.idle()];
  };
}

/** @type {Record<string, (protocol: Protocol) => fc.IProperty<any>>} */
export const LAWS = {
  'round trip: a frame comes back as it was': ({ encodeFrame, FrameDecoder }) =>
    fc.property(byte, fc.array(anyByte, { maxLength: 252, size: 'max' }), (code, data) => {
      const bytes = encodeFrame(code, data);
      hold(isRight(bytes, 5), `no right frame: ${hex(bytes)}`);
      same(shown(new FrameDecoder().push(bytes)), hex([code, ...data]), 'the frame');
    }),

  'round trip: a message comes back as it was': ({ FrameDecoder, ...codec }) =>
    fc.property(
      options.chain((timer) => fc.tuple(fc.constant(timer), requestFor(timer), replyFor(timer))),
      ([timer, request, reply]) => {
        const decoder = new FrameDecoder({ quirks: { bareChecksum: [0x63, 0x69, 0x72, 0x73, 0x76, 0x77] } });
        /** @param {Uint8Array} bytes */
        const frameOf = (bytes) => /** @type {Frame} */ (decoder.push(bytes)[0]);
        // Longer frames with a bare checksum are none: a decoder takes that for frames of one byte of data alone.
        const usually = { ...timer, bareChecksum: false };
        const asked = codec.encodeRequest(request, 'memory' in request ? timer : usually);
        same(text(codec.decodeRequest(frameOf(asked), timer)), text(request), 'the request');
        const answer = codec.encodeReply(reply, 'idleThrottle' in reply ? timer : usually);
        same(text(codec.decodeReply(frameOf(answer), { ...timer, pending: reply.name })), text(reply), 'the reply');
      },
    ),

  'round trip: bytes come back as they were, or are refused by code': ({ FrameDecoder, encodeFrame, ...codec }) => {
    const ways = {
      request: { encode: codec.encodeRequest, decode: codec.decodeRequest, message: requestFor },
      reply: { encode: codec.encodeReply, decode: codec.decodeReply, message: replyFor },
    };
    /** A message as bytes, with one byte of its data changed. */
    const changed = fc.tuple(options, fc.constantFrom('request', 'reply'), fc.boolean()).chain(([timer, way, known]) =>
      fc.record({
        way: fc.constant(way),
        layout: fc.constant({ quirks: timer.quirks, identity: known ? timer.identity : undefined }),
        message: ways[way].message(timer),
        change: fc.option(fc.tuple(fc.nat(255), byte)),
      }),
    );
    return fc.property(changed, ({ way, layout, message, change }) => {
      const { encode, decode } = ways[way];
      const [frame] = new FrameDecoder().push(encode(/** @type {any} */ (message), layout));
      if (!frame) throw new Error('the decoder does not find the frame of the encoder');
      if (change && frame.data.length > 0) frame.data[change[0] % frame.data.length] = change[1];
      /** @type {any} */
      let values;
      try {
        values = decode(frame, layout);
      } catch (error) {
        hold(error instanceof codec.CodecError, String(error));
        return;
      }
      // Nobody knows what the two separators of a version are for: any are read, and spaces are written.
      if (way === 'reply' && values.name === 'GETSWVER') frame.data.fill(0x20, 4, 5).fill(0x20, 8, 9);
      same(hex(encode(values, layout)), hex(encodeFrame(frame.code, frame.data)), 'the bytes');
    });
  },

  'any split: the same frames whatever the pieces': (protocol) => {
    const decode = decoderOf(protocol);
    return fc.property(stream, pieces, pieces, ({ bytes }, one, other) => {
      same(shown(decode(bytes, one)), shown(decode(bytes, other)), 'the frames');
    });
  },

  'resynchronisation: exactly the frames of the law, whatever is around them': (protocol) => {
    const decode = decoderOf(protocol);
    return fc.property(stream, pieces, ({ bytes }, cut) => {
      same(shown(decode(bytes, cut)), shown(framesOf(bytes)), 'the frames');
    });
  },

  'silence: exactly the frames of the protocol page, each as soon as it says': ({ FrameDecoder }) =>
    fc.property(stream, piecesAndSilence, ({ bytes }, cut) => {
      const decoder = new FrameDecoder();
      const page = new PageDecoder();
      for (const [index, { piece, silent }] of cut.of(bytes).entries()) {
        same(shown(decoder.push(piece)), shown(page.push(piece)), `the frames of piece ${index}`);
        if (silent) same(shown(decoder.idle()), shown(page.idle()), `the frames of the silence after piece ${index}`);
      }
      same(shown(decoder.idle()), shown(page.idle()), 'the frames at the end');
    }),

  'every byte is told of once: as part of a frame or as passed over': ({ FrameDecoder }) =>
    fc.property(stream, piecesAndSilence, ({ bytes }, cut) => {
      /** @type {number[]} */
      const told = [];
      const decoder = new FrameDecoder({
        onFrame: (_, wire) => told.push(...wire),
        onRejected: (rejection) => told.push(...rejection.bytes),
      });
      for (const { piece, silent } of cut.of(bytes)) {
        decoder.push(piece);
        if (silent) decoder.idle();
      }
      decoder.idle();
      // Of more than five zeros five are shown, and those at the very end still wait for what follows.
      /** @param {Iterable<number>} all */
      const plain = (all) =>
        hex(all)
          .replaceAll(/(00 ?){5,}/g, '00 00 00 00 00 ')
          .replace(/(00 ?)+$/, '')
          .trim();
      same(plain(told), plain(bytes), 'what was told');
    }),

  'never throws, never invents: each frame stands in the stream with a right length, sum and end': ({ FrameDecoder }) =>
    fc.property(stream, piecesAndSilence, bareChecksum, ({ bytes }, cut, bare) => {
      /** @type {{ frame: Frame, wire: Uint8Array, bare: boolean }[]} */
      const told = [];
      const decoder = new FrameDecoder({
        quirks: { bareChecksum: bare },
        onFrame: (frame, wire, isBare) => told.push({ frame, wire, bare: isBare }),
      });
      /** @type {Frame[]} */
      const delivered = [];
      for (const { piece, silent } of cut.of(bytes)) {
        delivered.push(...decoder.push(piece));
        if (silent) delivered.push(...decoder.idle());
      }
      delivered.push(...decoder.idle());
      same(shown(delivered), shown(told.map(({ frame }) => frame)), 'the delivered frames');
      const all = hex(bytes);
      let from = 0;
      for (const { frame, wire, bare: isBare } of told) {
        const begin = wire.findIndex((value) => value !== 0);
        hold(begin >= 4, `too few zeros: ${hex(wire)}`);
        const right = isRight(wire, begin);
        const letters = bare === true ? [0x76] : bare || [];
        const takenBare =
          letters.includes(frame.code) && wire[begin] === 4 && wire.at(-2) === frame.code && wire.at(-1) === 0x45;
        hold(isBare ? takenBare : right, `no right frame: ${hex(wire)}`);
        same(hex(wire.subarray(begin + 1, -2)), hex([frame.code, ...frame.data]), 'the frame');
        const at = all.indexOf(hex(wire.subarray(begin)), from);
        hold(at >= 0, `not in the stream: ${hex(wire)}`);
        from = at + 3 * (wire.length - begin);
      }
    }),

  'holds no more than one longest frame': ({ FrameDecoder }) =>
    fc.property(stream, piecesAndSilence, ({ bytes }, cut) => {
      let told = 0;
      const decoder = new FrameDecoder({
        onFrame: (_, wire) => {
          told += wire.length - ZEROS_SHOWN;
        },
        onRejected: (rejection) => {
          told += rejection.bytes.length;
        },
      });
      /** What can be told of: what was held, what comes now, and of the zeros before it five. @param {number} come */
      const most = (come) => (decoder.waiting ? MOST_HELD + ZEROS_SHOWN : ZEROS_SHOWN) + come;
      for (const { piece, silent } of cut.of(bytes)) {
        let limit = most(piece.length);
        told = 0;
        decoder.push(piece);
        hold(told <= limit, `${told} bytes told of when at most ${limit} were there`);
        if (!silent) continue;
        limit = most(0);
        told = 0;
        decoder.idle();
        hold(told <= limit, `${told} bytes were held when at most ${limit} may be`);
        hold(!decoder.waiting, 'waits although all is given up');
      }
    }),

  'frames own their data: neither the chunk nor another frame changes it': ({ FrameDecoder }) =>
    fc.property(fc.array(usual, { minLength: 1, maxLength: 6 }), pieces, (frames, cut) => {
      const bytes = Uint8Array.from(frames.flatMap((frame) => [...frame]));
      const decoder = new FrameDecoder();
      const delivered = cut.of(bytes).flatMap(({ piece }) => {
        const found = decoder.push(piece);
        piece.fill(0xee);
        return found;
      });
      delivered.push(...decoder.idle());
      same(shown(delivered), shown(framesOf(bytes)), 'the frames, with their chunks overwritten');
      for (const { data } of delivered.filter((_, index) => index % 2 === 0)) data.fill(0xdd);
      const others = framesOf(bytes).map(({ code, data }, index) => ({
        code,
        data: index % 2 === 0 ? data.fill(0xdd) : data,
      }));
      same(shown(delivered), shown(others), 'the frames, with every other one overwritten');
    }),
};
