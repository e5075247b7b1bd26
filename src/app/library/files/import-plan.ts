import type { EntryFacts, Flight, LibraryFile, Model, Setting } from '../../../program/index.js';
import { withPlainNames } from '../../records/plain-names.js';
import { versionsWith } from '../../records/versions.js';
import { type Change, type FlightRecord, isSame, type ModelRecord, type SettingRecord } from '../../storage/index.js';
import { programKey } from '../../timer/record-keys.js';

/** The records of a library, or of a part of one. */
export interface Records {
  readonly models: readonly ModelRecord[];
  readonly settings: readonly SettingRecord[];
  readonly flights: readonly FlightRecord[];
}
export const KINDS = ['models', 'settings', 'flights'] as const;
export type Kind = (typeof KINDS)[number];

/** What a record holds. */
export function contentOf(record: Records[Kind][number]): Model | Setting | Flight {
  if ('model' in record) return record.model;
  return 'setting' in record ? record.setting : record.flight;
}

/** The id of the model to which a setting or a flight belongs; null for none, and for a model. */
function modelOf(content: Model | Setting | Flight): string | null {
  return 'model' in content ? content.model : null;
}

/** How many there are of each kind. */
export type EntryCounts = Readonly<Record<Kind, number>>;

export function countsOf({ models, settings, flights }: Readonly<Record<Kind, readonly unknown[]>>): EntryCounts {
  return { models: models.length, settings: settings.length, flights: flights.length };
}

/** One entry of a file. */
export interface Entry {
  readonly kind: Kind;
  readonly entry: Model | Setting | Flight;
  readonly facts: EntryFacts;
  /** When it was last changed, if the file says so; else when the file was written. */
  readonly changedAt: number;
  /** Beside the device's entry of the same id. */
  readonly standing: 'new' | 'same' | 'file-newer' | 'not-newer';
}

/** The entries of a file that belong to one model, or to none. */
export interface Group {
  /** The id of the model; null for none. */
  readonly id: string | null;
  /** Empty when no name is known. */
  readonly name: string;
  readonly entries: readonly Entry[];
}

/** What a file would bring, with names made plain, grouped by model, in the order of the file. */
export function groupsOf({ library, facts, writtenAt }: LibraryFile, held: Records): Group[] {
  const groups = new Map<string | null, { name: string; entries: Entry[] }>();
  const heldModels = byKey(held.models);
  for (const kind of KINDS) {
    const present = byKey<Records[Kind][number]>(held[kind]);
    for (const given of library[kind]) {
      const entry = withPlainNames(given);
      const id = kind === 'models' ? given.id : modelOf(given);
      const group = groups.get(id) ?? { name: heldModels.get(id ?? '')?.model.name ?? '', entries: [] };
      groups.set(id, group);
      if ('memoryNames' in entry) group.name = entry.name;
      if ('modelName' in entry) group.name ||= entry.modelName;
      const known = facts.get(given) ?? {};
      const changedAt = known.changedAt ?? ('at' in entry ? entry.at : writtenAt);
      const record = present.get(given.id);
      group.entries.push({ kind, entry, facts: known, changedAt, standing: standingOf(entry, changedAt, record) });
    }
  }
  return [...groups].map(([id, group]) => ({ id, ...group }));
}

function standingOf(entry: Entry['entry'], changedAt: number, here?: Records[Kind][number]): Entry['standing'] {
  if (!here) return 'new';
  if (isSame(entry, contentOf(here))) return 'same';
  return changedAt > here.changedAt ? 'file-newer' : 'not-newer';
}

/** The entries to import. Of two that differ the newer one stays, or that of the device if both have the same date. */
export function takenOf({ entries }: Group): readonly Entry[] {
  return entries.filter(({ standing }) => standing === 'new' || standing === 'file-newer');
}

/** The records after an import. */
export function recordsOf(groups: readonly Group[], held: Records): Records {
  const records = { models: [] as ModelRecord[], settings: [] as SettingRecord[], flights: [] as FlightRecord[] };
  const heldModels = byKey(held.models);
  const heldSettings = byKey(held.settings);
  for (const { entry, changedAt, facts } of groups.flatMap(takenOf)) {
    const key = entry.id;
    if ('memoryNames' in entry) {
      const verified = latest([...(heldModels.get(key)?.verified ?? []), ...(facts.verified ?? [])]);
      records.models.push({ key, model: entry, changedAt, verified });
    } else if ('tags' in entry) {
      const versions = versionsWith(facts.versions, heldSettings.get(key), entry.program);
      records.settings.push({ key, setting: entry, changedAt, ...(versions && { versions }) });
    } else {
      records.flights.push({ key, flight: entry, changedAt });
    }
  }
  return records;
}

/**
 * The changes that bring one list back to how it was before an import. What was changed after it stays.
 * @param put what the import has saved. @param before the list before it. @param now the list as it is.
 */
export function undoOf<R extends { readonly key: string }>(
  put: readonly R[],
  before: readonly R[],
  now: readonly R[],
): Change<R> {
  const old = new Map(before.map((record) => [record.key, record]));
  const present = new Map(now.map((record) => [record.key, record]));
  const untouched = put.filter((record) => present.has(record.key) && isSame(record, present.get(record.key)));
  return {
    put: untouched.flatMap(({ key }) => old.get(key) ?? []),
    gone: untouched.filter(({ key }) => !old.has(key)).map(({ key }) => key),
  };
}

/** How many of them there are, by kind. */
export function countOf(entries: readonly Entry[]): EntryCounts {
  const of = (kind: Kind): readonly Entry[] => entries.filter((each) => each.kind === kind);
  return countsOf({ models: of('models'), settings: of('settings'), flights: of('flights') });
}

function byKey<T extends { readonly key: string }>(records: readonly T[]): ReadonlyMap<string, T> {
  return new Map(records.map((record) => [record.key, record]));
}

/** What each memory held when it was last seen. */
function latest(verified: ModelRecord['verified']): ModelRecord['verified'] {
  const found = new Map<string, ModelRecord['verified'][number]>();
  for (const each of verified) {
    const key = programKey(each.program, each.simulated ?? false);
    if (each.at >= (found.get(key)?.at ?? 0)) found.set(key, each);
  }
  return [...found.values()];
}
