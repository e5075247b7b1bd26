import type { TimerProgram } from '../../program/index.js';
import { motorStopOf, stagesOf } from './flight.js';
import { lanesOf } from './lanes.js';
import { highestOf, layoutOf, WHOLE } from './layout.js';
import { Edges, Lines } from './picture.js';
import { rounded, type Scale, stretchedScale } from './scale.js';
import './small-lanes.css';

/** The picture's own measures in units. It is stretched to the room that it gets. */
const WIDTH = 520;
const LANE = 100;
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
export function SmallLanes({
  program,
  names,
  scale = stretchedScale(program.times.slice(1), SPACING),
}: SmallLanesProps) {
  const { length } = program.positions;
  const height = LANE * length;
  const box = { left: 0, right: WIDTH, top: 0, bottom: height };
  const layout = layoutOf(scale, WHOLE, box, lanesOf(length, null, 0, height), highestOf([program]));
  const stages = stagesOf(program);
  const dt = rounded(layout.x(stages.at(-1)?.from ?? 0));
  const stop = rounded(layout.x(motorStopOf(program) ?? 0));
  return (
    <div class="small-lanes">
      <svg viewBox={`0 0 ${WIDTH} ${height}`} preserveAspectRatio="none" aria-hidden="true">
        <Edges layout={layout} />
        <Lines program={program} stages={stages} layout={layout} />
        {stop > 0 && <path class="motor-bar" d={`M0 ${height - 3}H${stop}`} />}
        <path class="flag-line dt" d={`M${dt} 0V${height}`} />
      </svg>
      {names && (
        <div class="small-names" aria-hidden="true">
          {names.map((name) => (
            <span key={name}>{name}</span>
          ))}
        </div>
      )}
    </div>
  );
}
