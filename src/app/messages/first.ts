import * as v from 'valibot';
import { nameplate } from '../browser/services.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import { language, speak } from './language.js';
import type { FirstSentences } from './sentences.js';

/** What the page says before its other sentences are here, in all languages: nothing else may come before it. */
const FIRST = import.meta.glob<FirstSentences>('./*.ftl', { query: '?first', import: 'default', eager: true });

/** The codes of all languages, such as `de`. English is the first. */
export const LANGUAGES: readonly string[] = Object.keys(FIRST)
  .map((path) => path.slice('./'.length, -'.ftl'.length))
  .sort((a, b) => Number(b === 'en') - Number(a === 'en') || (languageName(a) < languageName(b) ? -1 : 1));

/** The first sentences of a language. */
export function firstOf(language: string): FirstSentences['first'] {
  const { first } = FIRST[`./${language}.ftl`] as FirstSentences;
  return first;
}

/** A language as its speakers write it at the beginning of a line: “Deutsch”, “Italiano”. */
export function languageName(language: string): string {
  const name = new Intl.DisplayNames(language, { type: 'language' }).of(language) ?? language;
  return name.charAt(0).toLocaleUpperCase(language) + name.slice(1);
}

/** The language that was chosen; else the first of the browser's languages that the page has; else English. */
export function preferredLanguage(): string {
  const chosen = loadSetting('language', v.picklist(LANGUAGES));
  // Some browsers write `de_DE`, and one that hides who it is may give no list.
  const wished = (nameplate().languages ?? []).map((each) => each.toLowerCase().replace(/[-_].*/, ''));
  return chosen ?? wished.find((each) => LANGUAGES.includes(each)) ?? 'en';
}

/**
 * Speaks a language now and from the next start on.
 * @throws when its file cannot be loaded. Then nothing has changed.
 */
export async function chooseLanguage(code: string): Promise<void> {
  await speak(code);
  // Another one may have been chosen since.
  if (language.peek() === code) saveSetting('language', code);
}
