import type { Progress } from '../../client/index.js';
import { messages } from '../messages/index.js';

interface ProgressLineProps {
  readonly label: string;
  /** Null while it is not known how much there is to do. */
  readonly progress: Progress | null;
  readonly onStop?: () => void;
}

/** A job under way: what it is, how far it has come, and how to stop it. */
export function ProgressLine({ label, progress, onStop }: ProgressLineProps) {
  const share = progress && progress.total > 0 ? { value: progress.done, max: progress.total } : {};
  return (
    <div class="progress-line">
      <span role="status">{label}</span>
      <progress aria-label={label} {...share} />
      {onStop && (
        <button type="button" class="quiet" onClick={onStop}>
          {messages.value.header.stop}
        </button>
      )}
    </div>
  );
}
