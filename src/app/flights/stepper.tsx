import { useId } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import type { FlightForm } from './flight-form.js';
import { type Measure, RANGES } from './measures.js';
import './stepper.css';

interface StepperProps {
  readonly form: FlightForm;
  readonly measure: Measure;
  readonly label: string;
  readonly unit: string;
  /** The id of its field. */
  readonly field?: string;
}

/** A number for cold hands: a field between a large button down and one up, and why a typed text is none. */
export function Stepper({ form, measure, label, unit, field }: StepperProps) {
  const { less, moreOf } = messages.value;
  const { form: words } = moreMessages.value.flights;
  const [own, note] = [useId(), useId()];
  const id = field ?? own;
  const problem = form.problems.value.get(measure);
  const { min, max } = RANGES[measure];
  return (
    <div class="stepper">
      <label for={id}>
        {label} <small>{unit}</small>
      </label>
      <span class="stepper-line">
        <button type="button" aria-label={less({ what: label })} onClick={() => form.step(measure, -1)}>
          {'−'}
        </button>
        <input
          type="text"
          // A number pad without minus sign and colon would be useless here.
          inputMode={measure === 'wind' ? 'decimal' : 'text'}
          autocomplete="off"
          id={id}
          aria-describedby={problem && note}
          aria-invalid={problem !== undefined}
          value={form.textOf(measure)}
          onInput={({ currentTarget }) => form.type(measure, currentTarget.value)}
          onBlur={() => form.leave(measure)}
        />
        <button type="button" aria-label={moreOf({ what: label })} onClick={() => form.step(measure, 1)}>
          {'+'}
        </button>
      </span>
      {problem && (
        <p class="bad-text stepper-problem" id={note} role="alert">
          {problem === 'out-of-range' ? words.range({ min, max, unit }) : words.unreadable[problem]}
        </p>
      )}
    </div>
  );
}
