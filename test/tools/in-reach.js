/** What can cover the page. */
export const OVER = 'dialog[open], .top:has(.strip-panel), .row-panel, .edit-sheet:popover-open';

/**
 * What a pilot cannot read or press in the present window: text that is cut off or lies on other text, and controls
 * that are outside the window or covered at every scroll position. Runs in the page.
 * @param {string} scope what lies over the page, if anything: the controls below it are not checked then
 */
export function outOfReach(scope) {
  /** @type {string[]} */
  const found = [];
  const root = document.documentElement;
  // An element that is laid out only when it becomes visible is checked at its later place.
  const every = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('main *'));
  const put = [...every].filter((element) => getComputedStyle(element).contentVisibility === 'auto');
  for (const element of put) element.style.contentVisibility = 'visible';
  // A dialog comes last and lies over all else.
  const over = [...document.querySelectorAll(scope)].at(-1);
  const all = (/** @type {string} */ selector) =>
    /** @type {NodeListOf<HTMLElement>} */ ((over ?? document).querySelectorAll(selector));
  const name = (/** @type {Element} */ element) =>
    `${element.tagName.toLowerCase()}.${element.getAttribute('class') ?? ''} “${(element.getAttribute('aria-label') ?? element.textContent ?? '').trim().slice(0, 40)}”`;
  const isSeen = (/** @type {Element} */ element) =>
    element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) &&
    element.getBoundingClientRect().width > 1 &&
    !element.closest('.visually-hidden, [inert]');
  const ancestors = function* (/** @type {Element | null} */ element) {
    for (let each = element; each; each = each.parentElement) yield each;
  };
  const scrolls = (/** @type {Element} */ element, /** @type {'X' | 'Y'} */ axis) =>
    /auto|scroll/.test(getComputedStyle(element)[`overflow${axis}`]);
  /** Elements that are hidden only for the eye. */
  const isForEars = (/** @type {Element} */ element) => getComputedStyle(element).clipPath !== 'none';

  if (root.scrollWidth > root.clientWidth)
    found.push(`the page goes ${root.scrollWidth - root.clientWidth} px sideways`);

  /** Below the last line of a text with a limited number of lines that ends in an ellipsis. */
  const isLeftOut = (/** @type {Element} */ of, /** @type {DOMRect} */ box) => {
    const clamped = [...ancestors(of)].find((each) => !/none|^$/.test(getComputedStyle(each).webkitLineClamp));
    return clamped !== undefined && box.top > clamped.getBoundingClientRect().bottom - 0.5 * box.height;
  };

  /**
   * Lines of text. A layer is the element with which a line scrolls.
   * @type {{ box: DOMRect, text: string, of: Element, layer: Element | undefined }[]}
   */
  const lines = [];
  const walker = document.createTreeWalker(over ?? document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const { parentElement: of } = node;
    const text = node.textContent?.trim() ?? '';
    if (!of || text === '' || of.closest('svg, script, noscript, option') || !isSeen(of)) continue;
    if ([...ancestors(of)].some(isForEars)) continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    const layer = [...ancestors(of)].find(
      (each) =>
        /sticky|fixed|absolute/.test(getComputedStyle(each).position) || scrolls(each, 'X') || scrolls(each, 'Y'),
    );
    for (const box of range.getClientRects()) {
      if (box.width < 1 || isLeftOut(of, box)) continue;
      lines.push({ box, text, of, layer });
      for (const each of ancestors(of)) {
        const { overflowX, textOverflow, contain } = getComputedStyle(each);
        const cuts = overflowX !== 'visible' || /strict|content|paint/.test(contain);
        if (!cuts || each === root || each === document.body) continue;
        if (scrolls(each, 'X')) break;
        const edge = each.getBoundingClientRect();
        if (box.right > edge.right + 1 || box.left < edge.left - 1)
          found.push(`“${text.slice(0, 40)}” is cut off by ${name(each)} ${textOverflow}`);
      }
    }
  }
  for (const [at, one] of lines.entries()) {
    for (const other of lines.slice(at + 1)) {
      if (one.layer !== other.layer || one.of === other.of) continue;
      const wide = Math.min(one.box.right, other.box.right) - Math.max(one.box.left, other.box.left);
      const high = Math.min(one.box.bottom, other.box.bottom) - Math.max(one.box.top, other.box.top);
      // The box of a line is higher than its letters.
      if (wide > 1 && high > 0.4 * Math.min(one.box.height, other.box.height))
        found.push(`“${one.text.slice(0, 30)}” lies on “${other.text.slice(0, 30)}”`);
    }
  }

  /** @type {(() => void)[]} */
  const places = [];
  const control = 'button, a[href], input, select, textarea, summary, [role=switch], [role=option]';
  for (const element of all(control)) {
    const target = element.closest('label') ?? element;
    if (!isSeen(target) || element.closest('svg') || isForEars(target)) continue;
    if (element.scrollWidth > element.clientWidth + 1 && element.matches('button, a, input:not([readonly]), summary'))
      found.push(`${name(element)} is too narrow for what it says`);
    const inTable = [...ancestors(target)].some((each) => each !== root && scrolls(each, 'X'));
    const { left, right } = target.getBoundingClientRect();
    if (!inTable && (left < -0.5 || right > root.clientWidth + 0.5))
      found.push(`${name(element)} stands over the edge`);
    const isHit = () => {
      // Of a link on two lines the first: between them there may be nothing of it.
      const box = target.getClientRects()[0] ?? new DOMRect();
      const there = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
      return there !== null && target.contains(there);
    };
    if (isHit()) continue;
    // Wherever it can be scrolled to.
    for (const each of ancestors(target)) {
      const { scrollTop, scrollLeft } = each;
      places.push(() => each.scrollTo(scrollLeft, scrollTop));
    }
    target.scrollIntoView({ block: 'center', inline: 'center' });
    if (!isHit()) {
      const box = target.getBoundingClientRect();
      const there = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
      found.push(`${name(element)} is covered by ${there ? name(there) : 'nothing'}`);
    }
    for (const back of places.splice(0)) back();
  }
  for (const element of put) element.style.contentVisibility = '';
  return [...new Set(found)];
}
