import { type ReadonlySignal, signal } from '@preact/signals';
import { LINK_MARK } from '../../../program/index.js';
import { type Camera, type CameraFault, openCamera } from '../../browser/camera.js';
import { decodedPicture } from '../../browser/picture.js';
import { QrReader, WIDEST_LOOK } from '../../browser/qr-reader.js';

/** Why nothing was read. */
export type ScanFault = CameraFault | 'picture' | 'large' | 'nothing' | 'reader';

/** What is said of it. */
export type ScanState =
  | { readonly kind: 'idle' }
  /** The browser asks the pilot for the camera. */
  | { readonly kind: 'starting' }
  | { readonly kind: 'looking'; readonly stream: MediaStream }
  | { readonly kind: 'picture' }
  | { readonly kind: 'fault'; readonly fault: ScanFault }
  /** A QR code that holds something else. */
  | { readonly kind: 'other'; readonly text: string };

/** Between two looks at what the camera shows, in milliseconds. */
const PAUSE = 150;
/** What the camera shows is looked at once: the next picture comes soon. */
const ONE_LOOK = [800];

/** Reads a QR code, from a camera or a picture. The camera is asked for by the pilot alone, and let go of at once. */
export class Scanner {
  readonly #state = signal<ScanState>({ kind: 'idle' });
  readonly state: ReadonlySignal<ScanState> = this.#state;
  readonly #onLink: (link: string) => void;
  readonly #reader = new QrReader();
  #camera: Camera | null = null;
  /** What was begun last: whatever comes from earlier is too late. */
  #turn = 0;

  /** @param onLink a setting was found. */
  constructor(onLink: (link: string) => void) {
    this.#onLink = onLink;
  }

  /** Asks for the camera. */
  async start(): Promise<void> {
    const turn = this.#begin({ kind: 'starting' });
    const ready = this.#reader.prepare().then(
      () => true,
      () => false,
    );
    const opened = await openCamera();
    if (turn !== this.#turn) return 'stop' in opened ? opened.stop() : undefined;
    if ('fault' in opened) return this.#fail(opened.fault);
    this.#camera = opened;
    if (!(await ready) && turn === this.#turn) return this.#fail('reader');
    if (turn !== this.#turn) return;
    opened.onEnd(() => turn === this.#turn && this.#fail('taken'));
    this.#state.value = { kind: 'looking', stream: opened.stream };
  }

  /**
   * Looks at what the camera shows, again and again, until something is found or the camera is stopped.
   * @returns a function that ends it.
   */
  watch(video: HTMLVideoElement): () => void {
    let waiting: ReturnType<typeof setTimeout> | undefined;
    let isOver = false;
    const look = async (): Promise<void> => {
      const text = await this.#reader.find(video, ONE_LOOK).catch(() => null);
      if (isOver) return;
      if (text === null || !this.#take(text, { goesOn: true })) waiting = setTimeout(() => void look(), PAUSE);
    };
    waiting = setTimeout(() => void look(), PAUSE);
    return () => {
      isOver = true;
      clearTimeout(waiting);
    };
  }

  /** Looks at a picture that the pilot has chosen. */
  async readPicture(file: Blob): Promise<void> {
    const turn = this.#begin({ kind: 'picture' });
    const isLate = (): boolean => turn !== this.#turn;
    const picture = await decodedPicture(file, WIDEST_LOOK);
    if (typeof picture === 'string') {
      return isLate() ? undefined : this.#fail(picture === 'too-large' ? 'large' : 'picture');
    }
    const isReady = await this.#reader.prepare().then(
      () => true,
      () => false,
    );
    const text = await this.#reader.find(picture).catch(() => null);
    picture.close();
    if (isLate()) return;
    if (text !== null) this.#take(text, { goesOn: false });
    else this.#fail(isReady ? 'nothing' : 'reader');
  }

  /** Lets go of the camera, and forgets what was said. */
  stop(): void {
    this.#begin({ kind: 'idle' });
  }

  /** @returns whether it is a setting. */
  #take(text: string, { goesOn }: { readonly goesOn: boolean }): boolean {
    if (!text.includes(LINK_MARK)) {
      // The camera may see other codes on its way.
      if (!goesOn) this.#state.value = { kind: 'other', text };
      return false;
    }
    this.stop();
    this.#onLink(text);
    return true;
  }

  #begin(state: ScanState): number {
    this.#camera?.stop();
    this.#camera = null;
    this.#state.value = state;
    this.#turn += 1;
    return this.#turn;
  }

  #fail(fault: ScanFault): void {
    this.#begin({ kind: 'fault', fault });
  }
}
