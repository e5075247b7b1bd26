import type { Lane } from './layout.js';

/** Pixels between two lanes, and inside a lane above the highest position and below 0. */
const GAP = 2;
const INSET = { tall: 10, low: 4 };
/** The selected lane has at least this height where there is room, which gives a finger its full way. In pixels. */
const TALL = 180;
/**
 * The height of the other lanes in pixels: at least, so that a step of ten is visible;
 * at most, because more shows nothing more.
 */
const LOW = { least: 24, most: 64 };
/** Where there is less room, the selected lane has at least this height, in pixels. */
const LEAST_TALL = 110;

/** The least height of all lanes for this number of servos, in pixels. */
export function leastHeight(servos: number): number {
  return LEAST_TALL + Math.max(0, servos - 1) * (LOW.least + GAP);
}

/**
 * A lane for each servo, from top to bottom, so that equal positions of two servos never look different. The lane of
 * the selected servo is tall, the others are low.
 * @param front the selected servo; null when all lanes are equal.
 */
export function lanesOf(servos: number, front: number | null, top: number, bottom: number): Lane[] {
  const others = front === null ? servos : servos - 1;
  const room = bottom - top - (servos - 1) * GAP;
  const low =
    front === null ? room / servos : Math.min(LOW.most, Math.max(LOW.least, others > 0 ? (room - TALL) / others : 0));
  const tall = Math.max(LEAST_TALL, room - others * low);
  const lanes: Lane[] = [];
  let from = top;
  for (let servo = 0; servo < servos; servo++) {
    const [height, inset] = servo === front ? [tall, INSET.tall] : [low, Math.min(INSET.low, low / 4)];
    lanes.push({ from, until: from + height, top: from + inset, bottom: from + height - inset });
    from += height + GAP;
  }
  return lanes;
}

/** The servo whose lane is at this height; above the first and below the last lane, the nearest one. */
export function laneAt(lanes: readonly Lane[], y: number): number {
  const at = lanes.findIndex(({ until }) => y <= until);
  return at < 0 ? lanes.length - 1 : at;
}
