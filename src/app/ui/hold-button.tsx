import { useEffect, useMemo, useRef } from 'preact/hooks';
import { PressAndHold } from './press-and-hold.js';
import { usePress } from './use-press.js';
import './hold-button.css';

interface HoldButtonProps {
  readonly label: string;
  /** The text while it is held. */
  readonly holding: string;
  readonly disabled: boolean;
  readonly onHeld: () => void;
  /** The id of the warning about it. */
  readonly describedBy: string;
}

/**
 * A button that has to be held, with the pointer, Space or Enter. A bar fills in the meantime;
 * releasing the button stops it.
 */
export function HoldButton({ label, holding, disabled, onHeld, describedBy }: HoldButtonProps) {
  const latest = useRef(onHeld);
  latest.current = onHeld;
  const hold = useMemo(() => new PressAndHold(() => latest.current()), []);
  const release = hold.release.bind(hold);
  useEffect(() => {
    if (disabled) release();
  }, [disabled]);
  const isHolding = hold.holding.value;
  return (
    <button
      type="button"
      class={`hold ${isHolding ? 'holding' : ''}`}
      disabled={disabled}
      aria-describedby={describedBy}
      {...usePress(hold, () => hold.press())}
      onKeyDown={(event) => {
        if (event.key !== ' ' && event.key !== 'Enter') return;
        event.preventDefault();
        // A key that still repeats after the act begins no second hold.
        if (!event.repeat) hold.press();
      }}
      onKeyUp={release}
      onBlur={release}
    >
      <span class="hold-bar" aria-hidden="true" />
      <span class="hold-label">{isHolding ? holding : label}</span>
    </button>
  );
}
