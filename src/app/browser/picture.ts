import { type PictureSize, pictureSize } from './picture-size.js';

/** Why a file is not taken for a picture: it is none that can be read, or more than a phone has room for. */
export type PictureFault = 'unreadable' | 'too-large';

/** Nobody has a picture of more bytes. */
const LARGEST_FILE = 50_000_000;
/** Decoded, each takes four bytes: 256 MB in all. More than any phone takes, but where it is asked for 108 million. */
const MOST_PIXELS = 64_000_000;
/** Before its size a JPEG may have previews and notes of the camera. */
const BEGINNING = 8_000_000;
/** What is longer than that in one direction is not made smaller while it is decoded: see `smallerBy`. */
const LONG = 4;

/**
 * Decodes a picture from a file that may come from anybody. What it says of its size is looked at first: a file of some
 * bytes can ask for gigabytes.
 * @param side a larger picture comes with so many pixels from left to right, but for a narrow strip.
 */
export async function decodedPicture(file: Blob, side: number): Promise<ImageBitmap | PictureFault> {
  if (file.size > LARGEST_FILE) return 'too-large';
  try {
    const size = pictureSize(await file.slice(0, BEGINNING).arrayBuffer());
    if (!size) return 'unreadable';
    if (size.width * size.height > MOST_PIXELS) return 'too-large';
    return await createImageBitmap(file, smallerBy(size, side));
  } catch {
    return 'unreadable';
  }
}

/**
 * One side alone is asked for: the other follows, and a camera that was held upright says so only behind the size, so
 * that width and height may be the other way round.
 */
function smallerBy({ width, height }: PictureSize, side: number): ImageBitmapOptions {
  const [short, long] = width < height ? [width, height] : [height, width];
  return short <= side || long > LONG * short ? {} : { resizeWidth: side, resizeQuality: 'medium' };
}
