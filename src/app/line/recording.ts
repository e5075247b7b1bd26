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
import { textOfFile } from '../browser/read-file.js';
import { describeFrame, frameName } from '../messages/frame-text.js';
import { plainName } from '../records/plain-names.js';
import { type LineRecord, recorder } from '../timer/line-record.js';

/** A recording of a line, from this page or another source. */
export interface Recording {
  /** The name of the file. */
  readonly name: string;
  /** The entries of the file, which a replay needs. */
  readonly entries: readonly CaptureEntry[];
  /** Their frames, and the bytes between them. Times are milliseconds since the recording began. */
  readonly records: readonly LineRecord[];
  /** Whether the timer states its identity in it: otherwise nothing can connect to a replay. */
  readonly replayable: boolean;
}

/** What is wrong with a file that is no recording. */
export interface RecordingFault {
  /** The line with the fault, counted from 1; null when the fault is in no single line. */
  readonly line: number | null;
}

/** The largest file that is read, in bytes: hours of a busy line. */
const LARGEST = 10_000_000;
/** Milliseconds without a byte after which an unfinished frame is given up. */
const SILENCE = 60;
/** The letters that may come with a bare checksum: see row 5 of docs/protocol.md. */
const BARE = [COMMANDS.GETLOWRPM.reply, COMMANDS.SETMEMORY.request, COMMANDS.SETLOWRPM.request];

export async function readRecording(file: File): Promise<Recording | RecordingFault> {
  const read = file.size > LARGEST ? null : await textOfFile(file);
  return read && 'text' in read ? parseRecording(plainName(file.name), read.text) : { line: null };
}

export function parseRecording(name: string, text: string): Recording | RecordingFault {
  let entries: CaptureEntry[];
  try {
    entries = parseCapture(text);
  } catch (error) {
    if (!(error instanceof CodecError)) throw error;
    const line = Number(error.field.replace('line ', ''));
    // The first line is the heading: without it the file is something else.
    return { line: line === 1 ? null : line };
  }
  if (entries.length === 0) return { line: null };
  const records = recordsOf(entries);
  const { request, reply } = COMMANDS.GETSWVER;
  const asked = records.findIndex(({ frame }) => frame?.code === request);
  const said = asked >= 0 && records.slice(asked).some(({ frame, layout }) => frame?.code === reply && layout.identity);
  return { name, entries, records, replayable: said };
}

/** Finds the frames in the recorded bytes, whatever pieces they came in. */
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
 * Writes entries of a line as text in the format of a capture. The meaning of each stands above it, and `notes` at the
 * top. Times count from the first entry, so nothing shows the date.
 */
export function captureText(records: readonly LineRecord[], notes: readonly string[]): string {
  const [heading = '', ...lines] = formatCapture(captureOf(records)).split('\n');
  const body = records.flatMap((record) => {
    const comment = `# ${[frameName(record), describeFrame(record, record.layout)].filter(Boolean).join(': ')}`;
    return record.bytes.length > 0 ? [comment, lines.shift() as string] : [comment];
  });
  return `${[heading, ...notes.map((note) => `# ${note}`), '', ...body].join('\n')}\n`;
}
