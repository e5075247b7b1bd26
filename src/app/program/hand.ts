import { batch, computed, type ReadonlySignal, type Signal, signal } from '@preact/signals';
import type { EditedValue } from '../work/edited-value.js';

/** The field in which a value is edited. */
export interface HeldField {
  readonly input: HTMLInputElement;
  readonly label: string;
  readonly value: EditedValue;
}

/**
 * Which field is being edited, and by what. A finger has no keys, so a sheet of keys replaces the screen keyboard.
 * Keyboard and mouse need none.
 */
export class Hand {
  // Only this hand writes them.
  /** The field with the focus. */
  readonly held = signal<HeldField | null>(null);
  /** Whether a finger or a pen was used last. */
  readonly isTouch: Signal<boolean>;
  /**
   * Whether a finger has come down after keys or a mouse, and its tap has not ended. A sheet that opened now for the
   * field of the keys would lie under the finger, and take the tap that was meant for something else.
   */
  readonly #isArriving = signal(false);

  /** The field of the sheet; null while there is no sheet. */
  readonly field: ReadonlySignal<HeldField | null> = computed(() =>
    this.isTouch.value && !this.#isArriving.value ? this.held.value : null,
  );

  /** @param isTouch what is likely before the pilot has done anything. */
  constructor(isTouch: boolean) {
    this.isTouch = signal(isTouch);
  }

  /** Follows what the pilot works with. @returns a function that ends this. */
  follow({ documentElement }: Document): () => void {
    const point = ({ pointerType }: PointerEvent): void => {
      const isTouch = pointerType !== 'mouse';
      batch(() => {
        if (isTouch && !this.isTouch.value) this.#isArriving.value = this.held.value !== null;
        this.isTouch.value = isTouch;
      });
    };
    const press = (): void => {
      this.isTouch.value = false;
    };
    const arrive = (): void => {
      this.#isArriving.value = false;
    };
    const end = new AbortController();
    const options = { capture: true, signal: end.signal };
    documentElement.addEventListener('pointerdown', point, options);
    documentElement.addEventListener('keydown', press, options);
    // Before a click, the focus has gone where the tap leads. A scroll ends without a click, and asks for no sheet.
    documentElement.addEventListener('click', arrive, options);
    return () => end.abort();
  }

  /** A field has got the focus. */
  hold(field: HeldField): void {
    batch(() => {
      this.held.value = field;
      this.#isArriving.value = false;
    });
  }

  /** A field has lost the focus. */
  release(input: HTMLInputElement): void {
    if (this.held.value?.input === input) this.held.value = null;
  }
}
