import { plural } from './plural.js';

/** Moving servos and motor from the page. */
export const bench = {
  slots: 'Move to',
  elsewhere: (memory: string) => `Servos and motor work with ${memory}, which flies next. Show ${memory} to move them.`,
  trim: (slot: string) => `Trim at ${slot}`,
  at: (slot: string) => `Servos at ${slot}`,
  atNone: 'It is not known where the servos stand.',
  moveMaybe: 'No answer came. The servos may have moved anyway. Look at the model.',
  unlocked: 'The motor is unlocked. The propeller may start.',
  unlockMaybe: 'No answer came. The motor may be unlocked anyway. Keep away from the propeller.',
  jumped: 'The timer acknowledged the jump.',
  here: 'servos here',
  /** A change that no servo follows: it is not in the timer. */
  waits: 'Waits for Write.',
  bring: (slot: string) => `Move the servos to ${slot}`,
  follow: 'Servos follow the positions',
  followHint:
    'First the page reads the timer and keeps a backup. Then each position that you change where the servos stand is stored at once, and its servo moves.',
  followingNow: 'Following: a position that you change where the servos stand is stored at once.',
  stopFollowing: 'Stop following',
  followPending: 'Earlier changes wait for Write.',
  ended: {
    over: 'The servos no longer follow.',
    memory: 'The servos no longer follow: another memory is current, or may be.',
    strayed:
      'Another memory became current while the servos followed. It may have taken some of the positions: look at all of it before you fly it.',
    unlike: 'The servos no longer follow: the timer did not do what it acknowledged.',
    failed: 'The servos no longer follow: the timer did not answer.',
  },
  notTaken: (field: string, wanted: string, held: string) => `${field} holds ${held}, not ${wanted}.`,
  /** @param more how many there are besides those that are named. */
  beside: (named: readonly string[], more: number) =>
    `Changed beside it: ${named.join('; ')}${more === 0 ? '' : `; and ${plural(more, 'more value', 'more values')}`}.`,
  endUnread: 'The timer has not been read since then.',
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
  unlock: 'Hold to UNLOCK',
  unlockHold: 'Keep holding',
  unlockHint: 'The propeller may start. Hold the model, keep your hands away from the propeller, then press and hold.',
  experimental: 'Experimental',
  jumpHint: 'Jumps to the function after an early DT. Its exact effect is not documented: servos may move.',
  jump: 'Jump…',
  jumpSure: 'Send the jump now',
};
