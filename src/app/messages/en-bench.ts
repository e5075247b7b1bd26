const plural = (count: number, one: string, many: string): string => `${count} ${count === 1 ? one : many}`;

/** Servos and motor moved from the page. */
export const bench = {
  title: 'Bench',
  lead: 'Moves the servos of the timer in front of you.',
  slots: 'Move the servos to',
  previous: 'Previous function',
  next: 'Next function',
  at: (slot: string) => `Servos at ${slot}`,
  atNone: 'It is not known where the servos stand.',
  moveMaybe: (slot: string) => `No answer came. The servos may have moved to ${slot} anyway. Look at the model.`,
  unlocked: 'The motor is unlocked. The propeller may start.',
  unlockMaybe: 'No answer came. The motor may be unlocked anyway. Keep away from the propeller.',
  jumped: 'The timer acknowledged the jump.',
  jumpMaybe: 'No answer came. The timer may have jumped anyway. Look at the model.',
  here: 'servos here',
  waits: 'Not in the timer yet.',
  bring: (slot: string) => `Move the servos to ${slot}`,
  follow: 'Servos follow the positions',
  followHint:
    'First the timer is read and backed up. Then each position that you change where the servos stand is stored in the timer at once, and its servo moves.',
  followingNow: 'Following: a position that you change where the servos stand is stored in the timer at once.',
  starting: 'Reading the timer and keeping a backup.',
  unkept: 'This device could not keep a backup. Without one you cannot bring back later what the timer holds now.',
  followUnkept: 'Follow without a backup',
  stopFollowing: 'Stop following',
  going: 'Go to the function I edit',
  goingHint: 'The servos move there without asking. This switches itself off when following stops.',
  followPending: 'Earlier edits are not sent: they wait for Write.',
  timesWait: 'Times wait for Write.',
  ended: {
    hidden: 'Following has stopped: the page was hidden.',
    job: 'Following has stopped: something else was done with the timer.',
    memory: 'Following has stopped: another memory is current, or may be.',
    unsafe: 'Following has stopped: the safety box is no longer ticked.',
    lost: 'Following has stopped: the connection ended.',
    failed: 'Following has stopped: the timer did not acknowledge a command.',
  },
  endRead: 'The timer has been read since.',
  endUnread: 'The timer has not been read since.',
  tried: (count: number) =>
    count === 0 ? 'Nothing has been tried yet.' : `Tried: ${plural(count, 'position', 'positions')}.`,
  triedAndWaiting: (tried: number, waiting: number) =>
    `${tried} tried in the timer${waiting === 0 ? '' : `, ${plural(waiting, 'waits', 'wait')} for Write`}`,
  decide: 'Keep what was tried, or put back what the timer held before?',
  keep: 'Keep it',
  putBack: 'Put it back…',
  triedOf: (field: string, from: string, to: string) => `${field}: ${from} → ${to}`,
  motor: 'Motor',
  unlock: 'Hold to UNLOCK',
  unlockHold: 'Keep holding',
  unlockHint: 'The propeller may start. Hold the model, keep your hands away from the propeller, then press and hold.',
  experimental: 'Experimental',
  jumpHint: 'Jumps to the function after an early DT. What it does exactly is not documented: servos may move.',
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
  dt: (time: string) => `DT ${time}`,
  readAt: (time: string) => `read ${time}`,
  or: ' or ',
  notCertain: 'Not certain: a write into it was cut off. Shown as it was before that write.',
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
