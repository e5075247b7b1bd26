import { comparingMessages } from '../messages/comparing.js';

/** The way to two programs side by side. */
export function CompareButton({ onCompare }: { readonly onCompare: () => void }) {
  return (
    <button type="button" onClick={onCompare}>
      {comparingMessages.value.compare.open}
    </button>
  );
}
