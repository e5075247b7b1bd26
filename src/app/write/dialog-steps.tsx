import type { Progress } from '../../client/index.js';
import { messages } from '../messages/index.js';
import type { JobRunner } from '../timer/job-runner.js';
import { NoticeText } from '../ui/notice-text.js';
import { ProgressLine } from '../ui/progress-line.js';

interface JobStepProps {
  readonly runner: JobRunner;
  /** What the job does, by how far it is. */
  readonly label: (progress: Progress | null) => string;
  readonly onStop: () => void;
}

/** The job of a dialog: its progress, or its question. */
export function JobStep({ runner, label, onStop }: JobStepProps) {
  const job = runner.job.value;
  if (job?.asking) return <UnkeptStep onAnswer={(goOn) => runner.answer(goOn)} />;
  const { write, header } = messages.value;
  const progress = job?.progress ?? null;
  // The request in progress still comes to its end.
  const isStopping = job?.stopping ?? false;
  return (
    <>
      <ProgressLine label={label(progress)} progress={progress} stopping={isStopping ? write.stopping : null} />
      <div class="buttons">
        {/* Not disabled: it would lose the focus. */}
        <button type="button" aria-disabled={isStopping} onClick={onStop}>
          {header.stop}
        </button>
      </div>
    </>
  );
}

/** The browser cannot keep a copy of a memory. Nothing is written into it before the pilot has answered. */
function UnkeptStep({ onAnswer }: { readonly onAnswer: (goOn: boolean) => void }) {
  const { write, cancel } = messages.value;
  return (
    <>
      <div class="notice bad" role="alert">
        <NoticeText said={write.unkept} />
      </div>
      <div class="buttons">
        <button type="button" onClick={() => onAnswer(true)}>
          {write.withoutCopy}
        </button>
        <button type="button" class="primary" onClick={() => onAnswer(false)}>
          {cancel}
        </button>
      </div>
    </>
  );
}

interface ClosingButtonsProps {
  readonly onClose: () => void;
  /** The next step after a failure; null when there is none. */
  readonly again?: { readonly label: string; readonly disabled: boolean; readonly onClick: () => void } | null;
}

/** The last buttons of a dialog: try again, where that helps, and Close. */
export function ClosingButtons({ onClose, again = null }: ClosingButtonsProps) {
  return (
    <div class="buttons">
      <button type="button" class={again ? 'quiet' : 'primary'} onClick={onClose}>
        {messages.value.close}
      </button>
      {again && (
        <button type="button" class="primary" disabled={again.disabled} onClick={again.onClick}>
          {again.label}
        </button>
      )}
    </div>
  );
}
