import type { TimerErrorCode } from '../../client/index.js';
import type { ConnectionErrorCode } from '../../serial/index.js';
import { unsupportedHere } from './en-browsers.js';

/** One sentence that says what happened, and one that says what to do. */
export interface Said {
  readonly title: string;
  readonly advice: string;
}

/** Why there is no connection. */
export const connection: Record<ConnectionErrorCode, Said> = {
  unsupported: unsupportedHere,
  insecure: {
    title: 'The browser does not let this page use serial ports.',
    advice: 'Open it by its https address. Everything but the connection works here too.',
  },
  policy: {
    title: 'The server of this page forbids serial ports.',
    advice: 'Open this page by its own address, in its own tab. Everything but the connection works here too.',
  },
  'nothing-chosen': {
    title: 'No port was chosen.',
    advice: 'Press Connect again and choose the adapter of the timer. If it is not in the list, the steps below help.',
  },
  'not-allowed': {
    title: 'The browser does not allow serial ports here.',
    advice: 'Allow serial ports for this page in the settings of the browser, then press Connect again.',
  },
  busy: {
    title: 'The adapter does not open.',
    advice:
      'Most often another program has it. Close other programs and tabs that talk to the timer, or unplug the adapter and plug it in again. Then press Connect again.',
  },
  'bad-settings': {
    title: 'The adapter does not take these settings.',
    advice: 'Choose another rate, or let this page find it. Then press Connect again.',
  },
  unplugged: {
    title: 'The adapter is not plugged in.',
    advice: 'Plug it in, then press Connect again.',
  },
  'bad-reply': {
    title: 'Something answered, but not as a timer does.',
    advice: 'Choose another port, or move the infrared head closer and press Connect again.',
  },
  lost: {
    title: 'The connection is gone.',
    advice:
      'The port failed each time it was opened. Unplug the adapter, plug it in again and press Connect. What you typed is kept.',
  },
};

/** Why a job with the timer has ended. */
export const timer: Record<TimerErrorCode, Said> = {
  'no-answer': {
    title: 'The timer did not answer.',
    advice:
      'Is it awake, and the infrared head closer than 20\u00a0cm? Press the switch of the timer briefly and try again. What you typed is kept.',
  },
  'bad-reply': {
    title: 'The answer of the timer cannot be right.',
    advice:
      'Try again. If it happens again: switch Expert on in the settings, open Line and press “Copy report”. Send the report to the maintainers (github.com/sidus-timer/sidus-timer/issues).',
  },
  unstable: {
    title: 'The line is too noisy to trust.',
    advice: 'Too many bytes were damaged. Move the infrared head closer, shade it from the sun, and try again.',
  },
  crowded: {
    title: 'More than one timer seems to answer.',
    advice:
      'Answers came that nobody asked for, and no two readings agreed. Keep other timers and programmers out of the beam, and try again.',
  },
  'other-memory': {
    title: 'The current memory is not the one on the screen.',
    advice: 'Read again before you write.',
  },
  'memory-unknown': {
    title: 'This timer does not say which memory is current.',
    advice:
      'So this page cannot select another memory: it would not know which one to go back to. You can read and write the current one.',
  },
  'memory-left': {
    title: 'The memory that flies next may have changed.',
    advice:
      'This page could not go back to the one that was current. Connect again and make the right memory fly next before you fly.',
  },
  'other-timer': {
    title: 'This is not the timer that answered before.',
    advice: 'This page identifies it and reads it. Look at what it holds before you write.',
  },
  stale: {
    title: 'The timer does not hold what was shown.',
    advice: 'Nothing was written. Look at what it holds now before you write.',
  },
  changed: {
    title: 'The timer does not hold what was read before.',
    advice: 'Something else changed it, or this is another timer. Look at the marked fields before you write again.',
  },
  'stood-still': {
    title: 'This page stood still during the job.',
    advice:
      'The computer slept, or something held the page up. Nothing more was sent: another timer may be there by now. Read again to see what the timer holds.',
  },
  undecided: {
    title: 'It is not certain in which order this timer sends the bytes of a time.',
    advice: 'The times fall. They would rise if the two bytes of each were swapped. Nothing was written.',
  },
  serious: {
    title: 'The checks have found something serious.',
    advice: 'Nothing was written. Look at the checks before you write again.',
  },
  busy: {
    title: 'Something else on this page uses the port.',
    advice: 'Nothing was sent. Disconnect, connect again and try once more. What you typed is kept.',
  },
  'port-lost': {
    title: 'The connection is gone.',
    advice: 'It comes back by itself. If the adapter was unplugged, plug it in again. What you typed is kept.',
  },
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
  'edits-restored': {
    title: 'Your changes are back.',
    advice: 'Connect to the timer to compare them with what it holds, and to write them.',
  },
  'edits-uncertain': {
    title: 'Your changes are back.',
    advice: 'It is not known whether they were written. Connect to the timer and read it before you fly.',
  },
  'edits-kept': {
    title: 'Earlier changes for this memory are back.',
    advice: 'The timer was read and does not hold them. Look at them, then write or undo them.',
  },
  'edits-moved': {
    title: 'The timer holds other values than when you made your changes.',
    advice: 'Your changes are kept and marked. Look at the difference before you write: is this the same timer?',
  },
  'edits-set-aside': {
    title: 'Your changes of the other memory are kept.',
    advice: 'They come back when you read that memory again.',
  },
  'back-same': {
    title: 'The timer is back.',
    advice: 'It holds what it held before. Your changes are as they were.',
  },
  'back-changed': {
    title: 'The timer is back, and holds other values than before.',
    advice: 'The screen shows what it holds now. Something else changed it, or this is another timer.',
  },
  'other-kind': {
    title: 'Another kind of timer is at this port now.',
    advice:
      'The screen shows what it holds. Your changes for the other one are kept. They come back when you read it again.',
  },
  'write-completed': {
    title: 'The interrupted write is complete.',
    advice: 'The timer was read again and holds all that was to be written.',
  },
  'nothing-written': {
    title: 'Nothing was written.',
    advice: 'You stopped before the first value went out. What you typed is kept.',
  },
  'select-unanswered': {
    title: 'The timer did not answer when a memory was selected.',
    advice:
      'It answers other requests. Hold the infrared head closer and try again. If it happens again, this timer may want the request without a correct checksum. You can try that here, and later under “About this timer”.',
  },
  strays: {
    title: 'Answers came that nobody asked for.',
    advice:
      'The page read everything again until two readings agreed. Keep other timers and programmers out of the beam of the infrared head.',
  },
  'made-restored': {
    title: 'Your program is back.',
    advice: 'It is in no timer yet. Connect to a timer to write it.',
  },
  'made-laid': {
    title: 'Your program is loaded over what the timer holds.',
    advice: 'Nothing was written. What differs is marked. Undo shows what the timer holds.',
  },
  'made-put-away': {
    title: 'Your program does not fit this timer.',
    advice: 'It is for another class or layout, or a field has no value yet. The program is kept on this device.',
  },
  unexpected: {
    title: 'Something went wrong in this page.',
    advice: 'Nothing more was sent. Load the page again. What you typed is kept.',
  },
} satisfies Record<string, Said>;
