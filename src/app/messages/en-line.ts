import type { LineErrorKind } from '../../client/index.js';
import type { CodecErrorCode, Command, CommandName, RejectionReason } from '../../protocol/index.js';
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

const rejected: Record<RejectionReason, string> = {
  noise: 'Noise',
  length: 'Damaged: length',
  terminator: 'Damaged: end',
  checksum: 'Damaged: checksum',
  silence: 'Cut off',
};

const rejectedMeaning: Record<RejectionReason, string> = {
  noise: 'These bytes belong to no frame.',
  length: 'A frame begins here, but its length is impossible.',
  terminator: 'A frame begins here, but does not end where its length says.',
  checksum: 'The checksum of this frame does not fit its bytes.',
  silence: 'A frame begins here, but the rest of it never came.',
};

const errors: Record<LineErrorKind, string> = {
  framing: 'Line error: framing',
  parity: 'Line error: parity',
  break: 'Line error: break',
  overrun: 'Line error: overrun',
  other: 'Line error',
};

const errorMeaning: Record<LineErrorKind, string> = {
  framing: 'A byte did not end as it should: the rate is wrong, or the signal is weak.',
  parity: 'A byte did not have the parity that is set.',
  break: 'The line was held down for longer than a byte.',
  overrun: 'Bytes came faster than they were read, and some are lost.',
  other: 'The port reported an error and went on.',
};

const unreadable: Record<CodecErrorCode, string> = {
  'not-an-integer': 'a value is not whole',
  'out-of-range': 'a value is out of its range',
  'wrong-count': 'it has the wrong number of values for this timer',
  'wrong-length': 'its length is wrong',
  'unknown-command': 'no command has this letter',
  'unexpected-reply': 'it does not answer what was asked',
  'bad-identity': 'no timer can describe itself like this',
  'identity-needed': 'the timer has not yet said how many functions and servos it has',
  'bad-capture': 'it is not a recording',
  'wrong-type': 'a value is of the wrong kind',
  'unknown-word': 'a word in it is not known',
  'bad-file': 'it is not a library file',
  'bad-link': 'it is not a link to a setting, or not all of it',
  'newer-version': 'a newer version of this page made it',
  'too-large': 'it is too large',
  duplicate: 'something is in it twice',
};

const filters = {
  all: 'Everything',
  out: 'To the timer',
  in: 'From the timer',
  damaged: 'Damaged',
};

const danger: Record<Command['effect'], string> = {
  reads: '',
  stores: 'This changes what the timer holds. The timer is read again afterwards.',
  moves: 'Servos may move.',
  'frees-motor': 'This unlocks the motor: the propeller may start.',
  unknown:
    'Nobody knows for certain what this does: servos may move, the propeller may start, and what the timer holds may change.',
};

const frameFaults = {
  'not-hex': 'Not hex: type two digits, 0 to 9 or A to F, for each byte.',
  'odd-digits': 'A digit is missing: type two for each byte.',
  'not-a-byte': 'Type the letter as one byte in hex, such as 6B.',
  'too-long': 'A frame carries at most 252 bytes.',
};

const recordingFaults: Record<'heading' | 'line' | 'empty' | 'too-large' | 'unreadable', (line: number) => string> = {
  heading: () => 'This file is not a recording: its first line is not “# Sidus capture 1”.',
  line: (line) =>
    `Line ${line} of this file cannot be read. It should be a time in seconds (not before the one above), then > or <, then bytes in hex.`,
  empty: () => 'There is nothing in this recording.',
  'too-large': () => 'This file is too large for a recording.',
  unreadable: () => 'This file cannot be read.',
};

/** The log of the line. */
export const line = {
  title: 'Line',
  empty: 'Nothing to show.',
  unused:
    'Nothing has been on the line yet. Here you will see all that goes to a timer and comes from it. You can also load a recording, look at it, and replay it as a timer.',
  time: 'Time',
  direction: 'Direction',
  message: 'Message',
  bytes: 'Bytes',
  out: 'to the timer',
  in: 'from the timer',
  request: (name: string, letters: string) => `${name} · ${letters}`,
  reply: (name: string, letters: string) => `${name}, reply · ${letters}`,
  echo: (name: string, letters: string) => `${name}, echo · ${letters}`,
  unknown: (letter: string) => `Unknown letter ${letter}`,
  names,
  rejected,
  rejectedMeaning,
  errors,
  errorMeaning,

  position: (slot: string, servo: string, steps: number) => `${slot}, ${servo}: ${steps} steps`,
  positions: (servo: string, steps: readonly number[]) => `${servo}: ${steps.join(' ')}`,
  dt: (time: string) => `DT ${time}`,
  motorStop: (time: string) => `motor stop ${time}`,
  reserved: (time: string) => `reserved ${time}`,
  functions: (times: readonly string[]) => `functions ${times.join(' ')}`,
  identity: (name: string, firmware: string, functions: number, memories: number, servos: number) =>
    `${name}, firmware ${firmware}, ${plural(functions, 'function', 'functions')} and DT, ${plural(memories, 'memory', 'memories')}, ${plural(servos, 'servo', 'servos')}`,
  memoryUnsaid: 'It does not say which.',
  idleThrottle: (value: number) => `${value}, unit unknown`,
  idleThrottleUnsaid: 'It gives no value.',
  acknowledged: 'Acknowledged.',
  unreadable: (code: CodecErrorCode) => `Cannot be read: ${unreadable[code]}.`,

  pause: 'Pause',
  goOn: 'Go on',
  came: (number: number) => `Paused. ${plural(number, 'entry', 'entries')} since.`,
  clear: 'Clear',
  copyByHand: 'The browser does not let this page copy. Copy it from here.',
  save: 'Save',
  fileName: (kind: string) => `sidus-line-${kind}.txt`,
  unidentified: 'unknown',
  load: 'Load…',
  filter: 'Show',
  filters,
  search: 'Search',
  searchHint: 'name or hex',
  counts: (out: number, incoming: number, damaged: number, errors: number) => [
    `${out} to the timer`,
    `${incoming} from the timer`,
    `${damaged} damaged`,
    plural(errors, 'line error', 'line errors'),
  ],
  more: (shown: number, all: number) => `The newest ${shown} of ${all} are shown.`,
  older: 'Show older',

  recording: (name: string, entries: number) => `${name}: a recording of ${plural(entries, 'entry', 'entries')}.`,
  recordingLead: 'You are looking at a file, not at the line.',
  replay: 'Replay it as a timer',
  replayHint: 'A simulated timer then answers as this one did.',
  cannotReplay: 'It cannot be replayed: the timer never says what it is.',
  back: 'Back to the live line',
  recordingFaults,

  send: {
    title: 'Send a frame by hand',
    lead: 'To find out what a timer does. The page adds length, checksum and the rest of the frame.',
    command: 'Frame',
    choice: (name: string, letters: string, letter: string) => `${name} · ${letters} (${letter})`,
    other: 'Another letter',
    letter: 'Letter, in hex',
    data: 'Data, in hex',
    faults: frameFaults,
    preview: 'Goes out as',
    send: 'Send…',
    sendNow: 'Send',
    confirmTitle: 'Send this frame to the timer?',
    danger,
    safety: 'Take the propeller off or hold the model first.',
    confirm: 'Yes, send it once',
    cancel: 'Do not send',
    sending: 'Sending',
    answered: 'Answered:',
    unanswered: 'No reply came. What the frame asked for may have happened anyway.',
    notConnected: 'Connect to the timer to send.',
  },
};

/** What a maintainer needs to know. */
export const report = {
  copy: 'Copy report',
  program: (name: string, version: string) => `${name} ${version}`,
  browser: (browser: string, platform: string) => `Browser: ${browser}, ${platform}`,
  page: (installed: boolean) => `Page: ${installed ? 'installed' : 'in a browser tab'}`,
  timer: (identity: string | null) => `Timer: ${identity ?? 'not identified'}`,
  simulated: 'simulated',
  port: (kind: string, key: string, settings: string) => `Port: ${kind}, ${key}, ${settings}`,
  noPort: 'Port: none',
  found: (quirks: readonly string[]) => `Found: ${quirks.length > 0 ? quirks.join('; ') : 'nothing unusual'}`,
  assumed: (quirks: readonly string[]) => `Assumed: ${quirks.length > 0 ? quirks.join('; ') : 'nothing'}`,
  errors: (errors: readonly string[]) => `Line errors: ${errors.length > 0 ? errors.join(', ') : 'none'}`,
  unasked: (strays: number, delay: number | null) =>
    `Unasked frames: ${strays}; latest reply: ${delay === null ? 'in time' : `after ${Math.round(delay)} ms`}`,
  line: (counts: readonly string[], repeats: number | null) =>
    `Line: ${counts.join(', ')}${repeats === null ? '' : `, ${plural(repeats, 'repeat', 'repeats')}`}`,
};
