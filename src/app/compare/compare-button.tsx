import { comparingMessages } from '../messages/comparing.js';

/** Opens the comparison of two programs. */
export function CompareButton({ onCompare }: { readonly onCompare: () => void }) {
  return (
    <button type="button" onClick={onCompare}>
      {comparingMessages.value.compare.open}
    </button>
  );
}
