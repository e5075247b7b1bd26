import type { ComponentChildren } from 'preact';
import { fieldKey, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { formatTime } from '../editing/units.js';
import { fieldLabel, messages } from '../messages/index.js';
import { limitsOf, type OnEdit } from './drag.js';
import { FLAG, type Flag, type Geometry } from './geometry.js';
import type { HandleKeys } from './key-control.js';
import { servoClass } from './layers.js';
import { timeOf } from './preview/flight.js';
import type { TimelineModel } from './view-model.js';
import './handles.css';

export interface HandlesProps {
  readonly geometry: Geometry;
  readonly model: TimelineModel;
  readonly keys: HandleKeys;
  readonly front: number;
  readonly selected: ProgramField | null;
  /** The program as it is by now. */
  readonly now: () => TimerProgram;
  /** Absent when nothing can be changed: then there are the marks, but no handles. */
  readonly onEdit: OnEdit | undefined;
  readonly onSelect: ((field: ProgramField) => void) | undefined;
}

/** The marks above the plot, the end of the motor and the steps of the servo in front, in the order of the slots. */
export function Handles(props: HandlesProps) {
  const { geometry, front, onEdit } = props;
  const { flags, stages, heights, layout, measures, motorStop } = geometry;
  const row = heights[front];
  const dots = onEdit && row ? row : [];
  return (
    <g>
      {motorStop !== null && (
        <Handle
          {...props}
          field={{ kind: 'time', slot: 0 }}
          x={layout.x(motorStop)}
          y={measures.motor}
          inView={layout.shows(layout.x(motorStop))}
        >
          <circle class="knob" r="5.5" />
        </Handle>
      )}
      {stages.map(({ slot, from, passing }) => {
        const roomy = flags[slot - 1]?.roomy ?? true;
        const inView = layout.shows(layout.x(from));
        const flag = flags[slot - 1];
        const y = dots[slot];
        return (
          <g key={slot}>
            {flag && (
              <Handle {...props} field={{ kind: 'time', slot }} x={flag.x} y={FLAG} inView={inView}>
                <FlagFigure flag={flag} />
              </Handle>
            )}
            {y !== undefined && (
              <Handle
                {...props}
                field={{ kind: 'position', servo: front, slot }}
                x={layout.x(from)}
                y={y}
                inView={inView}
              >
                <circle
                  class={`dot ${servoClass(front)} ${passing === 'passed' ? 'passed' : ''} ${roomy ? '' : 'small'}`}
                  r={roomy ? 5 : 3}
                />
              </Handle>
            )}
          </g>
        );
      })}
    </g>
  );
}

function FlagFigure({ flag: { slot, isDt, radius, labelled, roomy, passedOver } }: { flag: Flag }) {
  const { dt } = messages.value.program;
  const classes = `flag ${isDt ? 'dt' : ''} ${passedOver ? 'passed' : ''}`;
  const wide = radius + 2;
  return (
    <>
      {isDt && <rect class={classes} x={-wide} y={-radius} width={2 * wide} height={2 * radius} rx="6" />}
      {!isDt && roomy && <circle class={classes} r={radius} />}
      {labelled && (
        <text class={classes} y="0.35em" font-size={Math.min(13, radius * 1.2)}>
          {isDt ? dt : slot}
        </text>
      )}
    </>
  );
}

/** What a finger needs, in pixels. */
const FINGER = 44;

interface HandleProps extends HandlesProps {
  readonly field: ProgramField;
  readonly x: number;
  readonly y: number;
  /** Out of view it can still get the focus, which brings it into view. */
  readonly inView: boolean;
  readonly children: ComponentChildren;
}

function Handle({
  geometry,
  model,
  keys,
  selected,
  now,
  onEdit,
  onSelect,
  field,
  x,
  y,
  inView,
  children,
}: HandleProps) {
  const { program } = geometry;
  const key = fieldKey(field);
  const isSelected = selected !== null && fieldKey(selected) === key;
  const place = { transform: `translate(${Math.round(x * 10) / 10} ${Math.round(y * 10) / 10})` };
  const classes = `handle ${field.kind} ${isSelected ? 'selected' : ''} ${inView ? '' : 'away'}`;
  if (!onEdit) {
    return (
      <g class={classes} {...place}>
        {children}
      </g>
    );
  }
  const value = valueAt(program, field) ?? 0;
  const limits = limitsOf(program, field);
  const isTime = field.kind === 'time';
  const shown = (number: number): number => (isTime ? number / 100 : number);
  const { seconds } = messages.value;
  const { steps } = messages.value.timeline;
  return (
    <g
      {...place}
      class={classes}
      data-field={key}
      role="slider"
      tabindex={model.entered.value ? 0 : -1}
      aria-label={fieldLabel(program.identity, field)}
      aria-orientation={isTime ? 'horizontal' : 'vertical'}
      aria-valuemin={shown(limits.min)}
      aria-valuemax={shown(Math.max(limits.max, value))}
      aria-valuenow={shown(value)}
      aria-valuetext={isTime ? seconds(formatTime(value)) : steps(value)}
      onFocus={() => {
        model.setEntered(true);
        model.reveal(geometry.layout.scale.place(timeOf(program, field)));
        onSelect?.(field);
      }}
      onKeyDown={(event) => keys.down(event, now(), field, onEdit)}
      onKeyUp={keys.up}
      onBlur={keys.up}
    >
      <rect class="reach" x={-FINGER / 2} y={-FINGER / 2} width={FINGER} height={FINGER} />
      <circle class="ring" r="15" />
      {children}
    </g>
  );
}
