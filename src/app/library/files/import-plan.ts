import {
  type EntryFacts,
  type Flight,
  LIMITS,
  type LibraryFile,
  type Model,
  type Setting,
} from '../../../program/index.js';
import { beginningOf, withPlainNames } from '../../records/plain-names.js';
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

/**
 * What to do with entries that differ: keep the newer one, or that of the device if both have the same date; or keep
 * both.
 */
export const WAYS = ['newer', 'both'] as const;
export type Way = (typeof WAYS)[number];

/** One entry of a file, with the device's entry of the same id. */
export interface Entry {
  readonly kind: Kind;
  readonly entry: Model | Setting | Flight;
  readonly facts: EntryFacts;
  /** When it was last changed, if the file says so; else when the file was written. */
  readonly changedAt: number;
  /** The device's entry of the same id; null for none. */
  readonly here: Model | Setting | Flight | null;
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
      const here = record ? contentOf(record) : null;
      const standing = standingOf(entry, here, changedAt > (record?.changedAt ?? 0));
      group.entries.push({ kind, entry, facts: known, changedAt, here, standing });
    }
  }
  return [...groups].map(([id, group]) => ({ id, ...group }));
}

function standingOf(entry: Entry['entry'], here: Entry['here'], isNewer: boolean): Entry['standing'] {
  if (!here) return 'new';
  // An old record may hold what names may not hold today.
  if (isSame(entry, withPlainNames(here))) return 'same';
  return isNewer ? 'file-newer' : 'not-newer';
}

/** Whether a copy beside it says anything: one that is only in the archive, or only not, does not. */
function isOther(entry: Entry): boolean {
  const { entry: content, here } = entry;
  return differs(entry) && !(here && 'archived' in here && isSame({ ...content, archived: here.archived }, here));
}

/** Whether its model is kept twice: then the second one has the programs of the file, and is not empty. */
function isSplit({ entries }: Group, way: Way): boolean {
  return way === 'both' && entries.some((entry) => entry.kind === 'models' && isOther(entry));
}

/** The entries to import in this way. */
export function takenOf(group: Group, way: Way): readonly Entry[] {
  const isWhole = isSplit(group, way);
  return group.entries.filter((entry) => {
    if (isWhole && entry.kind === 'settings') return true;
    if (!differs(entry)) return !entry.here;
    return way === 'both' ? isOther(entry) : entry.standing === 'file-newer';
  });
}

/**
 * The records after an import. An entry that is kept beside another one gets a new id and a new name; the programs of a
 * second model keep their names.
 * @param newId makes an id that is not in use.
 */
export function recordsOf(groups: readonly Group[], way: Way, held: Records, newId: () => string): Records {
  const records = { models: [] as ModelRecord[], settings: [] as SettingRecord[], flights: [] as FlightRecord[] };
  const heldModels = byKey(held.models);
  const heldSettings = byKey(held.settings);
  const all = groups.flatMap((group) => {
    const second = isSplit(group, way) ? newId() : null;
    return takenOf(group, way).map((entry) => ({ entry, second }));
  });
  for (const { entry, second } of all) {
    const { kind, changedAt, facts } = entry;
    const isOfSecond = second !== null && kind === 'settings';
    const isCopy = way === 'both' && isOther(entry);
    const fresh = kind === 'models' ? (second ?? newId()) : newId();
    const key = isCopy || isOfSecond ? fresh : entry.entry.id;
    const content = { ...entry.entry, id: key };
    if (isOfSecond && 'tags' in content) content.model = second;
    else if (isCopy && 'name' in content) {
      const beside = [...held[kind], ...records[kind]]
        .map(contentOf)
        .filter((each) => modelOf(each) === modelOf(content));
      content.name = freeName(content.name, beside);
    }
    if ('memoryNames' in content) {
      const verified = latest([...(heldModels.get(key)?.verified ?? []), ...(facts.verified ?? [])]);
      records.models.push({ key, model: content, changedAt, verified });
    } else if ('tags' in content) {
      const versions = versionsWith(facts.versions, heldSettings.get(key), content.program);
      records.settings.push({ key, setting: content, changedAt, ...(versions && { versions }) });
    } else {
      records.flights.push({ key, flight: content, changedAt });
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

/** `calm (2)`, or the next free number. */
function freeName(name: string, beside: readonly object[]): string {
  for (let number = 2; ; number++) {
    const end = ` (${number})`;
    const free = beginningOf(name, LIMITS.name - end.length) + end;
    if (!beside.some((each) => 'name' in each && each.name === free)) return free;
  }
}
