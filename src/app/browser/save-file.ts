import { service } from './services.js';

/** Milliseconds that a browser may take to begin with a download. */
const BEGUN = 10_000;

/** Gives a text to the browser as a file to be saved. */
export function saveFile(name: string, text: string, type = 'text/plain'): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), BEGUN);
}

/** A file that the pilot has chosen: it can be written again without asking where. */
export type ChosenFile = Pick<FileSystemFileHandle, 'name' | 'createWritable'>;

/**
 * Asks where a file is to lie. It must begin within a few seconds of a tap.
 * @param type the kind of the file, with its endings.
 * @returns `dismissed` where the pilot chose none; null where this browser does not ask.
 */
export async function chooseFile(
  name: string,
  type: Readonly<Record<string, readonly string[]>>,
): Promise<ChosenFile | 'dismissed' | null> {
  try {
    const ask = service('showSaveFilePicker');
    return ask ? await ask({ suggestedName: name, types: [{ accept: type }] }) : null;
  } catch (error) {
    return error instanceof DOMException && error.name === 'AbortError' ? 'dismissed' : null;
  }
}

/**
 * Replaces what a file holds, all of it or nothing.
 * @throws what the browser says: the disk is full, or it is not allowed.
 */
export async function writeFile(file: ChosenFile, text: string): Promise<void> {
  const stream = await file.createWritable();
  await stream.write(text);
  await stream.close();
}
