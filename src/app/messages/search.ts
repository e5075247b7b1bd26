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

/** Worked out once for each record: a changed record is a new object. */
export function foldedOf<T extends object>(textsOf: (record: T) => readonly string[]): (record: T) => string {
  const known = new WeakMap<T, string>();
  return (record) => {
    const text = known.get(record) ?? foldedText(textsOf(record).join('\n'));
    known.set(record, text);
    return text;
  };
}
