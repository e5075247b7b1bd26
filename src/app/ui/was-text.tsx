import type { ReadonlySignal } from '@preact/signals';
import { messages } from '../messages/index.js';
import type { Standing } from '../timer/standing.js';
import './was-text.css';

interface WasTextProps {
  readonly standing: ReadonlySignal<Standing>;
  readonly value: string;
}

/** The old value of a changed field: what the timer holds, or what was last read. */
export function WasText({ standing, value }: WasTextProps) {
  const { marks, notCertain } = messages.value.knowledge;
  const { sure } = standing.value;
  return (
    <>
      {marks[sure === 'now' ? 'now' : 'once']({ value })}
      {sure === 'not' && <span class="visually-hidden">{notCertain}</span>}
    </>
  );
}

interface OldValueProps extends WasTextProps {
  readonly id: string;
  /** The value without its unit, which stands in the heading. */
  readonly figure: string;
  /** What a click on it does; null when it is only shown. */
  readonly label: string | null;
  readonly onPutBack: () => void;
}

/**
 * The same in a cell, beside the new value: only the figure, struck through. A value that the timer may still hold is
 * not struck through, because it may be in force.
 */
export function OldValue({ id, standing, value, figure, label, onPutBack }: OldValueProps) {
  const { sure } = standing.value;
  const shown = sure === 'not' ? <span>{`${figure}?`}</span> : <s>{figure}</s>;
  return (
    <>
      <span class="visually-hidden" id={id}>
        <WasText standing={standing} value={value} />
      </span>
      {label !== null ? (
        <button
          type="button"
          class="old-value"
          tabIndex={-1}
          aria-label={label}
          title={label}
          // The focus stays in the field.
          onPointerDown={(event) => event.preventDefault()}
          onMouseDown={(event) => event.preventDefault()}
          onClick={onPutBack}
        >
          {shown}
        </button>
      ) : (
        <span class="old-value" aria-hidden="true">
          {shown}
        </span>
      )}
    </>
  );
}
