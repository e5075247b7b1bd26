import { computed, type ReadonlySignal } from '@preact/signals';
import { parseLibraryFile } from '../../../program/index.js';
import { CodecError } from '../../../protocol/index.js';
import { isSame } from '../../storage/index.js';
import { type EntryCounts, type Group, groupsOf, type Records } from './import-plan.js';
import { type PlaceInFile, placeInFile } from './place-in-file.js';

/** The content of a file. */
interface Found {
  readonly writtenAt: number;
  readonly ignored: number;
  readonly holds: EntryCounts;
  readonly groups: ReadonlySignal<readonly Group[]>;
}

/** Reads the text of a file and compares it with the library. */
export function lookInto(
  text: string,
  held: () => Records,
): Found | { readonly refused: CodecError; readonly place: PlaceInFile | null } {
  try {
    const file = parseLibraryFile(text);
    const { models, settings, flights } = file.library;
    const holds = { models: models.length, settings: settings.length, flights: flights.length };
    // The library may change while the pilot looks at the file.
    const groups = computed(() => groupsOf(file, held()));
    const { writtenAt, ignored } = file;
    return { writtenAt, ignored: ignored.length, holds, groups };
  } catch (error) {
    if (!(error instanceof CodecError)) throw error;
    return { refused: error, place: placeInFile(text, error.field) };
  }
}

/** The changes that bring one list back to how it was before an import. What was changed after it stays. */
export interface Undo<R> {
  /** Records to put back in their place. */
  readonly back: readonly R[];
  /** Keys of records to remove again. */
  readonly gone: readonly string[];
}

/** @param put what the import has saved. @param before the list before it. @param now the list as it is. */
export function undoOf<R extends { readonly key: string; readonly changedAt: number }>(
  put: readonly R[],
  before: readonly R[],
  now: readonly R[],
): Undo<R> {
  const old = new Map(before.map((record) => [record.key, record]));
  const present = new Map(now.map((record) => [record.key, record]));
  const untouched = put.filter((record) => present.has(record.key) && isSame(record, present.get(record.key)));
  return {
    back: untouched.flatMap(({ key }) => old.get(key) ?? []),
    gone: untouched.filter(({ key }) => !old.has(key)).map(({ key }) => key),
  };
}
