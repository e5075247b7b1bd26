import { type ReadonlySignal, useSignal } from '@preact/signals';
import { copyText } from '../browser/clipboard.js';

/** A text on its way to the clipboard. */
export interface Copying {
  /** Whether it was just copied. */
  readonly copied: ReadonlySignal<boolean>;
  /** The text that the browser did not let this page copy, to be copied by hand; null when there is none. */
  readonly refused: ReadonlySignal<string | null>;
  copy(): Promise<void>;
  /** What became of it is said no more. */
  forget(): void;
}

/**
 * @param text made when it is asked for.
 * @param onRefused the browser does not let this page copy it.
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
