import { slotKind, type TimerProgram } from '../../program/index.js';
import type { CellField } from '../editing/grid.js';
import { marksOf, motorStopOf, type Stage, stagesOf } from './flight.js';
import { lanesOf, leastHeight } from './lanes.js';
import { highestOf, type Layout, layoutOf, spread, type TimeView, WHOLE } from './layout.js';
import { type Scale, stretchedScale } from './scale.js';
import { ticks } from './ticks.js';
import type { Size } from './use-size.js';

/** The measures of a picture in pixels. */
export interface Measures extends Size {
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
}

/** Pixels: the marks stand above the lanes, the motor's bar and the times below them. */
const SCREEN = { left: 44, right: 16, flag: 16, radius: 12, top: 36 };
const PAPER = { right: 10, flag: 9, radius: 8, top: 21 };
const MOTOR = 18;
const TIMES = 30;
/** The least width of the picture on the screen in pixels, however little room there is. */
const LEAST_WIDTH = 180;

/** The least height of the picture on the screen, in pixels. */
export function leastHeightOf(program: TimerProgram): number {
  return SCREEN.top + leastHeight(program.identity.servos) + belowOf(program);
}

/** @param room what there is, in pixels. */
export function measuresOf(program: TimerProgram, room: Size): Measures {
  const width = Math.max(LEAST_WIDTH, room.width);
  const height = Math.max(room.height, leastHeightOf(program));
  const bottom = height - belowOf(program);
  return { ...SCREEN, bottom, motor: bottom + MOTOR / 2 + 1, axis: height - 10, width, height };
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

/**
 * A program on paper: all lanes are equal.
 * @param group the servos that have a lane.
 * @param names what each servo moves; empty texts where nobody says it.
 */
export function onPaper(program: TimerProgram, group: readonly number[], names: readonly string[]): Geometry {
  const left = group.some((servo) => names[servo]) ? PAPER_NAMES.some : PAPER_NAMES.none;
  const each = Math.max(PAPER_LANE.least, PAPER_LANE.most - PAPER_LANE.lessForEach * group.length);
  const bottom = PAPER.top + each * group.length;
  const height = bottom + (motorStopOf(program) === null ? 15 : 26);
  const measures = { ...PAPER, left, bottom, motor: bottom + 7, axis: height - 2, width: PAPER_WIDTH, height };
  const positions = group.map((servo) => program.positions[servo] ?? []);
  return geometryOf({ ...program, positions }, measures, { front: null, first: group[0] ?? 0, names });
}

/** What the pilot looks at. */
export interface Look {
  /** The selected servo, whose lane is tall; null on paper, where all lanes are equal. */
  readonly front: number | null;
  /** The servo of the first lane. Default: the first of all. */
  readonly first?: number;
  /** The pilot's names for what each servo moves. */
  readonly names?: readonly string[] | undefined;
  readonly selected?: CellField | null;
  /** A second program, drawn behind the first. */
  readonly behind?: TimerProgram | null;
  readonly view?: TimeView;
  /** The axis while a handle is held. Default: that of the programs. */
  readonly scale?: Scale | undefined;
}

/** How to draw a program, in pixels. */
export type Geometry = ReturnType<typeof geometryOf>;

/** In pixels: the least distance of two marks on the stretched axis, the run-out, the least distance of two times. */
const MARK_GAP = 28;
const RUN_OUT_ROOM = 16;
const TICK_GAP = 52;

export function geometryOf(program: TimerProgram, measures: Measures, look: Look) {
  const { front, first = 0, names, selected = null, behind = null, view = WHOLE } = look;
  const { left, right, top, bottom, radius } = measures;
  const width = measures.width - left - right;
  const marks = marksOf(program);
  const others = behind ? marksOf(behind) : [];
  const scale = look.scale ?? stretchedScale(marks, { minGap: MARK_GAP / width, runOut: RUN_OUT_ROOM / width, others });
  const lanes = lanesOf(program.positions.length, front, top, bottom);
  const highest = highestOf(behind ? [program, behind] : [program]);
  const layout = layoutOf(scale, view, { left, right: left + width, top, bottom }, lanes, highest);
  const stages = stagesOf(program);
  // A selected time goes before all others but DT.
  const chosen = selected?.kind === 'time' ? [program.times[selected.slot] ?? 0] : [];
  return {
    program,
    front,
    first,
    names,
    selected,
    behind,
    measures,
    layout,
    stages,
    flags: flagsOf(program, stages, layout, radius),
    /** The times that stand below the plot. */
    ticks: ticks(scale, [stages.at(-1)?.from ?? 0], [...chosen, 0, ...marks], view, (TICK_GAP / width) * view.span),
    motorStop: motorStopOf(program),
  };
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
}

/** The radius of the circle around a number where it is narrow, in pixels. */
const SMALLEST_RADIUS = 8;

function flagsOf(program: TimerProgram, stages: readonly Stage[], layout: Layout, most: number): Flag[] {
  const { left, right } = layout.box;
  const flags = stages.slice(1).map(({ slot, from }) => {
    return { slot, isDt: slotKind(program.identity, slot) === 'dt', at: layout.x(from) };
  });
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
    return flags.map((flag) => {
      const x = places[inView.indexOf(flag)] ?? flag.at;
      return { ...flag, x, radius, labelled: true, roomy: true };
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

/** The place of a handle. */
export interface HandlePlace {
  readonly field: CellField;
  readonly x: number;
  readonly y: number;
}

/** The places of all handles: the end of the motor run, and by slots the marks and the steps of the selected servo. */
export function handlePlaces({ program, front, flags, stages, layout, measures, motorStop }: Geometry): HandlePlace[] {
  if (front === null) return [];
  const motor: HandlePlace[] =
    motorStop === null ? [] : [{ field: { kind: 'time', slot: 0 }, x: layout.x(motorStop), y: measures.motor }];
  const steps = stages.flatMap(({ slot, from }): HandlePlace[] => {
    const flag = flags[slot - 1];
    const y = layout.y(front, program.positions[front]?.[slot] ?? 0);
    return [
      ...(flag ? [{ field: { kind: 'time', slot } as const, x: flag.x, y: measures.flag }] : []),
      { field: { kind: 'position', servo: front, slot }, x: layout.x(from), y },
    ];
  });
  return [...motor, ...steps];
}
