import type { LineErrorKind } from '../../client/index.js';
import type { CodecErrorCode, CommandName, RejectionReason } from '../../protocol/index.js';
import { plural } from './plural.js';

const names: Record<CommandName, string> = {
  GETTIMERS: 'Read times',
  SETTIMERS: 'Write times',
  GETSERVOPOS: 'Read positions',
  SETSERVO: 'Write a position',
  MOVETOFUNC: 'Move servos',
  GETSWVER: 'Identify',
  UNLOCK: 'Unlock motor',
  JUMP2: 'Jump',
  GETMEMORY: 'Which memory',
  SETMEMORY: 'Select memory',
  GETLOWRPM: 'Read idle throttle',
  SETLOWRPM: 'Write idle throttle',
};

/** Bytes that belong to no frame. */
const rejected: Record<RejectionReason, string> = {
  noise: 'Damaged: noise',
  length: 'Damaged: impossible length',
  terminator: 'Damaged: no end where it should be',
  checksum: 'Damaged: wrong checksum',
  silence: 'Damaged: cut off',
};

/** An error of the port, by the name that the makers of ports have for it. */
const error: Record<LineErrorKind, string> = {
  framing: 'Line error: framing',
  parity: 'Line error: parity',
  break: 'Line error: break',
  overrun: 'Line error: overrun, bytes were lost',
  other: 'Line error of another kind',
};

const noText = 'Its content cannot be read.';
const noValue = 'A value in it cannot be right.';

/** Why the content of a frame has no text. */
const unreadable: Record<CodecErrorCode, string> = {
  'wrong-length': 'Its content is longer or shorter than it should be.',
  'unknown-command': 'What it means is not known.',
  'unexpected-reply': 'It answers another request.',
  'bad-identity': 'What it says of the timer cannot be right.',
  'identity-needed': 'It can be read once the timer has said what it is.',
  'out-of-range': noValue,
  'not-an-integer': noValue,
  'wrong-count': noValue,
  'wrong-type': noValue,
  'unknown-word': noText,
  'bad-capture': noText,
  'bad-file': noText,
  'bad-link': noText,
  'newer-version': noText,
  'too-large': noText,
  duplicate: noText,
};

/** The log of the line. */
export const line = {
  empty: 'Nothing to show.',
  unused: 'Nothing on the line yet. You can also load a recording and replay it as a timer.',
  all: 'Everything',
  out: 'To the timer',
  in: 'From the timer',
  damaged: 'Damaged',
  request: (name: string, letters: string) => `${name} · ${letters}`,
  reply: (name: string, letters: string) => `${name}, reply · ${letters}`,
  echo: (name: string, letters: string) => `${name}, echo · ${letters}`,
  unknown: (letter: string) => `Unknown letter ${letter}`,
  names,
  rejected,
  error,

  position: (slot: string, servo: string, steps: number) => `${slot}, ${servo}: ${steps} steps`,
  motorStop: (time: string) => `motor stop ${time}`,
  reserved: (time: string) => `reserved ${time}`,
  functions: (times: readonly string[]) => `functions ${times.join(' ')}`,
  identity: (name: string, firmware: string, functions: number, memories: number, servos: number) =>
    `${name}, firmware ${firmware}, ${plural(functions, 'function', 'functions')} and DT, ${plural(memories, 'memory', 'memories')}, ${plural(servos, 'servo', 'servos')}`,
  memoryUnsaid: 'It does not say which.',
  idleThrottle: (value: number) => `${value}, unit unknown`,
  idleThrottleUnsaid: 'It gives no value.',
  acknowledged: 'Acknowledged.',
  unreadable,

  goOn: 'Go on',
  came: (number: number) => `Paused. ${plural(number, 'entry', 'entries')} since.`,
  clear: 'Clear',
  copyByHand: 'The browser does not let this page copy. Copy it from here.',
  unidentified: 'unknown',
  load: 'Load…',
  filter: 'Show',
  searchHint: 'name or hex',
  counts: (out: number, incoming: number, damaged: number, errors: number) => [
    `${out} to the timer`,
    `${incoming} from the timer`,
    `${damaged} damaged`,
    plural(errors, 'line error', 'line errors'),
  ],
  recording: (name: string, entries: number) => `${name}: a recording of ${plural(entries, 'entry', 'entries')}.`,
  replay: 'Replay it as a timer',
  cannotReplay: 'It cannot be replayed: the timer never says what it is.',
  back: 'Back to the live line',
  /** @param line of the file, counted from 1; null where no line is to blame. */
  noRecording: (line: number | null) =>
    line === null
      ? 'This file is not a recording.'
      : `Line ${line}: expected a time in seconds, > or <, and bytes in hex.`,

  send: {
    title: 'Send a frame by hand',
    lead: 'The page adds length and checksum.',
    bytes: 'Letter and data, in hex',
    faults: {
      hex: 'Type two hex digits for each byte, 0 to 9 or A to F.',
      'too-long': 'A frame carries at most 252 bytes.',
    },
    preview: 'Goes out as',
    send: 'Send…',
    confirmTitle: 'Send this frame to the timer?',
    danger:
      'Servos may move, the propeller may start, and what the timer holds may change. The timer is read again afterwards.',
    confirm: 'Yes, send it once',
    sending: 'Sending',
    answered: 'Answered:',
    unanswered: 'No reply came. What the frame asked for may have happened anyway.',
  },
  copyReport: 'Copy report',
};
