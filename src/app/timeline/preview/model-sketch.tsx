import type { ComponentChildren } from 'preact';
import { messages } from '../../messages/index.js';
import { servoClass } from '../servo-class.js';
import type { Linkages, Surface } from './surfaces.js';
import './model-sketch.css';

/**
 * How far a surface turns on the sketch at the end of a servo's way, in degrees. Chosen to be seen; not those of any
 * model.
 */
const SWING: Readonly<Record<Surface, number>> = { rudder: 30, tailplane: 24, wing: 14 };

export interface ModelSketchProps {
  /** For each surface -1 to 1; null where nothing moves it. */
  readonly deflections: Readonly<Record<Surface, number | null>>;
  readonly linkages: Linkages;
  /** Whether the model has a propeller: all but those of class E. */
  readonly propeller: boolean;
  readonly motorRuns: boolean;
  /** Whether the propeller turns now: while it is played. */
  readonly turning: boolean;
}

/**
 * A free-flight model from the side and from above, in plain lines. The surfaces that servos move have the colours of
 * their lines.
 */
export function ModelSketch(props: ModelSketchProps) {
  return (
    <div class="sketch">
      <SideView {...props} />
      <TopView {...props} />
    </div>
  );
}

function SideView(props: ModelSketchProps) {
  const { sideView } = messages.value.preview;
  return (
    <figure>
      <svg viewBox="24 14 316 96" role="img" aria-label={sideView}>
        <path class="body" d="M112 60L121 42H137L142 60Z" />
        <path class="body" d="M304 64C306 51 311 44 318 43H325V65Z" />
        <path class="body" d="M306 66C310 74 317 79 325 80V67Z" />
        <path class="body" d="M325 43H328C333 49 335 57 334 65C334 72 332 77 328 80H325Z" />
        <path class="body" d="M46 66C54 60 78 58.5 104 59L150 61L324 64.4V66.6L150 70.5L104 72.5C78 73 54 72 46 66Z" />
        <Turned {...props} surface="tailplane" x={281} y={60.5} reach={32}>
          <path d="M-5 0.3C-3 -2.8 9 -3 25 0.8C11 0.4 3 0.6 -5 0.3Z" />
        </Turned>
        <Turned {...props} surface="wing" x={121} y={40} reach={44}>
          <path d="M-16 1.5C-14 -3.8 2 -5 15 -3C23 -1.8 31 0.5 38 3C24 0.2 -2 -0.6 -16 1.5Z" />
        </Turned>
        {props.propeller && <Propeller {...props} x={42} y={66} span={42} />}
      </svg>
      <figcaption>{sideView}</figcaption>
    </figure>
  );
}

function TopView(props: ModelSketchProps) {
  const { topView } = messages.value.preview;
  return (
    <figure>
      <svg viewBox="24 2 316 216" role="img" aria-label={topView}>
        <path
          class="body"
          d="M112 110V52L119 14C120 9 123 6 128 6H132C136 6 138 8 139 12L144 52V168L139 208C138 212 136 214 132 214H128C123 214 120 211 119 206L112 168Z"
        />
        <path class="seam" d="M112 52H144M112 168H144" />
        <path
          class="body"
          d="M276 110V82C276 77 279 74 284 74H290C295 74 297 77 297 82V138C297 143 295 146 290 146H284C279 146 276 143 276 138Z"
        />
        <path
          class="body"
          d="M46 110C54 105 78 103.5 104 104L150 106L318 108.6V111.4L150 114L104 116C78 116.5 54 115 46 110Z"
        />
        <Turned {...props} surface="rudder" x={317} y={110} reach={22}>
          <path d="M-8 -1.6C2 -2.4 14 -1.4 20 0C14 1.4 2 2.4 -8 1.6Z" />
        </Turned>
        {props.propeller && <Propeller {...props} x={42} y={110} span={42} />}
      </svg>
      <figcaption>{topView}</figcaption>
    </figure>
  );
}

interface TurnedProps extends ModelSketchProps {
  readonly surface: Surface;
  /** The hinge. */
  readonly x: number;
  readonly y: number;
  /** How far behind the hinge the middle of its way is marked. */
  readonly reach: number;
  readonly children: ComponentChildren;
}

function Turned({ deflections, linkages, surface, x, y, reach, children }: TurnedProps) {
  const turned = deflections[surface];
  const { servo } = linkages[surface];
  const moved = turned !== null && servo !== null;
  const degrees = (turned ?? 0) * SWING[surface];
  return (
    <g transform={`translate(${x} ${y})`} class={moved ? servoClass(servo) : ''}>
      {moved && <path class="middle" d={`M0 0H${reach + 12}`} />}
      <g class={moved ? 'surface' : 'body'} data-surface={surface} style={{ transform: `rotate(${degrees}deg)` }}>
        {children}
      </g>
    </g>
  );
}

interface PropellerProps extends ModelSketchProps {
  readonly x: number;
  readonly y: number;
  readonly span: number;
}

/** Folded along the fuselage; while the motor runs, a disc seen from its edge. */
function Propeller({ motorRuns, turning, x, y, span }: PropellerProps) {
  return (
    <g transform={`translate(${x} ${y})`} class="propeller">
      {motorRuns ? (
        <>
          <ellipse class="disc" rx="5" ry={span} />
          <path class={turning ? 'blade turning' : 'blade'} d={`M0 ${-span}V${span}`} />
        </>
      ) : (
        <path class="blade" d="M2 -5C20 -12 36 -13 50 -11M2 5C20 12 36 13 50 11" />
      )}
      <path class="spinner" d="M5 -6C-2 -5 -6 -2 -7 0C-6 2 -2 5 5 6Z" />
    </g>
  );
}
