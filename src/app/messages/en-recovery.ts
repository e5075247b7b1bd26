import { plural } from './plural.js';

/** What an earlier job left behind on a timer. */
export const recovery = {
  title: 'An earlier write was interrupted.',
  when: (memory: string, time: string) => `A write into ${memory} began on ${time}.`,
  nothing: (missing: number) =>
    `The timer holds what it held before: nothing was written, ${plural(missing, 'change is', 'changes are')} missing.`,
  part: (written: number, missing: number) =>
    `The timer holds ${plural(written, 'value', 'values')} of that write; ${plural(missing, 'value is', 'values are')} still as before.`,
  foreign: (count: number) =>
    `${plural(count, 'value', 'values')} in the timer ${count === 1 ? 'is' : 'are'} neither old nor from that write. Is it another timer, or did something else change it?`,
  sure: 'This page cannot tell timers of one kind apart. Go on only if this is the timer of that write.',
  finish: 'Finish the write…',
  goBack: 'Write the old values back…',
  leave: 'Leave it as it is',
  otherTimer: 'It is another timer',
  sameTimer: 'It is the same timer: show what was to be written',
  compare: 'Compare',
  before: 'Before',
  elsewhere: (memory: string) =>
    `A write into ${memory} of a timer of this kind was interrupted. Read ${memory} to see what it holds.`,
  left: (original: string, current: string) =>
    `Work on the memories was interrupted. Now ${current} flies next. Before that it was ${original}.`,
  /** By a note of this page alone: nobody has asked the timer since. */
  mayFly: (memory: string) => `${memory} may fly next: selecting it was interrupted.`,
  mayNotFly: (original: string) =>
    `Work on the memories was interrupted. Another memory than ${original} may fly next.`,
  unknownMemory: 'an unknown memory',
};

export const backups = {
  title: 'Backups',
  empty: 'Before each write, this page keeps here what the timer holds.',
  reasons: { write: 'before a write', memories: 'all memories' },
};
