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
    view,
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
 * The line of one servo, as the data of paths: its positions and how it goes from one to the next, and apart from that
 * where it would have to go back in time.
 */
export function lineOf({ positions }: TimerProgram, stages: readonly Stage[], servo: number, layout: Layout) {
  const row = positions[servo] ?? [];
  const height = (slot: number): number => rounded(layout.y(servo, row[slot] ?? 0));
  let line = `M${rounded(layout.x(0))} ${height(0)}`;
  let back = '';
  for (const { slot, from, until, passing } of stages) {
    const last = Math.max(layout.x(layout.scale.end), layout.box.right);
    const end = rounded(until === null ? last : layout.x(until));
    if (passing === 'back') {
      back += `M${rounded(layout.x(from))} ${height(slot)}H${end}`;
      line += `M${end} ${height(slot)}`;
    } else line += `H${end}`;
    if (until !== null) line += `V${height(slot + 1)}`;
  }
  return { line, back };
}

/**
 * Moves numbers as little as possible, so that neighbours are `gap` apart. Equal numbers keep their order. Where there
 * is too little room they are closer.
 */
export function spread(numbers: readonly number[], gap: number, min: number, max: number): number[] {
  const order = numbers.map((_, i) => i).sort((a, b) => (numbers[a] as number) - (numbers[b] as number) || a - b);
  const each = Math.min(gap, (max - min) / Math.max(1, numbers.length - 1));
  // Groups that touch are joined and moved to the average place of their members.
  const groups: { first: number; members: number[] }[] = [];
  for (const i of order) {
    let group = { first: numbers[i] as number, members: [i] };
    for (
      let last = groups.at(-1);
      last && group.first < last.first + last.members.length * each;
      last = groups.at(-1)
    ) {
      groups.pop();
      const members = [...last.members, ...group.members];
      const wished = members.map((member, at) => (numbers[member] as number) - at * each);
      group = { first: wished.reduce((a, b) => a + b, 0) / members.length, members };
    }
    const longest = max - (group.members.length - 1) * each;
    groups.push({ ...group, first: Math.max(min, Math.min(longest, group.first)) });
  }
  const result = [...numbers];
  // From the end back, in case that the edge has pushed a group into the one before.
  let limit = max;
  for (const { first, members } of groups.reverse()) {
    const start = Math.min(first, limit - (members.length - 1) * each);
    members.forEach((member, at) => {
      result[member] = start + at * each;
    });
    limit = start - each;
  }
  return result;
}
