import type { ReadonlySignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { plainSeconds } from '../editing/units.js';
import { messages, secondsText } from '../messages/index.js';
import type { EditedValue } from '../work/edited-value.js';
import { RepeatPress } from './repeat-press.js';
import { usePress } from './use-press.js';

interface StepKeyProps {
  readonly value: EditedValue;
  /** How many steps up; negative: down. */
  readonly by: number;
  /** Makes the step. @param isFirst whether it is the first one of this press. */
  readonly onStep: (isFirst: boolean) => void;
  /** Whether an earlier step is still on its way to the timer. */
  readonly isBehind: ReadonlySignal<boolean>;
  /** The name of the field, for a screen reader. Without it the focus stays in the field, which says it. */
  readonly of?: string;
}

/** A step key. It repeats while it is held, with the pointer, Space or Enter. */
export function StepKey({ value, by, onStep, isBehind, of }: StepKeyProps) {
  const repeat = useMemo(() => new RepeatPress(isBehind), [isBehind]);
  const text = `${by > 0 ? '+' : '−'}${amountOf(value, Math.abs(by))}`;
  const isHeldBy = (event: KeyboardEvent): boolean => {
    if (event.key !== ' ' && event.key !== 'Enter') return false;
    // The clicks of the browser for a held key know no pace.
    event.preventDefault();
    return !event.repeat;
  };
  return (
    <button
      type="button"
      tabIndex={of === undefined ? -1 : undefined}
      aria-label={of && messages.value.of({ button: text, name: of })}
      {...usePress(repeat, () => repeat.press(onStep))}
      onKeyDown={(event) => isHeldBy(event) && repeat.press(onStep)}
      onKeyUp={(event) => isHeldBy(event) && repeat.lift(onStep)}
      onBlur={() => repeat.release()}
      onClick={() => repeat.click(onStep)}
    >
      {text}
    </button>
  );
}

/** “10”, “0.1 s”: positions are whole steps. */
function amountOf({ kind, stepSize }: EditedValue, steps: number): string {
  const amount = stepSize * steps;
  return kind !== 'steps' ? secondsText(plainSeconds(amount)) : String(amount);
}
