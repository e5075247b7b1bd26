import { answerOf, service, tried } from './services.js';

/** A picture that the pilot chose, or the live picture of a camera. */
export type QrPicture = ImageBitmap | HTMLVideoElement;

/** The browser's own finder. Many browsers have none, or one that does not know QR codes. */
interface Detector {
  detect(source: QrPicture): Promise<readonly { readonly rawValue: string }[]>;
}

declare global {
  /** Not in every browser: https://wicg.github.io/shape-detection-api/ */
  var BarcodeDetector: {
    readonly prototype: Detector;
    new (options: { readonly formats: readonly string[] }): Detector;
  };
}

/** The longer edges at which a picture is searched, in pixels. Larger ones take longer and find no more. */
const EDGES = [1000, 1800, 500];
/** No picture is searched with more pixels in one direction. */
export const WIDEST_LOOK = Math.max(...EDGES);

/** Finds the texts of QR codes, with the browser's own finder or with a library that is fetched when needed. */
export class QrReader {
  readonly #detector: Detector | null;
  #decode: typeof import('qr/decode.js').decodeQR | null = null;
  #canvas: HTMLCanvasElement | null = null;

  constructor() {
    const Detector = service('BarcodeDetector');
    this.#detector = Detector && tried(() => new Detector({ formats: ['qr_code'] }));
  }

  /**
   * Fetches the library where the browser has no finder.
   * @throws the error of the browser when the library cannot be fetched.
   */
  async prepare(): Promise<void> {
    this.#decode ??= (await import('qr/decode.js')).decodeQR;
  }

  /**
   * Searches a picture.
   * @param edges the longer edges in pixels at which to search, one after another.
   * @returns the text; null when nothing is found.
   */
  async find(picture: QrPicture, edges: readonly number[] = EDGES): Promise<string | null> {
    const seen = await this.#detect(picture);
    if (seen !== null) return seen;
    for (const edge of edges) {
      const pixels = this.#pixelsOf(picture, edge);
      const text = pixels && tried(() => this.#decode?.(pixels));
      if (text) return text;
    }
    return null;
  }

  async #detect(picture: QrPicture): Promise<string | null> {
    const detector = this.#detector;
    if (!detector) return null;
    const found = await answerOf(() => detector.detect(picture)).catch(() => []);
    return found.find(({ rawValue }) => rawValue !== '')?.rawValue ?? null;
  }

  #pixelsOf(picture: QrPicture, edge: number): ImageData | null {
    const [width, height] =
      'videoWidth' in picture ? [picture.videoWidth, picture.videoHeight] : [picture.width, picture.height];
    if (width === 0 || height === 0) return null;
    const scale = Math.min(1, edge / Math.max(width, height));
    this.#canvas ??= document.createElement('canvas');
    const canvas = this.#canvas;
    canvas.width = Math.max(1, Math.round(width * scale));
    canvas.height = Math.max(1, Math.round(height * scale));
    const context = canvas.getContext('2d', { willReadFrequently: true });
    if (!context) return null;
    context.drawImage(picture, 0, 0, canvas.width, canvas.height);
    return context.getImageData(0, 0, canvas.width, canvas.height);
  }
}
