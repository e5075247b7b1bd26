import { type ProgramField, slotKind, type TimerProgram } from '../../program/index.js';
import { marksOf, motorStopOf, type Stage, stagesOf } from './flight.js';
import { lanesOf, leastHeight } from './lanes.js';
import { highestOf, Layout, spread, type TimeView, WHOLE } from './layout.js';
import { type Scale, stretchedScale } from './scale.js';
import { ticks } from './ticks.js';

/** The measures of a picture in pixels, without its width. */
export interface Measures {
  readonly left: number;
  readonly right: number;
  /** The middle of the marks' numbers, and the radius of the circles around them where there is room. */
  readonly flag: number;
  readonly radius: number;
  /** The top of the first lane and the bottom of the last one. */
  readonly top: number;
  readonly bottom: number;
  /** The middle of the bar that shows how long the motor runs. */
  readonly motor: number;
  /** The base line of the times below the plot. */
  readonly axis: number;
  readonly height: number;
}

/** Pixels: the marks stand above the lanes, the motor's bar and the times below them. */
const SCREEN = { left: 44, right: 16, flag: 16, radius: 12, top: 36 };
const PAPER = { right: 10, flag: 9, radius: 8, top: 21 };
const MOTOR = 18;
const TIMES = 30;

/** The least height of the picture on the screen, in pixels. */
export function leastHeightOf(program: TimerProgram): number {
  return SCREEN.top + leastHeight(program.identity.servos) + belowOf(program);
}

/** @param room the height that there is, in pixels. */
export function measuresOf(program: TimerProgram, room: number): Measures {
  const height = Math.max(room, leastHeightOf(program));
  const bottom = height - belowOf(program);
  return { ...SCREEN, bottom, motor: bottom + MOTOR / 2 + 1, axis: height - 10, height };
}

/** The height of the motor's bar and the times. */
function belowOf(program: TimerProgram): number {
  return (motorStopOf(program) === null ? 0 : MOTOR) + TIMES;
}

/** The width of A5 between its margins, in pixels. On larger paper the picture is larger. */
const PAPER_WIDTH = 484;
/** The height of a lane on paper in pixels: the one for a single lane, and the least among many. */
const PAPER_LANE = { most: 49, least: 26, lessForEach: 4 };
/** The room beside the lanes for the names of the servos, and for what they move. In pixels. */
const PAPER_NAMES = { none: 26, some: 74 };

/** A program on paper: all lanes are equal. @param isNamed whether it says what a servo moves. */
export function onPaper(program: TimerProgram, isNamed: boolean): Geometry {
  const { length: servos } = program.positions;
  const left = isNamed ? PAPER_NAMES.some : PAPER_NAMES.none;
  const each = Math.max(PAPER_LANE.least, PAPER_LANE.most - PAPER_LANE.lessForEach * servos);
  const bottom = PAPER.top + each * servos;
  const height = bottom + (motorStopOf(program) === null ? 15 : 26);
  const measures = { ...PAPER, left, bottom, motor: bottom + 7, axis: height - 2, height };
  const plot = PAPER_WIDTH - left - PAPER.right;
  const scale = scaleOf(program, null, plot);
  const layout = layoutOf({ scale, view: WHOLE, plot, measures, servos, front: null, highest: highestOf([program]) });
  return { program, layout, measures, ...marksIn(program, layout, measures, null) };
}

/** The least distance of two marks on the stretched axis, and the width of the run-out, in pixels. */
const MARK_GAP = 28;
const RUN_OUT_ROOM = 16;

/** The axis for a program and the one behind it. @param width of the plot, in pixels. */
export function scaleOf(program: TimerProgram, overlay: TimerProgram | null, width: number): Scale {
  return stretchedScale(marksOf(program), {
    minGap: MARK_GAP / width,
    runOut: RUN_OUT_ROOM / width,
    others: overlay ? marksOf(overlay) : [],
  });
}

/** The mark of a function or DT: where its time is, and where its number stands above it. */
export interface Flag {
  readonly slot: number;
  readonly isDt: boolean;
  readonly at: number;
  readonly x: number;
  readonly radius: number;
  /** False when there is no room for its number. */
  readonly labelled: boolean;
  /** Whether there is room for a circle around its number, and for a dot at each step below. */
  readonly roomy: boolean;
  readonly passedOver: boolean;
}

/** The radius of the circle around a number where it is narrow, in pixels. */
const SMALLEST_RADIUS = 8;

function flagsOf(program: TimerProgram, stages: readonly Stage[], layout: Layout, most: number): Flag[] {
  const { left, right } = layout.box;
  const flags = stages.slice(1).map(({ slot, from, passing }) => ({
    slot,
    isDt: slotKind(program.identity, slot) === 'dt',
    at: layout.x(from),
    passedOver: passing === 'passed',
  }));
  const inView = flags.filter(({ at }) => layout.shows(at));
  const room = (right - left + 2 * most) / Math.max(1, inView.length);
  if (room >= 2 * SMALLEST_RADIUS) {
    const radius = Math.min(most, room / 2 - 0.5);
    const places = spread(
      inView.map(({ at }) => at),
      2 * radius + 3,
      // DT is wider, and closer to the edge of the picture than the first one.
      left - 2 * most,
      right,
    );
    let next = 0;
    return flags.map(({ slot, isDt, at, passedOver }) => {
      const x = layout.shows(at) ? (places[next++] ?? at) : at;
      return { slot, isDt, at, passedOver, x, radius, labelled: true, roomy: true };
    });
  }
  // Not every mark has room for its number: DT has it, and each mark far enough from the last one with a number.
  const dt = inView.find(({ isDt }) => isDt)?.at ?? Number.POSITIVE_INFINITY;
  let last = Number.NEGATIVE_INFINITY;
  return flags.map((flag) => {
    const free = Math.abs(flag.at - last) > 3 * most && Math.abs(dt - flag.at) > 3 * most;
    const labelled = flag.isDt || (free && layout.shows(flag.at));
    if (labelled && !flag.isDt) last = flag.at;
    return { ...flag, x: flag.at, radius: most, labelled, roomy: flag.isDt };
  });
}

/** How to draw the times of a program, in pixels. */
export interface Marks {
  readonly stages: readonly Stage[];
  readonly flags: readonly Flag[];
  /** The times that stand below the plot. */
  readonly ticks: readonly number[];
  readonly motorStop: number | null;
}

/** How to draw a program, in pixels. */
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
  /** The selected servo, whose lane is tall; null when all lanes are equal. */
  readonly front: number | null;
  /** The position at the top of each lane. */
  readonly highest: number;
}

export function layoutOf({ scale, view, plot, measures, servos, front, highest }: GeometryOptions): Layout {
  const { left, top, bottom } = measures;
  const box = { left, right: left + plot, top, bottom };
  return new Layout(scale, view, box, lanesOf(servos, front, top, bottom), highest);
}

/** The least distance of two times on the axis, in pixels. */
const TICK_GAP = 52;

/** @param chosen a time that goes before all others but DT. */
export function marksIn(program: TimerProgram, layout: Layout, { radius }: Measures, chosen: number | null): Marks {
  const { scale, view, width } = layout;
  const stages = stagesOf(program);
  const dt = stages.at(-1)?.from ?? 0;
  const wished = [...(chosen === null ? [] : [chosen]), 0, ...marksOf(program)];
  const room = { from: view.start, to: view.start + view.span, gap: (TICK_GAP / width) * view.span };
  return {
    stages,
    flags: flagsOf(program, stages, layout, radius),
    ticks: ticks(scale, [dt], wished, room),
    motorStop: motorStopOf(program),
  };
}

/** The place of a handle. */
export interface HandlePlace {
  readonly field: ProgramField;
  readonly x: number;
  readonly y: number;
}

/** The places of all handles: the marks, the end of the motor run, and the steps of the selected servo. */
export function handlePlaces(geometry: Geometry, front: number): HandlePlace[] {
  const { program, flags, stages, layout, measures, motorStop } = geometry;
  const places = flags.map(({ slot, x }): HandlePlace => ({ field: { kind: 'time', slot }, x, y: measures.flag }));
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
