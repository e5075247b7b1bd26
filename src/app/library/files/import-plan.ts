import {
  type EntryFacts,
  type Flight,
  LIMITS,
  type LibraryFile,
  type Model,
  type Setting,
} from '../../../program/index.js';
import { beginningOf, withPlainNames } from '../../session/plain-names.js';
import { programKey } from '../../session/record-keys.js';
import { type FlightRecord, isSame, type ModelRecord, type SettingRecord } from '../../storage/index.js';

/** The records of a library, or of a part of it. */
export interface Records {
  readonly models: readonly ModelRecord[];
  readonly settings: readonly SettingRecord[];
  readonly flights: readonly FlightRecord[];
}
export type Kind = keyof Records;

/** What becomes of what differs: the newer of the two, both, or neither this nor anything else of its model. */
export type Way = 'newer' | 'both' | 'skip';
export const WAYS = ['newer', 'both', 'skip'] as const satisfies readonly Way[];

type EntryOf = { models: Model; settings: Setting; flights: Flight };

/** One entry of a file, beside what the device has under the same id. */
export interface Entry<K extends Kind = Kind> {
  readonly kind: K;
  readonly entry: EntryOf[K];
  readonly facts: EntryFacts;
  /** When it was changed last, as far as the file says; else when it was written. */
  readonly changedAt: number;
  readonly standing: 'new' | 'same' | 'file-newer' | 'device-newer';
}

/** The entries of a file that belong to one model, or to none. */
export interface Group {
  /** The id of the model; null: of none. */
  readonly id: string | null;
  /** Empty: nothing knows a name. */
  readonly name: string;
  readonly entries: readonly Entry[];
}

/** How many entries of each kind. */
export type EntryCounts = Readonly<Record<Kind, number>>;

/** What a file would bring, model by model in its order. */
export function groupsOf({ library, facts, writtenAt }: LibraryFile, held: Records): Group[] {
  const groups = new Map<string | null, { name: string; entries: Entry[] }>();
  const heldModels = byKey(held.models);
  const groupOf = (id: string | null): { name: string; entries: Entry[] } => {
    const group = groups.get(id) ?? { name: heldModels.get(id ?? '')?.model.name ?? '', entries: [] };
    groups.set(id, group);
    return group;
  };
  const add = <K extends Kind>(kind: K, id: string | null, entry: EntryOf[K], here: Here | undefined): void => {
    const known = facts.get(entry) ?? {};
    const changedAt = known.changedAt ?? ('at' in entry ? entry.at : writtenAt);
    const standing = standingOf(entry, changedAt, here);
    groupOf(id).entries.push({ kind, entry, facts: known, changedAt, standing });
  };
  for (const model of library.models) {
    const here = heldModels.get(model.id);
    groupOf(model.id).name = model.name;
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
    group.name ||= flight.modelName;
  }
  return [...groups].map(([id, group]) => ({ id, ...group }));
}

/** What the device has under the same id. */
interface Here {
  readonly entry: unknown;
  readonly changedAt: number;
}

function standingOf(entry: unknown, changedAt: number, here: Here | undefined): Entry['standing'] {
  if (!here) return 'new';
  if (isSame(entry, here.entry)) return 'same';
  return changedAt > here.changedAt ? 'file-newer' : 'device-newer';
}

interface Taken {
  readonly entry: Entry;
  /** It gets an id and a name of its own. */
  readonly asCopy: boolean;
}

/** Which entries come in, and as what, when it is done this way. */
export function takenOf({ entries }: Group, way: Way): readonly Taken[] {
  if (way === 'skip') return [];
  return entries.flatMap((entry): Taken[] => {
    if (entry.standing === 'same') return [];
    if (entry.standing === 'new') return [{ entry, asCopy: false }];
    if (way === 'both') return [{ entry, asCopy: true }];
    return entry.standing === 'file-newer' ? [{ entry, asCopy: false }] : [];
  });
}

/**
 * The records that an import keeps: what is there already stays in its place, what is new comes behind it.
 * @param newId makes an id that nothing has.
 */
export function recordsOf(
  groups: readonly Group[],
  wayOf: (group: Group) => Way,
  held: Records,
  newId: () => string,
): Records {
  const records = { models: [] as ModelRecord[], settings: [] as SettingRecord[], flights: [] as FlightRecord[] };
  const heldModels = byKey(held.models);
  const heldSettings = byKey(held.settings);
  const order = { models: lastOrder(held.models), settings: lastOrder(held.settings) };
  for (const group of groups) {
    for (const { entry, asCopy } of takenOf(group, wayOf(group))) {
      const id = asCopy ? newId() : entry.entry.id;
      const { changedAt } = entry;
      if (isOf(entry, 'models')) {
        const names = [...held.models, ...records.models].map(({ model }) => model.name);
        const model = { ...entry.entry, id, name: asCopy ? freeName(entry.entry.name, names) : entry.entry.name };
        const here = heldModels.get(id);
        const verified = latest([...(here?.verified ?? []), ...(entry.facts.verified ?? [])]);
        records.models.push({
          key: id,
          model: withPlainNames(model),
          order: here?.order ?? ++order.models,
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
          setting: withPlainNames(setting),
          order: heldSettings.get(id)?.order ?? ++order.settings,
          changedAt,
        });
      } else if (isOf(entry, 'flights')) {
        records.flights.push({ key: id, flight: withPlainNames({ ...entry.entry, id }), changedAt });
      }
    }
  }
  return records;
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

function lastOrder(records: readonly { readonly order: number }[]): number {
  return records.reduce((last, { order }) => Math.max(last, order), 0);
}

/** What each memory held when it was seen last. */
function latest(verified: ModelRecord['verified']): ModelRecord['verified'] {
  const found = new Map<string, ModelRecord['verified'][number]>();
  for (const each of verified) {
    const key = programKey(each.program, each.simulated ?? false);
    if (each.at >= (found.get(key)?.at ?? 0)) found.set(key, each);
  }
  return [...found.values()];
}

/** `calm (2)`, or the next number that is free. */
function freeName(name: string, names: readonly string[]): string {
  for (let number = 2; ; number++) {
    const end = ` (${number})`;
    const free = beginningOf(name, LIMITS.name - end.length) + end;
    if (!names.includes(free)) return free;
  }
}
