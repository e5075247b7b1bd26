import { encodeLink, LINK_MARK, type Model, type Setting, type SharedSetting } from '../../program/index.js';

/** What a link says of a setting of the library. */
export function sharedOf({ name, note, tags, at, program }: Setting, model: Pick<Model, 'name'> | null): SharedSetting {
  return { name, note, tags, at, program, modelName: model?.name ?? '' };
}

/** A setting as an address: the page itself, with the whole setting behind the `#`, which no server is told. */
export function linkOf(shared: SharedSetting, page: string): string {
  return baseOf(page) + encodeLink(shared);
}

/**
 * So many characters a phone reads from another screen without trouble, version 15 of the QR codes; and so many with
 * patience, version 25. A note is cut to fit the first; values never are.
 */
const EASY_IN_QR = 500;
const MOST_IN_QR = 1200;

/** The link for a QR code. */
export interface QrLink {
  readonly link: string;
  /** The end of a long note has no room in it. */
  readonly isCut: boolean;
}

/** @returns null where the values alone are more than a phone can read. */
export function qrLinkOf(shared: SharedSetting, page: string): QrLink | null {
  const base = baseOf(page);
  const code = encodeLink(shared, { longest: EASY_IN_QR - base.length });
  if (base.length + code.length > MOST_IN_QR) return null;
  return { link: base + code, isCut: code !== encodeLink(shared) };
}

function baseOf(page: string): string {
  const { origin, pathname, protocol } = new URL(page);
  return `${protocol === 'file:' ? 'file://' : origin}${pathname}${LINK_MARK}`;
}
