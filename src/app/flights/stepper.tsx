import { useId } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { TimeQuestion } from '../ui/time-question.js';
import { steppedMeasure } from './measures.js';
import type { TypedMeasure } from './typed-measure.js';
import './stepper.css';

interface StepperProps {
  readonly field: TypedMeasure;
  readonly label: string;
  /** What the first tap takes while nothing is noted. */
  readonly first: () => number;
}

/** A number for cold hands: a field between a large button down and one up, and why a typed text is none. */
export function Stepper({ field, label, first }: StepperProps) {
  const { less, moreOf } = messages.value;
  const [id, note] = [useId(), useId()];
  const { measure, unit, value, either, problem, take } = field;
  const step = (direction: 1 | -1) => () => take(value === null ? first() : steppedMeasure(measure, value, direction));
  return (
    <div class="stepper">
      <label for={id}>
        {label} <small>{unit}</small>
      </label>
      <span class="stepper-line">
        <button type="button" aria-label={less({ what: label })} onClick={step(-1)}>
          {'−'}
        </button>
        <input
          // A number pad without minus sign and colon would be useless here.
          inputMode={measure === 'wind' ? 'decimal' : 'text'}
          id={id}
          aria-describedby={problem === null ? undefined : note}
          {...field.input}
        />
        <button type="button" aria-label={moreOf({ what: label })} onClick={step(1)}>
          {'+'}
        </button>
      </span>
      {either && (
        <TimeQuestion
          label={label}
          either={either}
          onAnswer={(hundredths, byKey) => {
            take(hundredths / 100);
            if (byKey) document.getElementById(id)?.focus();
          }}
          onEscape={field.drop}
        />
      )}
      {problem !== null && (
        <p class="bad-text" id={note} role="alert">
          {problem}
        </p>
      )}
    </div>
  );
}
