import { type ReadonlySignal, signal } from '@preact/signals';
import type { CodecError } from '../../../protocol/index.js';
import { askForFiles } from '../../browser/ask-for-file.js';
import { textOfFile, type UnreadableFile } from '../../browser/read-file.js';
import { saveFile } from '../../browser/save-file.js';
import { version } from '../../browser/version.js';
import { type Library, newId } from '../../session/library.js';
import { plainName } from '../../session/plain-names.js';
import { ExportMarks } from './export-marks.js';
import { type EntryCounts, type Group, type Kind, type Records, recordsOf, type Way } from './import-plan.js';
import { lookInto, undoOf } from './import-work.js';
import { type FilePart, type Made, partOf, textOf } from './library-text.js';
import type { PlaceInFile } from './place-in-file.js';

/** The state of an import. */
export type ImportStep =
  | { readonly step: 'reading'; readonly name: string }
  | {
      readonly step: 'refused';
      readonly name: string;
      readonly why: FileRefusal;
      /** Null outside of all entries. */
      readonly place?: PlaceInFile | null;
    }
  | ({ readonly step: 'plan'; readonly name: string; readonly writtenAt: number } & {
      readonly ignored: number;
      readonly holds: EntryCounts;
      /** What the file would bring, compared with the present library. */
      readonly groups: ReadonlySignal<readonly Group[]>;
      readonly way: ReadonlySignal<Way>;
    });
export type FileRefusal = UnreadableFile | 'several' | CodecError;

/** What was done last. */
export type FileWord =
  /** An import or its undo is not in the storage yet. */
  | { readonly kind: 'busy' }
  | { readonly kind: 'downloaded'; readonly name: string; readonly holds: EntryCounts }
  /** The browser does not give everything that it keeps. */
  | { readonly kind: 'partly'; readonly name: string; readonly holds: EntryCounts; readonly missing: readonly Kind[] }
  | { readonly kind: 'too-large' | 'unread' | 'failed' }
  | { readonly kind: 'undone'; readonly kept: boolean }
  | { readonly kind: 'imported'; readonly name: string; readonly holds: EntryCounts; readonly kept: boolean };

/** The name of a file with everything, before its date. */
export const ALL_NAME = 'Sidus library';
/** The files that the pilot can choose. */
const ACCEPTED = '.sidus,.json,application/json';
const ENDING = '.sidus.json';

/** What the import has put into the library, and what was there before. */
interface Done {
  readonly put: Records;
  readonly before: Records;
}

export interface LibraryFilesParts {
  readonly library: Library;
  /** Whether the browser keeps and gives back all; null when it does not answer. */
  readonly kept: ReadonlySignal<boolean | null>;
}

/** Exports the library to files, and imports files. */
export class LibraryFiles {
  readonly #current = signal<ImportStep | null>(null, { name: 'import' });
  readonly #said = signal<FileWord | null>(null, { name: 'fileWord' });
  readonly #way = signal<Way>('newer');
  readonly current: ReadonlySignal<ImportStep | null> = this.#current;
  readonly said: ReadonlySignal<FileWord | null> = this.#said;
  /** When the library was last exported, and until when the pilot has put it off. */
  readonly marks: ExportMarks;
  readonly #parts: LibraryFilesParts;
  #done: Done | null = null;
  /** Goes up with each new action, so that the late result of an earlier one is ignored. */
  #turn = 0;

  constructor(parts: LibraryFilesParts) {
    this.#parts = parts;
    this.marks = new ExportMarks(parts.library);
  }

  /** Whether there is nothing to export, as far as it was read. */
  get isEmpty(): boolean {
    const { models, settings, flights } = this.#parts.library;
    return [models, settings, flights].every(
      ({ list, loaded, failed }) => loaded.value && !failed.value && list.value.length === 0,
    );
  }

  /**
   * Gives a part of the library to the browser as a download.
   * @param title the name of the file, before its date.
   */
  async export(part: FilePart, title: string): Promise<void> {
    this.#done = null;
    this.#say(null);
    const name = `${safeName(title)} ${dayName(new Date())}${ENDING}`;
    const now = Date.now();
    const made = await this.#textOf(part, now);
    if (made === 'nothing') return;
    if (typeof made === 'string') return this.#say({ kind: made });
    const { text, holds, missing } = made;
    saveFile(name, text, 'application/json');
    if (missing.length > 0) return this.#say({ kind: 'partly', name, holds, missing });
    if (part.kind === 'all') this.marks.exported(now);
    this.#say({ kind: 'downloaded', name, holds });
  }

  /** Saves all of the library; see {@link export}. */
  async exportAll(): Promise<void> {
    await this.export({ kind: 'all' }, ALL_NAME);
  }

  /** Asks for a file and reads it. */
  ask(): void {
    askForFiles(ACCEPTED, (files) => void this.open(files));
  }

  /** Shows what a file would bring. Nothing is imported before the pilot agrees. */
  async open(chosen: readonly File[]): Promise<void> {
    const [file, more] = chosen;
    if (!file) return;
    const turn = ++this.#turn;
    const name = plainName(file.name);
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
      if ('refused' in found) return show({ step: 'refused', name, why: found.refused, place: found.place });
      this.#way.value = 'newer';
      show({ step: 'plan', name, ...found, way: this.#way });
    } catch {
      // This is our own fault, but the pilot must not be left with a dialog that goes on reading.
      show({ step: 'refused', name, why: 'gone' });
    }
  }

  /** Chooses what to do with entries that differ. */
  choose(way: Way): void {
    this.#way.value = way;
  }

  /**
   * Whether imports are closed: an import would not see what the browser keeps,
   * and might overwrite it with something older.
   */
  get shut(): boolean {
    return this.#unread.length > 0 || this.#parts.kept.value === null;
  }

  /** What the browser keeps, perhaps, and does not give. */
  get #unread(): Kind[] {
    const { library } = this.#parts;
    return (['models', 'settings', 'flights'] as const).filter((kind) => library[kind].failed.value);
  }

  /** Imports what the plan shows. */
  async take(): Promise<void> {
    const step = this.#current.peek();
    if (step?.step !== 'plan' || this.shut) return;
    const before = this.#records();
    const put = recordsOf(step.groups.peek(), this.#way.peek(), before, newId);
    this.dismiss();
    // On an empty device, the file equals an export of everything.
    if (before.models.length + before.settings.length + before.flights.length === 0)
      this.marks.exported(step.writtenAt);
    const holds = { models: put.models.length, settings: put.settings.length, flights: put.flights.length };
    const { name } = step;
    this.#say({ kind: 'busy' });
    const kept = await this.#parts.library.change({
      models: { put: put.models },
      settings: { put: put.settings },
      flights: { put: put.flights },
    });
    // Only now: the pilot may have exported, or imported another file, while this one was being saved.
    this.#done = { put, before };
    this.#say({ kind: 'imported', name, holds, kept });
  }

  /** Brings back what was there before the import. Later changes stay. */
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
    this.#say({ kind: 'busy' });
    const kept = await library.change({
      models: { gone: models.gone, put: models.back },
      settings: { gone: settings.gone, put: settings.back },
      flights: { gone: flights.gone, put: flights.back },
    });
    this.#say({ kind: 'undone', kept });
  }

  /** The pilot leaves the import, whatever state it is in. */
  dismiss(): void {
    this.#turn++;
    this.#current.value = null;
  }

  /** The pilot has read the message. */
  dismissWord(): void {
    this.#done = null;
    this.#say(null);
  }

  #say(word: FileWord | null): void {
    this.#said.value = word;
  }

  async #textOf(part: FilePart, now: number): Promise<Made | 'unread' | 'failed'> {
    try {
      await this.#load();
      // The file of a setting holds no flights.
      const missing = this.#unread.filter((kind) => part.kind !== 'setting' || kind === 'models');
      const made = textOf(partOf(this.#records(), part), part.kind === 'all', version, now, missing);
      return made === 'nothing' && missing.length > 0 ? 'unread' : made;
    } catch {
      return 'failed';
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

/** A name that every system accepts for a file. */
function safeName(name: string): string {
  // Also at its end, where some systems drop characters silently.
  const safe = name.replaceAll(/[\p{C}<>:"/\\|?*]/gu, '_').replaceAll(/^[. ]+|[. ]+$/g, '');
  return safe === '' ? '_' : safe;
}

/** The day on the pilot's calendar. */
function dayName(date: Date): string {
  return [date.getFullYear(), date.getMonth() + 1, date.getDate()]
    .map((part) => String(part).padStart(2, '0'))
    .join('-');
}
