/** How much is shown, and played, after the last event, in hundredths of a second. */
export const RUN_OUT = 300;

/** More than anybody can type. Later times are drawn here, so that no loop counts up to a time that never comes. */
const LAST_DRAWN = 1e9;

/** A time in a form that can be drawn, whatever a program holds: finite hundredths of a second from launch. */
export function drawable(time: number): number {
  return Number.isNaN(time) ? 0 : Math.min(LAST_DRAWN, Math.max(0, time));
}

/** A coordinate, short enough for the text of a picture. */
export function rounded(place: number): number {
  return Math.round(place * 10) / 10;
}

/** Shorter gaps are drawn nearly in proportion, longer ones more and more compressed. In hundredths of a second. */
const BEND = 50;
/** At most this share of the picture is divided evenly between the gaps. The rest follows the times. */
const EVEN_SHARE = 0.8;

/**
 * A time axis. Times are hundredths of a second from launch. Places run from 0 at launch to 1 at the end of the
 * picture. It rises strictly and is straight between its knots, so every place has one time and every time one place,
 * also past the end.
 */
export class Scale {
  readonly times: readonly number[];
  readonly places: readonly number[];
  /** Places for each hundredth of a second past the last knot, as in the most compressed gap. */
  readonly #beyond: number;

  /**
   * @param times at least two, strictly rising, the first is 0.
   * @param places one for each time, strictly rising, the first is 0.
   */
  constructor(times: readonly number[], places: readonly number[]) {
    this.times = times;
    this.places = places;
    this.#beyond = Math.min(...times.slice(1).map((_, i) => rate(times, places, i)));
  }

  /** The last time of the picture. */
  get end(): number {
    return this.times.at(-1) as number;
  }

  /** The place of a time. Times before launch lie at 0. */
  place(time: number): number {
    return along(this.times, this.places, time, this.#beyond);
  }

  /** The time at a place, not rounded: the inverse of {@link place}. */
  time(place: number): number {
    return along(this.places, this.times, place, 1 / this.#beyond);
  }
}

/** What stands at the same way between two knots of `to` as a number between those of `from`. */
function along(from: readonly number[], to: readonly number[], at: number, beyond: number): number {
  if (at <= 0) return 0;
  const next = from.findIndex((knot) => knot > at);
  const last = (next < 0 ? from.length : next) - 1;
  return (to[last] as number) + (at - (from[last] as number)) * (next < 0 ? beyond : rate(from, to, last));
}

/** How much `to` rises for each of `from` after a knot. */
function rate(from: readonly number[], to: readonly number[], knot: number): number {
  const [way, time] = [to, from].map((all) => (all[knot + 1] as number) - (all[knot] as number));
  return (way as number) / (time as number);
}

export interface StretchOptions {
  /** The least distance of neighbouring marks, as a share of the picture; less when there are too many marks. */
  readonly minGap: number;
  /** The width of the run-out, as a share of the picture. */
  readonly runOut: number;
  /** Times that get room only by their length, such as those of a second program. */
  readonly others?: readonly number[];
}

/**
 * An axis that shows both 0.05 s and 6 min. Each gap between two neighbouring marks gets an equal share, and a share
 * that grows with the logarithm of its length.
 * @param marks times that must be distinct in the picture, in any order. Launch always counts as one.
 */
export function stretchedScale(marks: readonly number[], { minGap, runOut, others = [] }: StretchOptions): Scale {
  const own = rising([0, ...marks.map(drawable)]);
  const times = rising([...own, ...others.map(drawable)]);
  const end = times.at(-1) as number;
  const stops = rising([...own, end]);
  const gaps = stops.length - 1;
  if (gaps === 0) return new Scale([0, RUN_OUT], [0, 1]);

  const room = 1 - runOut;
  const even = Math.min(minGap, (EVEN_SHARE * room) / gaps);
  const weights = times.slice(1).map((time, i) => Math.log1p((time - (times[i] as number)) / BEND));
  const share = (room - even * gaps) / sum(weights);

  const places = [0];
  let next = 0;
  for (let stop = 1; stop < stops.length; stop++) {
    const from = next;
    while ((times[next] as number) < (stops[stop] as number)) next++;
    const inside = weights.slice(from, next);
    const each = even / sum(inside) + share;
    for (const weight of inside) places.push((places.at(-1) as number) + weight * each);
  }
  return new Scale([...times, end + RUN_OUT], [...places, 1]);
}

/** The numbers in rising order, each once. */
function rising(numbers: readonly number[]): number[] {
  return [...new Set(numbers)].sort((a, b) => a - b);
}

function sum(numbers: readonly number[]): number {
  return numbers.reduce((total, number) => total + number, 0);
}
