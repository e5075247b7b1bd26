import { TimeQuestion } from '../ui/time-question.js';
import { measureText } from './measures.js';
import { useTypedMeasure } from './typed-measure.js';

interface MaximumFieldProps {
  readonly label: string;
  /** In seconds; null for none. */
  readonly value: number | null;
  /** What counts without it. */
  readonly otherwise?: number | null;
  readonly onTake: (seconds: number | null) => void;
}

/** A maximum, typed as a result is. */
export function MaximumField({ label, value, otherwise = null, onTake }: MaximumFieldProps) {
  const { input, either, problem, leave, take, drop } = useTypedMeasure('maximum', value, onTake);
  return (
    <>
      <input
        aria-label={label}
        placeholder={measureText(otherwise)}
        onKeyDown={({ key }) => key === 'Enter' && leave()}
        {...input}
      />
      {either && (
        <TimeQuestion label={label} either={either} onAnswer={(hundredths) => take(hundredths / 100)} onEscape={drop} />
      )}
      {problem !== null && (
        <span class="time-question bad-text" role="alert">
          {problem}
        </span>
      )}
    </>
  );
}
