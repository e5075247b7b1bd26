import { fieldKey, valueAt } from '../../program/index.js';
import { formatTime } from '../editing/units.js';
import { fieldLabel, messages, secondsText } from '../messages/index.js';
import { limitsOf } from './drag.js';
import { timeOf } from './flight.js';
import { type Geometry, type HandlePlace, handlePlaces } from './geometry.js';
import { rounded } from './scale.js';
import { servoColour } from './servo-colour.js';
import './handles.css';

interface HandlesProps {
  readonly geometry: Geometry;
  /** Whether the Tab key goes from handle to handle. */
  readonly entered: boolean;
}

/** What can be dragged: the end of the motor run, the marks and the steps of the selected servo, by their slots. */
export function Handles({ geometry, entered }: HandlesProps) {
  return (
    <g>
      {handlePlaces(geometry).map((place) => (
        // A handle in use stays when another servo is selected.
        <Handle key={`${place.field.kind} ${place.field.slot}`} {...{ geometry, entered }} {...place} />
      ))}
    </g>
  );
}

/** The size that a finger needs, in pixels. */
const FINGER = 44;

function Handle({ geometry, entered, field, x, y }: HandlesProps & HandlePlace) {
  const { program, layout, selected } = geometry;
  const words = messages.value;
  const key = fieldKey(field);
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
      tabindex={entered ? 0 : -1}
      aria-label={fieldLabel(program.identity, field)}
      aria-orientation={isTime ? 'horizontal' : 'vertical'}
      aria-valuemin={shown(min)}
      aria-valuemax={shown(Math.max(max, value))}
      aria-valuenow={shown(value)}
      aria-valuetext={isTime ? secondsText(formatTime(value)) : words.timeline.steps({ position: value })}
    >
      <rect class="reach" x={-FINGER / 2} y={-FINGER / 2} width={FINGER} height={FINGER} />
      <circle class="ring" r="15" />
      {isTime ? field.slot === 0 && <circle class="dot" r="6" /> : <Dot {...geometry} {...field} />}
    </g>
  );
}

/** The dot at a step of the selected servo. A mark has its number in its place. */
function Dot({ flags, stages, servo, slot }: Geometry & { readonly servo: number; readonly slot: number }) {
  const roomy = flags[slot - 1]?.roomy ?? true;
  const passed = stages[slot]?.passing === 'passed';
  const classes = `dot ${passed ? 'passed' : ''} ${roomy ? '' : 'small'}`;
  return <circle class={classes} {...servoColour(servo)} r={roomy ? 6 : 3} />;
}
