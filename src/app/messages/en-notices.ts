import type { TimerErrorCode } from '../../client/index.js';
import type { ConnectionErrorCode } from '../../serial/index.js';
import { unsupportedHere } from './en-browsers.js';

/** A sentence that says what happened, and one that says what to do. */
export interface Said {
  readonly title: string;
  readonly advice: string;
}

/** Why there is no connection. */
export const connection: Record<ConnectionErrorCode, Said> = {
  unsupported: unsupportedHere,
  insecure: {
    title: 'The browser withholds serial ports from this page.',
    advice: 'Open it by its https address. Everything but the connection works here too.',
  },
  policy: {
    title: 'The server of this page forbids serial ports.',
    advice: 'Open its own address in a tab of its own. Everything but the connection works here too.',
  },
  'nothing-chosen': {
    title: 'No port was chosen.',
    advice: 'Click Connect again and pick the adapter of the timer; if it is not in the list, the steps below help.',
  },
  'not-allowed': {
    title: 'The browser does not allow serial ports here.',
    advice: 'Allow serial ports for this page in the settings of the browser, then click Connect again.',
  },
  busy: {
    title: 'The port cannot be opened.',
    advice:
      'Most often something else has it. Close other programs and tabs that talk to the timer, or plug the adapter in again, then click Connect again.',
  },
  'bad-settings': {
    title: 'The adapter does not take these settings.',
    advice: 'Choose another rate, or leave the rate to be found, then connect again.',
  },
  unplugged: {
    title: 'The adapter is not plugged in.',
    advice: 'Plug it in, then click Connect again.',
  },
  'bad-reply': {
    title: 'Something answered, but not as a timer does.',
    advice: 'Choose another port, or move the infra-red head closer and click Connect again.',
  },
  lost: {
    title: 'The connection is gone.',
    advice:
      'The port failed again and again, each time it was opened. Plug the adapter in again and click Connect: what you typed is kept.',
  },
};

/** Why a job on the wire has ended. */
export const timer: Record<TimerErrorCode, Said> = {
  'no-answer': {
    title: 'The timer did not answer.',
    advice: 'Is it awake, and closer than 20 cm? Press its switch briefly and try again. What you typed is kept.',
  },
  'bad-reply': {
    title: 'The timer answered something that cannot be.',
    advice: 'Try again. If it comes again, copy the line below and tell the maintainers.',
  },
  unstable: {
    title: 'The line is too noisy to be believed.',
    advice: 'Too much came damaged. Move the infra-red head closer, shade it from the sun, and try again.',
  },
  crowded: {
    title: 'More than one timer seems to answer.',
    advice:
      'Answers came that nobody asked for, and no two readings agreed. Keep other timers and programmers out of the beam, and try again.',
  },
  'other-memory': {
    title: 'Another memory is current than the one on the screen.',
    advice: 'Read again before you write.',
  },
  'memory-unknown': {
    title: 'This timer does not say which memory is current.',
    advice:
      'Other memories are not selected: nobody could tell which one to come back to. The current one can be read and written.',
  },
  'memory-left': {
    title: 'Another memory may be current now than before.',
    advice:
      'The timer could not be set back to it, and would fly with the other one. Connect again and select the right memory before you fly.',
  },
  'other-timer': {
    title: 'Another timer answers than before.',
    advice: 'It is asked what it is, and read. Look at what it holds before you write.',
  },
  stale: {
    title: 'The timer holds something else than was shown.',
    advice: 'Nothing was written. Look at what it holds now before you write.',
  },
  changed: {
    title: 'The timer holds other values than were read.',
    advice: 'Something else changed it, or this is another timer. Look at the marked fields before you write again.',
  },
  undecided: {
    title: 'It is not certain how this timer counts its times.',
    advice: 'They fall as they are read, and would rise with their bytes exchanged. Nothing was written.',
  },
  'port-lost': {
    title: 'The connection is gone.',
    advice: 'It comes back by itself. If the adapter was unplugged, plug it in again. What you typed is kept.',
  },
  aborted: { title: 'Stopped.', advice: 'Read again to see what the timer holds.' },
  closed: { title: 'Disconnected.', advice: 'Click Connect to go on. What you typed is kept.' },
};

/** What there is to say beside errors. */
export const notes = {
  'edits-restored': {
    title: 'Your edits are back.',
    advice: 'Connect to the timer to compare them with what it holds, and to write them.',
  },
  'edits-uncertain': {
    title: 'Your edits are back.',
    advice: 'It is not known whether they were written. Connect to the timer and read it before you fly.',
  },
  'edits-kept': {
    title: 'Earlier edits for this memory are back.',
    advice: 'The timer was read and does not hold them. Take a look, then write or undo them.',
  },
  'edits-moved': {
    title: 'The timer holds something else than when you made your edits.',
    advice: 'Your edits are kept and marked. Look at the difference before you write: is this the same timer?',
  },
  'edits-set-aside': {
    title: 'Your edits of the other memory are kept.',
    advice: 'They come back when you read that memory again.',
  },
  'back-same': {
    title: 'The timer is back.',
    advice: 'It holds what it held before. Your edits are as they were.',
  },
  'back-changed': {
    title: 'The timer is back, and holds other values than before.',
    advice: 'The screen shows what it holds now. Something else changed it, or this is another timer.',
  },
  'other-kind': {
    title: 'Another kind of timer is at this port now.',
    advice: 'The screen shows what it holds. Edits for the other one are kept until it is read again.',
  },
  'write-completed': {
    title: 'The interrupted write is complete.',
    advice: 'The timer was read afresh and holds all that was to be written.',
  },
  'nothing-written': {
    title: 'Nothing was written.',
    advice: 'You stopped before the first value went out. What you typed is kept.',
  },
  'select-unanswered': {
    title: 'The timer did not take the choice of memory.',
    advice:
      'It answers other requests. Hold the head closer and try again. If it comes again, it may want this request without a true checksum: that can be tried here, and stands under “About this timer”.',
  },
  strays: {
    title: 'Answers came that nobody asked for.',
    advice:
      'All was read again until two readings agreed. Keep other timers and programmers out of the beam of the infra-red head.',
  },
  'taken-over': {
    title: 'Another tab of this program has taken the port over.',
    advice: 'What you typed here is kept.',
  },
  'not-kept': {
    title: 'This browser does not keep what you type.',
    advice: 'Its storage is full or switched off. Write to the timer before you close the page.',
  },
  unexpected: {
    title: 'Something went wrong in this program.',
    advice: 'Nothing more was sent. Load the page again; what you typed is kept.',
  },
} satisfies Record<string, Said>;
