import { batch, type ReadonlySignal, signal } from '@preact/signals';
import { sentencesOf, type Tree } from './catalogue.js';

/** The files of the languages, by their paths: `./de.ftl`. */
export type Files = Readonly<Record<string, () => Promise<Tree>>>;

interface Step {
  /** The language of its sentences; null before they are here. */
  said: string | null;
  /** Gets its sentences in a language; the result shows them. */
  readonly load: (code: string) => Promise<() => void>;
}

/** One for each step in which the page is loaded. */
const steps = new Set<Step>();

const spoken = signal('en');
/** The language that the page speaks, such as `de`. */
export const language: ReadonlySignal<string> = spoken;

/**
 * The sentences of a step: none before `speak`. A component that reads them is drawn again when the language changes.
 * @param files of a step that is loaded later than the first.
 */
export function inLanguage<Sentences>(files: Files): ReadonlySignal<Sentences> {
  const said = signal({} as Sentences);
  const load = async (code: string): Promise<() => void> => {
    const file = files[`./${code}.ftl`];
    if (!file) throw new Error(`no language ${code}`);
    const sentences = sentencesOf<Sentences>(await file(), code);
    return () => {
      said.value = sentences;
    };
  };
  steps.add({ said: null, load });
  return said;
}

/** One change after another: the last one that was asked for stays. */
let changes: Promise<void> = Promise.resolve();

/**
 * From now on the page speaks this language, all of it at once.
 * @param code such as `de`. Without one, parts that have been loaded since then learn the present language.
 * @throws when its file cannot be loaded. Then nothing has changed.
 */
export function speak(code?: string): Promise<void> {
  const change = changes.then(() => changeTo(code ?? language.peek()));
  changes = change.catch(() => {});
  return change;
}

async function changeTo(code: string): Promise<void> {
  const silent = [...steps].filter(({ said }) => said !== code);
  const shows = await Promise.all(silent.map(({ load }) => load(code)));
  batch(() => {
    for (const show of shows) show();
    for (const step of silent) step.said = code;
    spoken.value = code;
  });
}
