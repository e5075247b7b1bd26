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

/** What was asked for last. */
let asked = 'en';

/**
 * From now on the page speaks this language, all of it at once; or the one that was asked for while its file came, so
 * that a file that does not come holds up no other.
 * @param code such as `de`. Without one, parts that have been loaded since then learn the present language.
 * @throws when its file cannot be loaded. Then nothing has changed.
 */
export async function speak(code?: string): Promise<void> {
  if (code !== undefined) asked = code;
  const wanted = (): string => (code === undefined ? language.peek() : asked);
  // While files come, another language may be asked for, and another part may come that has sentences.
  for (let isDone = false; !isDone; ) {
    const next = wanted();
    const isSilent = ({ said }: Step): boolean => said !== next;
    const silent = [...steps].filter(isSilent);
    const shows = await Promise.all(silent.map(({ load }) => load(next))).catch((error: unknown) => {
      if (next === wanted()) throw error;
      return [];
    });
    isDone = next === wanted() && [...steps].filter(isSilent).every((step) => silent.includes(step));
    if (!isDone) continue;
    batch(() => {
      for (const show of shows) show();
      for (const step of silent) step.said = next;
      spoken.value = next;
    });
  }
}
