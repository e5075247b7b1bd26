/** Letters that no sign is taken from: they are other letters. */
const ALONE: Readonly<Record<string, string>> = { ł: 'l', ø: 'o', đ: 'd', ð: 'd', ß: 'ss', æ: 'ae', œ: 'oe', ı: 'i' };

/** A text in the form for comparison: small letters without marks, so that “muller” finds “Müller”. */
export function foldedText(text: string): string {
  return text
    .normalize('NFKD')
    .replaceAll(/\p{M}/gu, '')
    .toLowerCase()
    .replaceAll(/[łøđðßæœı]/g, (letter) => ALONE[letter] ?? letter);
}

/**
 * The search of every list of the page.
 * @param search what the pilot typed. Without a word everything is found.
 * @returns whether a text, which must be folded, contains each of the words.
 */
export function searchFor(search: string): (text: string) => boolean {
  const words = foldedText(search).trim().split(/\s+/);
  return (text) => words.every((word) => text.includes(word));
}
