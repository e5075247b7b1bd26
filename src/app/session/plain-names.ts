import type { Flight, Model, Setting } from '../../program/index.js';

/** What turns the direction of all text behind it: after such a name a sentence would say 61 in the place of 16. */
const TURNS = /[\u202a-\u202e\u2066-\u2069]/g;

const plain = (text: string): string => text.replaceAll(TURNS, '');
/** Where a name has to be. */
const named = (text: string): string => plain(text) || '–';

/** As it may stand in a sentence, wherever it comes from. What a pilot writes in Hebrew or Arabic stays as it is. */
export function withPlainNames<T extends Model | Setting | Flight>(entry: T): T {
  if ('memoryNames' in entry) {
    const servos = entry.servos.map((use) => ({ ...use, name: plain(use.name) }));
    return { ...entry, name: named(entry.name), memoryNames: entry.memoryNames.map(plain), servos };
  }
  if ('tags' in entry) return { ...entry, name: named(entry.name), tags: entry.tags.map(plain).filter(Boolean) };
  const { modelName, settingName, place, round } = entry;
  const texts = { modelName, settingName, place, round };
  return { ...entry, ...Object.fromEntries(Object.entries(texts).map(([field, text]) => [field, plain(text)])) };
}

/** The beginning of a name that has no more room, in whole characters: half an emoji is none. */
export function beginningOf(name: string, characters: number): string {
  return [...name].slice(0, characters).join('');
}
