import { encodeLink, LINK_MARK, type Model, type Setting, type SharedSetting } from '../../program/index.js';

/** The parts of a library setting that a link carries. */
export function sharedOf({ name, note, tags, at, program }: Setting, model: Pick<Model, 'name'> | null): SharedSetting {
  return { name, note, tags, at, program, modelName: model?.name ?? '' };
}

/** A setting as an address: this page, with the whole setting after the `#`, which no server sees. */
export function linkOf(shared: SharedSetting, page: string): string {
  return baseOf(page) + encodeLink(shared);
}

/**
 * How many characters a phone reads easily from another screen (version 15 of QR codes), and how many with patience
 * (version 25). A note is cut to fit the first; values are never cut.
 */
const EASY_IN_QR = 500;
const MOST_IN_QR = 1200;

/** A link that fits into a QR code. */
export interface QrLink {
  readonly link: string;
  /** Whether the end of a long note was cut. */
  readonly isCut: boolean;
}

/** @returns null when the values alone are more than a phone can read. */
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
