import { LIMITS } from '../../program/index.js';

/** The longer side of a picture that is kept, in pixels; smaller ones where that takes too much room. */
const SIDES = [1280, 1024, 800, 640, 480];
const QUALITIES = [0.82, 0.7, 0.55];
/** Nobody has a picture of this size; a browser would choke on it. Bytes. */
const LARGEST_FILE = 50_000_000;

/**
 * A picture as it is kept: scaled down, as base64 of a JPEG file within the limit of a model.
 * @throws when it is no picture that the browser can read.
 */
export async function scaledPhoto(file: Blob): Promise<string> {
  if (file.size > LARGEST_FILE) throw new Error('the file is too large for a picture');
  const picture = await createImageBitmap(file);
  try {
    for (const side of SIDES) {
      const canvas = document.createElement('canvas');
      draw(picture, canvas, side);
      for (const quality of QUALITIES) {
        const jpeg = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/jpeg', quality));
        const text = jpeg && base64Of(new Uint8Array(await jpeg.arrayBuffer()));
        if (text && text.length <= LIMITS.photo) return text;
      }
    }
  } finally {
    picture.close();
  }
  throw new Error('the picture does not become small enough');
}

/**
 * Draws a picture that was kept.
 * @param isOld asked when it was read, which takes its time: whether another one has taken its place.
 * @throws when it is none.
 */
export async function drawPhoto(photo: string, canvas: HTMLCanvasElement, isOld: () => boolean): Promise<void> {
  const picture = await createImageBitmap(new Blob([bytesOf(photo)], { type: 'image/jpeg' }));
  if (!isOld()) draw(picture, canvas, SIDES[0] as number);
  picture.close();
}

function draw(picture: ImageBitmap, canvas: HTMLCanvasElement, side: number): void {
  const scale = Math.min(1, side / Math.max(picture.width, picture.height));
  canvas.width = Math.max(1, Math.round(picture.width * scale));
  canvas.height = Math.max(1, Math.round(picture.height * scale));
  const pen = canvas.getContext('2d');
  if (!pen) throw new Error('nothing can be drawn here');
  // A picture may be clear in places; a JPEG is not.
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
