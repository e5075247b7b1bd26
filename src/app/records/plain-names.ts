import type { Flight, Model, Setting } from '../../program/index.js';

/**
 * What nobody sees: two names that look alike would be two models. And what turns the direction of all later text:
 * after such a name a sentence would show 61 in place of 16. Not the joiners, the shapes of emoji, and flags.
 */
const HIDDEN =
  /(?<=[^\p{Script=Latin}\p{Script=Greek}\p{Script=Cyrillic}\p{DI}])[\ufe00-\ufe0f]|(?<=[\u{1f3f4}\u{e0020}-\u{e007f}])[\u{e0020}-\u{e007f}]|[\u200c\u200d]|(?<hidden>\p{DI})/gu;
/** Joiners change what is seen within emoji, and between the letters of these scripts. */
const JOINERS = new RegExp(
  `(?<=[\\p{ExtPict}\\ufe0f\\u{1f3fb}-\\u{1f3ff}])\\u200d(?=\\p{ExtPict})|(?<=${joining()})[\\u200c\\u200d](?=${joining()})|(?<hidden>[\\u200c\\u200d])`,
  'gu',
);
/** Line breaks, tabs and other signs for machines. A name stands on one line. */
const CONTROLS = /[\p{Cc}\u2028\u2029]+/gu;
/** One half of a character: it cannot be saved in a file, nor sent. */
const HALVES = /\p{Cs}/gu;
/** Of a text of these alone nobody would see anything. */
const UNSEEN = /^[\p{Z}\p{Cc}\p{Cf}\p{Default_Ignorable_Code_Point}]*$/u;

/**
 * A name that is safe in sentences, wherever it comes from. Hebrew or Arabic stays as it is. Empty when there is
 * nothing to see.
 */
export function plainName(text: string): string {
  const plain = withoutHidden(text).replaceAll(CONTROLS, ' ').replaceAll(HALVES, '\ufffd').trim();
  return UNSEEN.test(plain) ? '' : plain;
}

function withoutHidden(text: string): string {
  // Nearly every name.
  if (!/[^ -~]/.test(text)) return text;
  return [HIDDEN, JOINERS].reduce(
    (left, kind) => left.replaceAll(kind, (all, ...more) => (more.at(-1).hidden === undefined ? all : '')),
    text,
  );
}

function joining(): string {
  const scripts = 'Arab Syrc Mong Deva Beng Guru Gujr Orya Taml Telu Knda Mlym Sinh Khmr'.split(' ');
  return `[${scripts.map((script) => `\\p{Script=${script}}`).join('')}]`;
}

/** For a name that must not be empty. */
const named = (text: string): string => plainName(text) || '–';

/** Makes the names of an entry safe; see {@link plainName}. */
export function withPlainNames<T extends Model | Setting | Flight>(entry: T): T {
  if ('memoryNames' in entry) {
    const servos = entry.servos.map((use) => ({ ...use, name: plainName(use.name) }));
    return { ...entry, name: named(entry.name), memoryNames: entry.memoryNames.map(plainName), servos };
  }
  if ('tags' in entry) return { ...entry, name: named(entry.name), tags: entry.tags.map(plainName).filter(Boolean) };
  const { modelName, settingName, place, round } = entry;
  const texts = { modelName, settingName, place, round };
  return { ...entry, ...Object.fromEntries(Object.entries(texts).map(([field, text]) => [field, plainName(text)])) };
}

/** The beginning of a name that is too long, in whole characters: half an emoji is none. */
export function beginningOf(name: string, characters: number): string {
  return [...name].slice(0, characters).join('');
}
