import type { LineEntry } from '../../client/index.js';
import {
  type CaptureEntry,
  COMMANDS,
  CodecError,
  captureOf,
  FrameDecoder,
  formatCapture,
  parseCapture,
} from '../../protocol/index.js';
import { describeFrame, frameName } from '../messages/frame-text.js';
import { type LineRecord, recorder } from '../session/line-record.js';

/** A line that was recorded, here or elsewhere. */
export interface Recording {
  /** The name of the file. */
  readonly name: string;
  /** As they stand in the file: what a replay needs. */
  readonly entries: readonly CaptureEntry[];
  /** The frames in them, and the bytes between. Times are milliseconds since the recording began. */
  readonly records: readonly LineRecord[];
  /** Whether the timer says in it what it is: without that nothing can connect to a replay. */
  readonly replayable: boolean;
}

/**
 * Why a file is no recording: it begins with another line, one of its lines is of another form, or it has no entries.
 */
export type RecordingFault = 'heading' | 'line' | 'empty' | 'too-large' | 'unreadable';

/** A file that cannot be taken for a recording. */
export class RecordingError extends Error {
  override readonly name = 'RecordingError';
  readonly fault: RecordingFault;
  /** Counts from 1; 0 where the fault is of no one line. */
  readonly line: number;

  constructor(fault: RecordingFault, line = 0, cause?: unknown) {
    super(`no recording: ${fault}`, { cause });
    this.fault = fault;
    this.line = line;
  }
}

/** Bytes of the largest file that is read: hours of a busy line. */
const LARGEST = 10_000_000;
/** Milliseconds without a byte after which a frame that is not whole is given up. */
const SILENCE = 60;
/** The letters that may come with a bare checksum: see row 5 of the protocol page. */
const BARE = [COMMANDS.GETLOWRPM.reply, COMMANDS.SETMEMORY.request, COMMANDS.SETLOWRPM.request];

/** @throws RecordingError */
export async function readRecording(file: File): Promise<Recording> {
  if (file.size > LARGEST) throw new RecordingError('too-large');
  const text = await file.text().catch((error: unknown) => {
    throw new RecordingError('unreadable', 0, error);
  });
  return parseRecording(file.name, text);
}

/** @throws RecordingError `heading`, `line` or `empty`. */
export function parseRecording(name: string, text: string): Recording {
  const entries = parsed(text);
  if (entries.length === 0) throw new RecordingError('empty');
  const records = recordsOf(entries);
  const { request, reply } = COMMANDS.GETSWVER;
  const asked = records.findIndex(({ frame }) => frame?.code === request);
  const said = asked >= 0 && records.slice(asked).some(({ frame, layout }) => frame?.code === reply && layout.identity);
  return { name, entries, records, replayable: said };
}

function parsed(text: string): CaptureEntry[] {
  try {
    return parseCapture(text);
  } catch (error) {
    if (!(error instanceof CodecError)) throw error;
    const line = Number(error.field.replace('line ', ''));
    throw new RecordingError(line === 1 ? 'heading' : 'line', line, error);
  }
}

/** Finds the frames in bytes that may have been recorded in any pieces. */
function recordsOf(entries: readonly CaptureEntry[]): LineRecord[] {
  const records: LineRecord[] = [];
  const record = recorder();
  let now = 0;
  const listen = (direction: 'out' | 'in') => {
    const keep = (part: Pick<LineEntry, 'bytes' | 'frame' | 'rejected'>): void =>
      void records.push(record({ time: now, direction, error: null, ...part }));
    const decoder = new FrameDecoder({
      quirks: { bareChecksum: BARE },
      onFrame: (frame, bytes) => keep({ bytes, frame, rejected: null }),
      onRejected: ({ reason, bytes }) => keep({ bytes, frame: null, rejected: reason }),
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
  return records;
}

/**
 * Entries of a line as text, in the format of a capture: what each one means stands above it, and `notes` stand at the
 * top. Times count from the first entry, so that nothing tells when it was.
 */
export function captureText(records: readonly LineRecord[], notes: readonly string[]): string {
  const [heading = '', ...lines] = formatCapture(captureOf(records)).split('\n');
  const body = records.flatMap((record) => {
    const comment = `# ${[frameName(record), describeFrame(record, record.layout)].filter(Boolean).join(': ')}`;
    return record.bytes.length > 0 ? [comment, lines.shift() as string] : [comment];
  });
  return `${[heading, ...notes.map((note) => `# ${note}`), '', ...body].join('\n')}\n`;
}
