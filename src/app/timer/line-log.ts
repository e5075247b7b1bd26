import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { LineEntry } from '../../client/index.js';
import { COMMANDS, type LayoutQuirks } from '../../protocol/index.js';
import { isReplyToIdentify, type LineRecord, recorder } from './line-record.js';

/** More than a pilot scrolls through, and few enough to keep the whole day. */
const KEPT = 500;

/** What was on the line since the log was cleared, including entries that are no longer kept. */
export interface LineCounts {
  /** Frames to the timer. */
  readonly out: number;
  /** Frames from the timer. */
  readonly in: number;
  /** Pieces that belong to no frame. */
  readonly damaged: number;
  /** Errors that the port reported. */
  readonly errors: number;
}

const NOTHING: LineCounts = { out: 0, in: 0, damaged: 0, errors: 0 };

/**
 * The last {@link KEPT} entries of the line. The screen is told once for all entries that come together.
 */
export class LineLog {
  /** Newest last. */
  readonly entries: ReadonlySignal<readonly LineRecord[]> = computed(() => {
    this.#version.value;
    return this.#kept;
  });
  readonly counts: ReadonlySignal<LineCounts> = computed(() => {
    this.#version.value;
    return this.#counts;
  });
  /** The number of the newest entry of all time; 0 before the first. */
  readonly newest: ReadonlySignal<number> = computed(() => {
    this.#version.value;
    return this.#newest;
  });
  /** Whether anything was ever on the line. */
  readonly used: ReadonlySignal<boolean> = computed(() => this.newest.value > 0);
  readonly #version = signal(0, { name: 'line' });
  #kept: readonly LineRecord[] = [];
  readonly #record: (entry: LineEntry) => LineRecord;
  #newest = 0;
  #counts = NOTHING;
  #asked: LineRecord | undefined;
  #introduction: readonly LineRecord[] = [];
  #telling = false;

  /** @param quirks gives what is assumed about the timer now, which decides how its messages are read. */
  constructor(quirks?: () => LayoutQuirks) {
    this.#record = recorder(quirks);
  }

  readonly add = (entry: LineEntry): void => {
    const record = this.#record(entry);
    this.#newest = record.number;
    this.#kept = [...this.#kept.slice(1 - KEPT), record];
    this.#counts = counted(this.#counts, record);
    this.#noteIntroduction(record);
    this.#tell();
  };

  clear(): void {
    this.#kept = [];
    this.#counts = NOTHING;
    this.#tell();
  }

  /**
   * Adds to entries of this log the exchange in which the timer last gave its identity, if that is older than they are:
   * without it they can neither be read nor replayed.
   */
  introduced(records: readonly LineRecord[]): readonly LineRecord[] {
    const first = records[0]?.number ?? 0;
    return [...this.#introduction.filter(({ number }) => number < first), ...records];
  }

  #noteIntroduction(record: LineRecord): void {
    if (record.direction === 'out' && record.frame) this.#asked = record;
    if (!isReplyToIdentify(record) || !record.layout.identity) return;
    if (this.#asked?.frame?.code === COMMANDS.GETSWVER.request) this.#introduction = [this.#asked, record];
  }

  /** Once for all entries that come together. */
  #tell(): void {
    if (this.#telling) return;
    this.#telling = true;
    queueMicrotask(() => {
      this.#telling = false;
      this.#version.value++;
    });
  }
}

function counted(counts: LineCounts, { direction, rejected, error }: LineEntry): LineCounts {
  const kind = error ? 'errors' : rejected ? 'damaged' : direction;
  return { ...counts, [kind]: counts[kind] + 1 };
}
