import {
  type EntryFacts,
  type Flight,
  LIMITS,
  type LibraryFile,
  type Model,
  type Setting,
} from '../../../program/index.js';
import { beginningOf, withPlainNames } from '../../records/plain-names.js';
import { type Change, type FlightRecord, isSame, type ModelRecord, type SettingRecord } from '../../storage/index.js';
import { programKey } from '../../timer/record-keys.js';

/** The records of a library, or of a part of one. */
export interface Records {
  readonly models: readonly ModelRecord[];
  readonly settings: readonly SettingRecord[];
  readonly flights: readonly FlightRecord[];
}
export type Kind = keyof Records;

/**
 * What to do with entries that differ: keep the newer one, or that of the device if both have the same date; or keep
 * both.
 */
export const WAYS = ['newer', 'both'] as const;
export type Way = (typeof WAYS)[number];

type EntryOf = { models: Model; settings: Setting; flights: Flight };

/** One entry of a file, with the device's entry of the same id. */
export interface Entry<K extends Kind = Kind> {
  readonly kind: K;
  readonly entry: EntryOf[K];
  readonly facts: EntryFacts;
  /** When it was last changed, if the file says so; else when the file was written. */
  readonly changedAt: number;
  /** The device's entry of the same id; null for none. */
  readonly here: EntryOf[K] | null;
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

/** Whether it differs from the device's entry of the same id. */
export const differs = ({ standing }: Entry): boolean => standing !== 'new' && standing !== 'same';

/** How many entries of each kind. */
export type EntryCounts = Readonly<Record<Kind, number>>;

/** What a file would bring, with names made plain, grouped by model, in the order of the file. */
export function groupsOf({ library, facts, writtenAt }: LibraryFile, held: Records): Group[] {
  const groups = new Map<string | null, { name: string; entries: Entry[] }>();
  const heldModels = byKey(held.models);
  const groupOf = (id: string | null): { name: string; entries: Entry[] } => {
    const group = groups.get(id) ?? { name: heldModels.get(id ?? '')?.model.name ?? '', entries: [] };
    groups.set(id, group);
    return group;
  };
  const add = <K extends Kind>(kind: K, id: string | null, given: EntryOf[K], here: Here<K> | undefined): void => {
    const known = facts.get(given) ?? {};
    const entry = withPlainNames(given);
    const changedAt = known.changedAt ?? ('at' in entry ? entry.at : writtenAt);
    const standing = standingOf(entry, changedAt, here);
    groupOf(id).entries.push({ kind, entry, facts: known, changedAt, here: here?.entry ?? null, standing });
  };
  for (const model of library.models) {
    const here = heldModels.get(model.id);
    groupOf(model.id).name = withPlainNames(model).name;
    add('models', model.id, model, here && { entry: here.model, changedAt: here.changedAt });
  }
  const heldSettings = byKey(held.settings);
  for (const setting of library.settings) {
    const here = heldSettings.get(setting.id);
    add('settings', setting.model, setting, here && { entry: here.setting, changedAt: here.changedAt });
  }
  const heldFlights = byKey(held.flights);
  for (const flight of library.flights) {
    const here = heldFlights.get(flight.id);
    add('flights', flight.model, flight, here && { entry: here.flight, changedAt: here.changedAt });
    const group = groupOf(flight.model);
    group.name ||= withPlainNames(flight).modelName;
  }
  return [...groups].map(([id, group]) => ({ id, ...group }));
}

/** The device's entry of the same id. */
interface Here<K extends Kind> {
  readonly entry: EntryOf[K];
  readonly changedAt: number;
}

function standingOf<K extends Kind>(entry: EntryOf[K], changedAt: number, here?: Here<K>): Entry['standing'] {
  if (!here) return 'new';
  // An old record may hold what names may not hold today.
  if (isSame(entry, withPlainNames(here.entry))) return 'same';
  return changedAt > here.changedAt ? 'file-newer' : 'not-newer';
}

interface Taken {
  readonly entry: Entry;
  /** Whether it gets a new id and a new name. */
  readonly asCopy: boolean;
}

/** The entries to import in this way, and in which form. */
export function takenOf({ entries }: Group, way: Way): readonly Taken[] {
  return entries.flatMap((entry): Taken[] => {
    if (entry.standing === 'same') return [];
    if (entry.standing === 'new') return [{ entry, asCopy: false }];
    if (way === 'both') return [{ entry, asCopy: true }];
    return entry.standing === 'file-newer' ? [{ entry, asCopy: false }] : [];
  });
}

/**
 * The records after an import.
 * @param newId makes an id that is not in use.
 */
export function recordsOf(groups: readonly Group[], way: Way, held: Records, newId: () => string): Records {
  const records = { models: [] as ModelRecord[], settings: [] as SettingRecord[], flights: [] as FlightRecord[] };
  const heldModels = byKey(held.models);
  for (const group of groups) {
    for (const { entry, asCopy } of takenOf(group, way)) {
      const id = asCopy ? newId() : entry.entry.id;
      const { changedAt } = entry;
      if (isOf(entry, 'models')) {
        const names = [...held.models, ...records.models].map(({ model }) => model.name);
        const model = { ...entry.entry, id, name: asCopy ? freeName(entry.entry.name, names) : entry.entry.name };
        const here = heldModels.get(id);
        const verified = latest([...(here?.verified ?? []), ...(entry.facts.verified ?? [])]);
        records.models.push({
          key: id,
          model,
          changedAt,
          verified,
        });
      } else if (isOf(entry, 'settings')) {
        const beside = [...held.settings, ...records.settings].filter(
          ({ setting }) => setting.model === entry.entry.model,
        );
        const names = beside.map(({ setting }) => setting.name);
        const setting = { ...entry.entry, id, name: asCopy ? freeName(entry.entry.name, names) : entry.entry.name };
        records.settings.push({
          key: id,
          setting,
          changedAt,
        });
      } else if (isOf(entry, 'flights')) {
        records.flights.push({ key: id, flight: { ...entry.entry, id }, changedAt });
      }
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
export function countOf(entries: readonly { readonly kind: Kind }[]): EntryCounts {
  const count = (wanted: Kind): number => entries.filter(({ kind }) => kind === wanted).length;
  return { models: count('models'), settings: count('settings'), flights: count('flights') };
}

function isOf<K extends Kind>(entry: Entry, kind: K): entry is Entry<K> {
  return entry.kind === kind;
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

/** `calm (2)`, or the next free number. */
function freeName(name: string, names: readonly string[]): string {
  for (let number = 2; ; number++) {
    const end = ` (${number})`;
    const free = beginningOf(name, LIMITS.name - end.length) + end;
    if (!names.includes(free)) return free;
  }
}
