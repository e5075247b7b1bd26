import type { ComponentChildren } from 'preact';
import { useRef } from 'preact/hooks';
import type { ServoUse } from '../../program/index.js';
import { FIRST_SERVO_COLUMN } from '../editing/grid.js';
import { messages } from '../messages/index.js';
import { dutyName, servoName, servoText } from '../messages/names.js';
import { servoColour } from '../timeline/servo-colour.js';
import { ServoMenu, type ServoMenuProps } from './servo-menu.js';
import './table-head.css';

interface TableHeadProps extends Omit<ServoMenuProps, 'servo' | 'name'> {
  readonly servos: readonly number[];
  /** What they move, as the pilot says; null when he has not said it. */
  readonly uses: readonly ServoUse[] | null;
  /** Where there is room for only one of the two, shows the other one. */
  readonly onSwitch: () => void;
}

/** The headings of the columns, with units. */
export function TableHead({ servos, uses, onSwitch, ...menu }: TableHeadProps) {
  const { program, edits } = messages.value;
  const { table } = edits;
  return (
    <thead>
      <tr>
        <th scope="col" aria-label={program.slot}>
          <span class="visually-hidden">{program.slot}</span>
          <a class="cell-cover head-help" href="#help/words" title={table.explain}>
            <span class="visually-hidden">{table.explain}</span>
          </a>
        </th>
        <TimeHead class="time" onSwitch={onSwitch}>
          {program.time}
        </TimeHead>
        <TimeHead class="interval" onSwitch={onSwitch}>
          {table.interval}
        </TimeHead>
        {servos.map((servo) => (
          <th
            scope="col"
            class="servo"
            {...servoColour(servo)}
            key={servo}
            aria-label={servoText(servo, uses?.[servo])}
            data-cell={FIRST_SERVO_COLUMN + servo}
          >
            {servoName(servo)}
            {uses?.[servo] && <bdi class="servo-use">{dutyName(uses[servo])}</bdi>}
            <ServoMenu {...menu} servo={servo} name={servoText(servo, uses?.[servo])} />
          </th>
        ))}
      </tr>
    </thead>
  );
}

interface TimeHeadProps {
  readonly class: string;
  readonly onSwitch: () => void;
  readonly children: ComponentChildren;
}

function TimeHead({ class: name, onSwitch, children }: TimeHeadProps) {
  const head = useRef<HTMLTableCellElement>(null);
  return (
    <th scope="col" class={name} ref={head}>
      {children} <span class="head-unit">{messages.value.times.units.s}</span>
      <button
        type="button"
        class="cell-cover column-switch"
        aria-label={messages.value.edits.table.switch}
        onClick={() => {
          const { current } = head;
          onSwitch();
          // The column with this button goes away. The new column has its own button.
          requestAnimationFrame(() => {
            const others = current?.parentElement?.querySelectorAll<HTMLElement>('.column-switch') ?? [];
            for (const other of others) if (!current?.contains(other)) other.focus({ preventScroll: true });
          });
        }}
      />
    </th>
  );
}
