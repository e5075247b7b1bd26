import { useId } from 'preact/hooks';
import { figureText, messages } from '../messages/index.js';
import { servoName } from '../messages/names.js';
import { marksOf, motorStopOf, reachedAt, stagesOf } from './flight.js';
import type { Geometry } from './geometry.js';
import { type Layout, lineOf } from './layout.js';
import { rounded } from './scale.js';
import { servoColour } from './servo-colour.js';
import { shortTime } from './ticks.js';
import './picture.css';

/** The drawing of a program over time, on the screen and on paper. What can be dragged lies over it. */
export function Picture(geometry: Geometry) {
  const { front, layout, measures } = geometry;
  const { left, right } = layout.box;
  const clip = useId();
  return (
    <>
      <clipPath id={clip}>
        <rect x={left - 2} y={0} width={right - left + 4} height={measures.height} />
      </clipPath>
      <Edges layout={layout} />
      {front !== null && <Levels layout={layout} front={front} />}
      <g clip-path={`url(#${clip})`}>
        <Behind {...geometry} />
        <MotorRun {...geometry} />
        <Unknown {...geometry} />
        <Marks {...geometry} />
        <Lines {...geometry} />
      </g>
      <TimeAxis {...geometry} />
      <LaneNames {...geometry} />
      <Numbers {...geometry} />
    </>
  );
}

/** Where one lane ends and the next begins. */
export function Edges({ layout }: { readonly layout: Layout }) {
  const edges = layout.lanes.slice(0, -1).map(({ until }) => Math.round(until) + 0.5);
  return <path class="level" d={edges.map((y) => `M0 ${y}H${layout.box.right}`).join('')} />;
}

/** A handle on the left edge does not touch the position that stands beside it, in pixels. */
const LEVEL_GAP = 12;

/** In the selected lane the positions of its ends and its middle, at the left edge with their lines. */
function Levels({ layout, front }: { readonly layout: Layout; readonly front: number }) {
  const { left, right } = layout.box;
  return (
    <g>
      {[...new Set([0, 65, 130, layout.highest])].map((position) => {
        const y = Math.round(layout.y(front, position)) + 0.5;
        return (
          <g key={position}>
            <path class="level" d={`M${left} ${y}H${right}`} />
            <text class="level" x={left - LEVEL_GAP} y={y} dy="0.35em">
              {position}
            </text>
          </g>
        );
      })}
    </g>
  );
}

type LinesProps = Pick<Geometry, 'program' | 'stages' | 'layout'> & Partial<Pick<Geometry, 'front' | 'first'>>;

/** The lines of the servos, each in its lane. */
export function Lines({ program, stages, layout, front = null, first = 0 }: LinesProps) {
  return (
    <>
      {program.positions.flatMap((_, lane) => {
        const { line, back } = lineOf(program, stages, lane, layout);
        const colour = servoColour(first + lane);
        return [
          <path key={lane} {...colour} class={`servo-line ${lane === front ? 'front' : ''}`} d={line} />,
          back !== '' && <path key={`${lane} back`} {...colour} class="servo-line back" d={back} />,
        ];
      })}
    </>
  );
}

/** A second program behind the first, thin and dashed: its lines, its DT and its motor stop. */
function Behind({ behind, layout, motorStop }: Geometry) {
  if (!behind) return null;
  const stages = stagesOf(behind);
  const stop = motorStopOf(behind);
  // Dashes would show through the thin line of an equal motor stop, as if it differed.
  const marks = [stages.at(-1)?.from ?? 0, ...(stop === null || stop === motorStop ? [] : [stop])];
  return (
    <g class="overlay">
      {behind.positions.map((_, servo) => {
        const { line, back } = lineOf(behind, stages, servo, layout);
        return <path key={servo} d={line + back} />;
      })}
      {marks.map((time, i) => (
        <path key={i} class="mark" d={`M${layout.x(time)} ${layout.box.top}V${layout.box.bottom}`} />
      ))}
    </g>
  );
}

/** A lower lane has no room for a word beside its line, in pixels. */
const WORD_ROOM = 40;
/** On paper a longer name is drawn narrower, so that it stays beside its lane. */
const NAME_FITS = 11;

/** The name of each servo at the left edge of its lane, and what it moves: in the lane, or on paper beside it. */
function LaneNames({ layout, front, first, names }: Geometry) {
  const { left } = layout.box;
  const isPaper = front === null;
  return (
    <g class="lane-names">
      {layout.lanes.map(({ from, until }, lane) => {
        const name = names?.[first + lane];
        const height = until - from;
        // Between the position figures at the left edge of the selected lane.
        const y = from + (lane === front ? height / 4 : height / 2);
        const narrow = name && name.length > NAME_FITS && { textLength: left - 8, lengthAdjust: 'spacingAndGlyphs' };
        return (
          <g key={from}>
            <text {...servoColour(first + lane)} x={isPaper ? 0 : 8} y={y} dy={isPaper && name ? '-0.15em' : '0.35em'}>
              {servoName(first + lane)}
            </text>
            {name && (isPaper || height >= WORD_ROOM) && (
              <text {...(isPaper ? { x: 0, y, dy: '1em', ...narrow } : { x: left + 14, y: from + 14, dy: '0.35em' })}>
                {name}
              </text>
            )}
          </g>
        );
      })}
    </g>
  );
}

/** A time closer to an edge is not centred, in pixels: less than the run-out, so that DT is. */
const EDGE_ROOM = 14;

/** The times below the plot: DT in bold, those of the marks, and round ones where there is room. */
function TimeAxis({ program, layout, measures, ticks, stages, selected }: Geometry) {
  const chosen = selected?.kind === 'time' ? program.times[selected.slot] : null;
  const dt = stages.at(-1)?.from;
  const marks = new Set(marksOf(program));
  const { left, right } = layout.box;
  const top = Math.max(layout.box.bottom, measures.axis - 20);
  const { figure, units } = messages.value.times;
  return (
    <g class="axis">
      {ticks.map((time, i) => {
        const x = layout.x(time);
        const at = x < left + EDGE_ROOM ? 'first' : x > right - EDGE_ROOM ? 'last' : '';
        const classes = `${marks.has(time) ? 'mark' : ''} ${time === dt ? 'dt' : ''} ${time === chosen ? 'selected' : ''}`;
        return (
          // Moved times keep their element: adding and removing elements makes the browser restyle the whole page.
          <g key={time === dt ? 'dt' : i} class={classes} transform={`translate(${rounded(x)} 0)`}>
            <path d={`M0 ${top}v5`} />
            <text y={measures.axis} class={at}>
              {time === 0 ? figure({ text: '0', unit: units.s }) : shortTime(time)}
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

/** The vertical lines of the functions and DT, from their numbers down. */
function Marks({ flags, layout, measures, selected }: Geometry) {
  const { top, bottom } = layout.box;
  return (
    <g>
      {flags.map(({ slot, isDt, at, x, radius, labelled }) => {
        const lead = labelled ? `M${rounded(x)} ${measures.flag + radius}L${rounded(at)} ${top - 3}V${top}` : '';
        const classes = `flag-line ${isDt ? 'dt' : ''} ${slot === selected?.slot ? 'selected' : ''}`;
        return <path key={slot} class={classes} d={`${lead}M${rounded(at)} ${top}V${bottom}`} />;
      })}
    </g>
  );
}

/** In a circle with a smaller radius the number is smaller, too. In pixels. */
const LETTERS = 11;

/** The numbers of the marks, each in a circle where there is room. That of the selected slot is lit. */
function Numbers({ flags, stages, layout, measures, selected }: Geometry) {
  const { dt } = messages.value.program;
  return (
    <>
      {flags.map(({ slot, isDt, at, x, radius, labelled, roomy }) => {
        if (!layout.shows(at)) return null;
        const isChosen = slot === selected?.slot;
        const classes = `flag ${isDt ? 'dt' : ''} ${stages[slot]?.passing ?? ''} ${isChosen ? 'chosen' : ''}`;
        const wide = radius + 2;
        return (
          <g key={slot} class={classes} transform={`translate(${rounded(x)} ${measures.flag})`}>
            {isDt && <rect x={-wide} y={-radius} width={2 * wide} height={2 * radius} rx="6" />}
            {!isDt && roomy && <circle r={radius} />}
            {labelled && (
              <text y="0.35em" font-size={radius < LETTERS ? radius * 1.2 : undefined}>
                {isDt ? dt : slot}
              </text>
            )}
          </g>
        );
      })}
    </>
  );
}

/** The width of the words for the motor stop beside it, and of its figure alone, in pixels. */
const MOTOR_NAME = 150;
const MOTOR_FIGURE = 66;

/** The motor run: a band over all lanes and a bar below them. */
function MotorRun({ program, motorStop, layout, measures }: Geometry) {
  if (motorStop === null) return null;
  const start = layout.x(0);
  const { top, bottom, left, right } = layout.box;
  const end = layout.x(motorStop);
  const { motor } = measures;
  // Before its end the words lie on the bar: rather the figure alone.
  const isBrief = end > right - MOTOR_NAME;
  const isBefore = end > right - MOTOR_FIGURE;
  const isNamed = layout.shows(end) && (!isBefore || end > left + MOTOR_NAME);
  return (
    <g class="motor">
      <rect class="run" x={start} y={top} width={Math.max(0, end - start)} height={bottom - top} />
      <path class="motor-bar" d={`M${rounded(start)} ${motor}H${rounded(end)}`} />
      <path class="motor-end" d={`M${rounded(end)} ${top}V${motor}`} />
      {isNamed && (
        <text class={`figure ${isBefore ? 'before' : ''}`} x={isBefore ? end - 12 : end + 12} y={motor} dy="0.35em">
          {(!isBrief || isBefore) && `${messages.value.program.motorStop} `}
          {figureText(program.identity, { kind: 'time', slot: 0 }, motorStop)}
        </text>
      )}
    </g>
  );
}

/** The width of the position beside the line at one time, in pixels. */
const VALUE_ROOM = 40;

/**
 * A line at one time of the flight, with a dot and the position on each servo's line. Drawn at each frame of a flight,
 * so that nothing around it is.
 */
export function Crosshair({ layout, program, timeNow }: Geometry & { readonly timeNow: () => number | null }) {
  const time = timeNow();
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
          <g key={servo} {...servoColour(servo)}>
            <circle cy={y} r={4} />
            <text
              class={`figure ${side}`}
              x={side ? -9 : 9}
              y={Math.min(until - 8, Math.max(from + 8, y - 10))}
              dy="0.35em"
            >
              {certain ? row[slot] : '?'}
            </text>
          </g>
        );
      })}
    </g>
  );
}
