import { batch, type Signal, signal } from '@preact/signals';
import { sentencesOf, type Tree } from './catalogue.js';

/** The files of the languages, by their paths: `./de.ftl`. */
export type Files = Readonly<Record<string, () => Promise<Tree>>>;

/** One for each step in which the page is loaded. Gets its sentences in a language; the result shows them. */
const steps = new Set<(language: string) => Promise<() => void>>();

/**
 * The sentences of a step. A component that reads them is drawn again when the language changes.
 * @param english until another language is spoken.
 * @param of how a tree becomes the sentences.
 */
export function inLanguage<Sentences>(
  english: Sentences,
  files: Files,
  of: (tree: Tree, language: string) => Sentences = sentencesOf,
): Signal<Sentences> {
  const said = signal(english);
  steps.add(async (language) => {
    const file = files[`./${language}.ftl`];
    const sentences = file ? of(await file(), language) : english;
    return () => {
      said.value = sentences;
    };
  });
  return said;
}

/**
 * From now on the page speaks this language, all of it at once. A part that is loaded later must be told again.
 * @param language such as `de`. English for one that is not there.
 * @throws when its file cannot be loaded. Then nothing has changed.
 */
export async function speak(language: string): Promise<void> {
  const shows = await Promise.all([...steps].map((step) => step(language)));
  batch(() => {
    for (const show of shows) show();
  });
}
