import { moreMessages } from '../messages/more.js';

/** Opens the comparison of two programs. */
export function CompareButton({ onCompare }: { readonly onCompare: () => void }) {
  return (
    <button type="button" onClick={onCompare}>
      {moreMessages.value.compare.open}
    </button>
  );
}
