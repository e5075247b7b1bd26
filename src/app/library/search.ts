/** A text as it is compared: without capitals, and without marks on its letters. */
export function foldedText(text: string): string {
  return text.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
}

/** The words that are searched for. */
export function searchWords(text: string): string[] {
  return foldedText(text).split(/\s+/).filter(Boolean);
}

/** Whether each of the words stands somewhere in a text. */
export function hasAll(folded: string, words: readonly string[]): boolean {
  return words.every((word) => folded.includes(word));
}
