/** Where the pilot was in a view. */
export interface ViewPlace {
  readonly scroll: number;
  /** The same inside the table, which scrolls with unusually many functions or servos. */
  readonly inTable: { readonly left: number; readonly top: number };
  /** The focused element, by its number among those of its kind; null when nothing had the focus. */
  readonly focus: { readonly tag: string; readonly at: number } | null;
}

const TABLE = '.table-scroller, .bench-table';

/**
 * Where the pilot is in a view now.
 * @param last what last had the focus in it. The link to another view may have it by now.
 */
export function placeIn(view: HTMLElement, last: Element | null): ViewPlace {
  const scroll = view.ownerDocument.documentElement.scrollTop;
  const { scrollLeft: left = 0, scrollTop: top = 0 } = view.querySelector(TABLE) ?? {};
  const here = { scroll, inTable: { left, top } };
  if (!last || last === view || !view.contains(last)) return { ...here, focus: null };
  const tag = last.tagName;
  return { ...here, focus: { tag, at: [...view.querySelectorAll(tag)].indexOf(last) } };
}

/**
 * Takes the pilot back to a place: scrolled as before, with the focus there; without a place, to the top. An open
 * dialog keeps its focus.
 * @param byTouch whether a finger came here: a focused field would open the keyboard.
 */
export function putBackPlace(view: HTMLElement, place: ViewPlace | undefined, byTouch: boolean): void {
  const { ownerDocument: page } = view;
  // A field that was sought from another view is there already.
  if (page.activeElement !== view && view.contains(page.activeElement)) return;
  page.documentElement.scrollTop = place?.scroll ?? 0;
  if (place) view.querySelector(TABLE)?.scrollTo(place.inTable);
  if (page.querySelector('dialog[open]')) return;
  const was = place?.focus && view.querySelectorAll<HTMLElement>(place.focus.tag)[place.focus.at];
  (was && !byTouch ? was : view).focus({ preventScroll: true });
}
