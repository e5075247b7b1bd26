import type { ProgramField, TimerProgram } from '../../program/index.js';
import { figureText, messages } from '../messages/index.js';
import { marksOf, motorStopOf, reachedAt } from './flight.js';
import { FLAG, type Geometry, type Marks as MarksOf } from './geometry.js';
import { Kept } from './kept.js';
import type { Layout } from './layout.js';
import { LaneNames, Lines, Overlay } from './lines.js';
import { rounded } from './scale.js';
import { servoClass } from './servo-class.js';
import { shortTime } from './ticks.js';
import './layers.css';

interface PictureProps {
  readonly geometry: Geometry;
  /** The selected servo. */
  readonly front: number;
  readonly selected: ProgramField | null;
  /** The program behind it. */
  readonly overlay: TimerProgram | null;
  /** The pilot's names for what each servo moves. */
  readonly names?: readonly string[] | undefined;
  /** The id of the clip path that keeps the lines inside the plot. */
  readonly clip: string;
}

/** The drawing of a program without its handles. Unchanged parts are not drawn again. */
export function Picture({ geometry, front, selected, overlay, names, clip }: PictureProps) {
  const { program, layout, measures, flags, ticks, stages, motorStop } = geometry;
  const { left, right } = layout.box;
  const chosen = selected && selected.kind !== 'idleThrottle' ? selected.slot : null;
  const hasStop = overlay !== null && motorStopOf(overlay) !== motorStop;
  const time = selected?.kind === 'time' ? (program.times[selected.slot] ?? null) : null;
  return (
    <>
      <clipPath id={clip}>
        <rect x={left - 2} y={0} width={right - left + 4} height={measures.height} />
      </clipPath>
      <Kept on={[layout, front]} draw={() => <Grid layout={layout} front={front} />} />
      <g clip-path={`url(#${clip})`}>
        {overlay && (
          <Kept on={[overlay, layout, hasStop]} draw={() => <Overlay {...{ program: overlay, layout, hasStop }} />} />
        )}
        <Kept on={[geometry.flags, motorStop]} draw={() => <MotorRun {...geometry} />} />
        <Kept on={[stages, layout]} draw={() => <Unknown stages={stages} layout={layout} />} />
        <Kept on={[flags, chosen]} draw={() => <Marks {...geometry} chosen={chosen} />} />
        <Lines geometry={geometry} front={front} />
      </g>
      <Kept on={[ticks, layout, time]} draw={() => <TimeAxis {...geometry} chosen={time} />} />
      <Kept on={[layout, names]} draw={() => <LaneNames layout={layout} names={names} />} />
      <Kept on={[layout]} draw={() => <Extent layout={layout} y={measures.height - 3} />} />
    </>
  );
}

/** The positions with a line across the selected lane: the ends and the middle. */
function levels(highest: number): number[] {
  return highest > 130 ? [0, 65, 130, highest] : [0, 65, highest];
}

/** A handle on the left edge does not touch the position that stands beside it, in pixels. */
const LEVEL_GAP = 12;

/** The ends of the lanes, and in the selected lane the positions at the left edge with their lines. */
function Grid({ layout, front }: { readonly layout: Layout; readonly front: number }) {
  const { left, right } = layout.box;
  const edges = layout.lanes.slice(0, -1).map(({ until }) => Math.round(until) + 0.5);
  return (
    <g class="grid">
      {edges.map((y) => (
        <path key={y} class="edge" d={`M0 ${y}H${right}`} />
      ))}
      {levels(layout.highest).map((position) => {
        const y = Math.round(layout.y(front, position)) + 0.5;
        return (
          <g key={position}>
            <path d={`M${left} ${y}H${right}`} />
            <text x={left - LEVEL_GAP} y={y} dy="0.35em">
              {position}
            </text>
          </g>
        );
      })}
    </g>
  );
}

/** A time closer to an edge is not centred, in pixels: less than the run-out, so that DT is. */
const EDGE_ROOM = 14;

/** The times below the plot: DT in bold, those of the marks, and round ones where there is room. */
function TimeAxis({ program, layout, measures, ticks, stages, chosen }: Geometry & { readonly chosen: number | null }) {
  const dt = stages.at(-1)?.from;
  const marks = new Set(marksOf(program));
  const { bottom, left, right } = layout.box;
  return (
    <g class="axis">
      {ticks.map((time, i) => {
        const x = layout.x(time);
        const at = x < left + EDGE_ROOM ? 'first' : x > right - EDGE_ROOM ? 'last' : '';
        const classes = `${marks.has(time) ? 'mark' : ''} ${time === dt ? 'dt' : ''} ${time === chosen ? 'selected' : ''}`;
        return (
          // Moved times keep their element: adding and removing elements makes the browser restyle the whole page.
          <g key={time === dt ? 'dt' : i} class={classes} transform={`translate(${rounded(x)} 0)`}>
            <path d={`M0 ${bottom}V${bottom + 5}`} />
            <text y={measures.axis} class={at}>
              {time === 0 ? messages.value.timeline.zero : shortTime(time)}
            </text>
          </g>
        );
      })}
    </g>
  );
}

/** Where times fall: between a function and the one before it, which comes later. */
function Unknown({ stages, layout }: Pick<Geometry, 'stages' | 'layout'>) {
  const { top, bottom } = layout.box;
  return (
    <g class="unknown">
      {stages.map(({ slot, from, until, passing }) => {
        if (passing !== 'back' || until === null) return null;
        const x = layout.x(until);
        return <rect key={slot} x={x} y={top} width={layout.x(from) - x} height={bottom - top} />;
      })}
    </g>
  );
}

interface MarksProps extends Pick<MarksOf, 'flags'> {
  readonly layout: Layout;
  /** The slot that is selected. */
  readonly chosen: number | null;
}

/** The vertical lines of the functions and DT, from their numbers down. */
function Marks({ flags, layout, chosen }: MarksProps) {
  const { top, bottom } = layout.box;
  return (
    <g class="marks">
      {flags.map(({ slot, isDt, at, x, radius, labelled, roomy }) => {
        const lead = labelled ? `M${rounded(x)} ${FLAG + radius}L${rounded(at)} ${top - 3}V${top}` : '';
        const classes = `${isDt ? 'dt' : ''} ${slot === chosen ? 'selected' : ''} ${roomy ? '' : 'many'}`;
        return <path key={slot} class={classes} d={`${lead}M${rounded(at)} ${top}V${bottom}`} />;
      })}
    </g>
  );
}

/** The width of the words for the motor stop beside it, and of its figure alone, in pixels. */
const MOTOR_NAME = 150;
const MOTOR_FIGURE = 66;
/** The thickness of the bar that shows how long the motor runs, in pixels. */
const MOTOR_BAR = 6;

/** The motor run: a band over all lanes and a bar below them. */
function MotorRun({ program, motorStop, layout, measures }: Geometry) {
  if (motorStop === null) return null;
  const start = layout.x(0);
  const { top, bottom, left, right } = layout.box;
  const end = layout.x(motorStop);
  const width = Math.max(0, end - start);
  const { motor } = measures;
  // Before its end the words lie on the bar: rather the figure alone.
  const isBrief = end > right - MOTOR_NAME;
  const isBefore = end > right - MOTOR_FIGURE;
  const isNamed = layout.shows(end) && (!isBefore || end > left + MOTOR_NAME);
  return (
    <g class="motor">
      <rect class="run" x={start} y={top} width={width} height={bottom - top} />
      <rect class="bar" x={start} y={motor - MOTOR_BAR / 2} width={width} height={MOTOR_BAR} rx={MOTOR_BAR / 2} />
      <path d={`M${rounded(end)} ${top}V${motor}`} />
      {isNamed && (
        <text class={isBefore ? 'before' : ''} x={isBefore ? end - 12 : end + 12} y={motor} dy="0.35em">
          {(!isBrief || isBefore) && `${messages.value.program.motorStop} `}
          {figureText(program.identity, { kind: 'time', slot: 0 }, motorStop)}
        </text>
      )}
    </g>
  );
}

/** Which part of the whole is in view, when it is not everything. */
function Extent({ layout, y }: { readonly layout: Layout; readonly y: number }) {
  const { start, span } = layout.view;
  if (span >= 1) return null;
  const { left, right } = layout.box;
  const from = left + start * layout.width;
  return (
    <g class="extent">
      <path d={`M${left} ${y}H${right}`} />
      <path class="seen" d={`M${from} ${y}H${from + span * layout.width}`} />
    </g>
  );
}

/** The width of the position beside the line at one time, in pixels. */
const VALUE_ROOM = 40;

interface CrosshairProps {
  readonly geometry: Geometry;
  readonly time: number | null;
}

/** A line at one time of the flight, with a dot and the position on each servo's line. */
export function Crosshair({ geometry, time }: CrosshairProps) {
  const { layout, program } = geometry;
  if (time === null || !layout.shows(layout.x(time))) return null;
  const { top, bottom, right } = layout.box;
  const x = layout.x(time);
  const { slot, certain } = reachedAt(program, time);
  const side = x > right - VALUE_ROOM ? 'before' : '';
  return (
    <g class="crosshair" transform={`translate(${x.toFixed(1)} 0)`}>
      <path d={`M0 ${top - 4}V${bottom + 4}`} />
      {program.positions.map((row, servo) => {
        const y = layout.y(servo, row[slot] ?? 0);
        const { from, until } = layout.lanes[servo] ?? { from: top, until: bottom };
        return (
          <g key={servo} class={servoClass(servo)}>
            <circle cy={y} r={4} />
            <text class={side} x={side ? -9 : 9} y={Math.min(until - 8, Math.max(from + 8, y - 10))} dy="0.35em">
              {certain ? row[slot] : messages.value.timeline.unknownValue}
            </text>
          </g>
        );
      })}
    </g>
  );
}
