/** The size of the picture in a file, in pixels, from the beginning of the file alone: before anything is decoded. */
export interface PictureSize {
  readonly width: number;
  readonly height: number;
}

/** Where each format that browsers decode keeps the size, by the first bytes of the file. */
const FORMATS: readonly (readonly [
  begins: (view: DataView) => boolean,
  size: (view: DataView) => PictureSize | null,
])[] = [
  [(view) => view.getUint16(0) === 0xffd8, jpegSize],
  [(view) => view.getUint32(0) === 0x89504e47, (view) => ({ width: view.getUint32(16), height: view.getUint32(20) })],
  [
    (view) => textAt(view, 0, 3) === 'GIF',
    (view) => ({ width: view.getUint16(6, true), height: view.getUint16(8, true) }),
  ],
  [(view) => textAt(view, 0, 4) === 'RIFF' && textAt(view, 8, 4) === 'WEBP', webpSize],
  [
    (view) => textAt(view, 0, 2) === 'BM',
    (view) => ({ width: Math.abs(view.getInt32(18, true)), height: Math.abs(view.getInt32(22, true)) }),
  ],
  // AVIF and HEIC.
  [(view) => textAt(view, 4, 4) === 'ftyp', boxedSize],
];

/**
 * The size that a picture file states.
 * @param beginning the first bytes of the file, as many as are known.
 * @returns null for anything else: no picture, an unknown format, or no size in these bytes.
 */
export function pictureSize(beginning: ArrayBuffer): PictureSize | null {
  const view = new DataView(beginning);
  try {
    const [, sizeOf] = FORMATS.find(([begins]) => begins(view)) ?? [];
    const size = sizeOf?.(view) ?? null;
    return size && size.width > 0 && size.height > 0 ? size : null;
  } catch (cause) {
    // The bytes end before the size.
    if (cause instanceof RangeError) return null;
    throw cause;
  }
}

/** The first segment that begins a frame has the size. Any number of other segments may come before it. */
function jpegSize(view: DataView): PictureSize | null {
  for (let at = 2; ; ) {
    if (view.getUint8(at) !== 0xff) return null;
    const marker = view.getUint8(at + 1);
    // Fill bytes.
    if (marker === 0xff) at += 1;
    else if (isFrame(marker)) return { width: view.getUint16(at + 7), height: view.getUint16(at + 5) };
    // The picture data begins here, and no segment has given the size.
    else if (marker === 0xda || marker === 0xd9) return null;
    else at += 2 + view.getUint16(at + 2);
  }
}

/** SOF0 to SOF15, without the tables and extensions among these numbers. */
function isFrame(marker: number): boolean {
  return marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker);
}

function webpSize(view: DataView): PictureSize | null {
  const kind = textAt(view, 12, 4);
  if (kind === 'VP8X') return { width: 1 + threeBytes(view, 24), height: 1 + threeBytes(view, 27) };
  if (kind === 'VP8 ') return { width: view.getUint16(26, true) & 0x3fff, height: view.getUint16(28, true) & 0x3fff };
  if (kind !== 'VP8L') return null;
  const bits = view.getUint32(21, true);
  return { width: 1 + (bits & 0x3fff), height: 1 + ((bits >>> 14) & 0x3fff) };
}

/** The largest of all sizes in the file, which may also hold small pictures. */
function boxedSize(view: DataView): PictureSize | null {
  let largest: PictureSize | null = null;
  for (let at = 0; at + 16 <= Math.min(view.byteLength, 65_536); at++) {
    if (view.getUint32(at) !== 0x69737065) continue; // ispe
    const size = { width: view.getUint32(at + 8), height: view.getUint32(at + 12) };
    if (!largest || size.width * size.height > largest.width * largest.height) largest = size;
  }
  return largest;
}

function threeBytes(view: DataView, at: number): number {
  return view.getUint16(at, true) + 0x1_0000 * view.getUint8(at + 2);
}

function textAt(view: DataView, at: number, count: number): string {
  return Array.from({ length: count }, (_, each) => String.fromCharCode(view.getUint8(at + each))).join('');
}
