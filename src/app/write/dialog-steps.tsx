import type { ComponentProps } from 'preact';
import type { Progress } from '../../client/index.js';
import { messages } from '../messages/index.js';
import type { JobRunner } from '../session/job-runner.js';
import { NoticeText } from '../ui/notice-text.js';
import { ProgressLine } from '../ui/progress-line.js';

interface RunningStepProps extends Pick<ComponentProps<typeof ProgressLine>, 'label' | 'progress'> {
  /** The pilot has asked to stop; the request under way comes to its end. */
  readonly stopping?: boolean;
  readonly onStop: () => void;
}

/** A job under way in a dialog, and the button that stops it. */
export function RunningStep({ label, progress, stopping = false, onStop }: RunningStepProps) {
  const { write } = messages.value;
  return (
    <>
      <ProgressLine label={stopping ? write.stopping : label} progress={progress} />
      <div class="buttons">
        {/* Not disabled: it would lose the focus. */}
        <button type="button" aria-disabled={stopping} onClick={onStop}>
          {write.stop}
        </button>
      </div>
    </>
  );
}

interface JobStepProps {
  readonly runner: JobRunner;
  /** What is done, by how far it has come. */
  readonly label: (progress: Progress | null) => string;
  readonly onStop: () => void;
}

/** The job of a dialog: how far it has come, or what it asks. */
export function JobStep({ runner, label, onStop }: JobStepProps) {
  const job = runner.job.value;
  if (job?.asking) return <UnkeptStep onAnswer={(goOn) => runner.answer(goOn)} />;
  const progress = job?.progress ?? null;
  return <RunningStep label={label(progress)} progress={progress} stopping={job?.stopping ?? false} onStop={onStop} />;
}

/** The browser keeps no copy of what a memory holds. Nothing is written into it before the pilot has answered. */
function UnkeptStep({ onAnswer }: { readonly onAnswer: (goOn: boolean) => void }) {
  const { write } = messages.value;
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
          {write.notWithout}
        </button>
      </div>
    </>
  );
}

interface ClosingButtonsProps {
  readonly onClose: () => void;
  /** What can be done about what did not succeed; null when there is nothing. */
  readonly again?: { readonly label: string; readonly disabled: boolean; readonly onClick: () => void } | null;
}

/** The end of a dialog: once more, where that helps, and Close. */
export function ClosingButtons({ onClose, again = null }: ClosingButtonsProps) {
  return (
    <div class="buttons">
      <button type="button" class={again ? 'quiet' : 'primary'} onClick={onClose}>
        {messages.value.write.close}
      </button>
      {again && (
        <button type="button" class="primary" disabled={again.disabled} onClick={again.onClick}>
          {again.label}
        </button>
      )}
    </div>
  );
}
