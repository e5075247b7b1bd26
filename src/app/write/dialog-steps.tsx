import type { ComponentProps } from 'preact';
import { messages } from '../messages/index.js';
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

/** The browser keeps no copy of what a memory holds. Nothing is written into it before the pilot has answered. */
export function UnkeptStep({ onAnswer }: { readonly onAnswer: (goOn: boolean) => void }) {
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
      {again && (
        <button type="button" class="primary" disabled={again.disabled} onClick={again.onClick}>
          {again.label}
        </button>
      )}
      <button type="button" class={again ? '' : 'primary'} onClick={onClose}>
        {messages.value.write.close}
      </button>
    </div>
  );
}
