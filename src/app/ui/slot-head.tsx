import type { ComponentChildren } from 'preact';
import { messages } from '../messages/index.js';

interface SlotHeadProps {
  /** The heading over the names of the slots. */
  readonly slot: ComponentChildren;
  /** The headings between the name of a slot and its positions. */
  readonly headings: readonly string[];
  /** How many servos have a column. */
  readonly servos: number;
}

/** The head of a table with a row for each slot: the name of the slot, some figures, then each servo. */
export function SlotHead({ slot, headings, servos }: SlotHeadProps) {
  const { servoName } = messages.value;
  const names = Array.from({ length: servos }, (_, servo) => servoName(servo));
  return (
    <thead>
      <tr>
        <th scope="col">{slot}</th>
        {[...headings, ...names].map((heading) => (
          <th scope="col" key={heading}>
            {heading}
          </th>
        ))}
      </tr>
    </thead>
  );
}
