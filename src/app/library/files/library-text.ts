import { formatLibraryFile } from '../../../program/index.js';
import { CodecError } from '../../../protocol/index.js';
import { moreMessages } from '../../messages/more.js';
import { contentOf, countsOf, type EntryCounts, type Kind, type Records } from './import-plan.js';

/** What a file contains: everything, one model with all that belongs to it, or one setting with its model. */
export type FilePart = { readonly kind: 'all' } | { readonly kind: 'model' | 'setting'; readonly id: string };

/** The records of a part of the library, in their order. */
export function partOf({ models, settings, flights }: Records, part: FilePart): Records {
  if (part.kind === 'all') return { models, settings, flights };
  if (part.kind === 'model') {
    return {
      models: models.filter(({ key }) => key === part.id),
      settings: settings.filter(({ setting }) => setting.model === part.id),
      flights: flights.filter(({ flight }) => flight.model === part.id),
    };
  }
  const [one] = settings.filter(({ key }) => key === part.id);
  return {
    models: models.filter(({ key }) => key === one?.setting.model),
    settings: one ? [one] : [],
    flights: [],
  };
}

/** The text of a file and how much it holds; or why there is none. */
export type Made = { readonly text: string; readonly holds: EntryCounts } | 'too-large' | 'nothing';

/**
 * Makes a library file.
 * @param isAll also writes what the pilot's timers last held: only his own devices need that.
 * @param missing what could not be read. The file says so beside the program that wrote it, which an import shows.
 */
export function textOf(
  records: Records,
  isAll: boolean,
  version: string,
  now: number,
  missing: readonly Kind[] = [],
): Made {
  const { models, settings, flights } = records;
  const all = [...models, ...settings, ...flights];
  if (all.length === 0) return 'nothing';
  const facts = all.map((record) => {
    const isKnown = isAll && 'verified' in record && record.verified.length > 0;
    const known = {
      ...(isKnown && { verified: record.verified }),
      ...('versions' in record && record.versions && { versions: record.versions }),
      changedAt: record.changedAt,
    };
    return [contentOf(record), known] as const;
  });
  const library = {
    models: models.map(({ model }) => model),
    settings: settings.map(({ setting }) => setting),
    flights: flights.map(({ flight }) => flight),
  };
  const { without, kinds } = moreMessages.value.files.export;
  try {
    const writtenBy = [`Sidus Timer ${version}`, ...missing.map((kind) => without({ kind: kinds[kind] }))].join(', ');
    const text = formatLibraryFile(library, { writtenAt: now, writtenBy, facts: new Map(facts) });
    return { text, holds: countsOf(library) };
  } catch (error) {
    if (error instanceof CodecError && error.code === 'too-large') return 'too-large';
    throw error;
  }
}
