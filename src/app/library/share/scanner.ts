import { type ReadonlySignal, signal } from '@preact/signals';
import { type Camera, type CameraFault, openCamera } from '../../browser/camera.js';
import { decodedPicture, type PictureFault } from '../../browser/picture.js';
import { QrReader, WIDEST_LOOK } from '../../browser/qr-reader.js';
import { holdsLink } from './sharing.js';

/** Why nothing was read. */
export type ScanFault = CameraFault | PictureFault | 'nothing' | 'reader';

/** The state that the page shows. */
export type ScanState =
  | { readonly kind: 'idle' }
  /** The browser asks the pilot for permission to use the camera. */
  | { readonly kind: 'starting' }
  | { readonly kind: 'looking'; readonly stream: MediaStream }
  | { readonly kind: 'picture' }
  | { readonly kind: 'fault'; readonly fault: ScanFault }
  /** A QR code with another content. */
  | { readonly kind: 'other'; readonly text: string };

/** The pause between two looks at the camera's picture, in milliseconds. */
const PAUSE = 150;
/** Each picture of the camera is searched in one size only: the next one comes soon. */
const ONE_LOOK = [800];

/** Reads a QR code from a camera or a picture. Only the pilot starts the camera. It is released as soon as possible. */
export class Scanner {
  readonly #state = signal<ScanState>({ kind: 'idle' });
  readonly state: ReadonlySignal<ScanState> = this.#state;
  readonly #onLink: (link: string) => void;
  readonly #reader = new QrReader();
  #camera: Camera | null = null;
  /** Goes up with each new action, so that the late result of an earlier one is ignored. */
  #turn = 0;

  /** @param onLink called when a setting was found. */
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
   * Searches the camera's picture again and again, until something is found or the camera stops.
   * @returns a function that ends this.
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

  /** Searches a picture that the pilot has chosen. */
  async readPicture(file: Blob): Promise<void> {
    const turn = this.#begin({ kind: 'picture' });
    const isLate = (): boolean => turn !== this.#turn;
    const picture = await decodedPicture(file, WIDEST_LOOK);
    if (typeof picture === 'string') return isLate() ? undefined : this.#fail(picture);
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

  /** Releases the camera and clears the message. */
  stop(): void {
    this.#begin({ kind: 'idle' });
  }

  /** @returns whether it is a setting. */
  #take(text: string, { goesOn }: { readonly goesOn: boolean }): boolean {
    if (!holdsLink(text)) {
      // On its way, the camera may see other codes.
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
