import type { Progress } from '../../client/index.js';
import { realClock } from '../../line/index.js';
import { messages } from '../messages/index.js';
import './progress-line.css';

/** How many seconds a job has left on a bad line; null on a good one, where nobody needs to know. */
export function disturbedFor(progress: ProgressLineProps['progress']): number | null {
  if (!progress?.repeats || !progress.endsBy) return null;
  // Not by the clock on the wall, which somebody can set, and which goes on while the computer sleeps.
  const left = progress.endsBy - realClock.now();
  return Math.max(0, Math.ceil(left / 1000));
}

interface ProgressLineProps {
  readonly label: string;
  /** Null while it is not known how much there is to do. */
  readonly progress: (Pick<Progress, 'done' | 'total'> & Partial<Pick<Progress, 'repeats' | 'endsBy'>>) | null;
  readonly onStop?: () => void;
  /** What it does on its way to a stop, in place of the label, once it was asked to stop. */
  readonly stopping?: string | null;
}

/** A job in progress: what it does, how far it is, and a button to stop it. */
export function ProgressLine({ label, progress, onStop, stopping = null }: ProgressLineProps) {
  const share = progress && progress.total > 0 ? { value: progress.done, max: progress.total } : {};
  const left = disturbedFor(progress);
  return (
    <div class="row gap-4 progress-line">
      <span role="status">{stopping ?? label}</span>
      <progress aria-label={stopping ?? label} {...share} />
      {left !== null && <span class="hint">{messages.value.disturbed({ seconds: left })}</span>}
      {onStop && (
        // Not disabled: it would lose the focus.
        <button type="button" class="quiet" aria-disabled={stopping !== null} onClick={onStop}>
          {messages.value.header.stop}
        </button>
      )}
    </div>
  );
}
