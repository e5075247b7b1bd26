import { type PictureSize, pictureSize } from './picture-size.js';
import { PATIENCE } from './read-file.js';
import { answerOf } from './services.js';

/**
 * Why a file is not accepted as a picture. `unreadable`: the browser cannot read it. `too-large`:
 * a phone has no room for it.
 */
export type PictureFault = 'unreadable' | 'too-large';

/** Nobody has a larger picture file, in bytes. */
const LARGEST_FILE = 50_000_000;
/**
 * Each decoded pixel takes four bytes, so 256 MB in all.
 * More than any phone takes by default (some take 108 million on request).
 */
const MOST_PIXELS = 64_000_000;
/** A JPEG may have previews and notes of the camera before its size. In bytes. */
const BEGINNING = 8_000_000;
/** A picture that is this many times longer than wide is not made smaller while it is decoded: see `smallerBy`. */
const LONG = 4;

/**
 * Decodes a picture from a file that may come from anybody. It checks the stated size first, because a small file can
 * ask for gigabytes.
 * @param side the width in pixels to which a larger picture is made smaller, unless it is a narrow strip.
 */
export async function decodedPicture(file: Blob, side: number): Promise<ImageBitmap | PictureFault> {
  if (file.size > LARGEST_FILE) return 'too-large';
  try {
    const size = pictureSize(await answerOf(() => file.slice(0, BEGINNING).arrayBuffer(), PATIENCE));
    if (!size) return 'unreadable';
    if (size.width * size.height > MOST_PIXELS) return 'too-large';
    return await answerOf(() => createImageBitmap(file, smallerBy(size, side)), PATIENCE);
  } catch {
    return 'unreadable';
  }
}

/**
 * Asks for the width alone; the height follows. A camera that was held upright says so only after the size, so width
 * and height may be swapped.
 */
function smallerBy({ width, height }: PictureSize, side: number): ImageBitmapOptions {
  const [short, long] = width < height ? [width, height] : [height, width];
  return short <= side || long > LONG * short ? {} : { resizeWidth: side, resizeQuality: 'medium' };
}
