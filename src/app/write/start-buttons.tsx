import { useId } from 'preact/hooks';
import { messages } from '../messages/index.js';
import type { Safety } from '../timer/safety.js';
import { CancelButton } from '../ui/form-buttons.js';
import { SafetyCheck } from './safety-check.js';

/** What a pilot has to tick before a write: that it is another model, that the warnings are read, that it is safe. */
export type Tick = keyof typeof messages.value.write.ticks;

interface StartButtonsProps {
  /** Null where nothing is written. */
  readonly safety: Safety | null;
  readonly ready: boolean;
  /** What is still to be ticked. */
  readonly unticked: readonly Tick[];
  readonly label: string;
  readonly onCancel: () => void;
  readonly onStart: () => void;
}

/** The end of a plan: leaves it, or starts it. While it cannot start, the reason stands beside the button. */
export function StartButtons({ safety, ready, unticked, label, onCancel, onStart }: StartButtonsProps) {
  const { stillToTick, ticks } = messages.value.write;
  const why = useId();
  const isWaiting = unticked.length > 0;
  return (
    <div class="buttons">
      {safety && <SafetyCheck safety={safety} />}
      {isWaiting && (
        <p class="why" id={why}>
          {stillToTick({ ticks: unticked.map((tick) => ticks[tick]).join(', ') })}
        </p>
      )}
      <CancelButton onClick={onCancel} />
      <button
        type="button"
        class="primary"
        disabled={!ready}
        aria-describedby={isWaiting ? why : undefined}
        onClick={onStart}
      >
        {label}
      </button>
    </div>
  );
}
