import type { JSX } from 'preact';
import { useMemo, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { formatTime } from '../editing/units.js';
import { fieldLabel, messages } from '../messages/index.js';
import { limitsOf, type OnEdit } from './drag.js';
import { timeOf } from './flight.js';
import { FLAG, type Flag, type Geometry } from './geometry.js';
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
  /** Absent when nothing can be changed: then there are marks, but no handles. */
  readonly onEdit: OnEdit | undefined;
  readonly onSelect: ((field: ProgramField) => void) | undefined;
}

/**
 * The marks above the plot, the end of the motor run and the steps of the selected servo, in the order of the slots.
 */
export function Handles(props: HandlesProps) {
  const { geometry, front, onEdit } = props;
  const { program, flags, stages, layout, measures, motorStop } = geometry;
  const row = onEdit ? program.positions[front] : undefined;
  const { selected } = props;
  const chosen = selected && selected.kind !== 'idleThrottle' ? selected.slot : null;
  return (
    <g>
      {motorStop !== null && (
        <Handle
          {...props}
          field={{ kind: 'time', slot: 0 }}
          x={layout.x(motorStop)}
          y={measures.motor}
          on=""
          figure={() => <circle class="knob" r="6" />}
        />
      )}
      {stages.map(({ slot, from, passing }) => {
        const flag = flags[slot - 1];
        const roomy = flag?.roomy ?? true;
        const position = row?.[slot];
        const dot = `dot ${servoClass(front)} ${passing === 'passed' ? 'passed' : ''} ${roomy ? '' : 'small'}`;
        return (
          <g key={slot}>
            {flag && (
              <Handle
                {...props}
                field={{ kind: 'time', slot }}
                x={flag.x}
                y={FLAG}
                on={`${flag.radius} ${flag.labelled} ${flag.roomy} ${flag.passedOver} ${slot === chosen}`}
                figure={() => <FlagFigure flag={flag} isChosen={slot === chosen} />}
              />
            )}
            {position !== undefined && (
              <Handle
                {...props}
                field={{ kind: 'position', servo: front, slot }}
                x={layout.x(from)}
                y={layout.y(front, position)}
                on={dot}
                figure={() => <circle class={dot} r={roomy ? 6 : 3} />}
              />
            )}
          </g>
        );
      })}
    </g>
  );
}

/** In a circle with a smaller radius the number is smaller, too. In pixels. */
const LETTERS = 11;

interface FlagFigureProps {
  readonly flag: Flag;
  /** Whether a value of this slot is selected: its time or a position. */
  readonly isChosen: boolean;
}

function FlagFigure({ flag, isChosen }: FlagFigureProps) {
  const { slot, isDt, radius, labelled, roomy, passedOver } = flag;
  const { dt } = messages.value.program;
  const classes = `flag ${isDt ? 'dt' : ''} ${passedOver ? 'passed' : ''} ${isChosen ? 'chosen' : ''}`;
  const wide = radius + 2;
  return (
    <>
      {isDt && <rect class={classes} x={-wide} y={-radius} width={2 * wide} height={2 * radius} rx="6" />}
      {!isDt && roomy && <circle class={classes} r={radius} />}
      {labelled && (
        <text class={classes} y="0.35em" font-size={radius < LETTERS ? radius * 1.2 : undefined}>
          {isDt ? dt : slot}
        </text>
      )}
    </>
  );
}

/** The size that a finger needs, in pixels. */
const FINGER = 44;

interface HandleProps extends HandlesProps {
  readonly field: ProgramField;
  readonly x: number;
  readonly y: number;
  /** Draws it, and what the drawing depends on. */
  readonly figure: () => JSX.Element;
  readonly on: string;
}

/** One handle. It is drawn again only when something of its own has changed. */
function Handle({ geometry, model, keys, selected, now, onEdit, onSelect, field, x, y, figure, on }: HandleProps) {
  const { program, layout } = geometry;
  const latest = useRef(geometry);
  latest.current = geometry;
  const key = fieldKey(field);
  const isSelected = selected !== null && fieldKey(selected) === key;
  // Outside of the view it can still get the focus, which brings it into view.
  const inView = layout.shows(layout.x(timeOf(program, field)));
  const place = `translate(${rounded(x)} ${rounded(y)})`;
  const classes = `handle ${field.kind} ${isSelected ? 'selected' : ''} ${inView ? '' : 'away'}`;
  const value = valueAt(program, field) ?? 0;
  const { min, max } = limitsOf(program, field);
  const isEntered = model.entered.value;
  const words = messages.value;
  return useMemo(() => {
    if (!onEdit) {
      return (
        <g class={classes} transform={place}>
          {figure()}
        </g>
      );
    }
    const isTime = field.kind === 'time';
    const shown = (number: number): number => (isTime ? number / 100 : number);
    return (
      <g
        transform={place}
        class={classes}
        data-field={key}
        role="slider"
        tabindex={isEntered ? 0 : -1}
        aria-label={fieldLabel(program.identity, field)}
        aria-orientation={isTime ? 'horizontal' : 'vertical'}
        aria-valuemin={shown(min)}
        aria-valuemax={shown(Math.max(max, value))}
        aria-valuenow={shown(value)}
        aria-valuetext={isTime ? words.seconds(formatTime(value)) : words.timeline.steps(value)}
        onFocus={() => {
          model.setEntered(true);
          model.reveal(latest.current.layout.scale.place(timeOf(latest.current.program, field)));
          onSelect?.(field);
        }}
        onKeyDown={(event) => keys.down(event, now, field, onEdit)}
        onKeyUp={keys.up}
        onBlur={keys.up}
      >
        <rect class="reach" x={-FINGER / 2} y={-FINGER / 2} width={FINGER} height={FINGER} />
        <circle class="ring" r="15" />
        {figure()}
      </g>
    );
  }, [key, place, classes, value, min, max, isEntered, words, on, now, onEdit, onSelect, program.identity]);
}
