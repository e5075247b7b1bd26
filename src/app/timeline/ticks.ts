import { formatTime } from '../editing/units.js';
import type { Scale } from './scale.js';

/** Round times in hundredths of a second. Each is a multiple of the next. */
const LEVELS = [30000, 6000, 3000, 1000, 500, 100, 50, 10, 5, 1];

/** Where there is room for times. */
export interface TickRoom {
  /** The first place in view. */
  readonly from: number;
  /** The last place in view. */
  readonly to: number;
  /** The least distance of two times, in places. */
  readonly gap: number;
}

/**
 * The times to show on an axis: those that must be there, then as many others as fit, round ones last.
 * @param fixed times that are always shown.
 * @param wished times that come before any round one.
 * @returns hundredths of a second, in rising order.
 */
export function ticks(
  scale: Scale,
  fixed: readonly number[],
  wished: readonly number[],
  { from, to, gap }: TickRoom,
): number[] {
  const chosen = fixed.map((time) => ({ time, place: scale.place(time) }));
  const free = (place: number): boolean => chosen.every((tick) => Math.abs(tick.place - place) >= gap);
  for (const time of wished) {
    const place = scale.place(time);
    if (free(place)) chosen.push({ time, place });
  }
  for (const level of LEVELS) {
    for (let knot = 1; knot < scale.times.length; knot++) {
      const [first, last] = [scale.times[knot - 1] as number, scale.times[knot] as number];
      const rate = scale.place(last) - scale.place(first);
      // In this gap they would stand too close, and all finer ones, too.
      if ((rate / (last - first)) * level < gap) continue;
      const begin = Math.max(first, scale.time(from));
      const end = Math.min(last, scale.time(to));
      const lowest = Math.ceil(begin / level);
      // No more than fit, whatever the numbers are.
      const count = Math.min(Math.floor(end / level) - lowest, Math.ceil((to - from) / gap)) + 1;
      for (let i = 0; i < count; i++) {
        const time = (lowest + i) * level;
        const place = scale.place(time);
        if (free(place)) chosen.push({ time, place });
      }
    }
  }
  return chosen
    .filter(({ place }) => place >= from && place <= to)
    .map(({ time }) => time)
    .sort((a, b) => a - b);
}

/** A time in its shortest form: `0`, `0.5` or `0,5`, `12`, `3:00`. */
export function shortTime(hundredths: number): string {
  const text = formatTime(hundredths);
  return text.includes(':') ? text : text.replace(/[.,]?0+$/, '');
}
