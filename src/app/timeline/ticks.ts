import { formatTime } from '../editing/units.js';
import type { TimeView } from './layout.js';
import type { Scale } from './scale.js';

/** Round times in hundredths of a second. Each is a multiple of the next. */
const LEVELS = [30000, 6000, 3000, 1000, 500, 100, 50, 10, 5, 1];
/** Round times that are more in view are too close. */
const MOST = 1000;

/**
 * The times to show on an axis: those that must be there, then as many others as fit, round ones last.
 * @param fixed times that are always shown.
 * @param wished times that come before any round one.
 * @param gap the least distance of two times, in places.
 * @returns hundredths of a second, in rising order.
 */
export function ticks(
  scale: Scale,
  fixed: readonly number[],
  wished: readonly number[],
  { start, span }: TimeView,
  gap: number,
): number[] {
  const [first, last] = [scale.time(start), scale.time(start + span)];
  const round = LEVELS.filter((level) => last - first < MOST * level).flatMap((level) => {
    const lowest = Math.ceil(first / level);
    const times = Array.from({ length: Math.floor(last / level) - lowest + 1 }, (_, i) => (lowest + i) * level);
    // Where not all of them have room, there is none.
    const isApart = (one: number, other: number): boolean => scale.place(other) - scale.place(one) >= gap;
    return times.filter((time) => isApart(time - level, time) && isApart(time, time + level));
  });
  const chosen = fixed.map((time) => ({ time, place: scale.place(time) }));
  for (const time of [...wished, ...round]) {
    const place = scale.place(time);
    if (chosen.every((tick) => Math.abs(tick.place - place) >= gap)) chosen.push({ time, place });
  }
  return chosen
    .filter(({ place }) => place >= start && place <= start + span)
    .map(({ time }) => time)
    .sort((a, b) => a - b);
}

/** A time in its shortest form: `0`, `0.5` or `0,5`, `12`, `3:00`. */
export function shortTime(hundredths: number): string {
  const text = formatTime(hundredths);
  return text.includes(':') ? text : text.replace(/[.,]?0+$/, '');
}
