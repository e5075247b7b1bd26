import type { CaptureEntry } from './capture.js';
import { COMMANDS, type CommandName, type Reply, type Request } from './commands.js';
import { FrameDecoder, type RejectionReason } from './decoder.js';
import { CodecError } from './errors.js';
import type { LayoutQuirks } from './fields.js';
import type { Frame } from './frame.js';
import type { Identity } from './identity.js';
import { answers, decodeReply, decodeRequest } from './messages.js';

/** A frame in a recording, or bytes that belong to none. */
export interface AnalysedEntry extends CaptureEntry {
  /** Null for bytes that belong to no frame. */
  readonly frame: Frame | null;
  /** Why the bytes belong to no frame; null for a frame. */
  readonly rejected: RejectionReason | null;
  /** What the frame says, by what the timer had said about itself until then; null when it cannot be read. */
  readonly message: Request | Reply | null;
  /** For a reply, the index of the request that it answers: the latest before it, once. Null for anything else. */
  readonly answers: number | null;
}

/** Milliseconds without a byte after which an unfinished frame is given up. */
const SILENCE = 60;
/** The letters that may come with a bare checksum: see row 5 of docs/protocol.md. */
const BARE = [COMMANDS.GETLOWRPM.reply, COMMANDS.SETMEMORY.request, COMMANDS.SETLOWRPM.request];

/**
 * Finds the frames in a recording, whatever pieces the bytes came in, reads them, and says which reply answers which
 * request.
 * @param entries as `parseCapture` gives them. `captureOf` makes them from what a client has reported.
 * @param quirks how this timer differs. Default: not at all.
 * @example
 * ```ts
 * import { analyse, encodeReply, encodeRequest } from 'sidus-timer/protocol';
 *
 * const [, said] = analyse([
 *   { time: 0, direction: 'out', bytes: encodeRequest({ name: 'GETMEMORY' }) },
 *   { time: 30, direction: 'in', bytes: encodeReply({ name: 'GETMEMORY', memory: 2 }) },
 * ]);
 * console.log(said?.message?.name, said?.answers); // GETMEMORY 0
 * ```
 */
export function analyse(entries: readonly CaptureEntry<Uint8Array>[], quirks: LayoutQuirks = {}): AnalysedEntry[] {
  const found: AnalysedEntry[] = [];
  let now = 0;
  let identity: Identity | undefined;
  let asked: { readonly name: CommandName; readonly index: number } | undefined;
  const sent = (frame: Frame): Partial<AnalysedEntry> => {
    const message = read(() => decodeRequest(frame, { identity, quirks }));
    asked = message ? { name: message.name, index: found.length } : undefined;
    return { message };
  };
  const came = (frame: Frame): Partial<AnalysedEntry> => {
    const pending = asked && answers(frame.code, asked.name) ? asked : undefined;
    const message = read(() => decodeReply(frame, { identity, quirks, pending: pending?.name }));
    if (pending) asked = undefined;
    if (message?.name === 'GETSWVER') identity = message.identity;
    return { message, answers: pending?.index ?? null };
  };
  const listen = (direction: 'out' | 'in') => {
    const keep = (part: Pick<AnalysedEntry, 'bytes'> & Partial<AnalysedEntry>): void =>
      void found.push({ time: now, direction, frame: null, rejected: null, message: null, answers: null, ...part });
    const decoder = new FrameDecoder({
      quirks: { bareChecksum: BARE },
      onFrame: (frame, bytes) => keep({ bytes, frame, ...(direction === 'out' ? sent(frame) : came(frame)) }),
      onRejected: ({ reason, bytes }) => keep({ bytes, rejected: reason }),
    });
    return { decoder, heard: 0 };
  };
  const ears = { out: listen('out'), in: listen('in') };
  for (const { time, direction, bytes } of entries) {
    for (const { decoder, heard } of Object.values(ears)) if (time - heard > SILENCE) decoder.idle();
    now = time;
    ears[direction].heard = time;
    ears[direction].decoder.push(bytes);
  }
  for (const { decoder } of Object.values(ears)) decoder.idle();
  return found;
}

function read<Message>(message: () => Message): Message | null {
  try {
    return message();
  } catch (error) {
    if (error instanceof CodecError) return null;
    throw error;
  }
}
