/**
 * Changes the texts of the first picture in a fixed order, those for screen readers too.
 * @param change gets each text and gives another one.
 */
export function changeTexts(picture: Element, change: (text: string) => string): void {
  const walker = document.createTreeWalker(picture, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const { currentNode: text } = walker;
    // The names of the languages are the same in each.
    if (!text.parentElement?.matches('option')) text.nodeValue = change(text.nodeValue ?? '');
  }
  for (const element of picture.querySelectorAll('[aria-label]'))
    element.setAttribute('aria-label', change(element.getAttribute('aria-label') ?? ''));
}
