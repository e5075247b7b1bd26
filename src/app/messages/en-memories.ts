import { dotted, whole } from './dotted.js';
import { plural } from './plural.js';

/** Which memory flies next, and what is known about the others. */
export const nextFlight = {
  badge: 'flies next',
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
  uncertain: (memory: string) => `It is not known what ${memory} holds`,
  /** Above the two values that a field may have after an interrupted write. */
  either: 'Either',
  or: 'or',
  /** @param current the memory that flies next. */
  lead: (current: string) => `For looking only. You change and write ${current}, which flies next.`,
  look: (memory: string) => `Look at ${memory}`,
  /** Where its reading is shown. */
  again: (memory: string) => `Read ${memory} again`,
  hint: (memory: string, current: string) => `This selects ${memory}, reads it and goes back to ${current}.`,
  fly: (memory: string) => `Make ${memory} fly next`,
  looking: (memory: string) => `Looking at ${memory}`,
  show: (memory: string) => `Show ${memory}`,
  picture: (memory: string) => `Timeline of ${memory}`,
};

/** Jobs over several memories, and the backups. */
export const memories = {
  copyTo: (from: string) => `Copy ${from} to`,
  copy: (from: string, to: string) => `Copy ${from} to ${to}…`,
  restoreAll: (count: number) => `Restore all ${count}…`,
  plans: {
    'back-up': {
      title: 'Read and keep all memories',
      lead: 'The page selects and reads one memory after the other.',
    },
    copy: {
      title: (from: string, to: string) => `Copy ${from} to ${to}`,
      lead: (from: string, to: string) =>
        `${to} will hold the times and positions of ${from}, as read just now. What ${to} holds now is backed up first.`,
    },
    restore: {
      title: 'Restore a backup',
      lead: (names: string, time: string) =>
        `This writes into ${names} what was backed up on ${time}. What is there now is backed up first.`,
    },
  },
  /** Said after what a plan does. */
  atEnd: (current: string) => `At the end ${current} flies next again.`,
  start: { 'back-up': 'Read and keep', copy: 'Copy', restore: 'Restore' },
  stage: (stage: string, memory: string) => `${stage} ${memory}`,
  saved: (count: number) => `${plural(count, 'memory was', 'memories were')} read and kept.`,
  /** “M3: DT 3:00 min → 4:00 min · Motor stop 10.0 s, stays”. */
  figures: (memory: string, figures: readonly string[]) => `${memory}: ${dotted(figures)}`,
  stays: (label: string, value: string) => `${label} ${value}, stays`,
  same: (memory: string) => `${memory} holds all of this already. It is read back and compared.`,
  refused: (memory: string) => `Nothing can be written into ${memory}: no program can send these values.`,
  changes: (count: number) => (count === 0 ? 'no changes' : plural(count, 'change', 'changes')),
  figure: (label: string, value: string) => `${label} ${value}`,
  verified: (memory: string, time: string, figures: readonly string[]) =>
    `${memory} verified ${time} · ${dotted(figures)}`,
  uncertain: (memory: string, open: readonly string[], more: number) =>
    `It is not known what ${memory} holds: ${open.join(', ')}${more > 0 ? `, and ${more} more` : ''}. Do not fly it before it is read.`,
  either: (field: string, one: string, other: string) => `${field} is ${whole(one)} or ${whole(other)}`,
  ends: {
    verified: (memory: string) => `${memory} verified.`,
    untouched: (memory: string) => `Nothing was written into ${memory}.`,
    differs: (memory: string) => `${memory}: the timer did not take every value. Look at it before you fly it.`,
    unknown: (memory: string) => `It is not known what ${memory} holds. Do not fly it before it is read.`,
  },
  again: 'Show the difference again…',
  stopped: { title: 'Stopped.', advice: 'What was not yet written is as it was.' },
};

/** All memories of a timer at a glance. */
export const overview = {
  readAll: 'Read and keep all…',
  fly: 'Make it fly next',
  copyTo: 'Copy to…',
  compareWith: (memory: string) => `Compare with ${memory}`,
  readAt: (time: string) => `read ${time}`,
  or: ' or ',
  notCertain: 'Not certain: a write into it was interrupted. Shown as before that write.',
  edited: 'Shown and copied as the timer holds it, without your changes.',
  same: 'They hold the same.',
  differs: (count: number) => `${plural(count, 'value differs', 'values differ')}.`,
};
