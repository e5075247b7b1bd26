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
  portNumbers: (vendor: string, product: string) => `${vendor}:${product}`,
  lastRate: (rate: number) => `last at ${rate} baud`,
  /** Large, while connecting: what is happening, and what to do. */
  stages: {
    choosing: {
      title: 'Choose the adapter of the timer',
      advice: 'The browser shows the ports that it has found.',
    },
    opening: { title: 'Opening the port', advice: '' },
    openingLong: {
      title: 'The port takes long to open',
      advice: 'Bluetooth: switch the adapter on and bring it near. Cable: unplug it, and plug it in again.',
    },
    looking: (rate: number) => ({ title: 'Looking for the timer', advice: `Asking at ${rate} baud.` }),
    reading: { title: 'Reading the timer', advice: 'Hold it as it is.' },
    closing: { title: 'Closing the port', advice: '' },
    /** While waiting for an answer. Changes with each second. */
    noAnswer: (seconds: number) => `No answer for ${seconds}\u00a0s.`,
    silent: 'This page keeps asking and goes on by itself.',
    open: 'The adapter is open',
    /** `now`: the step to take, large. `text`: the same step in the list. */
    steps: {
      switch: {
        now: 'Press the switch of the timer briefly',
        text: 'Wake the timer: press its switch briefly',
      },
      near: {
        now: 'Hold the infrared head closer than 20\u00a0cm',
        text: 'Hold the infrared head closer than 20\u00a0cm, out of the sun',
      },
      other: {
        now: 'Is the timer on another adapter?',
        text: 'Another adapter?',
      },
    },
  },
  refused: {
    title: 'The port does not open yet.',
    advice:
      'This page tries again for 15 seconds. Another program may have the port. On Linux, ModemManager often holds a new adapter for a moment.',
  },
  /** Bytes come that are not from a timer. */
  heard: {
    text: (sample: string, rate: number) => ({
      title: 'Something else talks on this port.',
      advice: `Lines of text come at ${rate} baud, such as “${sample}”. Choose another port. If the timer is here too, wake it: this page keeps asking.`,
    }),
    noise: (_: string, rate: number) => ({
      title: 'No timer answers. Bytes come that no timer sends.',
      advice: `They come at ${rate} baud. Something else talks on this port, or light disturbs the infrared head. Shade the head, wake the timer and hold the head closer than 20\u00a0cm, or choose another port.`,
    }),
    slow: (_: string, rate: number) => ({
      title: 'A timer answers, but too slowly.',
      advice: `Its bytes come one by one at ${rate} baud, with gaps so long that no answer is whole in time. This page cannot read it. Try another adapter, or a cable in place of Bluetooth.`,
    }),
    echo: () => ({
      title: 'Only what this page sends comes back.',
      advice:
        'The timer sleeps or is too far away, or something else is on this port. Press the switch of the timer briefly and hold the infrared head closer than 20\u00a0cm, or choose another port.',
    }),
  },
  chooseAnother: 'Choose another port',
  /** The bytes that came in place of an answer. */
  itSaid: (bytes: string, text: string) => `What came: ${bytes} (“${text}”).`,
  trySelectBare: 'Try it without a correct checksum',
  away: {
    title: 'The adapter is unplugged.',
    advice: 'Plug it in: the connection comes back by itself. What you typed is kept.',
  },
  brokenOff: {
    title: 'The connection to the adapter was lost.',
    advice: 'This page tries again by itself. What you typed is kept.',
  },
  status: {
    off: 'Not connected',
    choosing: 'Choose a port',
    opening: 'Connecting',
    searching: 'Looking for the timer',
    waiting: 'Waiting for the timer',
    away: 'Adapter unplugged',
    brokenOff: 'Connection lost',
    closing: 'Disconnecting',
  },
  stop: 'Stop',
  /** For an adapter that was unplugged. */
  stopWaiting: 'Do not wait',
};

/** The known ports, and how they are opened. */
export const ports = {
  title: 'Known adapters',
  connectTo: (name: string) => `Connect to ${name}`,
  forget: 'Forget',
  forgetNamed: (name: string) => `Forget ${name}`,
  settings: 'Serial settings',
  settingsHint: 'Only for an adapter that needs special settings. Otherwise this page finds the rate by itself.',
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

const quirkNames: Record<QuirkCode, string> = {
  'timers-reply-66': 'It answers “read times” with the letter of “write times”.',
  'unlock-reply-6a': 'It answers “unlock motor” with the letter of “move servos”.',
  'memory-unknown': 'It does not say which memory is current.',
  'memory-impossible': 'It names a current memory that it cannot have.',
  'bare-checksum': 'Its reply about the idle throttle has no correct checksum.',
  'times-big-endian': 'Its times fall. With the two bytes of each swapped they would rise.',
  'servo-first': 'It takes the servo before the function when a position is written.',
  'servo-unanswered': 'It did not answer when a position was written.',
  'times-rounded': 'It rounds times.',
  'memories-from-one': 'It counts its memories from 1.',
  'positions-unchanged': 'It acknowledged positions but did not keep them.',
  echo: 'The adapter sends back what it is sent.',
  'idle-throttle-unanswered': 'It did not answer when asked for its idle throttle.',
  'identity-unusual': 'What it says of itself has bytes that are not known.',
  'idle-throttle-malformed': 'Its reply about the idle throttle has no value.',
  'replies-alike': 'Its replies to some requests are damaged, each in the same way.',
};

/** What is known about the connected timer. */
export const about = {
  title: 'About this timer',
  kind: 'Timer',
  layout: 'Layout',
  layoutOf: (functions: number, memories: number, servos: number) =>
    `${functions - 1} functions and DT, ${memories} memories, ${servos} servos`,
  port: 'Port',
  rate: 'Rate',
  repeats: 'Requests repeated',
  strays: 'Answers that nobody asked for',
  delay: 'Answers',
  delayOf: (ms: number | null) => (ms === null ? 'in time' : `after ${(ms / 1000).toFixed(1)} s: slow`),
  lineErrors: 'Errors of the line',
  lineErrorNames: {
    framing: 'framing',
    parity: 'parity',
    break: 'break',
    overrun: 'overrun',
    other: 'other',
  },
  count: (name: string, count: number) => `${name} ${count}`,
  none: 'none',
  damage: 'Damage seen on the line',
  crowd: 'Another timer or programmer may be in the beam. Since then two readings must agree.',
  notConnected: 'No timer is connected.',
  found: 'What it did differently',
  nothingFound: 'Nothing so far: it has done all that was asked in the usual way.',
  quirkNames,
  assumed: 'What is known to differ',
  assumedHint: 'Remembered for this port and this kind of timer, as a first guess the next time.',
  nothingAssumed: 'Nothing.',
  /** A remembered kind of timer on a port. */
  kindAt: (timer: string, port: string) => `${timer} at ${port}`,
  not: ': no',
  forget: 'Forget what is known to differ',
  forgetOf: (kind: string) => `Forget what is known to differ: ${kind}`,
  others: 'What is known to differ on timers at known adapters',
  assumptions: {
    bigEndianTimes: 'The two bytes of each time are swapped',
    servoFirst: 'A position is written with the servo before the function',
    memoriesFromOne: 'Memories are counted from 1',
    bareChecksumRequests: '“Select memory” and “write idle throttle” are sent without a correct checksum',
    positionsNeedMove: 'Positions are kept only where the servos stand',
  },
};
