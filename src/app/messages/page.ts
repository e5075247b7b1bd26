import { sentencesOf, type Tree } from './catalogue.js';
import english from './en.ftl?page';
import { inLanguage } from './language.js';
import type { PageSentences } from './sentences.js';

/** One sentence that says what happened, and one that says what to do. */
export interface Said {
  readonly title: string;
  readonly advice: string;
}

/**
 * The sentences of what is loaded first. A component that reads a signal is drawn again with its parent only if a
 * property changed, and components such as the groups of the line count on that.
 */
export const messages = inLanguage(
  sentencesOf<PageSentences>(english, 'en'),
  import.meta.glob<Tree>(['./*.ftl', '!./en.ftl'], { query: '?page', import: 'default' }),
);
