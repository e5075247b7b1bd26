import type { ComponentChildren } from 'preact';
import { moreMessages } from '../../messages/more.js';
import { servoColour } from '../servo-colour.js';
import type { Surface, Turn, turnsAt } from './surfaces.js';
import './model-sketch.css';

export interface ModelSketchProps {
  readonly turned: ReturnType<typeof turnsAt>;
  /** Whether the model has a propeller: every class but E. */
  readonly propeller: boolean;
  /** Null when it is not known: the motor of an F1B is rubber. */
  readonly motorRuns: boolean | null;
  /** Whether the propeller turns and surfaces move gently: while the flight is played. */
  readonly turning: boolean;
  /** Whether the model comes down: DT was reached, and something moved. */
  readonly comesDown: boolean;
}

/**
 * A free-flight model from the side, and below it the fuselage from above, as in a workshop drawing. Surfaces have the
 * colours of their servos' lanes.
 */
export function ModelSketch(props: ModelSketchProps) {
  return (
    <svg
      class={`sketch ${props.turning ? 'plays' : ''}`}
      viewBox="28 30 276 102"
      role="img"
      aria-label={moreMessages.value.preview.sketch}
    >
      <g class={props.comesDown ? 'down' : ''}>
        <FromTheSide {...props} />
        {props.comesDown && <path class="fall" d="M72 80V97M66 91L72 97L78 91M196 80V97M190 91L196 97L202 91" />}
      </g>
      <FromAbove {...props} />
    </svg>
  );
}

function FromTheSide({ turned: { rudder, tailplane, wing }, propeller, motorRuns, turning }: ModelSketchProps) {
  return (
    <>
      <path class="body" d="M112 60L121 42H137L142 60Z" />
      <path class="body" d="M264 64C266 51 271 44 278 43H285V65Z" />
      <path class="body" d="M266 66C270 74 277 79 285 80V67Z" />
      <path
        class={rudder ? 'surface' : 'body'}
        {...servoColour(rudder?.servo ?? null)}
        d="M285 43H288C293 49 295 57 294 65C294 72 292 77 288 80H285Z"
      />
      <path class="body" d="M46 66C54 60 78 58.5 104 59L150 61L284 64.4V66.6L150 70.5L104 72.5C78 73 54 72 46 66Z" />
      <Hinged name="tailplane" turned={tailplane} x={241} y={60.5} reach={32}>
        <path d="M-5 0.3C-3 -2.8 9 -3 25 0.8C11 0.4 3 0.6 -5 0.3Z" />
      </Hinged>
      <Hinged name="wing" turned={wing} x={121} y={40} reach={44}>
        <path d="M-16 1.5C-14 -3.8 2 -5 15 -3C23 -1.8 31 0.5 38 3C24 0.2 -2 -0.6 -16 1.5Z" />
      </Hinged>
      {propeller && <Propeller motorRuns={motorRuns} turning={turning} />}
    </>
  );
}

/** Wing and tailplane are cut off: this view shows the rudder. */
function FromAbove({ turned: { rudder } }: ModelSketchProps) {
  return (
    <>
      <path class="cut" d="M112 103V129M144 103V129M236 105V127M260 105V127" />
      <path class="stub" d="M112 105H144V127H112ZM236 107H260V125H236Z" />
      <path
        class="body"
        d="M46 116C54 112.5 78 111.6 104 111.8L150 113L278 114.9V117.1L150 119L104 120.2C78 120.4 54 119.5 46 116Z"
      />
      <Hinged name="rudder" turned={rudder} x={276} y={116} reach={24}>
        <path d="M-8 -1.6C2 -2.4 14 -1.6 22 0C14 1.6 2 2.4 -8 1.6Z" />
      </Hinged>
    </>
  );
}

interface HingedProps {
  readonly name: Surface;
  readonly turned: Turn | null;
  /** The hinge. */
  readonly x: number;
  readonly y: number;
  /** How far behind the hinge the line for the straight position ends. */
  readonly reach: number;
  readonly children: ComponentChildren;
}

function Hinged({ name, turned, x, y, reach, children }: HingedProps) {
  return (
    <g transform={`translate(${x} ${y})`} {...servoColour(turned?.servo ?? null)}>
      {turned && <path class="straight" d={`M0 0H${reach}`} />}
      <g
        class={turned ? 'surface' : 'body'}
        data-surface={name}
        // A trailing edge should go up, but drawings turn clockwise.
        style={{ transform: `rotate(${-(turned?.degrees ?? 0)}deg)` }}
      >
        {children}
      </g>
    </g>
  );
}

interface PropellerProps {
  readonly motorRuns: boolean | null;
  readonly turning: boolean;
}

/** Folded along the fuselage; while the motor runs, a disc seen from its edge. Only the hub when it is not known. */
function Propeller({ motorRuns, turning }: PropellerProps) {
  return (
    <g transform="translate(42 66)" class="propeller">
      {motorRuns && (
        <>
          <ellipse class="disc" rx="5" ry="34" />
          <path class={turning ? 'blade turning' : 'blade'} d="M0 -34V34" />
        </>
      )}
      {motorRuns === false && <path class="blade" d="M2 -5C20 -12 36 -13 50 -11M2 5C20 12 36 13 50 11" />}
      <path class="spinner" d="M5 -6C-2 -5 -6 -2 -7 0C-6 2 -2 5 5 6Z" />
    </g>
  );
}
