import { PATIENCE } from './read-file.js';
import { attempt, service } from './services.js';

/** How long a browser may take to begin a download, in milliseconds. */
const BEGUN = 10_000;

/** Hands a text to the browser, to save it as a file. */
export function saveFile(name: string, text: string, type = 'text/plain'): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), BEGUN);
}

/** A file that the pilot has chosen. The page can write it again without asking. */
export type ChosenFile = Pick<FileSystemFileHandle, 'name' | 'createWritable'>;

/**
 * Asks where to save a file. Call it within a few seconds after a click.
 * @param type the kind of the file, with its endings.
 * @returns `dismissed` when the pilot chose no file; null when this browser cannot ask.
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

/** For each file, the end of its last write: also of a step that was given up and goes on. */
const ends = new WeakMap<ChosenFile, Promise<unknown>>();

/**
 * Replaces the whole content of a file, or changes nothing. Several writes reach the file in the order of the calls.
 * @throws the error of the browser: the disk is full, or writing is not allowed; an Error when the disk, or a network
 * drive, does not take it within a minute for each step. If it hangs at the last one, it may still take it later.
 */
export async function writeFile(file: ChosenFile, text: string): Promise<void> {
  const before = ends.get(file) ?? Promise.resolve();
  const steps: Promise<unknown>[] = [before];
  const written = writeAfter(before, file, text, steps);
  ends.set(
    file,
    written.catch(() => {}).then(() => Promise.allSettled(steps)),
  );
  await written;
}

/** @param steps takes each step that was begun. */
async function writeAfter(
  before: Promise<unknown>,
  file: ChosenFile,
  text: string,
  steps: Promise<unknown>[],
): Promise<void> {
  const begin = <T>(step: () => Promise<T>): Promise<T> =>
    attempt(() => {
      const begun = step();
      steps.push(begun);
      return begun;
    }, PATIENCE);
  // An earlier write that hangs holds this one up no longer than a step of its own would.
  await attempt(() => before, PATIENCE);
  const opening = file.createWritable();
  try {
    const stream = await begin(() => opening);
    await begin(() => stream.write(text));
    await begin(() => stream.close());
  } catch (error) {
    // A drive that comes back later must not put this over what was saved since. A close that has begun goes on.
    opening.then((stream) => stream.abort()).catch(() => {});
    throw error;
  }
}
