import type { ComponentChildren } from 'preact';
import { fieldKey, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { formatTime } from '../editing/units.js';
import { fieldLabel, messages } from '../messages/index.js';
import { limitsOf, type OnEdit } from './drag.js';
import { timeOf } from './flight.js';
import type { Geometry } from './geometry.js';
import type { HandleKeys } from './key-control.js';
import { rounded } from './scale.js';
import { servoClass } from './servo-class.js';
import type { TimelineModel } from './view-model.js';
import './handles.css';

export interface HandlesProps {
  readonly geometry: Geometry;
  readonly model: TimelineModel;
  readonly keys: HandleKeys;
  readonly front: number;
  readonly selected: ProgramField | null;
  /** Gives the present program. */
  readonly now: () => TimerProgram;
  readonly onEdit: OnEdit;
  readonly onSelect: ((field: ProgramField) => void) | undefined;
}

/** What can be dragged: the marks, the end of the motor run and the steps of the selected servo, by their slots. */
export function Handles(props: HandlesProps) {
  const { front, geometry } = props;
  const { program, flags, stages, layout, measures, motorStop } = geometry;
  return (
    <g>
      {motorStop !== null && (
        <Handle {...props} field={{ kind: 'time', slot: 0 }} x={layout.x(motorStop)} y={measures.motor}>
          <circle class="knob" r="6" />
        </Handle>
      )}
      {stages.map(({ slot, from, passing }) => {
        const flag = flags[slot - 1];
        const roomy = flag?.roomy ?? true;
        const classes = `dot ${servoClass(front)} ${passing === 'passed' ? 'passed' : ''} ${roomy ? '' : 'small'}`;
        return (
          <g key={slot}>
            {flag && <Handle {...props} field={{ kind: 'time', slot }} x={flag.x} y={measures.flag} />}
            <Handle
              {...props}
              field={{ kind: 'position', servo: front, slot }}
              x={layout.x(from)}
              y={layout.y(front, program.positions[front]?.[slot] ?? 0)}
            >
              <circle class={classes} r={roomy ? 6 : 3} />
            </Handle>
          </g>
        );
      })}
    </g>
  );
}

/** The size that a finger needs, in pixels. */
const FINGER = 44;

interface HandleProps extends HandlesProps {
  readonly field: ProgramField;
  readonly x: number;
  readonly y: number;
  readonly children?: ComponentChildren;
}

function Handle({ geometry, model, keys, selected, now, onEdit, onSelect, field, x, y, children }: HandleProps) {
  const { program, layout } = geometry;
  const words = messages.value;
  const key = fieldKey(field);
  const place = layout.scale.place(timeOf(program, field));
  // Outside of the view it can still get the focus, which brings it into view.
  const inView = layout.shows(layout.x(timeOf(program, field)));
  const isSelected = selected !== null && fieldKey(selected) === key;
  const value = valueAt(program, field) ?? 0;
  const { min, max } = limitsOf(program, field);
  const isTime = field.kind === 'time';
  const shown = (number: number): number => (isTime ? number / 100 : number);
  return (
    <g
      transform={`translate(${rounded(x)} ${rounded(y)})`}
      class={`handle ${field.kind} ${isSelected ? 'selected' : ''} ${inView ? '' : 'away'}`}
      data-field={key}
      role="slider"
      tabindex={model.entered.value ? 0 : -1}
      aria-label={fieldLabel(program.identity, field)}
      aria-orientation={isTime ? 'horizontal' : 'vertical'}
      aria-valuemin={shown(min)}
      aria-valuemax={shown(Math.max(max, value))}
      aria-valuenow={shown(value)}
      aria-valuetext={isTime ? words.seconds(formatTime(value)) : words.timeline.steps(value)}
      onFocus={() => {
        model.setEntered(true);
        model.reveal(place);
        onSelect?.(field);
      }}
      onKeyDown={(event) => keys.down(event, now, field, onEdit)}
      onKeyUp={keys.up}
      onBlur={keys.up}
    >
      <rect class="reach" x={-FINGER / 2} y={-FINGER / 2} width={FINGER} height={FINGER} />
      <circle class="ring" r="15" />
      {children}
    </g>
  );
}
