import type { Backup } from '../storage/index.js';
import { kindKey } from './record-keys.js';

/** How many days back one backup of each day stays. Before that, one of each month. */
const DAYS = 31;
/** The most backups that are kept. The oldest go first. */
const MOST = 3000;

/**
 * The backups that need not be kept any more. Of those from before a write, for each memory of each model:
 *
 * - all of today stay;
 * - of each day of the last month the first stays: it is what the timer held when that day began;
 * - of each month before that the first stays.
 *
 * The first of a day or a month never changes, so thinning twice gives the same as thinning once. Backups that the
 * pilot asked for (all memories) stay. Simulated timers are a group of their own, and their backups stay for a month at
 * most. The day of the newest backup counts as today, so a clock that is once years ahead deletes nothing.
 * @param now milliseconds since 1970; days and months are those of this device.
 */
export function outdated(backups: readonly Backup[], now: number): readonly Backup[] {
  const newest = Math.max(...backups.map(({ savedAt }) => savedAt));
  const today = dayOf(Math.min(now, newest));
  const oldest = monthBefore(Math.min(now, newest));
  const oldestSimulated = monthBefore(now);
  const kept = new Map<string, Backup>();
  const gone: Backup[] = [];
  const earliestFirst = [...backups].sort((a, b) => a.savedAt - b.savedAt || (a.key < b.key ? -1 : 1));
  for (const backup of earliestFirst) {
    const { savedAt, reason, simulated } = backup;
    const isOld = savedAt < oldest;
    const isOver = simulated && savedAt < oldestSimulated;
    if (isOver) gone.push(backup);
    if (reason !== 'write' || dayOf(savedAt) === today || savedAt > now || isOver) continue;
    const place = `${groupOf(backup)} ${isOld ? monthOf(savedAt) : dayOf(savedAt)}`;
    if (kept.has(place)) gone.push(backup);
    else kept.set(place, backup);
  }
  const left = backups.length - gone.length;
  if (left <= MOST) return gone;
  const isGone = new Set(gone);
  return [...gone, ...earliestFirst.filter((each) => !isGone.has(each)).slice(0, left - MOST)];
}

/** When the days begin of which one backup each stays. */
function monthBefore(time: number): number {
  const day = new Date(time);
  day.setHours(0, 0, 0, 0);
  return day.setDate(day.getDate() - DAYS);
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
