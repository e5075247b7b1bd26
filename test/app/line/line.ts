import { parseRecording, type Recording } from '../../../src/app/line/recording.js';
import type { LineEntry, LineErrorKind } from '../../../src/client/index.js';
import {
  type Bytes,
  encodeReply,
  encodeRequest,
  type RejectionReason,
  type Reply,
  type Request,
} from '../../../src/protocol/index.js';
import { B536 } from '../../protocol/vectors.js';
import { fromHex } from '../../tools/bytes.js';

/** A frame that was sent, as a client logs it. */
export function sent(request: Request, time = 0): LineEntry {
  return frameEntry('out', encodeRequest(request), time);
}

/** A frame that came from a timer of the example. */
export function came(reply: Reply, time = 0): LineEntry {
  return frameEntry('in', encodeReply(reply, { identity: B536 }), time);
}

/** Any whole frame, from its five zeros on. */
export function frameEntry(direction: 'in' | 'out', bytes: Bytes, time = 0): LineEntry {
  const frame = { code: bytes[6] as number, data: bytes.slice(7, -2) };
  return { time, direction, bytes, frame, rejected: null, error: null };
}

/** Bytes that belong to no frame. */
export function damage(rejected: RejectionReason, hex: string, time = 0): LineEntry {
  return { time, direction: 'in', bytes: fromHex(hex), frame: null, rejected, error: null };
}

/** An error that the port told of. */
export function lineError(error: LineErrorKind, time = 0): LineEntry {
  return { time, direction: 'in', bytes: new Uint8Array(), frame: null, rejected: null, error };
}

/** What the timer of the example says of itself. */
export const IDENTIFIED: readonly LineEntry[] = [
  sent({ name: 'GETSWVER' }),
  came({ name: 'GETSWVER', identity: B536 }),
];

/** The recording in a text that is one. */
export function recordingOf(text: string): Recording {
  const read = parseRecording('x', text);
  if ('line' in read) throw new Error(`It is no recording: line ${read.line}.`);
  return read;
}
