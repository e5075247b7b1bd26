import type { Lane } from './layout.js';

/** What lies between two lanes, and inside of a lane above the highest position and below 0: pixels. */
const GAP = 2;
const INSET = { tall: 10, low: 4 };
/** The lane in hand is at least this high where there is room, and has the whole way for a finger then. */
const TALL = 180;
/** How high the others are: at least, so that a step of ten is seen; at most, as more would tell no more. */
const LOW = { least: 24, most: 64 };
/** Where there is no room for that, the lane in hand has at least this. */
const LEAST_TALL = 110;

/** The least height of all lanes of so many servos, in pixels. */
export function leastHeight(servos: number): number {
  return LEAST_TALL + Math.max(0, servos - 1) * (LOW.least + GAP);
}

/**
 * A lane for each servo, from above: equal positions of two servos are never drawn as if they were different. The one
 * in hand is tall, the others are low.
 * @param front the servo in hand; null where all are alike.
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

/** The servo in whose lane a height lies; above the first and below the last it is the nearest one. */
export function laneAt(lanes: readonly Lane[], y: number): number {
  const at = lanes.findIndex(({ until }) => y <= until);
  return at < 0 ? lanes.length - 1 : at;
}
