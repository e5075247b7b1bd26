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

/** The field whose handle is under a pointer: the nearest one in reach. */
export function fieldUnder(geometry: Geometry, { x, y }: Point, coarse: boolean): CellField | null {
  const { layout, front } = geometry;
  const lane = servoUnder(geometry, y);
  // In another lane a tap means that lane.
  const isNear = coarse && (lane === null || lane === front);
  return (
    nearest(
      handlePlaces(geometry).filter((place) => layout.shows(place.x) || place.field.kind === 'time'),
      (place) => Math.hypot(place.x - x, place.y - y),
      isNear ? REACH.coarse : REACH.fine,
    )?.field ?? null
  );
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
