import { CodecError } from './errors.js';
import type { Bytes } from './frame.js';

/** Bytes that passed on the line together. */
export interface CaptureEntry<Data extends Uint8Array = Bytes> {
  /** Milliseconds since the capture began. Never less than in the entry before. */
  readonly time: number;
  /** `out`: to the timer. `in`: from the timer. */
  readonly direction: 'out' | 'in';
  /** One byte or more. */
  readonly bytes: Data;
}

const HEADER = '# Sidus capture 1';
/** Seconds of nine digits, in milliseconds. */
const LONGEST_CAPTURE = 1e12 - 1;
const LINE = /^(\d{1,9}(?:\.\d{1,6})?) ([<>])((?: [0-9a-f]{2})+)$/i;

/**
 * Writes a capture as text: a heading, then one line for each entry. A line has the time in seconds with three
 * decimals, `>` (to the timer) or `<` (from it), and the bytes in hex. A reader skips empty lines and lines that begin
 * with `#`.
 *
 * ```text
 * # Sidus capture 1
 * 0.000 > 00 00 00 00 00 03 6b 6b 45
 * 0.052 < 00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45
 * ```
 * @throws CodecError `bad-capture` with `entry N` as field, counted from 0, for an entry that {@link parseCapture}
 * could not read back: a time that is negative, past the longest capture (31 years) or before the one above it; no
 * bytes, or what is no byte; no direction. {@link captureOf} turns times since 1970 into times of a capture.
 */
export function formatCapture(entries: readonly CaptureEntry<Uint8Array>[]): string {
  let previous = 0;
  const lines = entries.map(({ time, direction, bytes }, index) => {
    if (!(time >= previous && time <= LONGEST_CAPTURE)) {
      throw entryRefusal(index, 'its time must be a time since the capture began, and none before the one above it');
    }
    if (!(bytes?.length > 0)) throw entryRefusal(index, 'it must have bytes');
    if (!Array.from(bytes).every((byte) => Number.isInteger(byte) && byte >= 0 && byte <= 255))
      throw entryRefusal(index, 'its bytes must be 0 to 255');
    if (direction !== 'out' && direction !== 'in') throw entryRefusal(index, 'its direction must be “out” or “in”');
    previous = time;
    const hex = [...bytes].map((byte) => byte.toString(16).padStart(2, '0')).join(' ');
    return `${(time / 1000).toFixed(3)} ${direction === 'out' ? '>' : '<'} ${hex}`;
  });
  return `${[HEADER, ...lines].join('\n')}\n`;
}

/**
 * Reads a capture with the line ends of any system.
 * @throws CodecError `bad-capture` with `line N` as field: no heading, a line of another form, a time before the one
 * above it.
 */
export function parseCapture(text: string): CaptureEntry[] {
  const lines = text.split(/\r\n|\r|\n/);
  // trim() removes a byte order mark, too.
  if ((lines[0] as string).trim() !== HEADER) throw refusal(1, `the first line must be “${HEADER}”`);
  const entries: CaptureEntry[] = [];
  lines.forEach((line, index) => {
    const trimmed = line.trim();
    if (trimmed === '' || trimmed.startsWith('#')) return;
    const match = LINE.exec(trimmed.replaceAll(/\s+/g, ' '));
    if (!match) throw refusal(index + 1, 'expected a time in seconds, < or >, and bytes in hex');
    const [, seconds, sign, hex] = match as unknown as [string, string, string, string];
    const time = Math.round(Number(seconds) * 1e6) / 1e3;
    const previous = entries.at(-1)?.time ?? 0;
    if (time < previous) throw refusal(index + 1, 'a time must not be before the one above it');
    const bytes = Uint8Array.from(hex.trim().split(' '), (byte) => Number.parseInt(byte, 16));
    entries.push({ time, direction: sign === '>' ? 'out' : 'in', bytes });
  });
  return entries;
}

/**
 * Makes a capture of what was seen on the line, such as the entries of the client's `onLine`. It takes the entries that
 * have bytes, and counts time from the first of them.
 * @param entries times in milliseconds, from any start. A time that runs backwards, as after a correction of the clock,
 * counts as the one before it.
 * @example
 * ```ts
 * import { TimerClient } from 'sidus-timer/client';
 * import { type CaptureEntry, captureOf, formatCapture } from 'sidus-timer/protocol';
 * import { VirtualTimer } from 'sidus-timer/simulator';
 *
 * const seen: CaptureEntry[] = [];
 * const timer = new TimerClient(new VirtualTimer(), { onLine: (entry) => seen.push(entry) });
 * await timer.identify();
 * await timer.close();
 * console.log(formatCapture(captureOf(seen)).split('\n')[1]); // 0.000 > 00 00 00 00 00 03 6b 6b 45
 * ```
 */
export function captureOf<Data extends Uint8Array>(entries: readonly CaptureEntry<Data>[]): CaptureEntry<Data>[] {
  const seen = entries.filter(({ bytes }) => bytes.length > 0);
  const begin = seen[0]?.time ?? 0;
  let latest = 0;
  return seen.map(({ time, direction, bytes }) => {
    latest = Math.max(latest, time - begin);
    return { time: latest, direction, bytes };
  });
}

function entryRefusal(index: number, why: string): CodecError {
  return new CodecError('bad-capture', `entry ${index}`, `entry ${index}: ${why}`);
}

function refusal(line: number, why: string): CodecError {
  return new CodecError('bad-capture', `line ${line}`, `line ${line}: ${why}`);
}
