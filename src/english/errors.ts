import type { TimerErrorCode } from '../client/index.js';
import type { ConnectionErrorCode } from '../serial/index.js';

const TIMER: Readonly<Record<TimerErrorCode, string>> = {
  'no-answer': 'The timer does not answer. It may have obeyed all the same.',
  'bad-reply': 'The answers of the timer cannot be right. It may have obeyed all the same.',
  unstable: 'The line damages too many bytes. Hold the head closer, out of the sun.',
  crowded: 'Answers came that nobody asked for. Is a second timer in the beam?',
  'other-memory': 'Another memory is current than the one that was read.',
  'memory-unknown': 'The timer does not say which memory is current, so no other was selected.',
  'memory-left': 'The memory that was current before is not current again. Select it before you fly.',
  'other-timer': 'Another kind of timer answers than before. Nothing more was sent.',
  stale: 'The timer holds something else than was read before. Nothing was written.',
  changed: 'Something else changed the timer meanwhile, or it is another timer. Read it again.',
  'stood-still': 'The computer stood still for a while, so nothing more was sent. Read the timer again.',
  'too-slow': 'The timer answers too slowly to tell its answers apart. It may have obeyed all the same.',
  undecided: 'The order of the bytes of times is not known. Compare with the handheld programmer first.',
  serious: 'This program may cost a model. Nothing was sent.',
  busy: 'Somebody else uses the port. Nothing was sent.',
  'port-lost': 'The port was unplugged or closed.',
  aborted: 'Stopped.',
  closed: 'The connection was closed.',
};

const CONNECTION: Readonly<Record<ConnectionErrorCode, string>> = {
  unsupported: 'This browser has no serial ports. Use Chrome, Edge, Opera or Firefox.',
  insecure: 'Serial ports need a page that was loaded over https.',
  policy: 'The server of this page forbids serial ports.',
  'nothing-chosen': 'No port was chosen.',
  'not-allowed': 'The browser does not allow serial ports here.',
  busy: 'The port does not open. Does another program use it?',
  'bad-settings': 'The port does not accept these settings.',
  unplugged: 'The port is unplugged.',
  'bad-reply': 'Something answers, but it is no timer.',
  lost: 'The port was unplugged, or the connection to it broke off.',
};

/**
 * What to tell a pilot of an error of this package. Of any other error, and of a `CodecError`, whose message names the
 * value, it is the message.
 * @param error also what its `toJSON()` gave.
 */
export function errorText(error: unknown): string {
  const { name, code, message } = Object(error) as { name?: string; code?: string; message?: string };
  const texts: Readonly<Record<string, string>> = { TimerError: TIMER, ConnectionError: CONNECTION }[name ?? ''] ?? {};
  return texts[code ?? ''] ?? message ?? String(error);
}
