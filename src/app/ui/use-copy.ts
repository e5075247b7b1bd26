import { type ReadonlySignal, useSignal } from '@preact/signals';
import { copyText } from '../browser/clipboard.js';

/** Copies a text to the clipboard. */
export interface Copying {
  /** Whether it was just copied. */
  readonly copied: ReadonlySignal<boolean>;
  /** The text that the browser did not copy, so that the pilot can copy it by hand; null for none. */
  readonly refused: ReadonlySignal<string | null>;
  copy(): Promise<void>;
  /** Clears the result. */
  forget(): void;
}

/**
 * @param text called on a click.
 * @param onRefused called when the browser does not allow copying.
 */
export function useCopy(text: () => string, onRefused?: () => void): Copying {
  const copied = useSignal(false);
  const refused = useSignal<string | null>(null);
  const forget = (): void => {
    copied.value = false;
    refused.value = null;
  };
  const copy = async (): Promise<void> => {
    const made = text();
    forget();
    try {
      await copyText(made);
      copied.value = true;
    } catch {
      refused.value = made;
      onRefused?.();
    }
  };
  return { copied, refused, copy, forget };
}
