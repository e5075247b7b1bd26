import type { TimerProgram } from '../../program/index.js';
import { MAX_POSITION } from '../../protocol/index.js';
import { messages } from '../messages/index.js';
import { rounded, type Scale, stretchedScale } from './scale.js';
import { servoClass } from './servo-class.js';
import './small-lanes.css';

/** The picture's own measures in units. It is stretched to the room that it gets. */
const WIDTH = 520;
const LANE = 100;
/** The distance between the line of a servo and the edge of its lane. */
const EDGE = 14;
/** The least distance of two functions, and the room after DT, as shares of the width. */
const SPACING = { minGap: 0.05, runOut: 0.06 };

/** One time axis for pictures that stand beside each other: what comes later in one lies further on in all. */
export function sharedScale(programs: readonly TimerProgram[]): Scale {
  return stretchedScale(
    programs.flatMap(({ times }) => times.slice(1)),
    // By their lengths alone: the times of several programs are too many to be kept apart.
    { ...SPACING, minGap: 0 },
  );
}

interface SmallLanesProps {
  readonly program: TimerProgram;
  /** The time axis. Default: its own, which fills the width. */
  readonly scale?: Scale;
  /** The names at the lanes. Without them the picture is too small for names. */
  readonly names?: readonly string[];
}

/**
 * A small picture by which a pilot recognises a program: a lane for each servo, the motor run, DT. Screen readers skip
 * it: its figures stand beside it.
 */
export function SmallLanes({ program, names, scale = ownScale(program) }: SmallLanesProps) {
  const { identity, times, positions } = program;
  const dt = times[identity.functions] ?? 0;
  const x = (time: number): number => rounded(scale.place(time) * WIDTH);
  /** In per cent of the width. */
  const share = (time: number): number => rounded(scale.place(time) * 100);
  const { program: words } = messages.value;
  // On a shared axis the seconds after a DT have no width, but the positions of DT are to be seen.
  const end = rounded((scale.place(dt) + SPACING.runOut) * WIDTH);
  const motor = identity.timerClass === 'Q' ? (times[0] ?? 0) : 0;
  const height = LANE * positions.length;
  return (
    <div class="small-lanes">
      <svg viewBox={`0 0 ${WIDTH} ${height}`} preserveAspectRatio="none" aria-hidden="true">
        {positions.map((row, servo) => {
          const y = (position: number): number =>
            rounded(LANE * (servo + 1) - EDGE - ((LANE - 2 * EDGE) * Math.min(MAX_POSITION, position)) / MAX_POSITION);
          // A function that comes before the one above it is drawn where that one ends.
          let last = 0;
          const path = row.map((position, slot) => {
            last = slot === 0 ? 0 : Math.max(last, x(times[slot] ?? 0));
            return `${slot === 0 ? 'M' : 'H'}${last}${slot === 0 ? ' ' : 'V'}${y(position)}`;
          });
          return (
            <g key={servo}>
              {servo > 0 && <path class="small-lane" d={`M0 ${servo * LANE}H${WIDTH}`} />}
              <path class={`small-line ${servoClass(servo)}`} d={`${path.join('')}H${Math.max(end, last)}`} />
            </g>
          );
        })}
        {motor > 0 && <path class="small-motor" d={`M0 ${height - 3}H${x(motor)}`} />}
        <path class="small-dt" d={`M${x(dt)} 0V${height}`} />
      </svg>
      {names && (
        <div class="small-names" aria-hidden="true">
          {names.map((name) => (
            <span key={name}>{name}</span>
          ))}
          <span class="small-of-dt" style={{ insetInlineEnd: `${100 - share(dt)}%` }}>
            {words.dt}
          </span>
          {motor > 0 && (
            <span class="small-of-motor" style={{ insetInlineStart: `min(${share(motor)}%, 100% - 4rem)` }}>
              {words.motor}
            </span>
          )}
        </div>
      )}
    </div>
  );
}

function ownScale({ times }: TimerProgram): Scale {
  return stretchedScale(times.slice(1), SPACING);
}
