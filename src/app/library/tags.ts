import { LIMITS } from '../../program/index.js';
import { beginningOf } from '../records/plain-names.js';

/** Tags from a typed text with commas between them. Each comes once; no more than can be kept. */
export function asTags(text: string): string[] {
  const tags = text.split(',').map((tag) => beginningOf(tag.trim(), LIMITS.tag));
  return [...new Set(tags.filter(Boolean))].slice(0, LIMITS.tags);
}

export function tagsText(tags: readonly string[]): string {
  return tags.join(', ');
}
