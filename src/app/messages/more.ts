import { sentencesOf, type Tree } from './catalogue.js';
import english from './en.ftl?more';
import { inLanguage } from './language.js';
import type { MoreSentences } from './sentences.js';

/** The sentences that the start and the program do not need. They are loaded with the parts that read them. */
export const moreMessages = inLanguage(
  sentencesOf<MoreSentences>(english, 'en'),
  import.meta.glob<Tree>(['./*.ftl', '!./en.ftl'], { query: '?more', import: 'default' }),
);
