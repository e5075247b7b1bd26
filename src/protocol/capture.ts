import { CodecError } from './errors.js';

/** Bytes that passed on the line together. */
export interface CaptureEntry {
  /** Milliseconds since the capture began, never less than the entry before. */
  readonly time: number;
  /** `out`: to the timer. `in`: from the timer. */
  readonly direction: 'out' | 'in';
  readonly bytes: Uint8Array;
}

const HEADER = '# Sidus capture 1';
const LINE = /^(\d{1,9}(?:\.\d{1,6})?) ([<>])((?: [0-9a-f]{2})+)$/i;

/**
 * A capture as text: a heading, then a line for each entry with its time in seconds, `>` to the timer or `<` from it,
 * and the bytes in hex. Empty lines and lines that begin with `#` are skipped.
 *
 *     # Sidus capture 1
 *     0.000 > 00 00 00 00 00 03 6b 6b 45
 *     0.052 < 00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45
 */
export function formatCapture(entries: readonly CaptureEntry[]): string {
  const lines = entries.map(({ time, direction, bytes }) => {
    const hex = [...bytes].map((byte) => byte.toString(16).padStart(2, '0')).join(' ');
    return `${(time / 1000).toFixed(3)} ${direction === 'out' ? '>' : '<'} ${hex}`;
  });
  return `${[HEADER, ...lines].join('\n')}\n`;
}

/**
 * Reads a capture. Line ends may be those of any system.
 * @throws CodecError `bad-capture` with `line N` as field: no heading, a line of another form, a time before the one
 * above it.
 */
export function parseCapture(text: string): CaptureEntry[] {
  const lines = text.replace(/^\uFEFF/, '').split(/\r\n|\r|\n/);
  if (lines[0]?.trim() !== HEADER) throw refusal(1, `the first line must be “${HEADER}”`);
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

function refusal(line: number, why: string): CodecError {
  return new CodecError('bad-capture', `line ${line}`, `line ${line}: ${why}`);
}
