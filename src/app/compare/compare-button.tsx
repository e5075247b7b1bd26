import { comparingMessages } from '../messages/en-compare.js';

/** Opens the comparison of two programs. */
export function CompareButton({ onCompare }: { readonly onCompare: () => void }) {
  return (
    <button type="button" onClick={onCompare}>
      {comparingMessages.compare.open}
    </button>
  );
}
