import type { Progress } from '../../client/index.js';
import { messages } from '../messages/index.js';
import './progress-line.css';

interface ProgressLineProps {
  readonly label: string;
  /** Null while it is not known how much there is to do. */
  readonly progress: (Pick<Progress, 'done' | 'total'> & Partial<Pick<Progress, 'repeats' | 'endsBy'>>) | null;
  readonly onStop?: () => void;
}

/** A job under way: what it is, how far it has come, and how to stop it. */
export function ProgressLine({ label, progress, onStop }: ProgressLineProps) {
  const share = progress && progress.total > 0 ? { value: progress.done, max: progress.total } : {};
  // On a good line nobody needs to know for how long a bad one is borne.
  const disturbed =
    progress?.repeats && progress.endsBy
      ? messages.value.disturbed(progress.repeats, Math.max(0, Math.ceil((progress.endsBy - Date.now()) / 1000)))
      : null;
  return (
    <div class="progress-line">
      <span role="status">{label}</span>
      <progress aria-label={label} {...share} />
      {disturbed && <span class="hint">{disturbed}</span>}
      {onStop && (
        <button type="button" class="quiet" onClick={onStop}>
          {messages.value.header.stop}
        </button>
      )}
    </div>
  );
}
