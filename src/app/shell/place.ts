/** Where somebody was in a view. */
export interface ViewPlace {
  readonly scroll: number;
  /** The element that had the focus: by its number among those of its kind; null where none had. */
  readonly focus: { readonly tag: string; readonly at: number } | null;
}

/**
 * Where somebody is in a view now.
 * @param last what has had the focus last in it: the link to another view may have it by now.
 */
export function placeIn(view: HTMLElement, last: Element | null): ViewPlace {
  const scroll = view.ownerDocument.documentElement.scrollTop;
  if (!last || last === view || !view.contains(last)) return { scroll, focus: null };
  const tag = last.tagName;
  return { scroll, focus: { tag, at: [...view.querySelectorAll(tag)].indexOf(last) } };
}

/**
 * Takes somebody to where they were: scrolled, and with the focus there; without a place, to the top. An open dialog
 * keeps its focus.
 * @param byTouch a finger came here: a field that gets the focus would open the keyboard.
 */
export function putBackPlace(view: HTMLElement, place: ViewPlace | undefined, byTouch: boolean): void {
  const { ownerDocument: page } = view;
  page.documentElement.scrollTop = place?.scroll ?? 0;
  if (page.querySelector('dialog[open]')) return;
  const was = place?.focus && view.querySelectorAll<HTMLElement>(place.focus.tag)[place.focus.at];
  (was && !byTouch ? was : view).focus({ preventScroll: true });
}
