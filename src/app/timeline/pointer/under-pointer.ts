import type { ProgramField } from '../../../program/index.js';
import { type Geometry, handlePlaces } from '../geometry.js';
import { laneAt } from '../lanes.js';
import type { Target } from './pointer-control.js';

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
export function fieldUnder(
  { geometry, onEdit }: Pick<Target, 'geometry' | 'onEdit'>,
  front: number,
  { x, y }: Point,
  coarse: boolean,
): ProgramField | null {
  if (!onEdit) return null;
  const { layout } = geometry;
  const { top, bottom } = layout.box;
  const isInLanes = y >= top && y <= bottom;
  const isInOther = isInLanes && laneAt(layout.lanes, y) !== front;
  const reach = isInOther ? REACH_FROM_OTHER : coarse ? REACH.coarse : REACH.fine;
  const near = handlePlaces(geometry, front)
    .filter((place) => layout.shows(place.x) || place.field.kind === 'time')
    .map((place) => ({ field: place.field, distance: Math.hypot(place.x - x, place.y - y) }))
    .filter(({ distance }) => distance <= reach)
    .sort((a, b) => a.distance - b.distance)[0];
  if (near) return near.field;
  if (coarse || !isInLanes) return null;

  const slot = isInOther ? null : slotUnder(geometry, front, { x, y });
  if (slot !== null) return { kind: 'position', servo: front, slot };
  const mark = geometry.flags.find(({ at }) => Math.abs(at - x) <= MARK_REACH && layout.shows(at));
  return mark ? { kind: 'time', slot: mark.slot } : null;
}

/** The slot of the selected line under a pointer; null where there is no line. */
function slotUnder({ program, stages, layout }: Geometry, front: number, { x, y }: Point): number | null {
  let found: number | null = null;
  let nearest = LINE_REACH;
  for (const { slot, from, until } of stages) {
    const ends = [layout.x(from), until === null ? layout.box.right : layout.x(until)];
    if (x < Math.min(...ends) || x > Math.max(...ends)) continue;
    const distance = Math.abs(layout.y(front, program.positions[front]?.[slot] ?? 0) - y);
    if (distance > nearest) continue;
    nearest = distance;
    found = slot;
  }
  return found;
}

/** The servo whose lane is under a pointer; null above and below the lanes. */
export function servoUnder({ layout }: Geometry, { y }: Point): number | null {
  const { top, bottom } = layout.box;
  return y < top || y > bottom ? null : laneAt(layout.lanes, y);
}

/** A pointer this near to a mark asks for exactly its time, in pixels. */
const SNAP = 5;

/** The time under a pointer, in whole hundredths of a second. */
export function timeUnder({ flags, stages, motorStop, layout }: Geometry, x: number): number {
  const marks = flags.map(({ slot, at }) => ({ time: stages[slot]?.from ?? 0, distance: Math.abs(at - x) }));
  if (motorStop !== null) marks.push({ time: motorStop, distance: Math.abs(layout.x(motorStop) - x) });
  const nearest = marks.sort((a, b) => a.distance - b.distance)[0];
  if (nearest && nearest.distance <= SNAP) return nearest.time;
  const { left, right } = layout.box;
  return Math.min(layout.scale.end, Math.round(layout.time(Math.min(right, Math.max(left, x)))));
}
