/**
 * The texts on the screen, also those for screen readers, that do not come from en.ftl: on a page that speaks the
 * language of tests each sentence stands in ⟦brackets⟧, and each of its vowels is doubled. A text that is put together
 * from two sentences is among them, unless a mark stands between, such as “.” or “·”, or it is a name with its figure,
 * or a servo with what it moves. A test also runs this in a page, so it needs nothing from outside.
 * @param known the forms of what is no sentence of the page, such as the name of a model.
 */
export function leftOut(within: Element, known: readonly string[] = []): string[] {
  const elsewhere = new RegExp(known.join('|') || '$', 'gu');
  const attributes = ['alt', 'aria-label', 'aria-valuetext', 'data-short', 'label', 'placeholder', 'title'];
  /** A text without the sentences in it. Brackets within brackets are a sentence in a sentence. */
  const bare = (text: string): string => {
    const inner = text.replaceAll(/⟦[^⟦⟧]*⟧/g, '\0');
    return inner === text ? text : bare(inner);
  };
  const isLeftOut = (text: string): boolean =>
    /\p{L}{2}/u.test(bare(text)) ||
    // A word in another sentence that is not marked.
    /(?<=\p{L})[aeiou]|[aeiou](?=\p{L})/iu.test(text.normalize('NFC').replaceAll(/[áéíóú][aeiou]/gi, '')) ||
    /(?<!⟦S\d|[.:…?])⟧\s*⟦(?!⟦?[\d−])/.test(text);
  const found = [...within.querySelectorAll('*:not(script, style, [lang=en], .language-choice option)')].flatMap(
    (element) => [
      ...[...element.childNodes].filter(({ nodeType }) => nodeType === Node.TEXT_NODE).map((node) => node.textContent),
      ...attributes.map((name) => element.getAttribute(name)),
    ],
  );
  return found.flatMap((text) => (text !== null && isLeftOut(text.replaceAll(elsewhere, '')) ? [text.trim()] : []));
}
