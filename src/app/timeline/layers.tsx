import type { ProgramField, TimerProgram } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { FLAG, type Geometry } from './geometry.js';
import { linesOf, spread } from './layout.js';
import { marksOf, motorStopOf, reachedAt, stagesOf } from './preview/flight.js';
import { shortTime } from './ticks.js';
import './layers.css';

interface PictureProps {
  readonly geometry: Geometry;
  readonly front: number | null;
  readonly selected: ProgramField | null;
  /** What lies behind. */
  readonly overlay: TimerProgram | null;
  /** The id for what keeps the lines inside of the plot. */
  readonly clip: string;
}

/** All that is drawn of a program but its handles. */
export function Picture({ geometry, front, selected, overlay, clip }: PictureProps) {
  const { left, right } = geometry.layout.box;
  const { height } = geometry.measures;
  return (
    <>
      <clipPath id={clip}>
        <rect x={left - 2} y={0} width={right - left + 4} height={height} />
      </clipPath>
      <Grid {...geometry} />
      <g clip-path={`url(#${clip})`}>
        <MotorRun {...geometry} />
        <Unknown {...geometry} />
        {overlay && <Overlay program={overlay} layout={geometry.layout} />}
        <Marks {...geometry} selected={selected} />
        <Lines {...geometry} front={front} />
      </g>
      <TimeAxis {...geometry} selected={selected} />
      <LineNames {...geometry} front={front} />
      <Extent {...geometry} />
    </>
  );
}

const COLOURS = 6;
const DASHES = 5;

/** Lines of servos differ by colour and by dash, whichever of the two can be seen. */
export function servoClass(servo: number): string {
  return `colour-${servo % COLOURS} dash-${servo % DASHES}`;
}

/** Positions that have a line of their own across the plot: the ends and the middle. */
function levels(highest: number): number[] {
  return highest > 130 ? [0, 65, 130, highest] : [0, 65, highest];
}

/** The positions at the left edge and their lines across the plot. */
function Grid({ layout, measures }: Geometry) {
  const { left, right } = layout.box;
  return (
    <g class="grid">
      {levels(layout.highest).map((position) => {
        const y = Math.round(layout.y(position)) + 0.5;
        return (
          <g key={position}>
            <path d={`M${left} ${y}H${right}`} />
            {measures.left >= 24 && (
              <text x={left - 7} y={y} dy="0.35em">
                {position}
              </text>
            )}
          </g>
        );
      })}
    </g>
  );
}

/** A time that stands nearer to the left edge than this does not have its middle there, in pixels. */
const FIRST_ROOM = 14;

/** The times below the plot: DT in strong letters, those of the marks, and round ones where there is room. */
function TimeAxis({ program, layout, measures, ticks, stages, selected }: Geometry & Pick<PictureProps, 'selected'>) {
  const dt = stages.at(-1)?.from;
  const marks = new Set(marksOf(program));
  const chosen = selected?.kind === 'time' ? program.times[selected.slot] : undefined;
  const { bottom, right } = layout.box;
  return (
    <g class="axis">
      {ticks.map((time) => {
        const x = layout.x(time);
        const classes = `${marks.has(time) ? 'mark' : ''} ${time === dt ? 'dt' : ''} ${time === chosen ? 'selected' : ''}`;
        return (
          <g key={time} class={classes}>
            <path d={`M${x} ${bottom}V${bottom + 5}`} />
            <text x={Math.min(x, right)} y={measures.axis} class={x < FIRST_ROOM ? 'first' : ''}>
              {time === 0 ? messages.value.timeline.zero : shortTime(time)}
            </text>
          </g>
        );
      })}
    </g>
  );
}

/** Where times fall: between a function and the one before it, which comes later. */
function Unknown({ stages, layout }: Geometry) {
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

/** The uprights of the functions and of DT, from their numbers down. */
function Marks({ flags, layout, measures, selected }: Geometry & { selected: ProgramField | null }) {
  const { top, bottom } = layout.box;
  const flagged = measures.left >= 24;
  const chosen = selected && selected.kind !== 'idleThrottle' ? selected.slot : null;
  return (
    <g class="marks">
      {flags.map(({ slot, isDt, at, x, radius, labelled, roomy }) => {
        const lead = !flagged || !labelled ? '' : `M${x} ${FLAG + radius}L${at} ${top - 4}V${top}`;
        return (
          <path
            key={slot}
            class={`${isDt ? 'dt' : ''} ${slot === chosen ? 'selected' : ''} ${roomy ? '' : 'many'}`}
            d={`${lead}M${at} ${top}V${bottom}`}
          />
        );
      })}
    </g>
  );
}

/** What the name of the motor stop needs beside it, in pixels. */
const MOTOR_NAME = 90;

/** While the motor runs. */
function MotorRun({ motorStop, layout, measures }: Geometry) {
  if (motorStop === null) return null;
  const start = layout.x(0);
  const { top, bottom } = layout.box;
  const end = layout.x(motorStop);
  const width = Math.max(0, end - start);
  const { motor, motorBar } = measures;
  return (
    <g class="motor">
      <rect class="run" x={start} y={top} width={width} height={bottom - top} />
      <rect class="bar" x={start} y={motor - motorBar / 2} width={width} height={motorBar} rx={motorBar / 2} />
      <path d={`M${end} ${top}V${motor}`} />
      {measures.left >= 24 && layout.shows(end) && end < layout.box.right - MOTOR_NAME && (
        <text x={end + 12} y={motor} dy="0.35em">
          {messages.value.program.motorStop}
        </text>
      )}
    </g>
  );
}

/** The lines of the servos, the one in front last. */
function Lines({ lines, front }: Pick<Geometry, 'lines'> & { front: number | null }) {
  const order = lines.map((_, servo) => servo).sort((a, b) => Number(a === front) - Number(b === front));
  return (
    <g class={`lines ${lines.length > 12 ? 'many' : ''}`}>
      {order.map((servo) => {
        const { held, steps, back } = lines[servo] as Geometry['lines'][number];
        return (
          <g key={servo} class={`servo-line ${servoClass(servo)} ${servo === front ? 'front' : ''}`} data-servo={servo}>
            <path class="steps" d={steps} />
            {back && <path class="back" d={back} />}
            <path class="held" d={held} />
          </g>
        );
      })}
    </g>
  );
}

/** A second program, faint behind the first: its lines, and where its DT and its motor stop are. */
function Overlay({ program, layout }: { program: TimerProgram; layout: Geometry['layout'] }) {
  const { top, bottom } = layout.box;
  const dt = stagesOf(program).at(-1)?.from ?? 0;
  const stop = motorStopOf(program);
  return (
    <g class="overlay">
      {linesOf(program, layout).map(({ held, steps, back }, servo) => (
        <path key={servo} class={`dash-${servo % DASHES}`} d={held + steps + back} />
      ))}
      <path class="mark" d={`M${layout.x(dt)} ${top}V${bottom}`} />
      {stop !== null && <path class="mark" d={`M${layout.x(stop)} ${top}V${bottom}`} />}
    </g>
  );
}

/** More lines than this are not named at their ends: there is no room for it. */
const MOST_NAMES = 10;
const NAME_HEIGHT = 14;

/** The name of each servo where its line leaves the picture. */
function LineNames({ program, heights, layout, measures, front }: Geometry & { readonly front: number | null }) {
  const { top, bottom, right } = layout.box;
  const { slot } = reachedAt(program, layout.time(right));
  const named = heights.map((row, servo) => ({ servo, y: row[slot] as number }));
  const shown = named.length > MOST_NAMES ? named.filter(({ servo }) => servo === front) : named;
  const places = spread(
    shown.map(({ y }) => y),
    measures.left >= 24 ? NAME_HEIGHT : NAME_HEIGHT - 2,
    Math.max(6, top - 4),
    bottom + 2,
  );
  return (
    <g class="line-names">
      {shown.map(({ servo }, i) => (
        <text
          key={servo}
          class={`${servoClass(servo)} ${servo === front ? 'front' : ''}`}
          x={right + 5}
          y={places[i]}
          dy="0.35em"
        >
          {messages.value.servoName(servo)}
        </text>
      ))}
    </g>
  );
}

/** Which part of the whole is in view, where it is not all. */
function Extent({ layout, measures }: Geometry) {
  const { start, span } = layout.view;
  if (span >= 1) return null;
  const { left } = layout.box;
  const y = measures.height - 3;
  const from = left + start * layout.width;
  return (
    <g class="extent">
      <path d={`M${left} ${y}H${layout.box.right}`} />
      <path class="seen" d={`M${from} ${y}H${from + span * layout.width}`} />
    </g>
  );
}

/** A line at one time of the flight, with a dot on each servo's line. */
export function Crosshair({ geometry, time }: { geometry: Geometry; time: number | null }) {
  const { layout, heights, program } = geometry;
  if (time === null || !layout.shows(layout.x(time))) return null;
  const { top, bottom } = layout.box;
  const { slot } = reachedAt(program, time);
  const dots = heights.length > MOST_NAMES ? [] : heights;
  return (
    <g class="crosshair" transform={`translate(${layout.x(time).toFixed(1)} 0)`}>
      <path d={`M0 ${top - 6}V${bottom + 6}`} />
      {dots.map((row, servo) => (
        <circle key={servoClass(servo)} class={servoClass(servo)} cy={row[slot]} r="3.5" />
      ))}
    </g>
  );
}
