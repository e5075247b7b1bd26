import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { describeFrame, frameName } from '../messages/frame-text.js';
import { hexOf } from '../messages/hex.js';
import { foldedOf, searchFor } from '../messages/search.js';
import type { LineLog } from '../timer/line-log.js';
import type { LineRecord } from '../timer/line-record.js';
import { type Recording, type RecordingFault, readRecording } from './recording.js';

/** Which entries are shown: all, those of one direction, or damaged ones. */
export type LineFilter = 'all' | 'out' | 'in' | 'damaged';

/** How many entries are shown at first, and how many more on each click. */
export const STEP = 100;

/** What the line view shows: the live line, a paused one, or a recording; everything, or what a filter finds. */
export class LineView {
  readonly #log: LineLog;
  readonly #room = signal(STEP);
  readonly #still = signal<{ readonly entries: readonly LineRecord[]; readonly newest: number } | null>(null);
  // Only this model writes these.
  readonly filter = signal<LineFilter>('all');
  /** The text that names, meanings or bytes must contain. */
  readonly search = signal('');
  readonly recording = signal<Recording | null>(null);
  /** Why the last file is no recording. */
  readonly fault = signal<RecordingFault | null>(null);
  readonly paused: ReadonlySignal<boolean> = computed(() => this.#still.value !== null);
  /** How many entries have come since the pause. */
  readonly came: ReadonlySignal<number> = computed(() =>
    this.#still.value ? this.#log.newest.value - this.#still.value.newest : 0,
  );
  /** All entries, oldest first. */
  readonly all: ReadonlySignal<readonly LineRecord[]> = computed(
    () => this.recording.value?.records ?? this.#still.value?.entries ?? this.#log.entries.value,
  );
  /** The entries that pass the filter, oldest first. */
  readonly found: ReadonlySignal<readonly LineRecord[]> = computed(() =>
    this.all.value.filter(test(this.filter.value, this.search.value)),
  );
  /** The newest of these, as many as there is room for, newest first. */
  readonly shown: ReadonlySignal<readonly LineRecord[]> = computed(() =>
    this.found.value.slice(-this.#room.value).reverse(),
  );
  /** Whether there is nothing to look at yet: the line was never used, and no recording is loaded. */
  readonly unused: ReadonlySignal<boolean> = computed(() => !this.recording.value && !this.#log.used.value);
  /** How much was on the line since the log began. */
  readonly counts: LineLog['counts'];

  constructor(log: LineLog) {
    this.#log = log;
    this.counts = log.counts;
  }

  setFilter(filter: LineFilter): void {
    batch(() => {
      this.filter.value = filter;
      this.#room.value = STEP;
    });
  }

  setSearch(text: string): void {
    batch(() => {
      this.search.value = text;
      this.#room.value = STEP;
    });
  }

  /** Shows more of the older entries. */
  showOlder(): void {
    this.#room.value += STEP;
  }

  /** Pauses the view while the log goes on. */
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

  /** Shows the recording in a file in place of the line, or says why the file is none. */
  async load(file: File): Promise<void> {
    this.fault.value = null;
    const read = await readRecording(file);
    batch(() => {
      if ('line' in read) this.fault.value = read;
      else this.recording.value = read;
      this.#room.value = STEP;
    });
  }

  /** Clears the message about a refused file. */
  dismissFault(): void {
    this.fault.value = null;
  }

  /** Shows the line again. */
  back(): void {
    this.recording.value = null;
  }

  /** The whole log of the line, with everything that a replay needs. */
  toSave(): readonly LineRecord[] {
    return this.#log.introduced(this.all.value);
  }
}

const wordsOf = foldedOf<LineRecord>((record) => [frameName(record), describeFrame(record, record.layout)]);

function test(filter: LineFilter, search: string): (record: LineRecord) => boolean {
  const isFound = searchFor(search);
  const hex = hexIn(search.trim().toLowerCase());
  return (record) => {
    const isDamaged = record.rejected !== null || record.error !== null;
    const isOfKind = filter === 'all' || (filter === 'damaged' ? isDamaged : record.direction === filter);
    if (!isOfKind || search.trim() === '') return isOfKind;
    return isFound(wordsOf(record)) || (hex !== null && hexOf(record.bytes).includes(hex));
  };
}

/** Whole bytes in hex, with any spacing; null for any other text. */
function hexIn(text: string): string | null {
  const digits = text.replaceAll(/\s/g, '');
  return /^(?:[0-9a-f]{2})+$/.test(digits) ? (digits.match(/../g) ?? []).join(' ') : null;
}
