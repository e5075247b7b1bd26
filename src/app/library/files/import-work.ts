import { computed, type ReadonlySignal } from '@preact/signals';
import { parseLibraryFile } from '../../../program/index.js';
import { CodecError } from '../../../protocol/index.js';
import { isSame } from '../../storage/index.js';
import { type EntryCounts, type Group, groupsOf, type Records } from './import-plan.js';

/** What a file is found to hold. */
interface Found {
  readonly writtenAt: number;
  readonly writtenBy: string;
  readonly ignored: number;
  readonly holds: EntryCounts;
  readonly groups: ReadonlySignal<readonly Group[]>;
}

/** Reads a text, and compares it with what the library holds. */
export function lookInto(text: string, held: () => Records): Found | { readonly refused: CodecError } {
  try {
    const file = parseLibraryFile(text);
    const { models, settings, flights } = file.library;
    const holds = { models: models.length, settings: settings.length, flights: flights.length };
    // Another tab, or the pilot, may change the library while he looks at it.
    const groups = computed(() => groupsOf(file, held()));
    return { writtenAt: file.writtenAt, writtenBy: file.writtenBy, ignored: file.ignored.length, holds, groups };
  } catch (error) {
    if (error instanceof CodecError) return { refused: error };
    throw error;
  }
}

/** What has to be done with one list to have what was there before an import. */
export interface Undo<R> {
  /** What is put back in its place. */
  readonly back: readonly R[];
  /** The keys of what is taken out again. */
  readonly gone: readonly string[];
  /** False: something was changed since then, and stays. */
  readonly isWhole: boolean;
}

/** @param put what the import has kept. @param before the list before it. @param now the list as it is. */
export function undoOf<R extends { readonly key: string; readonly changedAt: number }>(
  put: readonly R[],
  before: readonly R[],
  now: readonly R[],
): Undo<R> {
  const old = new Map(before.map((record) => [record.key, record]));
  const present = new Map(now.map((record) => [record.key, record]));
  const there = put.filter(({ key }) => present.has(key));
  const untouched = there.filter((record) => isSame(record, present.get(record.key)));
  return {
    back: untouched.flatMap(({ key }) => old.get(key) ?? []),
    gone: untouched.filter(({ key }) => !old.has(key)).map(({ key }) => key),
    isWhole: untouched.length === there.length,
  };
}
