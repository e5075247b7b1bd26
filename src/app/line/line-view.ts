import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import type { LineLog } from '../session/line-log.js';
import type { LineRecord } from '../session/line-record.js';
import { type Recording, RecordingError, readRecording } from './recording.js';
import { rowText } from './row-text.js';

/** Which entries are shown: all, frames and pieces of one direction, or what was damaged. */
export type LineFilter = 'all' | 'out' | 'in' | 'damaged';

/** So many entries are shown at first, and so many more whenever their end is reached: more than are in sight. */
const STEP = 32;
/** So many stand in one group: a new entry moves the groups below it, and has those of its own alone drawn again. */
const GROUP = 8;

/** Entries that stand together, newest first. It is the same object for as long as nothing in it changes. */
export interface LineGroup {
  /** Tells it from the others. */
  readonly key: number;
  readonly records: readonly LineRecord[];
}

/** What of the line is looked at: live, standing still, or a recording; all of it or what is searched for. */
export class LineView {
  readonly filter: ReadonlySignal<LineFilter>;
  /** What names, meanings or bytes must contain. */
  readonly search: ReadonlySignal<string>;
  readonly recording: ReadonlySignal<Recording | null>;
  /** Why the file that was given last is no recording. */
  readonly fault: ReadonlySignal<RecordingError | null>;
  readonly paused: ReadonlySignal<boolean> = computed(() => this.#still.value !== null);
  /** How many entries came since the picture stands still. */
  readonly came: ReadonlySignal<number> = computed(() =>
    this.#still.value ? this.#log.newest.value - this.#still.value.newest : 0,
  );
  /** All entries of the picture, oldest first. */
  readonly all: ReadonlySignal<readonly LineRecord[]> = computed(
    () => this.#recording.value?.records ?? this.#still.value?.entries ?? this.#log.entries.value,
  );
  /** Those of them that are asked for, oldest first. */
  readonly found: ReadonlySignal<readonly LineRecord[]> = computed(() => {
    const isAskedFor = test(this.#filter.value, this.#search.value);
    return this.all.value.filter(isAskedFor);
  });
  /** The newest of them, as many as there is room for, newest first. What has not changed is not drawn again. */
  readonly shown: ReadonlySignal<readonly LineGroup[]> = computed(() => {
    const before = new Map(this.#drawn.map((group) => [group.key, group]));
    this.#drawn = groupsOf(this.found.value.slice(-this.#room.value)).map((group) => {
      const known = before.get(group.key);
      return known && isSame(known, group) ? known : group;
    });
    return this.#drawn;
  });
  /** How many of those that are asked for are shown. */
  readonly shownCount: ReadonlySignal<number> = computed(() => Math.min(this.#room.value, this.found.value.length));
  /** There is nothing to look at yet: nothing was ever on the line, and no recording was loaded. */
  readonly unused: ReadonlySignal<boolean> = computed(() => !this.#recording.value && !this.#log.used.value);
  /** How much was on the line since the log is kept. */
  readonly counts: LineLog['counts'];
  readonly #log: LineLog;
  readonly #room = signal(STEP, { name: 'room' });
  #drawn: readonly LineGroup[] = [];
  readonly #filter = signal<LineFilter>('all', { name: 'filter' });
  readonly #search = signal('', { name: 'search' });
  readonly #recording = signal<Recording | null>(null, { name: 'recording' });
  readonly #fault = signal<RecordingError | null>(null, { name: 'fault' });
  readonly #still = signal<{ readonly entries: readonly LineRecord[]; readonly newest: number } | null>(null);

  constructor(log: LineLog) {
    this.#log = log;
    this.filter = this.#filter;
    this.search = this.#search;
    this.counts = log.counts;
    this.recording = this.#recording;
    this.fault = this.#fault;
  }

  setFilter(filter: LineFilter): void {
    batch(() => {
      this.#filter.value = filter;
      this.#room.value = STEP;
    });
  }

  setSearch(text: string): void {
    batch(() => {
      this.#search.value = text;
      this.#room.value = STEP;
    });
  }

  /** Shows older entries too. */
  showOlder(): void {
    this.#room.value = this.shownCount.peek() + STEP;
  }

  /** Lets the picture stand still while the log goes on. */
  pause(): void {
    this.#still.value = { entries: this.#log.entries.value, newest: this.#log.newest.value };
  }

  goOn(): void {
    this.#still.value = null;
  }

  clear(): void {
    batch(() => {
      this.#log.clear();
      this.goOn();
    });
  }

  /** Shows the recording in a file in place of the line, or says why it is none. */
  async load(file: File): Promise<void> {
    this.#fault.value = null;
    try {
      const recording = await readRecording(file);
      batch(() => {
        this.#recording.value = recording;
        this.#room.value = STEP;
      });
    } catch (error) {
      if (!(error instanceof RecordingError)) throw error;
      this.#fault.value = error;
    }
  }

  /** Forgets that a file was refused. */
  dismissFault(): void {
    this.#fault.value = null;
  }

  /** Shows the line again. */
  back(): void {
    this.#recording.value = null;
  }

  /** All that is kept of the line, with what a replay of it needs. */
  toSave(): readonly LineRecord[] {
    return this.#log.introduced(this.all.value);
  }
}

function test(filter: LineFilter, search: string): (record: LineRecord) => boolean {
  const words = search.trim().toLowerCase();
  const hex = hexIn(words);
  return (record) => isOfKind(record, filter) && (words === '' || says(record, words, hex));
}

function isOfKind({ direction, rejected, error }: LineRecord, filter: LineFilter): boolean {
  if (filter === 'all') return true;
  return filter === 'damaged' ? rejected !== null || error !== null : direction === filter;
}

function says(record: LineRecord, words: string, hex: string | null): boolean {
  const text = rowText(record);
  return text.words.includes(words) || (hex !== null && text.bytes.includes(hex));
}

/** Whole bytes in hex, however they are spaced; null for anything else. */
function hexIn(text: string): string | null {
  const digits = text.replaceAll(/\s/g, '');
  return /^(?:[0-9a-f]{2})+$/.test(digits) ? (digits.match(/../g) ?? []).join(' ') : null;
}

/** By their numbers, so that a new entry changes the first group alone. @param records oldest first. */
function groupsOf(records: readonly LineRecord[]): LineGroup[] {
  const groups: { readonly key: number; readonly records: LineRecord[] }[] = [];
  for (const record of [...records].reverse()) {
    const key = Math.floor(record.number / GROUP);
    const last = groups.at(-1);
    if (last?.key === key) last.records.push(record);
    else groups.push({ key, records: [record] });
  }
  return groups;
}

function isSame({ records }: LineGroup, other: LineGroup): boolean {
  return records.length === other.records.length && records.every((record, at) => record === other.records[at]);
}
