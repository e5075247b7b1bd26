import type { Page } from 'playwright';
import { decodeQR } from 'qr/decode.js';

/** What another library than the page's reads from a picture of a QR code. @param png decoded by the page's browser. */
export async function textOfCode(page: Page, png: Buffer): Promise<string> {
  const { data, ...size } = await page.evaluate(
    async (bytes) => {
      const picture = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
      const { width, height } = picture;
      const pen = new OffscreenCanvas(width, height).getContext('2d') as OffscreenCanvasRenderingContext2D;
      pen.drawImage(picture, 0, 0);
      return { width, height, data: Array.from(pen.getImageData(0, 0, width, height).data) };
    },
    [...png],
  );
  return decodeQR({ ...size, data: Uint8ClampedArray.from(data) });
}
