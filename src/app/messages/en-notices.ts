import type { TimerErrorCode } from '../../client/index.js';
import type { ConnectionErrorCode } from '../../serial/index.js';
import { restWorks, unsupportedHere } from './en-browsers.js';
import { help } from './en-help.js';
import { keeping } from './en-keeping.js';
import { link } from './en-link.js';
import { backedUp } from './en-memories.js';
import { write } from './en-write.js';

/** One sentence that says what happened, and one that says what to do. */
export interface Said {
  readonly title: string;
  readonly advice: string;
}

/** For a port that is not there, or fails each time. */
const unreachable: Said = {
  title: 'The adapter cannot be reached.',
  advice: 'Unplug it, plug it in again and press Connect. What you typed is kept.',
};

const crowded: Said = {
  title: 'More than one timer may be in the beam.',
  advice: 'Keep other timers and programmers away, and read again.',
};

const lookFirst = 'The page reads it. Look at what it holds before you write.';

const lookAgain = 'Nothing was written. Look at what a write would change now.';

const back = 'Your changes are back.';

const moved: Said = {
  title: 'The timer holds other values than before.',
  advice:
    'Something else changed it, or this is another timer. Your changes are kept: look at the difference before you write.',
};

/** How the timer writes its times: the question that no reading can answer. */
export const byteOrder = {
  title: 'The times of this timer fall from row to row.',
  advice:
    'They would rise if the two bytes of each time were swapped. Compare with what you know of the timer, and choose before you write.',
  keep: 'They are right as shown',
  exchange: 'Swap them and read again',
};

const notAllowed = 'The browser does not allow serial ports here.';

/** Why there is no connection. */
export const connection: Record<ConnectionErrorCode, Said> = {
  unsupported: unsupportedHere,
  insecure: { title: notAllowed, advice: restWorks },
  policy: { title: 'The server of this page forbids serial ports.', advice: restWorks },
  'nothing-chosen': {
    title: 'No adapter was chosen.',
    advice: 'Press Connect and choose the adapter. If it is not in the list, the steps below help.',
  },
  'not-allowed': {
    title: notAllowed,
    advice: 'Allow serial ports for this page in the settings of the browser, then press Connect again.',
  },
  busy: {
    title: 'The adapter does not open.',
    advice: 'Most often another program or tab has it. Close that, then press Connect again.',
  },
  'bad-settings': {
    title: 'The adapter does not take these settings.',
    advice: help.steps['usual-settings'],
  },
  unplugged: unreachable,
  'bad-reply': link.heard,
  lost: unreachable,
};

/** Why a job with the timer has ended. */
export const timer: Record<TimerErrorCode, Said> = {
  'no-answer': {
    title: 'The timer did not answer.',
    advice:
      'Press the switch of the timer briefly, hold the head closer than 20\u00a0cm, and try again. What you typed is kept.',
  },
  'bad-reply': {
    title: 'The answer of the timer cannot be right.',
    advice: 'Try again. If it happens again: Settings, Expert, Line, “Copy report”.',
  },
  unstable: {
    title: 'The line is too noisy to trust.',
    advice: 'Hold the infrared head closer, out of the sun, and try again.',
  },
  crowded,
  'other-memory': {
    title: 'The current memory is not the one on the screen.',
    advice: 'Read again before you write.',
  },
  'memory-unknown': {
    title: 'This timer does not say which memory is current.',
    advice: 'So this page cannot look at another memory and go back. You can read and write the current one.',
  },
  'memory-left': {
    title: 'The memory that flies next may have changed.',
    advice:
      'This page could not go back to the one that was current. Connect again and make the right memory fly next before you fly.',
  },
  'other-timer': { title: 'This is not the timer that answered before.', advice: lookFirst },
  stale: { title: 'The timer does not hold what was shown.', advice: lookAgain },
  changed: moved,
  'stood-still': {
    title: 'This page stood still during the job.',
    advice: 'Nothing more was sent: another timer may be there by now. Read again.',
  },
  'too-slow': {
    title: 'This timer answers too slowly.',
    advice:
      'Its answers take more than 3 seconds, so this page cannot tell which belongs to which question. Nothing more was sent. Try another adapter, or a cable in place of Bluetooth.',
  },
  undecided: byteOrder,
  serious: { title: 'The checks have found something serious.', advice: lookAgain },
  busy: {
    title: 'Something on this page or computer uses the adapter.',
    advice: 'Nothing was sent. Disconnect and connect again. What you typed is kept.',
  },
  'port-lost': link.lost,
  aborted: { title: 'Stopped.', advice: 'Read again to see what the timer holds.' },
  closed: { title: 'Disconnected.', advice: 'Press Connect to go on. What you typed is kept.' },
};

/** Replies that are no noise, which is random. */
export const alike = {
  title: (request: string) => `Each reply to ${request} is damaged in the same way.`,
  advice:
    'That is not noise: the timer or its adapter forms these replies in a way that is not known. With Expert on in the settings, open Line and press “Copy report”. Send the report to the maintainers (github.com/sidus-timer/sidus-timer/issues).',
  /** What could be read although the rest could not. */
  part: (values: string) => `For looking only, all else is not known: ${values}.`,
};

/** Messages that are not about errors. */
export const notes = {
  back: { title: back, advice: 'Compare them with what the timer holds, then write or undo them.' },
  'back-uncertain': {
    title: back,
    advice: 'It is not known whether they were written. Connect to the timer and read it before you fly.',
  },
  moved,
  'timer-moved': moved,
  kept: {
    title: 'Your changes are kept on this device.',
    advice:
      'They do not fit what was read now. They come back when you read that memory again; the start lists them, too.',
  },
  'other-kind': { title: 'Another kind of timer is there now.', advice: lookFirst },
  'write-completed': {
    title: 'The interrupted write is complete.',
    advice: 'The timer was read again and holds all that was to be written.',
  },
  'nothing-written': { title: write.refused, advice: '' },
  'backed-up': backedUp,
  'not-backed-up': { title: write.unkept.title, advice: keeping.notKept },
  'select-unanswered': {
    title: 'The timer did not answer when a memory was selected.',
    advice: 'It answers other requests. Try again, or try it without a correct checksum.',
  },
  strays: crowded,
  'made-laid': {
    title: 'Your program is loaded over what the timer holds.',
    advice: 'Nothing was written. What differs is marked. Undo shows what the timer holds.',
  },
  unexpected: {
    title: 'Something went wrong in this page.',
    advice: 'Nothing more was sent. Load the page again. What you typed is kept.',
  },
} satisfies Record<string, Said>;
