import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { on } from '../browser/lifecycle.js';
import type { Ambiguous } from '../editing/units.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { type Measure, measureText, RANGES, readMeasure } from './measures.js';

/** A number in its field. */
export interface TypedMeasure {
  readonly measure: Measure;
  readonly unit: string;
  /** What stands in the field, if that can be read; else what stood in it before. */
  readonly value: number | null;
  /** What the text may mean; null where it is clear. */
  readonly either: Ambiguous['either'] | null;
  /** Why the text is no number, as a sentence. */
  readonly problem: string | null;
  readonly leave: () => void;
  /** Takes a value in place of the text. */
  readonly take: (value: number | null) => void;
  /** Takes the text back. */
  readonly drop: () => void;
  readonly input: {
    readonly type: 'text';
    readonly autocomplete: 'off';
    readonly 'aria-invalid': boolean;
    readonly value: string;
    readonly onInput: (event: { readonly currentTarget: HTMLInputElement }) => void;
    readonly onBlur: () => void;
  };
}

/**
 * A number that a pilot types. It is taken when the field is left, or the page: half a number might change a whole day.
 * A text that is none stays in its field.
 */
export function useTypedMeasure(
  measure: Measure,
  value: number | null,
  onTake: (value: number | null) => void,
): TypedMeasure {
  const { range, unreadable, windUnit, temperatureUnit } = moreMessages.value.flights.form;
  const seconds = messages.value.times.units.s;
  const unit = { wind: windUnit, temperature: temperatureUnit, result: seconds, maximum: seconds }[measure];
  /** The typed text; null while the value is shown. */
  const typed = useSignal<string | null>(null);
  const read = typed.value === null ? { value } : readMeasure(measure, typed.value);
  const fault = 'unreadable' in read ? read.unreadable : null;
  const take = (taken: number | null): void => {
    typed.value = null;
    if (taken !== value) onTake(taken);
  };
  const leave = (): void => {
    if (typed.peek() !== null && 'value' in read) take(read.value);
  };
  useEffect(() => on('hide', leave));
  const { min, max } = RANGES[measure];
  return {
    measure,
    unit,
    value: 'value' in read ? read.value : value,
    either: 'either' in read ? read.either : null,
    problem:
      fault === null || fault === 'ambiguous'
        ? null
        : fault === 'out-of-range'
          ? range({ min, max, unit })
          : unreadable[fault],
    leave,
    take,
    drop: () => (typed.value = null),
    input: {
      type: 'text',
      autocomplete: 'off',
      'aria-invalid': fault !== null,
      value: typed.value ?? measureText(value),
      onInput: ({ currentTarget }) => (typed.value = currentTarget.value),
      onBlur: leave,
    },
  };
}
