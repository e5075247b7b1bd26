import { useId } from 'preact/hooks';
import { flightMessages } from '../messages/en-flights.js';
import { messages } from '../messages/index.js';
import type { FlightForm } from './flight-form.js';
import { type Measure, RANGES } from './measures.js';
import './stepper.css';

interface StepperProps {
  readonly form: FlightForm;
  readonly measure: Measure;
  readonly label: string;
  readonly unit: string;
}

/** A number for cold hands: a field between a large button down and one up. */
export function Stepper({ form, measure, label, unit }: StepperProps) {
  const { less, moreOf } = messages.value;
  const [id, note] = [useId(), useId()];
  return (
    <div class="stepper">
      <label for={id}>
        {label} <small>{unit}</small>
      </label>
      <span class="stepper-line">
        <button type="button" aria-label={less(label)} onClick={() => form.step(measure, -1)}>
          {'−'}
        </button>
        <MeasureField {...{ form, measure, id, note }} />
        <button type="button" aria-label={moreOf(label)} onClick={() => form.step(measure, 1)}>
          {'+'}
        </button>
      </span>
      <MeasureProblem {...{ form, measure, unit, note }} />
    </div>
  );
}

interface MeasureFieldProps {
  readonly form: FlightForm;
  readonly measure: Measure;
  readonly id: string;
  /** The id of the text about it. */
  readonly note: string;
}

export function MeasureField({ form, measure, id, note }: MeasureFieldProps) {
  return (
    <input
      type="text"
      // A number pad without minus sign and colon would be useless here.
      inputMode={measure === 'wind' ? 'decimal' : 'text'}
      autocomplete="off"
      id={id}
      aria-describedby={note}
      aria-invalid={form.problems.value.has(measure)}
      value={form.textOf(measure)}
      onInput={({ currentTarget }) => form.type(measure, currentTarget.value)}
      onBlur={() => form.leave(measure)}
    />
  );
}

interface MeasureProblemProps {
  readonly form: FlightForm;
  readonly measure: Measure;
  readonly unit: string;
  readonly note: string;
}

/** Why a number was refused. */
export function MeasureProblem({ form, measure, unit, note }: MeasureProblemProps) {
  const { form: words } = flightMessages;
  const problem = form.problems.value.get(measure);
  if (!problem) return null;
  const { min, max } = RANGES[measure];
  return (
    <p class="bad-text stepper-problem" id={note} role="alert">
      {problem === 'out-of-range' ? words.range(min, max, unit) : words.unreadable[problem]}
    </p>
  );
}
