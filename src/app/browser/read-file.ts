import { attempt } from './services.js';

/** A file of more bytes is not even read: a library of 20 million characters has at most three bytes for each. */
const LARGEST = 60_000_000;
/** How long a disk, or a network drive, may take to give a file, or for a step of taking one, in milliseconds. */
export const PATIENCE = 60_000;

/** Why a file could not be read as a text. */
export type UnreadableFile = 'too-large' | 'no-text' | 'gone';

/** The text of a file, whether it is in UTF-8 or in UTF-16 with its mark. */
export async function textOfFile(file: Blob): Promise<{ text: string } | { unreadable: UnreadableFile }> {
  if (file.size > LARGEST) return { unreadable: 'too-large' };
  let bytes: ArrayBuffer;
  try {
    bytes = await attempt(() => file.arrayBuffer(), PATIENCE);
  } catch {
    return { unreadable: 'gone' };
  }
  const [first, second] = new Uint8Array(bytes);
  const encoding =
    first === 0xff && second === 0xfe ? 'utf-16le' : first === 0xfe && second === 0xff ? 'utf-16be' : 'utf-8';
  try {
    return { text: new TextDecoder(encoding, { fatal: true }).decode(bytes) };
  } catch {
    return { unreadable: 'no-text' };
  }
}
