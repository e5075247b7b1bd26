import type { TimerProgram } from '../../program/index.js';
import { MAX_POSITION } from '../../protocol/index.js';
import { type Stage, stagesOf } from './preview/flight.js';
import type { Scale } from './scale.js';

/** The part of the time axis that is in view, in places of its scale. */
export interface View {
  readonly start: number;
  readonly span: number;
}

/** The room of the plot inside the picture, in pixels. */
export interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** Where times and positions lie in the picture. */
export class Layout {
  readonly scale: Scale;
  readonly view: View;
  readonly box: Box;
  /** The position at the upper edge. */
  readonly highest: number;

  constructor(scale: Scale, view: View, box: Box, highest: number) {
    this.scale = scale;
    this.view = view;
    this.box = box;
    this.highest = highest;
  }

  x(time: number): number {
    return this.box.left + ((this.scale.place(time) - this.view.start) / this.view.span) * this.width;
  }

  /** The time at a place of the picture, not rounded. */
  time(x: number): number {
    return this.scale.time(this.view.start + ((x - this.box.left) / this.width) * this.view.span);
  }

  y(position: number): number {
    const { top, bottom } = this.box;
    return bottom - (Math.min(position, this.highest) / this.highest) * (bottom - top);
  }

  position(y: number): number {
    const { top, bottom } = this.box;
    return ((bottom - y) / (bottom - top)) * this.highest;
  }

  get width(): number {
    return this.box.right - this.box.left;
  }

  /** Whether a place of the picture is beside the plot by no more than a mark is wide. */
  shows(x: number): boolean {
    return x >= this.box.left - 1 && x <= this.box.right + 1;
  }
}

/** The position at the upper edge: the last step, or what one byte can hold where a timer holds more than that. */
export function highestOf(programs: readonly TimerProgram[]): number {
  return programs.some(({ positions }) => positions.some((row) => row.some((p) => p > MAX_POSITION)))
    ? 255
    : MAX_POSITION;
}

/** More lines than this are not kept apart where they run together: there is no room for it. */
const MOST_STRANDS = 6;
/** Lines that run together are drawn side by side, this many pixels apart. */
const STRAND = 4;

/** `[servo][slot]`: how high each line runs, in pixels. Lines that would cover each other are drawn side by side. */
export function heightsOf({ positions }: TimerProgram, layout: Layout): number[][] {
  const heights = positions.map((row) => row.map((position) => layout.y(position)));
  if (heights.length > MOST_STRANDS) return heights;
  const slots = heights[0]?.length ?? 0;
  for (let slot = 0; slot < slots; slot++) {
    const apart = spread(
      heights.map((row) => row[slot] as number),
      STRAND,
      layout.box.top,
      layout.box.bottom,
    );
    heights.forEach((row, servo) => {
      row[slot] = apart[servo] as number;
    });
  }
  return heights;
}

/** The three parts of a servo's line, as the data of paths. */
export interface LinePaths {
  readonly held: string;
  /** Where it goes from one position to the next. */
  readonly steps: string;
  /** Where it would have to go back in time. */
  readonly back: string;
}

export function pathsOf(stages: readonly Stage[], heights: readonly number[], layout: Layout): LinePaths {
  const paths = { held: '', steps: '', back: '' };
  for (const { slot, from, until, passing } of stages) {
    const x = round(layout.x(from));
    const y = round(heights[slot] as number);
    const end = until === null ? round(Math.max(layout.x(layout.scale.end), layout.box.right)) : round(layout.x(until));
    if (passing !== 'passed') paths[passing === 'back' ? 'back' : 'held'] += `M${x} ${y}H${end}`;
    if (until !== null) paths.steps += `M${end} ${y}V${round(heights[slot + 1] as number)}`;
  }
  return paths;
}

/** The paths of all lines of a program. */
export function linesOf(program: TimerProgram, layout: Layout): LinePaths[] {
  const stages = stagesOf(program);
  return heightsOf(program, layout).map((row) => pathsOf(stages, row, layout));
}

/**
 * Moves numbers as little as may be, so that neighbours are `gap` apart; equal ones keep their order. Where there is no
 * room for that they are closer.
 */
export function spread(numbers: readonly number[], gap: number, min: number, max: number): number[] {
  const order = numbers.map((_, i) => i).sort((a, b) => (numbers[a] as number) - (numbers[b] as number) || a - b);
  const each = Math.min(gap, (max - min) / Math.max(1, numbers.length - 1));
  // Groups that touch are moved together, to where their members would be on the average.
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
  // From the upper edge down, in case that the edge has pushed a group into the one before it.
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

function round(pixels: number): number {
  return Math.round(pixels * 10) / 10;
}
