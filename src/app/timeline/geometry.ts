import { type ProgramField, slotKind, type TimerProgram } from '../../program/index.js';
import { heightsOf, highestOf, Layout, type LinePaths, pathsOf, spread, type View } from './layout.js';
import { endOf, marksOf, motorStopOf, type Stage, stagesOf } from './preview/flight.js';
import { evenScale, RUN_OUT, type Scale, stretchedScale } from './scale.js';
import { ticks } from './ticks.js';

/** The measures of a picture in pixels, all but its width. */
export interface Measures {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  /** The bar that shows how long the motor runs: its middle and its thickness. */
  readonly motor: number;
  readonly motorBar: number;
  /** The base line of the times below the plot. */
  readonly axis: number;
  readonly height: number;
}

const FULL: Measures = { left: 32, right: 34, top: 47, bottom: 199, motor: 214, motorBar: 8, axis: 241, height: 250 };
/** Without a motor everything below the plot is higher up by this. */
const MOTOR_ROOM = 20;
const COMPACT: Measures = { left: 8, right: 26, top: 8, bottom: 66, motor: 72, motorBar: 4, axis: 89, height: 94 };

/** @param compact a small picture, to be looked at and not to be worked on. */
export function measuresOf(program: TimerProgram, compact: boolean): Measures {
  if (compact) return COMPACT;
  if (motorStopOf(program) !== null) return FULL;
  return { ...FULL, axis: FULL.axis - MOTOR_ROOM, height: FULL.height - MOTOR_ROOM };
}

/** The least distance of two marks on the stretched axis, and the room of the run-out, in pixels. */
const MARK_GAP = 26;
const RUN_OUT_ROOM = 14;

/** The axis for a program and what lies behind it. @param width that of the plot, in pixels. */
export function scaleOf(program: TimerProgram, overlay: TimerProgram | null, even: boolean, width: number): Scale {
  if (even) return evenScale(Math.max(endOf(program), overlay ? endOf(overlay) : 0) - RUN_OUT);
  return stretchedScale(marksOf(program), {
    minGap: MARK_GAP / width,
    runOut: RUN_OUT_ROOM / width,
    others: overlay ? marksOf(overlay) : [],
  });
}

/** A function or DT: where its time is, and where its number stands above it. */
export interface Flag {
  readonly slot: number;
  readonly isDt: boolean;
  readonly at: number;
  readonly x: number;
  readonly radius: number;
  /** False where there is no room for its number. */
  readonly labelled: boolean;
  /** Whether there is room for a figure around its number, and for a dot at each step below. */
  readonly roomy: boolean;
  readonly passedOver: boolean;
}

/** The number of a mark stands in a circle of this radius, in pixels; where it is narrow, in a smaller one. */
const RADIUS = 11;
const SMALLEST_RADIUS = 8;

function flagsOf(program: TimerProgram, stages: readonly Stage[], layout: Layout): Flag[] {
  const { left, right } = layout.box;
  const flags = stages.slice(1).map(({ slot, from, passing }) => ({
    slot,
    isDt: slotKind(program.identity, slot) === 'dt',
    at: layout.x(from),
    passedOver: passing === 'passed',
  }));
  const inView = flags.filter(({ at }) => layout.shows(at));
  const room = (right - left + 2 * RADIUS) / Math.max(1, inView.length);
  if (room >= 2 * SMALLEST_RADIUS) {
    const radius = Math.min(RADIUS, room / 2 - 0.5);
    const places = spread(
      inView.map(({ at }) => at),
      2 * radius + 3,
      left - RADIUS,
      right + RADIUS,
    );
    return flags.map((flag) => {
      const x = places[inView.indexOf(flag)] ?? flag.at;
      return { ...flag, x, radius, labelled: true, roomy: true };
    });
  }
  // Too many for each to have its number: DT has it, and whoever is far enough from the last one that has it.
  const dt = inView.find(({ isDt }) => isDt)?.at ?? Number.POSITIVE_INFINITY;
  let last = Number.NEGATIVE_INFINITY;
  return flags.map((flag) => {
    const free = Math.abs(flag.at - last) > 3 * RADIUS && Math.abs(dt - flag.at) > 3 * RADIUS;
    const labelled = flag.isDt || (free && layout.shows(flag.at));
    if (labelled && !flag.isDt) last = flag.at;
    return { ...flag, x: flag.at, radius: RADIUS, labelled, roomy: flag.isDt };
  });
}

/** Everything that is to be drawn for a program, in pixels. */
export interface Geometry {
  readonly program: TimerProgram;
  readonly layout: Layout;
  readonly measures: Measures;
  readonly stages: readonly Stage[];
  readonly lines: readonly LinePaths[];
  /** `[servo][slot]` */
  readonly heights: readonly (readonly number[])[];
  readonly flags: readonly Flag[];
  readonly ticks: readonly number[];
  readonly motorStop: number | null;
}

export interface GeometryOptions {
  readonly scale: Scale;
  readonly view: View;
  /** The width of the plot in pixels. */
  readonly plot: number;
  readonly measures: Measures;
  readonly overlay: TimerProgram | null;
  readonly selected: ProgramField | null;
  /** Whether every second has the same length. */
  readonly even: boolean;
}

/** Two times at the axis are this far apart, in pixels. */
const TICK_GAP = 42;

export function geometryOf(program: TimerProgram, options: GeometryOptions): Geometry {
  const { scale, view, plot, measures, overlay, selected, even } = options;
  const box = { left: measures.left, right: measures.left + plot, top: measures.top, bottom: measures.bottom };
  const layout = new Layout(scale, view, box, highestOf(overlay ? [program, overlay] : [program]));
  const stages = stagesOf(program);
  const heights = heightsOf(program, layout);
  const dt = stages.at(-1)?.from ?? 0;
  const chosen = selected?.kind === 'time' ? [program.times[selected.slot] ?? 0] : [];
  const room = { from: view.start, to: view.start + view.span, gap: (TICK_GAP / plot) * view.span };
  return {
    program,
    layout,
    measures,
    stages,
    heights,
    lines: heights.map((row) => pathsOf(stages, row, layout)),
    flags: flagsOf(program, stages, layout),
    ticks: ticks(scale, [dt], even ? [] : [...chosen, 0, ...marksOf(program)], room),
    motorStop: motorStopOf(program),
  };
}

/** Where a handle is. */
export interface HandlePlace {
  readonly field: ProgramField;
  readonly x: number;
  readonly y: number;
}

/** Where the handles are: those of the marks, of the end of the motor, and of the steps of the servo in front. */
export function handlePlaces(geometry: Geometry, front: number): HandlePlace[] {
  const { flags, heights, stages, layout, measures, motorStop } = geometry;
  const places = flags.map(({ slot, x }): HandlePlace => ({ field: { kind: 'time', slot }, x, y: FLAG }));
  if (motorStop !== null) {
    places.push({ field: { kind: 'time', slot: 0 }, x: layout.x(motorStop), y: measures.motor });
  }
  for (const { slot, from } of stages) {
    const y = heights[front]?.[slot];
    if (y !== undefined) places.push({ field: { kind: 'position', servo: front, slot }, x: layout.x(from), y });
  }
  return places;
}

/** How high the numbers of the marks stand. */
export const FLAG = 17;
