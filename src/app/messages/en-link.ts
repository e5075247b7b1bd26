import type { QuirkCode } from '../../client/index.js';
import type { PortKind } from '../../serial/index.js';

const portNames: Record<PortKind, string> = {
  ftdi: 'FTDI adapter',
  cp210x: 'CP210x adapter (Silicon Labs)',
  ch340: 'CH340 adapter (WCH)',
  pl2303: 'PL2303 adapter (Prolific)',
  bluetooth: 'Bluetooth',
  usb: 'USB adapter',
  other: 'Serial port',
};

/** From the ports to a timer that answers. */
export const link = {
  portNames,
  /** Large, while connecting: what is happening, and what to do. */
  stages: {
    choosing: 'Choose the adapter of the timer',
    openingLong: {
      title: 'The adapter takes long to open',
      advice: 'Bluetooth: switch the adapter on, near. Cable: unplug it and plug it in again.',
    },
    asking: (rate: number) => `Asking at ${rate} baud.`,
    /** While waiting for an answer. Changes with each second. */
    noAnswer: (seconds: number) => `No answer for ${seconds}\u00a0s. This page keeps asking and goes on by itself.`,
    open: 'The adapter is open',
    /** The steps to take, in the list and, one at a time, large. */
    steps: {
      switch: 'Wake the timer: press its switch briefly',
      near: 'Hold the infrared head closer than 20\u00a0cm, out of the sun',
      other: 'Is the timer on another adapter?',
    },
  },
  refused: 'The page tries again for 15 seconds. Another program may have the adapter.',
  /** Bytes come, but no reply that can be used. */
  heard: {
    title: 'Something is heard, but no timer answers.',
    advice: 'Wake the timer and hold the head closer, out of the sun, or choose another adapter.',
  },
  slow: (rate: number) => ({
    title: 'A timer answers, but too slowly.',
    advice: `Its bytes come one by one at ${rate} baud, with gaps so long that no answer is whole in time. This page cannot read it. Try another adapter, or a cable in place of Bluetooth.`,
  }),
  /** The bytes that came in place of an answer. */
  itSaid: (bytes: string, text: string) => `What came: ${bytes} (“${text}”).`,
  trySelectBare: 'Try it without a correct checksum',
  /** The adapter was unplugged, or the connection to it broke off. */
  lost: {
    title: 'The connection to the adapter is lost.',
    advice: 'Plug it in, or bring it near: the page goes on by itself. What you typed is kept.',
  },
  status: {
    off: 'Not connected',
    opening: 'Connecting',
    searching: 'Looking for the timer',
    away: 'Connection lost',
    closing: 'Disconnecting',
  },
};

/** The known ports, and how they are opened. */
export const ports = {
  title: 'Known adapters',
  forget: 'Forget',
  settings: 'Serial settings',
  settingsHint: 'Only for a special adapter. The page finds the rate by itself.',
  rate: 'Rate',
  findRate: 'Find it',
  baud: (rate: number) => `${rate} baud`,
  parity: 'Parity',
  parities: { none: 'None', even: 'Even', odd: 'Odd' },
  stopBits: 'Stop bits',
  dtr: 'DTR',
  rts: 'RTS',
  signals: { leave: 'As the browser sets it', on: 'On', off: 'Off' },
  reset: 'Usual settings',
};

const letter = 'It answers with the letter of another command.';
const throttle = 'It does not answer about the idle throttle as usual.';
const memory = 'It does not say which memory is current.';

const quirkNames: Record<QuirkCode, string> = {
  'timers-reply-66': letter,
  'unlock-reply-6a': letter,
  'memory-unknown': memory,
  'memory-impossible': memory,
  'bare-checksum': throttle,
  'times-big-endian': 'Its times fall. With the two bytes of each swapped they would rise.',
  'servo-first': 'It takes the servo before the function when a position is written.',
  'servo-unanswered': 'It did not answer when a position was written.',
  'times-rounded': 'It rounds times.',
  'memories-from-one': 'It counts its memories from 1.',
  'positions-unchanged': 'It acknowledged positions but did not keep them.',
  echo: 'The adapter sends back what it is sent.',
  'idle-throttle-unanswered': throttle,
  'identity-unusual': 'What it says of itself has bytes that are not known.',
  'idle-throttle-malformed': throttle,
  'replies-alike': 'Its replies to some requests are damaged, each in the same way.',
};

/** What is known about the connected timer. Its numbers are in the report. */
export const about = {
  title: 'About this timer',
  damage: 'Damage seen on the line',
  crowd: 'Another timer or programmer may be in the beam. Since then two readings must agree.',
  found: 'What it did differently',
  nothingFound: 'Nothing so far: it has done all that was asked in the usual way.',
  quirkNames,
  assumed: 'What is known to differ',
  assumedHint: 'Remembered for this adapter and this kind of timer.',
  forget: 'Forget what is known to differ',
  /** A switch says what the page does, where the sentence above says only what was seen. */
  assumptions: {
    bigEndianTimes: 'The two bytes of each time are swapped',
    servoFirst: quirkNames['servo-first'],
    memoriesFromOne: quirkNames['memories-from-one'],
    bareChecksumRequests: '“Select memory” and “write idle throttle” are sent without a correct checksum',
    positionsNeedMove: 'Positions are kept only where the servos stand',
  },
};
