import { messages } from '../messages/index.js';
import './memory-picks.css';

interface PicksProps {
  readonly label: string;
  readonly picks: readonly number[];
  readonly disabled: boolean;
  readonly nameOf: (memory: number) => string;
  readonly onPick: (memory: number) => void;
}

/** Chooses one of several memories, in one row. */
export function Picks({ label, picks, disabled, nameOf, onPick }: PicksProps) {
  const { memoryName } = messages.value;
  return (
    <div class="row picks">
      <span>{label}</span>
      <div class="segments">
        {picks.map((memory) => (
          <button
            type="button"
            key={memory}
            aria-label={nameOf(memory)}
            disabled={disabled}
            onClick={() => onPick(memory)}
          >
            {memoryName(memory)}
          </button>
        ))}
      </div>
    </div>
  );
}
