import { sentencesOf, type Tree } from '../../src/app/messages/catalogue.js';
import type { MoreSentences, PageSentences } from '../../src/app/messages/sentences.js';

const PAGE = import.meta.glob<Tree>('../../src/app/messages/*.ftl', { query: '?page', import: 'default' });
const MORE = import.meta.glob<Tree>('../../src/app/messages/*.ftl', { query: '?more', import: 'default' });

/** Everything that the page says in a language, for tests. English is in `en.ts`. */
export async function sentencesIn(language: string): Promise<PageSentences & MoreSentences> {
  const path = `../../src/app/messages/${language}.ftl`;
  const [page, more] = await Promise.all([PAGE[path]?.(), MORE[path]?.()]);
  if (!page || !more) throw new Error(`There is no language ${language}.`);
  return { ...sentencesOf<PageSentences>(page, language), ...sentencesOf<MoreSentences>(more, language) };
}
