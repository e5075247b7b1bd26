import { plural } from './plural.js';

/** Moving servos and motor from the page. */
export const bench = {
  lead: 'Moves the servos of the timer in front of you.',
  slots: 'Move to',
  grid: 'What the timer holds for each function',
  /** The position in the timer, and the one that waits. */
  pending: (held: string, wanted: string) => `${held} → ${wanted}`,
  trim: (slot: string) => `Trim at ${slot}`,
  step: {
    down: (field: string) => `Step down ${field}`,
    up: (field: string) => `Step up ${field}`,
    signs: { down: '−', up: '+' },
  },
  trimFollows: 'Each step is stored in the timer at once, and its servo moves.',
  trimWaits: 'What you change waits for Write. Let the servos follow to see it at once.',
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
    'First the page reads the timer and keeps a backup. Then you change a position of the function where the servos stand: the timer stores it at once, and its servo moves.',
  followingNow:
    'Following: when you change a position of the function where the servos stand, the timer stores it at once.',
  followingAt: (slot: string) => `Following at ${slot}: change a position there, and the timer stores it at once.`,
  starting: 'Reading the timer and keeping a backup.',
  unkept: 'This device could not keep a backup. Without it you cannot bring back what the timer holds now.',
  followUnkept: 'Follow without a backup',
  stopFollowing: 'Stop following',
  followPending: 'Earlier edits are not sent: they wait for Write.',
  timesWait: 'Times wait for Write.',
  ended: {
    hidden: 'Following has stopped: the page was hidden.',
    job: 'Following has stopped: something else was done with the timer.',
    memory: 'Following has stopped: another memory is current, or may be.',
    unsafe: 'Following has stopped: the safety box is no longer ticked.',
    lost: 'Following has stopped: the connection ended.',
    strayed:
      'Another memory became current while the servos followed. It may have taken some of the positions: look at all of it before you fly it.',
    unlike: 'Following has stopped: the timer did not do what it acknowledged.',
    failed: 'Following has stopped: the timer did not answer.',
  },
  notTaken: (field: string, wanted: string, held: string) => `${field} holds ${held}, not ${wanted}.`,
  /** @param more how many there are besides those that are named. */
  beside: (named: readonly string[], more: number) =>
    `Changed beside it: ${named.join('; ')}${more === 0 ? '' : `; and ${plural(more, 'more value', 'more values')}`}.`,
  endRead: 'The timer has been read since then.',
  endUnread: 'The timer has not been read since then.',
  tried: (count: number) =>
    count === 0 ? 'Nothing has been tried yet.' : `Tried: ${plural(count, 'position', 'positions')}.`,
  /** @param more how many there are besides those that are named. */
  triedHere: (named: readonly string[], more: number) =>
    `Tried: ${named.join('; ')}${more === 0 ? '' : `; and ${plural(more, 'more position', 'more positions')}`}.`,
  triedAndWaiting: (tried: number, waiting: number) =>
    `${tried} tried in the timer${waiting === 0 ? '' : `, ${plural(waiting, 'waits', 'wait')} for Write`}`,
  /** In a timer that is not connected. */
  triedIn: (memory: string) => `Positions were tried in ${memory}.`,
  decide: 'Keep what was tried, or put back what the timer held before?',
  keep: 'Keep it',
  putBack: 'Put it back…',
  triedOf: (field: string, from: string, to: string) => `${field}: ${from} → ${to}`,
  motor: 'Motor',
  throttle: (unit: string) => `${unit.charAt(0).toUpperCase()}${unit.slice(1)}. What you change waits for Write.`,
  unlock: 'Hold to UNLOCK',
  unlockHold: 'Keep holding',
  unlockHint: 'The propeller may start. Hold the model, keep your hands away from the propeller, then press and hold.',
  experimental: 'Experimental',
  jumpHint: 'Jumps to the function after an early DT. Its exact effect is not documented: servos may move.',
  jump: 'Jump…',
  jumpSure: 'Send the jump now',
  notConnected: 'Connect to a timer to move its servos.',
};
