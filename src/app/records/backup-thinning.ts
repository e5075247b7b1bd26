import type { Backup } from '../storage/index.js';
import { kindKey } from '../timer/record-keys.js';

/** Of how many days with backups, counted from the latest, all stay. */
const FULL_DAYS = 2;
/** Of how many days with backups, counted from the latest, one of each stays. Before that, one of each month. */
const DAYS = 32;
/** For how many days the backups of simulated timers stay. */
const SIMULATED_DAYS = 31;
/** The most backups that are kept. The oldest go first. */
const MOST = 3000;

/**
 * The backups that need not be kept any more. Of those from before a write, for each memory of each model:
 *
 * - all of the last two days with backups stay;
 * - of each of the 30 days with backups before that the first stays: it is what the timer held when that day began;
 * - of each month before that the first stays.
 *
 * The clock of a device may be years ahead or behind for a while. So days are counted, not measured, in the order in
 * which the backups were made: a wrong clock counts as one more day. The first of a day or a month never changes, so
 * thinning twice gives the same as thinning once. Backups that the pilot asked for (all memories) stay. Simulated
 * timers are a group of their own, and their backups stay for a month at most.
 * @param now milliseconds since 1970; days and months are those of this device.
 */
export function outdated(backups: readonly Backup[], now: number): readonly Backup[] {
  const earliestFirst = [...backups].sort((a, b) => (a.key < b.key ? -1 : 1));
  const days = [...new Set(earliestFirst.map(({ savedAt }) => dayOf(savedAt)).reverse())];
  const full = new Set(days.slice(0, FULL_DAYS));
  const daily = new Set(days.slice(0, DAYS));
  const oldestSimulated = daysBefore(now, SIMULATED_DAYS);
  const gone = new Set<Backup>();
  let kept = new Set<string>();
  let before = '';
  for (const backup of earliestFirst) {
    const { savedAt, reason, simulated } = backup;
    const day = dayOf(savedAt);
    const period = daily.has(day) ? day : monthOf(savedAt);
    // The clock may come to the same day twice.
    if (period !== before) kept = new Set();
    before = period;
    const isOver = simulated && savedAt < oldestSimulated;
    if (isOver) gone.add(backup);
    if (reason !== 'write' || full.has(day) || isOver) continue;
    const group = groupOf(backup);
    if (kept.has(group)) gone.add(backup);
    kept.add(group);
  }
  const left = earliestFirst.filter((each) => !gone.has(each));
  return [...gone, ...left.slice(0, Math.max(0, left.length - MOST))];
}

/** When a day began. */
function daysBefore(time: number, days: number): number {
  const day = new Date(time);
  day.setHours(0, 0, 0, 0);
  return day.setDate(day.getDate() - days);
}

function groupOf({ simulated, model, program: { identity, memory } }: Backup): string {
  return `${kindKey(identity, simulated)}/${model ?? ''}/${memory ?? '?'}`;
}

function dayOf(time: number): string {
  return `${monthOf(time)}-${new Date(time).getDate()}`;
}

function monthOf(time: number): string {
  const day = new Date(time);
  return `${day.getFullYear()}-${day.getMonth()}`;
}
