import { useId } from 'preact/hooks';
import type { TimerProgram } from '../../program/index.js';
import { figureText, messages, slotLabel } from '../messages/index.js';
import { marksOf, motorStopOf, type Stage, stagesOf } from '../timeline/flight.js';
import { scaleOf } from '../timeline/geometry.js';
import { lanesOf } from '../timeline/lanes.js';
import { highestOf, Layout, lineOf, spread } from '../timeline/layout.js';
import { shortTime, ticks } from '../timeline/ticks.js';
import './sheet-timeline.css';

interface SheetTimelineProps {
  readonly program: TimerProgram;
  /** The servos with a lane, and what each servo moves. */
  readonly servos: readonly number[];
  readonly names: readonly string[];
}

/** The width of A5 between its margins, in pixels. On larger paper the picture is larger. */
const WIDTH = 484;
/** The height of a lane in pixels: the one for a single lane, and the least among many. */
const LANE = { most: 49, least: 26, lessForEach: 4 };
/** Pixels: the numbers of the marks above the lanes, the motor and the times below them, the names beside them. */
const TOP = 16;
const MOTOR = 13;
const TIMES = 15;
const NAMES = { none: 26, some: 74 };
const RIGHT = 10;
/** The smallest distances between two numbers of marks, between two times, and from a position to the next step. */
const NUMBER_GAP = 12;
const TIME_GAP = 36;
const POSITION_ROOM = 17;
/** What a position needs above its line. */
const POSITION_HEIGHT = 13;
/** A longer name is drawn narrower, so that it stays beside its lane. */
const NAME_FITS = 11;

/** A program over time in black and white. Each lane has its name, so no colour is needed. */
export function SheetTimeline({ program, servos, names }: SheetTimelineProps) {
  const id = useId();
  const { timeline, servoName } = messages.value;
  const shown = { ...program, positions: servos.map((servo) => program.positions[servo] ?? []) };
  const stages = stagesOf(program);
  const stop = motorStopOf(program);
  const dt = stages.at(-1)?.from ?? 0;
  const left = servos.some((servo) => names[servo]) ? NAMES.some : NAMES.none;
  const each = Math.max(LANE.least, LANE.most - LANE.lessForEach * servos.length);
  const box = { left, right: WIDTH - RIGHT, top: TOP, bottom: TOP + each * servos.length };
  const height = box.bottom + (stop === null ? 0 : MOTOR) + TIMES;
  const scale = scaleOf(program, null, box.right - box.left);
  const layout = new Layout(
    scale,
    { start: 0, span: 1 },
    box,
    lanesOf(servos.length, null, box.top, box.bottom),
    highestOf([program]),
  );
  const words = servos.map((servo) => [servoName(servo), names[servo] ?? ''] as const);
  return (
    <svg class="sheet-timeline" viewBox={`0 0 ${WIDTH} ${height}`} role="img">
      <title>{timeline.picture}</title>
      <pattern id={id} width="4" height="4" patternUnits="userSpaceOnUse">
        <path class="hatch" d="M0 4L4 0" />
      </pattern>
      {stages.map(({ slot, from, until, passing }) => {
        if (passing !== 'back' || until === null) return null;
        const x = layout.x(until);
        return (
          <rect
            key={slot}
            fill={`url(#${id})`}
            x={x}
            y={box.top}
            width={layout.x(from) - x}
            height={box.bottom - box.top}
          />
        );
      })}
      <Marks program={program} stages={stages} layout={layout} />
      {layout.lanes.map(({ from, until }, lane) => {
        const [name = '', use = ''] = words[lane] ?? [];
        const middle = (from + until) / 2;
        const { line, back } = lineOf(shown, stages, lane, layout);
        return (
          <g key={name}>
            <path class="lane-edge" d={`M0 ${until + 1}H${box.right}`} />
            <text class="lane-name" x={0} y={middle} dy={use ? '-0.15em' : '0.35em'}>
              {name}
            </text>
            {use && (
              <text
                x={0}
                y={middle}
                dy="1em"
                {...(use.length > NAME_FITS ? { textLength: left - 8, lengthAdjust: 'spacingAndGlyphs' } : {})}
              >
                {use}
              </text>
            )}
            <path class="lane-line" d={line} />
            {back && <path class="lane-back" d={back} />}
            <Positions row={shown.positions[lane] ?? []} stages={stages} lane={lane} layout={layout} />
          </g>
        );
      })}
      {stop !== null && (
        <g>
          <rect class="motor-runs" x={box.left} y={box.bottom + 4} width={layout.x(stop) - box.left} height={6} />
          <path class="motor-end" d={`M${layout.x(stop)} ${box.top}V${box.bottom + 10}`} />
          <MotorName program={program} stop={stop} x={layout.x(stop)} y={box.bottom + 7} right={box.right} />
        </g>
      )}
      {ticks(scale, [dt], [0, ...marksOf(program)], { from: 0, to: 1, gap: TIME_GAP / layout.width }).map((time) => {
        const x = layout.x(time);
        return (
          <g key={time} class={time === dt ? 'time of-dt' : 'time'}>
            <path d={`M${x} ${height - TIMES}v3`} />
            <text x={Math.min(x, WIDTH - RIGHT)} y={height - 2}>
              {time === 0 ? timeline.zero : shortTime(time)}
            </text>
          </g>
        );
      })}
    </svg>
  );
}

interface MarksProps {
  readonly program: TimerProgram;
  readonly stages: readonly Stage[];
  readonly layout: Layout;
}

/** The vertical lines of the functions and DT, with as many numbers as fit. */
function Marks({ program, stages, layout }: MarksProps) {
  const { left, right, top, bottom } = layout.box;
  const marks = stages.slice(1);
  const places = marks.map(({ from }) => layout.x(from));
  const fits = marks.length * NUMBER_GAP <= right - left;
  const numbers = fits ? spread(places, NUMBER_GAP + 2, left, right) : places;
  return (
    <g>
      {marks.map(({ slot }, at) => {
        const x = places[at] as number;
        const isDt = slot === program.identity.functions;
        const last = isDt || at === 0 ? Number.NEGATIVE_INFINITY : (places[at - 1] as number);
        return (
          <g key={slot} class={isDt ? 'mark of-dt' : 'mark'}>
            <path d={`M${numbers[at]} ${top - 5}L${x} ${top - 1}V${bottom}`} />
            {(fits || isDt || x - last >= NUMBER_GAP) && (
              <text x={numbers[at]} y={top - 7}>
                {isDt ? slotLabel(program.identity, slot) : slot}
              </text>
            )}
          </g>
        );
      })}
    </g>
  );
}

interface PositionsProps {
  readonly row: readonly number[];
  readonly stages: readonly Stage[];
  readonly lane: number;
  readonly layout: Layout;
}

/** The positions of a servo, beside its line after each movement, where there is room. */
function Positions({ row, stages, lane, layout }: PositionsProps) {
  const { from: upper = 0 } = layout.lanes[lane] ?? {};
  return (
    <>
      {stages.map(({ slot, from, passing }) => {
        const position = row[slot] ?? 0;
        if (passing !== 'held' || (slot > 0 && position === row[slot - 1])) return null;
        const moves = stages.find((later) => later.slot > slot && row[later.slot] !== position);
        const x = layout.x(from);
        // The last one may stand in the margin.
        const until = moves ? layout.x(moves.from) : layout.box.right + RIGHT;
        if (until - x < POSITION_ROOM) return null;
        const y = layout.y(lane, position);
        const isAbove = y - upper > POSITION_HEIGHT;
        return (
          <text key={slot} class="lane-position" x={x + 3} y={y} dy={isAbove ? '-0.3em' : '1em'}>
            {position}
          </text>
        );
      })}
    </>
  );
}

/** The width of the words for the motor stop beside it, in pixels. */
const MOTOR_NAME = 110;

interface MotorNameProps {
  readonly program: TimerProgram;
  readonly stop: number;
  readonly x: number;
  readonly y: number;
  readonly right: number;
}

function MotorName({ program, stop, x, y, right }: MotorNameProps) {
  const isAfter = x + MOTOR_NAME < right;
  return (
    <text class={isAfter ? 'motor-name' : 'motor-name before'} x={isAfter ? x + 4 : x - 4} y={y} dy="0.35em">
      {`${messages.value.program.motorStop} ${figureText(program.identity, { kind: 'time', slot: 0 }, stop)}`}
    </text>
  );
}
