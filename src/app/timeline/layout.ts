import type { TimerProgram } from '../../program/index.js';
import { MAX_POSITION } from '../../protocol/index.js';
import type { Stage } from './flight.js';
import { rounded, type Scale } from './scale.js';

/** The visible part of the time axis, in places of its scale. */
export interface TimeView {
  readonly start: number;
  readonly span: number;
}

/** All of it. */
export const WHOLE: TimeView = { start: 0, span: 1 };

/** The area of the plot inside the picture, in pixels. */
export interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** The strip in which the positions of one servo are drawn, in pixels. */
export interface Lane {
  /** Its edges. */
  readonly from: number;
  readonly until: number;
  /** The heights of the highest position and of 0. */
  readonly top: number;
  readonly bottom: number;
}

/** Converts between times and positions, and places in the picture. */
export type Layout = ReturnType<typeof layoutOf>;

/**
 * @param lanes one for each servo.
 * @param highest the position at the top of each lane.
 */
export function layoutOf(scale: Scale, view: TimeView, box: Box, lanes: readonly Lane[], highest: number) {
  const width = box.right - box.left;
  const laneOf = (servo: number): Pick<Lane, 'top' | 'bottom'> => lanes[servo] ?? box;
  return {
    scale,
    box,
    lanes,
    highest,
    width,
    x: (time: number): number => box.left + ((scale.place(time) - view.start) / view.span) * width,
    /** The time at a place of the picture, not rounded. */
    time: (x: number): number => scale.time(view.start + ((x - box.left) / width) * view.span),
    /** The height of a servo's position. */
    y: (servo: number, position: number): number => {
      const { top, bottom } = laneOf(servo);
      return bottom - (Math.min(position, highest) / highest) * (bottom - top);
    },
    /** The position of a servo at a height, not rounded. */
    position: (servo: number, y: number): number => {
      const { top, bottom } = laneOf(servo);
      return ((bottom - y) / (bottom - top)) * highest;
    },
    /** Whether a place lies in the plot, or at most the width of a mark beside it. */
    shows: (x: number): boolean => x >= box.left - 1 && x <= box.right + 1,
  };
}

/**
 * The position at the top of a lane: the last step;
 * or, when a timer holds more than that, the most that a byte can hold.
 */
export function highestOf(programs: readonly TimerProgram[]): number {
  return programs.some(({ positions }) => positions.some((row) => row.some((p) => p > MAX_POSITION)))
    ? 255
    : MAX_POSITION;
}

/**
 * The line of one servo, as the data of a path: its positions and how it goes from one to the next. It has a gap where
 * it would have to go back in time.
 */
export function lineOf({ positions }: TimerProgram, stages: readonly Stage[], servo: number, layout: Layout): string {
  const height = (slot: number): number => rounded(layout.y(servo, positions[servo]?.[slot] ?? 0));
  const last = Math.max(layout.x(layout.scale.end), layout.box.right);
  const ways = stages.map(({ slot, until, passing }) => {
    const end = rounded(until === null ? last : layout.x(until));
    const way = passing === 'back' ? `M${end} ${height(slot)}` : `H${end}`;
    return until === null ? way : `${way}V${height(slot + 1)}`;
  });
  return `M${rounded(layout.x(0))} ${height(0)}${ways.join('')}`;
}

/**
 * Moves numbers as little as possible, so that neighbours are `gap` apart. Equal numbers keep their order. Where there
 * is too little room they are closer.
 */
export function spread(numbers: readonly number[], gap: number, min: number, max: number): number[] {
  const last = numbers.length - 1;
  const order = numbers.map((_, i) => i).sort((a, b) => (numbers[a] as number) - (numbers[b] as number));
  const each = Math.min(gap, (max - min) / Math.max(1, last));
  const wished = order.map((i, at) => Math.min(max - last * each, Math.max(min, (numbers[i] as number) - at * each)));
  const result = [...numbers];
  order.forEach((i, at) => {
    // The middle between moving all that are too close to the right, and to the left.
    const [right, left] = [Math.max(...wished.slice(0, at + 1)), Math.min(...wished.slice(at))];
    result[i] = at * each + (right + left) / 2;
  });
  return result;
}
