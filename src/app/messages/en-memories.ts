import { plural } from './plural.js';

/** Which memory flies next, and what is known about the others. */
export const nextFlight = {
  badge: 'flies next',
  /** Before the memory that flies next. */
  onScreen: (memory: string) => `This is ${memory}.`,
  named: (memory: string) => `${memory}, flies next`,
  other: (memory: string) => `${memory} flies next.`,
  /** While no timer is connected. */
  last: (memory: string) =>
    `${memory} was current when the timer last answered. It flies next unless something else has changed that.`,
  original: (original: string) => `When you connected it was ${original}.`,
  originalUnknown: 'It is not known which one it was when you connected.',
  unknown: 'It is not known which memory flies next.',
  asked: (memory: string) => `${memory} was selected last.`,
  back: (original: string) => `Back to ${original}`,
  leaving: {
    title: 'Before you disconnect',
    back: (original: string) => `Back to ${original} and disconnect`,
    failed: (original: string) => `The timer did not go back to ${original}. It is still connected.`,
  },
};

/** The last reading of a memory that is not current. */
export const look = {
  read: (memory: string, time: string) => `${memory}, read ${time}`,
  notRead: (memory: string) => `${memory} has not been read`,
  /** Above the two values that a field may have after an interrupted write. */
  either: 'Either',
  or: 'or',
  /** @param current the memory that flies next. */
  lead: (current: string) => `For looking only. ${current} flies next.`,
  /** Opens it in the table. */
  edit: (memory: string) => `Edit ${memory}`,
  look: (memory: string) => `Look at ${memory}`,
  hint: (memory: string, current: string) => `This selects ${memory}, reads it and goes back to ${current}.`,
  fly: (memory: string) => `Make ${memory} fly next`,
  show: (memory: string) => `Show ${memory}`,
};

/** Jobs over several memories, and the backups. */
export const memories = {
  copy: (from: string, to: string) => `Copy ${from} to ${to}`,
  restore: 'Restore a backup',
  restoreAll: (count: number) => `Restore all ${count}…`,
  /** What a copy, a restore, and a write into a memory that does not fly next do. */
  plans: {
    screen: (to: string, keepsThrottle: boolean) =>
      `${to} will hold the times and positions on the screen. What ${to} holds now is backed up first.${keepsThrottle ? ' The idle throttle stays as it is.' : ''}`,
    copy: (from: string, to: string) =>
      `${to} will hold the times and positions of ${from}, as read just now. What ${to} holds now is backed up first.`,
    restore: (names: string, time: string) =>
      `This writes into ${names} what was backed up on ${time}. What is there now is backed up first.`,
  },
  /** Said after what a plan does. */
  atEnd: (current: string) => `At the end ${current} flies next again.`,
  refused: (memory: string) => `Nothing can be written into ${memory}: no program can send these values.`,
  untouched: (memory: string) => `Nothing was written into ${memory}.`,
  stopped: 'What was not yet written is as it was.',
};

export const backedUp = { title: 'All memories were read, and a backup of each is kept.', advice: '' };

/** All memories of a timer at a glance. */
export const overview = {
  readAll: 'Read and keep all',
  copyTo: 'Copy to…',
  compareWith: (memory: string) => `Compare with ${memory}`,
  readAt: (time: string) => `read ${time}`,
  notCertain: 'Not certain: a write into it was interrupted. Shown as before that write.',
  edited: 'Shown and copied as the timer holds it, without your changes.',
  same: 'They hold the same.',
  differs: (count: number) => `${plural(count, 'value differs', 'values differ')}.`,
};
