import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Ambiguous, Figure } from '../editing/units.js';

/** What stands in a field, and its colours. */
export interface FieldFace {
  readonly text: string;
  readonly unit: Figure['unit'] | null;
  readonly isChanged: boolean;
  /** Whether a write has just changed it and the read back has confirmed it. */
  readonly isConfirmed: boolean;
  readonly isWrong: boolean;
  /** The possible meanings of an ambiguous text; null for any other. */
  readonly either: Ambiguous['either'] | null;
  /** The old value in the timer, if it differs and is known; and the same without a unit. */
  readonly was: string | null;
  readonly old: string;
  /** Whether there is anything to put back. */
  readonly canPutBack: boolean;
  /** The notes about it, as one text. */
  readonly notes: string;
}

/** A value that is being edited: what it shows, and what can be done to it. */
export interface EditedValue {
  readonly kind: 'time' | 'steps' | 'interval';
  readonly face: ReadonlySignal<FieldFace>;
  /** The size of one step; for a time in hundredths of a second. */
  readonly stepSize: number;
  type(text: string): void;
  /** @param by how many steps up; negative: down. */
  step(by: number): void;
  putBack(): void;
  answer(value: number): void;
  /** The pilot does not answer what a text means. */
  takeBack(): void;
  /** Takes back what was typed or stepped since the field was entered. */
  escape(): void;
  /**
   * The pilot has finished the text.
   * @returns false when the page must first ask what it means.
   */
  finish(): boolean;
  /** The focus has left the field and its question. */
  leave(): void;
}

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
  readonly #held = signal<HeldField | null>(null);
  readonly #isTouch = signal(false);
  /**
   * Whether a finger has come down after keys or a mouse, and its tap has not ended. A sheet that opened now for the
   * field of the keys would lie under the finger, and take the tap that was meant for something else.
   */
  readonly #isArriving = signal(false);

  /** The field with the focus. */
  readonly held: ReadonlySignal<HeldField | null> = this.#held;
  /** Whether a finger or a pen was used last. */
  readonly isTouch: ReadonlySignal<boolean> = this.#isTouch;
  /** The field of the sheet; null while there is no sheet. */
  readonly field: ReadonlySignal<HeldField | null> = computed(() =>
    this.isTouch.value && !this.#isArriving.value ? this.#held.value : null,
  );

  /** @param isTouch what is likely before the pilot has done anything. */
  constructor(isTouch: boolean) {
    this.#isTouch.value = isTouch;
  }

  /** Follows what the pilot works with. @returns a function that ends this. */
  follow({ documentElement }: Document): () => void {
    const point = ({ pointerType }: PointerEvent): void => {
      const isTouch = pointerType !== 'mouse';
      batch(() => {
        if (isTouch && !this.#isTouch.value) this.#isArriving.value = this.#held.value !== null;
        this.#isTouch.value = isTouch;
      });
    };
    const press = (): void => {
      this.#isTouch.value = false;
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
      this.#held.value = field;
      this.#isArriving.value = false;
    });
  }

  /** A field has lost the focus. */
  release(input: HTMLInputElement): void {
    if (this.#held.value?.input === input) this.#held.value = null;
  }
}
