import { LIMITS } from '../../program/index.js';
import { beginningOf } from '../session/plain-names.js';

/** Tags as they are typed: words with commas between them; each once, as far as they are kept. */
export function asTags(text: string): string[] {
  const tags = text.split(',').map((tag) => beginningOf(tag.trim(), LIMITS.tag));
  return [...new Set(tags.filter(Boolean))].slice(0, LIMITS.tags);
}

export function tagsText(tags: readonly string[]): string {
  return tags.join(', ');
}
