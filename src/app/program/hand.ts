import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { StepOptions } from '../editing/edits.js';
import type { Ambiguous, Figure } from '../editing/units.js';
import type { Selection } from './selection.js';

/** A value while it is edited: what is seen of it, and what can be done to it without letters. */
export interface EditedValue {
  readonly text: ReadonlySignal<string>;
  readonly unit: ReadonlySignal<Figure['unit'] | null>;
  /** The value that the timer held, where it was another and is known. */
  readonly was: ReadonlySignal<string | null>;
  /** Whether there is something to put back. */
  readonly canPutBack: ReadonlySignal<boolean>;
  /** What the text may mean, where it is asked which. */
  readonly either: ReadonlySignal<Ambiguous['either'] | null>;
  /** What is to be said about it. */
  readonly notes: ReadonlySignal<string>;
  readonly kind: 'time' | 'steps';
  /** One step: hundredths of a second for a time. */
  readonly stepSize: ReadonlySignal<number>;
  step(direction: 1 | -1, options?: StepOptions): void;
  putBack(): void;
  answer(value: number): void;
  /**
   * The text is meant as it stands.
   * @returns false where it has to be asked first what it means.
   */
  finish(): boolean;
}

/** The field in which a value is edited. */
export interface HeldField {
  readonly input: HTMLInputElement;
  readonly label: string;
  readonly value: EditedValue;
  /** Of the table that the field stands in; absent elsewhere. */
  readonly selection?: Selection | undefined;
}

/**
 * Which field is being edited, and by what: a finger has no keys, so that a sheet of them stands in for the keyboard of
 * the screen; who has come by keys or by mouse needs none.
 */
export class Hand {
  readonly #held = signal<HeldField | null>(null);
  readonly #isTouch = signal(false);

  /** Whether a finger or a pen was used last. */
  readonly isTouch: ReadonlySignal<boolean> = this.#isTouch;
  /** The field that the sheet is for; null while there is no sheet. */
  readonly field: ReadonlySignal<HeldField | null> = computed(() => (this.isTouch.value ? this.#held.value : null));

  /** @param isTouch what is likely before anything was done. */
  constructor(isTouch: boolean) {
    this.#isTouch.value = isTouch;
  }

  /** Notes what the pilot works with. @returns a function that ends it. */
  follow({ documentElement }: Document): () => void {
    const point = ({ pointerType }: PointerEvent): void => {
      this.#isTouch.value = pointerType !== 'mouse';
    };
    const press = (): void => {
      this.#isTouch.value = false;
    };
    documentElement.addEventListener('pointerdown', point, { capture: true });
    documentElement.addEventListener('keydown', press, { capture: true });
    return () => {
      documentElement.removeEventListener('pointerdown', point, { capture: true });
      documentElement.removeEventListener('keydown', press, { capture: true });
    };
  }

  /** A field has got the focus. */
  hold(field: HeldField): void {
    this.#held.value = field;
  }

  /** A field has lost the focus. */
  release(input: HTMLInputElement): void {
    if (this.#held.value?.input === input) this.#held.value = null;
  }
}
