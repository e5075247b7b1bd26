import { messages } from '../messages/index.js';

interface PrintButtonProps {
  /** The keys of the settings to print. */
  readonly keys: readonly string[];
  readonly onPrint: (keys: readonly string[]) => void;
}

/** Opens the print view with these settings. */
export function PrintButton({ keys, onPrint }: PrintButtonProps) {
  return (
    <button type="button" data-print disabled={keys.length === 0} onClick={() => onPrint(keys)}>
      {messages.value.views.print}
    </button>
  );
}
