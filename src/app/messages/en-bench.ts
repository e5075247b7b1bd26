const plural = (count: number, one: string, many: string): string => `${count} ${count === 1 ? one : many}`;

/** Servos and motor moved from the page. */
export const bench = {
  title: 'Bench',
  lead: 'Moves the servos of the timer in front of you.',
  columns: 'Move the servos to',
  previous: 'Previous function',
  next: 'Next function',
  at: (column: string) => `Servos at ${column}`,
  atNone: 'Where the servos stand is not known here.',
  moveMaybe: (column: string) =>
    `No answer came: the servos may have moved to ${column} all the same. Look at the model.`,
  unlocked: 'The motor is unlocked. The propeller may start.',
  unlockMaybe: 'No answer came: the motor may be unlocked all the same. Keep away from the propeller.',
  jumped: 'The jump was acknowledged.',
  jumpMaybe: 'No answer came: the timer may have jumped all the same. Look at the model.',
  follow: 'Servos follow the positions',
  followHint: 'Each position that you change is stored in the timer at once. Before that it is read and backed up.',
  followingNow: 'Following: each change is stored in the timer at once.',
  stopFollowing: 'Stop following',
  followPending: 'Edits from before are not sent: they wait for Write.',
  tried: (count: number) =>
    count === 0 ? 'Nothing has been tried yet.' : `Tried: ${plural(count, 'position', 'positions')}.`,
  decide: 'Keep what was tried, or put back what the timer held before?',
  keep: 'Keep it',
  putBack: 'Put it back…',
  triedOf: (field: string, from: string, to: string) => `${field}: ${from} → ${to}`,
  motor: 'Motor',
  unlock: 'Hold to UNLOCK',
  unlockHold: 'Keep holding',
  unlockHint: 'The propeller may start. Hold the model, keep hands away, then press and hold.',
  experimental: 'Experimental',
  jumpHint: 'Jumps to the function after an early DT. What it does is not documented: servos may move.',
  jump: 'Jump…',
  jumpSure: 'Send the jump now',
  cancel: 'Cancel',
  notConnected: 'Connect to a timer to move its servos.',
};

/** All memories of a timer at a glance. */
export const overview = {
  title: 'Memories side by side',
  empty: 'Read all memories to see them here side by side.',
  readAll: 'Read all…',
  current: 'current',
  dt: (time: string) => `DT ${time}`,
  pick: (memory: string) => `Make ${memory} current`,
  edited: 'as the timer holds it, without your edits',
  from: 'Memory',
  to: 'compared with',
  compared: 'Comparison',
  picture: (first: string, second: string) => `Timeline of ${first} and ${second}`,
  same: 'They hold the same.',
  differs: (count: number) => `${plural(count, 'value differs', 'values differ')}.`,
};

const names = { system: 'System', light: 'Light', dark: 'Dark', sun: 'Sun' };

/** How the page looks. */
export const theme = { title: 'Colours', names };
