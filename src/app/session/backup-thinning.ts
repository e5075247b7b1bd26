import type { Backup } from '../storage/index.js';
import { kindKey } from './record-keys.js';

/** So many days back one of each day stays; before that one of each month. */
const DAYS = 31;
/** No more than these are kept in all: the oldest give way. */
const MOST = 3000;

/**
 * Which backups need not be kept any more. Of those that were made before writes, for each memory of each model:
 *
 * - all of today stay,
 * - of each day of the last month the first: it is what the timer held when that day began, after all the days before,
 * - of each month before that the first.
 *
 * The first of a day or a month is the first for ever, so thinning again and again comes to the same as thinning once.
 * What the pilot has asked for (all memories) stays. Simulated timers are a group of their own, and nothing of them
 * stays for more than a month.
 * The day of the newest backup is today: a clock that is years ahead for once takes nothing away.
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

/** The first moment of the days of which one each stays. */
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
