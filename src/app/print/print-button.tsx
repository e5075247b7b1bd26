import { messages } from '../messages/index.js';

interface PrintButtonProps {
  /** Of the settings. */
  readonly keys: readonly string[];
  readonly onPrint: (keys: readonly string[]) => void;
}

/** Leads to the sheets of settings. */
export function PrintButton({ keys, onPrint }: PrintButtonProps) {
  return (
    <button type="button" disabled={keys.length === 0} onClick={() => onPrint(keys)}>
      {messages.value.views.print}
    </button>
  );
}
