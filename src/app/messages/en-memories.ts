const plural = (count: number, one: string, many: string): string => `${count} ${count === 1 ? one : many}`;

/** Which memory flies next, and what is known of the others. */
export const nextFlight = {
  badge: 'flies next',
  named: (memory: string) => `${memory}, flies next`,
  other: (memory: string) => `${memory} flies next.`,
  will: (memory: string) => `${memory} will fly next.`,
  /** While there is no connection. */
  last: (memory: string) =>
    `${memory} was current when the timer was heard last: it flies next unless something else has changed it.`,
  original: (original: string) => `At connect it was ${original}.`,
  originalUnknown: 'Which one it was at connect is not known.',
  unknown: 'It is not known which memory flies next.',
  asked: (memory: string) => `${memory} was selected last.`,
  back: (original: string) => `Back to ${original}`,
  leaving: {
    title: 'Before you disconnect',
    back: (original: string) => `Back to ${original} and disconnect`,
    disconnect: 'Disconnect',
    stay: 'Stay connected',
    as: (memory: string) => `${memory} flies next, as at connect.`,
    failed: (original: string) => `It was not possible to go back to ${original}. The timer is still connected.`,
  },
};

/** A memory that is not the current one, by what was last read of it. */
export const look = {
  read: (memory: string, time: string) => `${memory}, read ${time}`,
  notRead: (memory: string) => `${memory} has not been read`,
  uncertain: (memory: string) => `It is not known what ${memory} holds`,
  /** Above the two values that a field may have since a write was cut off. */
  either: 'Either',
  or: 'or',
  /** @param current the memory that flies next. */
  lead: (current: string) => `Shown to be looked at. What you edit and write is ${current}, which flies next.`,
  look: (memory: string) => `Look at ${memory}`,
  hint: (memory: string, current: string) => `Looking selects ${memory}, reads it and goes back to ${current}.`,
  noWayBack: 'This timer does not say which memory is current: nobody could tell which one to go back to.',
  fly: (memory: string) => `Make ${memory} fly next`,
  looking: (memory: string) => `Looking at ${memory}`,
  show: (memory: string) => `Show ${memory}`,
  tableCaption: (memory: string) => `What was read of ${memory}`,
  picture: (memory: string) => `Timeline of ${memory}`,
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
        `${to} will hold the times and positions that ${from} holds, by a reading just now. What ${to} holds is backed up first. Then the memory that is current now is made current again.`,
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
  /** “M3: DT 3:00 min → 4:00 min · Motor stop 10.0 s, stays”. */
  figures: (memory: string, figures: readonly string[]) => `${memory}: ${figures.join(' · ')}`,
  stays: (label: string, value: string) => `${label} ${value}, stays`,
  same: (memory: string) => `${memory} holds all of this already. It is read back and compared.`,
  changes: (count: number) => (count === 0 ? 'no changes' : plural(count, 'change', 'changes')),
  figure: (label: string, value: string) => `${label} ${value}`,
  verified: (memory: string, time: string, figures: readonly string[]) =>
    `${memory} verified ${time} · ${figures.join(' · ')}`,
  uncertain: (memory: string, open: readonly string[], more: number) =>
    `It is not known what ${memory} holds: ${open.join(', ')}${more > 0 ? `, and ${more} more` : ''}. Do not fly it before it is read.`,
  either: (field: string, one: string, other: string) => `${field} is ${one} or ${other}`,
  ends: {
    verified: (memory: string) => `${memory} verified.`,
    untouched: (memory: string) => `Nothing was written into ${memory}.`,
    differs: (memory: string) => `${memory}: not everything was taken. Look at it before you fly it.`,
    unknown: (memory: string) => `It is not known what ${memory} holds. Do not fly it before it is read.`,
  },
  again: 'Show the difference again…',
  notKept:
    'This browser does not keep them: its storage is full or switched off. They are gone when this page is closed.',
  stopped: { title: 'Stopped.', advice: 'What was not written yet is as it was.' },
};
