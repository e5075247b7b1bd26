import { type ReadonlySignal, signal } from '@preact/signals';
import type { CodecError } from '../../../protocol/index.js';
import { askForFiles } from '../../browser/ask-for-file.js';
import { textOfFile, type UnreadableFile } from '../../browser/read-file.js';
import { type ChosenFile, chooseFile, saveFile, writeFile } from '../../browser/save-file.js';
import { version } from '../../browser/version.js';
import type { Collection } from '../../session/collection.js';
import { type Library, newId } from '../../session/library.js';
import type { StorageErrorCode } from '../../storage/index.js';
import { ExportMarks } from './export-marks.js';
import { type EntryCounts, type Group, type Records, recordsOf, type Way } from './import-plan.js';
import { lookInto, undoOf } from './import-work.js';
import { type FilePart, type Made, partOf, textOf } from './library-text.js';

/** What is imported just now. */
export type ImportStep =
  | { readonly step: 'reading'; readonly name: string }
  | { readonly step: 'refused'; readonly name: string; readonly why: FileRefusal }
  | ({ readonly step: 'plan'; readonly name: string; readonly writtenAt: number; readonly writtenBy: string } & {
      readonly ignored: number;
      readonly holds: EntryCounts;
      /** What the file would bring, beside what the library holds at this moment. */
      readonly groups: ReadonlySignal<readonly Group[]>;
      readonly ways: ReadonlySignal<Ways>;
    });
export type FileRefusal = UnreadableFile | 'several' | 'failed' | CodecError;

/** What becomes of what differs: for all, and for some models by themselves. */
export interface Ways {
  readonly all: Way;
  readonly of: ReadonlyMap<string | null, Way>;
}

/** What was done last. */
export type FileWord =
  | { readonly kind: 'saving'; readonly name: string }
  | { readonly kind: 'importing'; readonly name: string; readonly done: number; readonly of: number }
  | { readonly kind: 'saved' | 'downloaded' | 'not-written'; readonly name: string; readonly holds: EntryCounts }
  | { readonly kind: 'too-large' | 'nothing' | 'failed' | 'undone' | 'partly-undone' }
  | { readonly kind: 'imported'; readonly name: string; readonly holds: EntryCounts; readonly kept: boolean };

/** What a file of everything is called before its date. */
export const ALL_NAME = 'Sidus library';
/** What the pilot is asked for. */
export const ACCEPTED = '.sidus,.json,application/json';
/** The kind of a library file, and its endings. */
const TYPE = { 'application/json': ['.sidus.json', '.sidus'] };
/** So many records are kept at once. */
const AT_A_TIME = 200;
const ENDING = '.sidus.json';

/** What stands in the library, and was there before the import. */
interface Done {
  readonly put: Records;
  readonly before: Records;
}

export interface LibraryFilesParts {
  readonly library: Library;
  /** Why the browser does not give out what it keeps; null while all is well. */
  readonly storage: ReadonlySignal<StorageErrorCode | null>;
}

/** Takes the library out into files, and takes files into it. */
export class LibraryFiles {
  readonly #current = signal<ImportStep | null>(null, { name: 'import' });
  readonly #said = signal<FileWord | null>(null, { name: 'fileWord' });
  readonly #chosen = signal<ReadonlyMap<string, ChosenFile>>(new Map());
  readonly #ways = signal<Ways>({ all: 'newer', of: new Map() });
  readonly current: ReadonlySignal<ImportStep | null> = this.#current;
  readonly said: ReadonlySignal<FileWord | null> = this.#said;
  /** When it was exported last, and when the pilot did not want to hear of it. */
  readonly marks: ExportMarks;
  readonly #parts: LibraryFilesParts;
  #done: Done | null = null;
  /** Grows when something else is begun: what comes back later is not wanted any more. */
  #turn = 0;

  constructor(parts: LibraryFilesParts) {
    this.#parts = parts;
    this.marks = new ExportMarks(parts.library);
  }

  /** The file that this part was saved to, as long as the page is open. */
  chosen(part: FilePart): ChosenFile | null {
    return this.#chosen.value.get(keyOf(part)) ?? null;
  }

  /**
   * Saves a part of the library to a file: to the one that was chosen before, to one that the pilot chooses, or into
   * the downloads.
   * @param another asks for a file in any case.
   * @param title what the file is called before its date.
   */
  async export(part: FilePart, title: string, another = false): Promise<void> {
    this.#done = null;
    this.#say(null);
    const fileName = `${safeName(title)} ${dayName(new Date())}${ENDING}`;
    const now = Date.now();
    const made = await this.#textOf(part, now);
    if (typeof made === 'string') return this.#say({ kind: made });
    const { text, holds } = made;
    let file = another ? null : this.chosen(part);
    if (!file) {
      const answer = await chooseFile(fileName, TYPE);
      if (answer === 'dismissed') return;
      file = answer;
    }
    const isWritten = file !== null && (await this.#writeTo(file, text));
    if (!isWritten) saveFile(fileName, text, 'application/json');
    this.#remember(part, isWritten ? file : null);
    if (part.kind === 'all') this.marks.exported(now);
    const name = file?.name ?? fileName;
    this.#say({ kind: isWritten ? 'saved' : file ? 'not-written' : 'downloaded', name, holds });
  }

  /** Saves all of the library; see {@link export}. */
  async exportAll(another = false): Promise<void> {
    await this.export({ kind: 'all' }, ALL_NAME, another);
  }

  /** Asks for a file, and looks at it. */
  ask(): void {
    askForFiles(ACCEPTED, (files) => void this.open(files));
  }

  /** Looks at what a file would bring. Nothing is taken before the pilot says so. */
  async open(chosen: readonly File[]): Promise<void> {
    const [file, more] = chosen;
    if (!file) return;
    const turn = ++this.#turn;
    const { name } = file;
    const show = (step: ImportStep): void => {
      if (turn === this.#turn) this.#current.value = step;
    };
    if (more) return show({ step: 'refused', name, why: 'several' });
    show({ step: 'reading', name });
    const read = await textOfFile(file);
    if ('unreadable' in read) return show({ step: 'refused', name, why: read.unreadable });
    try {
      await this.#load();
      const found = lookInto(read.text, () => this.#records());
      if ('refused' in found) return show({ step: 'refused', name, why: found.refused });
      this.#ways.value = { all: 'newer', of: new Map() };
      show({ step: 'plan', name, ...found, ways: this.#ways });
    } catch {
      // A fault of ours; no reason to leave the pilot before a dialog that says that the file is read.
      show({ step: 'refused', name, why: 'failed' });
    }
  }

  /** Chooses what becomes of what differs; of one model, or of all. */
  choose(way: Way, group?: Group): void {
    const { all, of } = this.#ways.peek();
    this.#ways.value = group ? { all, of: new Map(of).set(group.id, way) } : { all: way, of: new Map() };
  }

  /** An import would not see what the browser keeps, and might put something older over it. */
  get shut(): boolean {
    const { library, storage } = this.#parts;
    const unseen = [library.models, library.settings, library.flights].some(({ failed }) => failed.value);
    // Where there is no storage nothing is hidden in it.
    return storage.value !== 'missing' && (unseen || (storage.value !== null && storage.value !== 'full'));
  }

  /** Takes in what the plan shows. */
  async take(): Promise<void> {
    const step = this.#current.peek();
    if (step?.step !== 'plan' || this.shut) return;
    const { all: way, of } = this.#ways.peek();
    const before = this.#records();
    const put = recordsOf(step.groups.peek(), ({ id }) => of.get(id) ?? way, before, newId);
    this.dismiss();
    this.#done = { put, before };
    // On a device that had nothing, the file is what an export of it would be.
    if (before.models.length + before.settings.length + before.flights.length === 0)
      this.marks.exported(step.writtenAt);
    const holds = { models: put.models.length, settings: put.settings.length, flights: put.flights.length };
    const { name } = step;
    const all = put.models.length + put.settings.length + put.flights.length;
    const kept = await this.#save(put, (done) => this.#say({ kind: 'importing', name, done, of: all }));
    this.#say({ kind: 'imported', name, holds, kept });
  }

  /** Puts back what was there before the import. What was changed since then stays as it is. */
  async undo(): Promise<void> {
    const { library } = this.#parts;
    const done = this.#done;
    if (!done) return;
    this.#done = null;
    const now = this.#records();
    const { put, before } = done;
    const models = undoOf(put.models, before.models, now.models);
    const settings = undoOf(put.settings, before.settings, now.settings);
    const flights = undoOf(put.flights, before.flights, now.flights);
    this.#say({ kind: [models, settings, flights].every(({ isWhole }) => isWhole) ? 'undone' : 'partly-undone' });
    library.models.remove(...models.gone);
    library.settings.remove(...settings.gone);
    library.flights.remove(...flights.gone);
    library.flush();
    await this.#save({ models: models.back, settings: settings.back, flights: flights.back });
  }

  /** The import is left, whatever it has come to. */
  dismiss(): void {
    this.#turn++;
    this.#current.value = null;
  }

  /** What was said has been read. */
  dismissWord(): void {
    this.#done = null;
    this.#say(null);
  }

  /**
   * Some at a time: each of them has only so long to be kept, however many there are.
   * @param tell called with how many are done.
   * @returns whether the browser has kept all of it.
   */
  async #save({ models, settings, flights }: Records, tell: (done: number) => void = () => {}): Promise<boolean> {
    const { library } = this.#parts;
    let done = 0;
    const save = async <R extends { readonly key: string; readonly changedAt: number }>(
      list: Collection<R>,
      records: readonly R[],
    ): Promise<boolean> => {
      for (let at = 0; at < records.length; at += AT_A_TIME) {
        const some = records.slice(at, at + AT_A_TIME);
        if (!(await list.save(...some))) {
          // Nobody waits for the rest part by part where the browser keeps nothing.
          await list.save(...records.slice(at + AT_A_TIME));
          return false;
        }
        done += some.length;
        tell(done);
      }
      return true;
    };
    const kept = [await save(library.models, models), await save(library.settings, settings)];
    return [...kept, await save(library.flights, flights)].every(Boolean);
  }

  #say(word: FileWord | null): void {
    this.#said.value = word;
  }

  #remember(part: FilePart, file: ChosenFile | null): void {
    const chosen = new Map(this.#chosen.peek());
    if (file) chosen.set(keyOf(part), file);
    else chosen.delete(keyOf(part));
    this.#chosen.value = chosen;
  }

  async #textOf(part: FilePart, now: number): Promise<Made | 'failed'> {
    try {
      await this.#load();
      return textOf(partOf(this.#records(), part), part.kind === 'all', version, now);
    } catch {
      return 'failed';
    }
  }

  async #writeTo(file: ChosenFile, text: string): Promise<boolean> {
    this.#say({ kind: 'saving', name: file.name });
    try {
      await writeFile(file, text);
      return true;
    } catch {
      return false;
    }
  }

  async #load(): Promise<void> {
    const { library } = this.#parts;
    await Promise.all([library.load(), library.flights.load()]);
  }

  #records(): Records {
    const { models, settings, flights } = this.#parts.library;
    return { models: models.list.value, settings: settings.list.value, flights: flights.list.value };
  }
}

function keyOf(part: FilePart): string {
  return part.kind === 'all' ? 'all' : `${part.kind}/${part.id}`;
}

/** What every system takes for the name of a file. */
function safeName(name: string): string {
  // Also at the end of it, where some systems drop them without a word.
  const safe = name.replaceAll(/[\p{C}<>:"/\\|?*]/gu, '_').replaceAll(/^[. ]+|[. ]+$/g, '');
  return safe === '' ? '_' : safe;
}

/** The day on the pilot's calendar. */
function dayName(date: Date): string {
  return [date.getFullYear(), date.getMonth() + 1, date.getDate()]
    .map((part) => String(part).padStart(2, '0'))
    .join('-');
}
