import { LIMITS } from '../../program/index.js';
import { decodedPicture, type PictureFault } from '../browser/picture.js';
import { tried } from '../browser/services.js';

/** The longer side of a kept picture in pixels. Smaller sizes are tried when a larger one takes too much room. */
const SIDES = [1280, 1024, 800, 640, 480] as const;
const QUALITIES = [0.82, 0.7, 0.55];

/**
 * A picture in its kept form: scaled down, as base64 of a JPEG file within the limit of a model. Or why there is none.
 */
export async function scaledPhoto(file: Blob): Promise<{ readonly photo: string } | { readonly fault: PictureFault }> {
  const picture = await decodedPicture(file, SIDES[0]);
  if (typeof picture === 'string') return { fault: picture };
  try {
    for (const side of SIDES) {
      const canvas = document.createElement('canvas');
      draw(picture, canvas, side);
      for (const quality of QUALITIES) {
        const jpeg = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/jpeg', quality));
        const text = jpeg && base64Of(new Uint8Array(await jpeg.arrayBuffer()));
        if (text && text.length <= LIMITS.photo) return { photo: text };
      }
    }
  } finally {
    picture.close();
  }
  return { fault: 'unreadable' };
}

/**
 * Draws a kept picture, which may come from somebody else's file.
 * @param isOld asked after reading, which takes time: whether another picture has taken its place.
 * @returns why nothing was drawn; null when it was.
 */
export async function drawPhoto(
  photo: string,
  canvas: HTMLCanvasElement,
  isOld: () => boolean,
): Promise<PictureFault | null> {
  const bytes = tried(() => bytesOf(photo));
  const picture = bytes ? await decodedPicture(new Blob([bytes], { type: 'image/jpeg' }), SIDES[0]) : 'unreadable';
  if (typeof picture === 'string') return picture;
  if (!isOld()) draw(picture, canvas, SIDES[0]);
  picture.close();
  return null;
}

function draw(picture: ImageBitmap, canvas: HTMLCanvasElement, side: number): void {
  const scale = Math.min(1, side / Math.max(picture.width, picture.height));
  canvas.width = Math.max(1, Math.round(picture.width * scale));
  canvas.height = Math.max(1, Math.round(picture.height * scale));
  const pen = canvas.getContext('2d');
  if (!pen) throw new Error('nothing can be drawn here');
  // A picture may be transparent in places; a JPEG cannot be.
  pen.fillStyle = 'white';
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.drawImage(picture, 0, 0, canvas.width, canvas.height);
}

function base64Of(bytes: Uint8Array): string {
  let text = '';
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(text);
}

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}
