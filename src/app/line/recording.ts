import {
  analyse,
  type CaptureEntry,
  COMMANDS,
  CodecError,
  captureOf,
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
  const record = recorder();
  const records = analyse(entries).map((entry) => record({ ...entry, error: null }));
  const { request, reply } = COMMANDS.GETSWVER;
  const asked = records.findIndex(({ frame }) => frame?.code === request);
  const said = asked >= 0 && records.slice(asked).some(({ frame, layout }) => frame?.code === reply && layout.identity);
  return { name, entries, records, replayable: said };
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
