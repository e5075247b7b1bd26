import { type ProgramField, slotKind, type TimerProgram } from '../../program/index.js';
import { lanesOf, leastHeight } from './lanes.js';
import { Layout, spread, type TimeView } from './layout.js';
import { flightEnd, marksOf, motorStopOf, type Stage, stagesOf } from './preview/flight.js';
import { evenScale, RUN_OUT, type Scale, stretchedScale } from './scale.js';
import { ticks } from './ticks.js';

/** The measures of a picture in pixels, all but its width. */
export interface Measures {
  readonly left: number;
  readonly right: number;
  /** The upper edge of the first lane and the lower edge of the last. */
  readonly top: number;
  readonly bottom: number;
  /** The bar that shows how long the motor runs: its middle and its thickness. */
  readonly motor: number;
  readonly motorBar: number;
  /** The base line of the times below the plot. */
  readonly axis: number;
  readonly height: number;
}

/** The marks stand above the lanes, the motor's bar and the times below them. */
const FULL = { left: 44, right: 16, top: 36, motor: 18, times: 30 };
const COMPACT = { left: 28, right: 10, top: 4, motor: 8, times: 24 };
/** A lane of a small picture, in pixels; of a few servos, and of many. */
const COMPACT_LANE = { few: 26, many: 16 };
const FEW = 4;

/** The least height of a picture that can be worked on. */
export function leastHeightOf(program: TimerProgram): number {
  return FULL.top + leastHeight(program.identity.servos) + belowOf(program, FULL);
}

/** @param height of the picture; none for a small one, to be looked at and not to be worked on. */
export function measuresOf(program: TimerProgram, height?: number): Measures {
  const { servos } = program.identity;
  const own = height === undefined ? COMPACT : FULL;
  const small = COMPACT.top + servos * COMPACT_LANE[servos > FEW ? 'many' : 'few'] + belowOf(program, COMPACT);
  const whole = height === undefined ? small : Math.max(height, leastHeightOf(program));
  const bottom = whole - belowOf(program, own);
  return {
    left: own.left,
    right: own.right,
    top: own.top,
    bottom,
    motor: bottom + own.motor / 2 + 1,
    motorBar: own === FULL ? 6 : 4,
    axis: whole - (own === FULL ? 10 : 4),
    height: whole,
  };
}

/** What the motor's bar and the times take. */
function belowOf(program: TimerProgram, { motor, times }: { readonly motor: number; readonly times: number }): number {
  return (motorStopOf(program) === null ? 0 : motor) + times;
}

/** The least distance of two marks on the stretched axis, and the room of the run-out, in pixels. */
const MARK_GAP = 28;
const RUN_OUT_ROOM = 16;

/** The axis for a program and what lies behind it. @param width that of the plot, in pixels. */
export function scaleOf(program: TimerProgram, overlay: TimerProgram | null, even: boolean, width: number): Scale {
  if (even) return evenScale(Math.max(flightEnd(program), overlay ? flightEnd(overlay) : 0) - RUN_OUT);
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
const RADIUS = 12;
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

/** What is to be drawn of the times of a program, in pixels. */
export interface Marks {
  readonly stages: readonly Stage[];
  readonly flags: readonly Flag[];
  /** The times that are written below the plot. */
  readonly ticks: readonly number[];
  readonly motorStop: number | null;
}

/** Everything that is to be drawn for a program, in pixels. */
export interface Geometry extends Marks {
  readonly program: TimerProgram;
  readonly layout: Layout;
  readonly measures: Measures;
}

export interface GeometryOptions {
  readonly scale: Scale;
  readonly view: TimeView;
  /** The width of the plot in pixels. */
  readonly plot: number;
  readonly measures: Measures;
  readonly servos: number;
  /** The servo in hand; null where all lanes are alike. */
  readonly front: number | null;
  /** The position at the upper edge of each lane. */
  readonly highest: number;
}

export function layoutOf({ scale, view, plot, measures, servos, front, highest }: GeometryOptions): Layout {
  const { left, top, bottom } = measures;
  const box = { left, right: left + plot, top, bottom };
  return new Layout(scale, view, box, lanesOf(servos, front, top, bottom), highest);
}

/** Two times at the axis are this far apart, in pixels. */
const TICK_GAP = 52;

/**
 * @param even whether every second has the same length: then round times are written, else those of the marks.
 * @param chosen a time that is written before all others but DT.
 */
export function marksIn(program: TimerProgram, layout: Layout, even: boolean, chosen: number | null): Marks {
  const { scale, view, width } = layout;
  const stages = stagesOf(program);
  const dt = stages.at(-1)?.from ?? 0;
  const wished = even ? [] : [...(chosen === null ? [] : [chosen]), 0, ...marksOf(program)];
  const room = { from: view.start, to: view.start + view.span, gap: (TICK_GAP / width) * view.span };
  return {
    stages,
    flags: flagsOf(program, stages, layout),
    ticks: ticks(scale, [dt], wished, room),
    motorStop: motorStopOf(program),
  };
}

/** Where a handle is. */
export interface HandlePlace {
  readonly field: ProgramField;
  readonly x: number;
  readonly y: number;
}

/** Where the handles are: those of the marks, of the end of the motor, and of the steps of the servo in hand. */
export function handlePlaces(geometry: Geometry, front: number): HandlePlace[] {
  const { program, flags, stages, layout, measures, motorStop } = geometry;
  const places = flags.map(({ slot, x }): HandlePlace => ({ field: { kind: 'time', slot }, x, y: FLAG }));
  if (motorStop !== null) {
    places.push({ field: { kind: 'time', slot: 0 }, x: layout.x(motorStop), y: measures.motor });
  }
  for (const { slot, from } of stages) {
    const position = program.positions[front]?.[slot];
    if (position === undefined) continue;
    places.push({ field: { kind: 'position', servo: front, slot }, x: layout.x(from), y: layout.y(front, position) });
  }
  return places;
}

/** How high the numbers of the marks stand. */
export const FLAG = 16;
