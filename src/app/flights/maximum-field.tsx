import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { on } from '../browser/lifecycle.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { TimeQuestion } from '../ui/time-question.js';
import { useUnsaved } from '../ui/unsaved.js';
import { measureText, RANGES, readMeasure } from './measures.js';

interface MaximumFieldProps {
  readonly label: string;
  /** In seconds; null for none. */
  readonly value: number | null;
  /** What counts without it. */
  readonly otherwise?: number | null;
  readonly onTake: (seconds: number | null) => void;
}

/** A maximum, typed as a result is. It is taken when the field is left: each key might change a whole day. */
export function MaximumField({ label, value, otherwise = null, onTake }: MaximumFieldProps) {
  const { range, unreadable } = moreMessages.value.flights.form;
  /** The typed text; null while the value is shown. */
  const typed = useSignal<string | null>(null);
  const read = readMeasure('maximum', typed.value ?? '');
  const problem = 'unreadable' in read ? read.unreadable : null;
  const end = (taken: number | null): void => {
    typed.value = null;
    if (taken !== value) onTake(taken);
  };
  const leave = (): void => {
    if (typed.peek() !== null && 'value' in read) end(read.value);
  };
  useEffect(() => on('hide', leave));
  useUnsaved(typed.value !== null);
  return (
    <>
      <input
        type="text"
        autocomplete="off"
        aria-label={label}
        aria-invalid={problem !== null}
        placeholder={measureText(otherwise)}
        value={typed.value ?? measureText(value)}
        onInput={({ currentTarget }) => (typed.value = currentTarget.value)}
        onKeyDown={({ key }) => key === 'Enter' && leave()}
        onBlur={leave}
      />
      {'either' in read && (
        <TimeQuestion
          label={label}
          either={read.either}
          onAnswer={(hundredths) => end(hundredths / 100)}
          onEscape={() => (typed.value = null)}
        />
      )}
      {problem !== null && problem !== 'ambiguous' && (
        <span class="time-question bad-text" role="alert">
          {problem === 'out-of-range'
            ? range({ min: RANGES.maximum.min, max: RANGES.maximum.max, unit: messages.value.times.units.s })
            : unreadable[problem]}
        </span>
      )}
    </>
  );
}
