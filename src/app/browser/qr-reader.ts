import { answerOf, service, tried } from './services.js';

/** What can be looked for QR codes: a picture that was chosen, or what a camera shows. */
export type QrPicture = ImageBitmap | HTMLVideoElement;

/** What the browser itself finds: many have no such service, or one that knows no QR codes. */
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

/** The longer edge of a picture that is searched, in pixels: more takes longer and finds no more. */
const EDGES = [1000, 1800, 500];
/** No picture is looked at with more pixels in one direction. */
export const WIDEST_LOOK = Math.max(...EDGES);

/** Finds the texts of QR codes: with what the browser has for it, else with a library that is fetched when needed. */
export class QrReader {
  readonly #detector: Detector | null;
  #decode: typeof import('qr/decode.js').decodeQR | null = null;
  #canvas: HTMLCanvasElement | null = null;

  constructor() {
    const Detector = service('BarcodeDetector');
    this.#detector = Detector && tried(() => new Detector({ formats: ['qr_code'] }));
  }

  /**
   * Fetches what is missing in the browser.
   * @throws what the browser says where that cannot be had.
   */
  async prepare(): Promise<void> {
    this.#decode ??= (await import('qr/decode.js')).decodeQR;
  }

  /**
   * Looks at a picture.
   * @param edges how large it is looked at, one after another.
   * @returns the text; null where nothing is found.
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
