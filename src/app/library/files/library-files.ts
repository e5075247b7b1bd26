import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { parseLibraryFile } from '../../../program/index.js';
import { CodecError } from '../../../protocol/index.js';
import { askForFiles } from '../../browser/ask-for-file.js';
import { textOfFile, type UnreadableFile } from '../../browser/read-file.js';
import { saveFile } from '../../browser/save-file.js';
import { version } from '../../browser/version.js';
import { messages } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import { countedText } from '../../messages/names.js';
import { type Library, newId } from '../../records/library.js';
import { plainName } from '../../records/plain-names.js';
import { ExportMarks } from './export-marks.js';
import {
  countsOf,
  type EntryCounts,
  type Group,
  groupsOf,
  KINDS,
  type Kind,
  type Records,
  recordsOf,
  undoOf,
  type Way,
} from './import-plan.js';
import { type FilePart, type Made, partOf, textOf } from './library-text.js';
import { type PlaceInFile, placeInFile } from './place-in-file.js';

/** Why a file cannot be imported. */
export interface Refusal {
  readonly why: UnreadableFile | 'several' | CodecError;
  /** Where in it the fault stands; null outside of all entries. */
  readonly place: PlaceInFile | null;
}

/** What a file holds. */
export interface Plan {
  readonly writtenAt: number;
  readonly ignored: number;
  readonly holds: EntryCounts;
  /** What it would bring, compared with the present library. */
  readonly groups: ReadonlySignal<readonly Group[]>;
}

/** A file that the pilot has chosen, and what is asked about it. */
export interface AskedFile {
  readonly name: string;
  readonly shown: 'reading' | Refusal | Plan;
  /** Imports it in this way; null leaves everything as it is. */
  readonly answer: (way: Way | null) => void;
}

/** What was done last. */
export interface FileWord {
  /** In the language that the page speaks by then. */
  readonly text: () => string;
  readonly isBad?: boolean;
  /** It is not in the storage yet. */
  readonly isBusy?: true;
  /** Brings back what was there before an import. Later changes stay. */
  readonly undo?: () => void;
}

/** The name of a file with everything, before its date. */
const ALL_NAME = 'Sidus library';
/** The files that the pilot can choose. */
const ACCEPTED = '.sidus,.json,application/json';
const ENDING = '.sidus.json';

export interface LibraryFilesParts {
  readonly library: Library;
  /** Whether the browser keeps and gives back all; null when it does not answer. */
  readonly kept: ReadonlySignal<boolean | null>;
}

/** Exports the library to files, and imports files. */
export class LibraryFiles {
  readonly #asked = signal<AskedFile | null>(null, { name: 'import' });
  readonly #said = signal<FileWord | null>(null, { name: 'fileWord' });
  readonly asked: ReadonlySignal<AskedFile | null> = this.#asked;
  readonly said: ReadonlySignal<FileWord | null> = this.#said;
  /** When the library was last exported, and until when the pilot has put it off. */
  readonly marks: ExportMarks;
  readonly #parts: LibraryFilesParts;

  constructor(parts: LibraryFilesParts) {
    this.#parts = parts;
    this.marks = new ExportMarks(parts.library);
  }

  /** Whether there is nothing to export, as far as it was read. */
  get isEmpty(): boolean {
    return KINDS.map((kind) => this.#parts.library[kind]).every(
      ({ list, loaded, failed }) => loaded.value && !failed.value && list.value.length === 0,
    );
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
    return KINDS.filter((kind) => this.#parts.library[kind].failed.value);
  }

  /**
   * Gives a part of the library to the browser as a download.
   * @param title the name of the file, before its date.
   */
  async export(part: FilePart = { kind: 'all' }, title = ALL_NAME): Promise<void> {
    const words = () => moreMessages.value.files.export;
    this.dismissWord();
    const now = Date.now();
    let missing: readonly Kind[];
    let made: Made;
    try {
      await this.#load();
      // The file of a setting holds no flights.
      missing = this.#unread.filter((kind) => part.kind !== 'setting' || kind === 'models');
      made = textOf(partOf(this.#records(), part), part.kind === 'all', version, now, missing);
    } catch {
      return this.#say({ text: () => words().failed, isBad: true });
    }
    if (made === 'nothing')
      return missing.length > 0 ? this.#say({ text: () => moreMessages.value.library.unread, isBad: true }) : undefined;
    if (made === 'too-large') return this.#say({ text: () => words().tooLarge, isBad: true });
    const name = `${safeName(title)} ${dayName(now)}${ENDING}`;
    saveFile(name, made.text, 'application/json');
    const { holds } = made;
    const file = () => ({ name: unbroken(name), what: countedText(holds) });
    if (missing.length > 0)
      return this.#say({ text: () => words().partly({ ...file(), missing: kindsText(missing) }), isBad: true });
    if (part.kind === 'all') this.marks.exported(now);
    this.#say({ text: () => words().downloaded(file()) });
  }

  /** Asks for a file to import. */
  choose(): void {
    askForFiles(ACCEPTED, (files) => void this.import(files));
  }

  /** Shows what a file would bring, and imports it once the pilot agrees. */
  async import([file, more]: readonly File[]): Promise<void> {
    if (!file) return;
    this.#asked.peek()?.answer(null);
    const name = plainName(file.name);
    const left = this.#ask(name, 'reading');
    const found = more ? ({ why: 'several', place: null } as const) : await Promise.race([left, this.#lookInto(file)]);
    if (found === null || typeof found === 'string') return;
    const way = await this.#ask(name, found);
    if (way === null || 'why' in found || this.shut) return;
    const before = this.#records();
    const put = recordsOf(found.groups.peek(), way, before, newId);
    // On an empty device, the file equals an export of everything.
    if (KINDS.every((kind) => before[kind].length === 0)) this.marks.exported(found.writtenAt);
    this.#say({ text: () => messages.value.parts.coming, isBusy: true });
    const kept = await this.#parts.library.change({
      models: { put: put.models },
      settings: { put: put.settings },
      flights: { put: put.flights },
    });
    const counts = countsOf(put);
    const done = () => moreMessages.value.files.import.done({ what: countedText(counts), name: unbroken(name) });
    this.#say({
      text: () => (kept ? done() : `${done()} ${messages.value.notKept}`),
      isBad: !kept,
      undo: () => void this.#undo(put, before),
    });
  }

  /** The pilot has read the message. */
  dismissWord(): void {
    this.#said.value = null;
  }

  #say(word: FileWord): void {
    this.#said.value = word;
  }

  #ask(name: string, shown: AskedFile['shown']): Promise<Way | null> {
    return new Promise((resolve) => {
      const answer = (way: Way | null): void => {
        this.#asked.value = null;
        resolve(way);
      };
      this.#asked.value = { name, shown, answer };
    });
  }

  /** Reads a file and compares it with the library. */
  async #lookInto(file: File): Promise<Refusal | Plan> {
    const read = await textOfFile(file);
    if ('unreadable' in read) return { why: read.unreadable, place: null };
    try {
      await this.#load();
      const parsed = parseLibraryFile(read.text);
      // The library may change while the pilot looks at the file.
      const groups = computed(() => groupsOf(parsed, this.#records()));
      const { writtenAt, ignored, library } = parsed;
      return { writtenAt, ignored: ignored.length, holds: countsOf(library), groups };
    } catch (why) {
      if (why instanceof CodecError) return { why, place: placeInFile(read.text, why.field) };
      // This is our own fault, but the pilot must not be left with a dialog that goes on reading.
      return { why: 'gone', place: null };
    }
  }

  async #undo(put: Records, before: Records): Promise<void> {
    const now = this.#records();
    this.#say({ text: () => messages.value.parts.coming, isBusy: true });
    const kept = await this.#parts.library.change({
      models: undoOf(put.models, before.models, now.models),
      settings: undoOf(put.settings, before.settings, now.settings),
      flights: undoOf(put.flights, before.flights, now.flights),
    });
    const text = () => (kept ? moreMessages.value.files.import.undone : messages.value.notKept);
    this.#say({ text, isBad: !kept });
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

/** “The flights and the backups” */
function kindsText(kinds: readonly Kind[]): string {
  const { export: words } = moreMessages.value.files;
  const [first = '', ...others] = kinds.map((kind) => words.kinds[kind]);
  return others.reduce((before, next) => words.and({ first: before, next }), first);
}

/** “Sidus library 2026-11-25.sidus.json”, whose date does not break. A long name must be able to. */
function unbroken(name: string): string {
  return name.length > 40 ? name : name.replaceAll('-', '-\u2060');
}

/** A name that every system accepts for a file. */
function safeName(name: string): string {
  // Also at its end, where some systems drop characters silently.
  const safe = name.replaceAll(/[\p{C}<>:"/\\|?*]/gu, '_').replaceAll(/^[. ]+|[. ]+$/g, '');
  return safe === '' ? '_' : safe;
}

/** The day on the pilot's calendar. */
function dayName(at: number): string {
  return new Date(at - new Date(at).getTimezoneOffset() * 60_000).toISOString().slice(0, 10);
}
