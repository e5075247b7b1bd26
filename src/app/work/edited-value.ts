import type { ReadonlySignal } from '@preact/signals';
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
