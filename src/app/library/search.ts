/** A text in the form for comparison: small letters without marks. */
export function foldedText(text: string): string {
  return text.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
}

/** The words to search for. */
export function searchWords(text: string): string[] {
  return foldedText(text).split(/\s+/).filter(Boolean);
}

/** Whether a text contains each of the words. */
export function hasAll(folded: string, words: readonly string[]): boolean {
  return words.every((word) => folded.includes(word));
}
