import type { CellField } from '../editing/grid.js';
import { type Geometry, handlePlaces } from './geometry.js';
import { laneAt } from './lanes.js';

/** A place of the picture, in pixels from its upper left corner. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** How near a pointer must come, in pixels: a finger covers 44, a mouse is exact. */
const REACH = { coarse: 22, fine: 13 };
/** The same from inside another lane, in pixels: a tap there means that lane. */
const REACH_FROM_OTHER = 12;
const LINE_REACH = 7;
const MARK_REACH = 4;

/**
 * The field whose handle is under a pointer: the nearest one in reach. A mouse can also take any part of the selected
 * line, and a function by its vertical line; a finger would do that by mistake.
 */
export function fieldUnder(geometry: Geometry, { x, y }: Point, coarse: boolean): CellField | null {
  const { layout, front, program, stages, flags } = geometry;
  const lane = servoUnder(geometry, y);
  const isInOther = lane !== null && lane !== front;
  const handle = nearest(
    handlePlaces(geometry).filter((place) => layout.shows(place.x) || place.field.kind === 'time'),
    (place) => Math.hypot(place.x - x, place.y - y),
    isInOther ? REACH_FROM_OTHER : coarse ? REACH.coarse : REACH.fine,
  );
  if (handle) return handle.field;
  if (coarse || lane === null) return null;

  const over = stages.filter(({ from, until }) => {
    const ends = [layout.x(from), until === null ? layout.box.right : layout.x(until)];
    return lane === front && x >= Math.min(...ends) && x <= Math.max(...ends);
  });
  const height = (slot: number): number => layout.y(lane, program.positions[lane]?.[slot] ?? 0);
  const step = nearest(over, ({ slot }) => Math.abs(height(slot) - y), LINE_REACH);
  if (step) return { kind: 'position', servo: lane, slot: step.slot };
  const mark = flags.find(({ at }) => Math.abs(at - x) <= MARK_REACH && layout.shows(at));
  return mark ? { kind: 'time', slot: mark.slot } : null;
}

/** The servo whose lane is at this height; null above and below the lanes. */
export function servoUnder({ layout }: Geometry, y: number): number | null {
  const { top, bottom } = layout.box;
  return y < top || y > bottom ? null : laneAt(layout.lanes, y);
}

/** A pointer this near to a mark asks for exactly its time, in pixels. */
const SNAP = 5;

/** The time under a pointer, in whole hundredths of a second. */
export function timeUnder({ stages, motorStop, layout }: Geometry, x: number): number {
  const times = [...stages.slice(1).map(({ from }) => from), ...(motorStop === null ? [] : [motorStop])];
  const mark = nearest(times, (time) => Math.abs(layout.x(time) - x), SNAP);
  if (mark !== undefined) return mark;
  const { left, right } = layout.box;
  return Math.min(layout.scale.end, Math.round(layout.time(Math.min(right, Math.max(left, x)))));
}

/** The nearest of all within reach. */
function nearest<T>(all: readonly T[], distanceOf: (each: T) => number, reach: number): T | undefined {
  return all.filter((each) => distanceOf(each) <= reach).sort((a, b) => distanceOf(a) - distanceOf(b))[0];
}
