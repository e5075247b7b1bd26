import type { Tree } from './catalogue.js';
import { inLanguage } from './language.js';
import type { MoreSentences } from './sentences.js';

/** The sentences that the start and the program do not need. They are loaded with the parts that read them. */
export const moreMessages = inLanguage<MoreSentences>(
  import.meta.glob<Tree>('./*.ftl', { query: '?more', import: 'default' }),
);
