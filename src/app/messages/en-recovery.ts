const plural = (count: number, one: string, many: string): string => `${count} ${count === 1 ? one : many}`;

/** What an earlier job left behind on a timer. */
export const recovery = {
  title: 'An earlier write was interrupted',
  when: (memory: string, time: string) => `It was begun on ${time}, into ${memory}.`,
  nothing: (missing: number) =>
    `The timer holds what it held before: nothing was written, ${plural(missing, 'change is', 'changes are')} missing.`,
  part: (written: number, missing: number) =>
    `The timer holds ${plural(written, 'value', 'values')} of that write; ${plural(missing, 'value is', 'values are')} still as before.`,
  foreign: (count: number) =>
    `The timer holds ${plural(count, 'value', 'values')} that neither that write nor what was there before explains. Is it another timer, or did something else change it?`,
  sure: 'Timers of one kind look alike: go on only if this is the timer of that write.',
  finish: 'Finish it…',
  goBack: 'Go back…',
  leave: 'Leave it as it is',
  otherTimer: 'It is another timer',
  sameTimer: 'It is the same timer: show what was to be written',
  compare: 'Compare',
  before: 'Before',
  goal: 'To be written',
  held: 'Timer holds now',
  elsewhere: (memory: string) =>
    `A write into ${memory} of a timer of this kind was interrupted. What became of it can be seen when ${memory} is current: that is then what flies next.`,
  show: (memory: string) => `Make ${memory} current and look`,
  leftTitle: 'Another memory is current than before',
  left: (home: string, current: string) =>
    `A job over several memories was interrupted: ${current} is current, and would fly next. Before the job it was ${home}.`,
  goHome: (memory: string) => `Make ${memory} current again`,
  unknownMemory: 'an unknown memory',
};

/** Jobs over several memories, and what was kept of them. */
export const memories = {
  title: 'All memories',
  backUp: 'Back up all…',
  copyTo: (from: string) => `Copy ${from} to`,
  copy: (from: string, to: string) => `Copy ${from} to ${to}…`,
  edited: 'Edits that have not been written are not copied.',
  restoreAll: 'Restore all…',
  plans: {
    'back-up': {
      title: 'Back up all memories',
      lead: 'Each memory is made current in turn and read. Then the one that is current now is made current again.',
    },
    copy: {
      title: 'Copy a memory',
      lead: (from: string, to: string) =>
        `${to} will hold the times and positions that ${from} holds now. What ${to} holds is backed up first. Then the memory that is current now is made current again.`,
    },
    restore: {
      title: 'Restore a backup',
      lead: (names: string, time: string) =>
        `${names} will hold what they held on ${time}. What they hold now is backed up first. Then the memory that is current now is made current again.`,
    },
  },
  start: { 'back-up': 'Back up', copy: 'Copy', restore: 'Restore' },
  stage: (stage: string, memory: string) => `${stage} ${memory}`,
  saved: (count: number) => `${plural(count, 'memory was', 'memories were')} read and kept.`,
  verified: (memory: string) => `${memory}: verified.`,
  differs: (memory: string) => `${memory}: not everything was taken.`,
  unknown: (memory: string) => `${memory}: not known what it holds now.`,
  notKept:
    'This browser does not keep them: its storage is full or switched off. They are gone when this page is closed.',
  stopped: 'Stopped. The memory that was current before is current again.',
};

export const backups = {
  title: 'Backups',
  empty: 'Before each write what the timer holds is kept here, without asking.',
  reasons: { write: 'before a write', memories: 'all memories' },
  entry: (timer: string, memory: string) => `${timer}, ${memory}`,
  set: (timer: string, count: number) => `${timer}, ${plural(count, 'memory', 'memories')}`,
  show: 'Show as edits',
  showOf: (memory: string) => `Show ${memory} as edits`,
  remove: 'Delete',
  origin: (time: string, reason: string, simulated: boolean) =>
    simulated ? `${time} · ${reason} · simulated` : `${time} · ${reason}`,
  otherLayout: 'For a timer of another layout.',
};
