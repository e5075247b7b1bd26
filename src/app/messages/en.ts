import type { FindingCode } from '../../program/index.js';
import type { UnreadableReason } from '../editing/units.js';
import { bench } from './en-bench.js';
import { edits } from './en-edits.js';
import { help } from './en-help.js';
import { aside, erase, framed, keeping, removed, removedFromLibrary } from './en-keeping.js';
import { knowledge } from './en-knowledge.js';
import { line, report } from './en-line.js';
import { about as aboutTimer, link, ports } from './en-link.js';
import { look, memories, nextFlight, overview } from './en-memories.js';
import { connection, notes, timer } from './en-notices.js';
import { preview } from './en-preview.js';
import { memoryNames, recognition } from './en-recognition.js';
import { backups, recovery } from './en-recovery.js';
import { density, settings, theme } from './en-settings.js';
import { shortDt } from './en-short-dt.js';
import { installHint, newProgram, start } from './en-start.js';
import { aboutPage, update } from './en-update.js';
import { palette, parts, strip, views } from './en-views.js';

type Params = Readonly<Record<string, string>>;

const slotName = (slot: number, kind: 'start' | 'function' | 'dt'): string =>
  kind === 'start' ? 'Start' : kind === 'dt' ? 'DT' : `Function ${slot}`;

const findings: Record<FindingCode, (params: Params) => string> = {
  'time-not-whole': () => 'A time must be a whole number of hundredths of a second.',
  'time-out-of-range': ({ max }) => `A time can be at most ${max}.`,
  'position-not-whole': () => 'A position must be a whole number of steps.',
  'position-out-of-range': ({ min, max }) => `A position must be ${min} to ${max} steps.`,
  'throttle-not-whole': () => 'The idle throttle must be a whole number.',
  'throttle-out-of-range': ({ min, max }) => `The idle throttle must be ${min} to ${max}.`,
  'position-as-read': ({ value, max }) =>
    `Read as ${value}, past the last step ${max}. It stays as it is unless you change it.`,
  'time-falls': ({ previous }) => `This comes before the function above it, at ${previous}.`,
  'time-repeats': ({ previous }) => `The same time as the function above it, ${previous}.`,
  'position-never-reached': ({ previous }) =>
    `The same time as the function above it, ${previous}. The positions of the function above are never reached.`,
  'motor-stop-after-dt': ({ dt }) => `The motor stops after DT (${dt}): the model comes down with the motor running.`,
  'motor-run-long': ({ limit }) => `The motor runs longer than ${limit}, the limit for F1Q.`,
  'time-outside-manual': ({ min, max }) => `The manual allows ${min} to ${max}.`,
  'time-too-fine': ({ step }) => `The manual gives steps of ${step}: the timer may round.`,
  'dt-short': ({ limit }) => `DT is shorter than ${limit}.`,
  'dt-moves-nothing': () => 'No servo moves at DT: this timer does not bring the model down.',
  'throttle-unusual': ({ limit }) => `More than ${limit} is unusual. The unit is not known.`,
  'class-unknown': ({ timerClass }) =>
    `This timer calls its class “${timerClass}”. That class is not known, so its rules were not checked.`,
};

const unreadable: Record<UnreadableReason, string> = {
  empty: 'Empty: type a value.',
  'not-a-time': 'Not a time: type seconds like 12.5, or minutes like 2:05.',
  'too-fine': 'Finer than a hundredth of a second.',
  'not-a-whole-number': 'Not a whole number of steps.',
  ambiguous: 'This can be read in several ways: choose one.',
};

const plural = (count: number, one: string, many: string): string => `${count} ${count === 1 ? one : many}`;

/** What a timeline shows, in the words of one sentence. */
export interface TimelineFacts {
  readonly servos: number;
  readonly functions: number;
  readonly dt: string;
  readonly motorStop: string | null;
}

/** Everything that a person reads. Its type is what every language must give. */
export const en = {
  name: 'Sidus Timer',
  classNames: { Q: 'F1Q', B: 'F1B', E: 'F1E' } as Readonly<Record<string, string>>,
  unknownClass: (letter: string) => `Class ${letter}`,
  memoryName: (memory: number) => `M${memory + 1}`,
  servoName: (servo: number) => `S${servo + 1}`,
  slotName,
  /** Where there is little room: the number alone. */
  slotShort: (slot: number, kind: 'start' | 'function' | 'dt') =>
    kind === 'function' ? String(slot) : slotName(slot, kind),
  /** What stands before a sentence about it. */
  about: (name: string) => `${name}:`,
  seconds: (time: string) => (time.includes(':') ? time : `${time} s`),
  times: {
    /** “2 min 30 s”, “3 min”, “20 s”. */
    spoken: (minutes: number, seconds: string) =>
      [minutes > 0 && `${minutes} min`, (seconds !== '0' || minutes === 0) && `${seconds} s`].filter(Boolean).join(' '),
    units: { s: 's', min: 'min' },
    /** “10.0 s”, “3:00 min”. */
    figure: (text: string, unit: string) => `${text} ${unit}`,
    /** What was typed as seconds and is minutes by now: “230 s, 3:50”. */
    asSeconds: (seconds: string, clock: string) => `${seconds} s, ${clock}`,
    /** Around the two answers. */
    meaning: (field: string) => `What ${field} means`,
  },

  header: {
    firmware: (firmware: string) => `firmware ${firmware}`,
    simulated: 'simulated',
    connect: 'Connect',
    choosePort: 'Choose a port',
    simulatedTimer: 'Simulated',
    putAway: 'Close program',
    disconnect: 'Disconnect',
    stop: 'Stop',
  },
  start,
  newProgram,
  installHint,
  program: {
    title: 'Program',
    tableCaption: 'Time and servo positions of each function',
    slot: 'Function',
    time: 'Time',
    memory: 'Memory',
    memoryUnknown: 'This timer does not say which memory is current, so it is not known which one flies next.',
    memoryOpen: 'It is not known which memory flies next. Make one fly next, or read again.',
    dt: 'DT',
    motorStop: 'Motor stop',
    /** Where there is little room. */
    motor: 'Motor',
    /** The time of the start, from which all others count. */
    origin: '0',
    idleThrottle: 'Idle throttle',
    throttle: 'Idle',
    idleThrottleUnit: 'unit unknown',
    reserved: 'reserved',
    editReserved: 'Edit the reserved time',
    timeOf: (slot: string) => `${slot} time`,
    motorStopTime: 'Motor stop time',
    positionOf: (slot: string, servo: string) => `${slot}, ${servo}`,
    shortDt: 'Short DT',
    changes: (count: number) => plural(count, 'change', 'changes'),
    undoAll: 'Undo all',
    read: 'Read again',
    connectAndWrite: 'Connect and write…',
    /** @param count of the values that differ. */
    write: (count: number) => (count === 0 ? 'Write…' : `Write ${count}…`),
    picture: 'Picture',
    table: 'Table',
    /** What is in the way of a write; its button leads there. */
    blocked: (field: string, why: string) => `Nothing can be written yet. ${field}: ${why}`,
    findings: 'Checks',
    noFindings: 'Nothing unusual.',
    absolute:
      'Times are shown as counted from launch. The manuals of this class do not say clearly whether they are intervals.',
    severity: { error: 'Cannot be written', serious: 'Serious', warning: 'Unusual' },
    reading: 'Reading the timer',
    selecting: 'Changing the memory',
  },
  write: {
    title: 'Write to the timer',
    lead: (memory: string) => `This is what changes in ${memory}. Everything else stays as it is.`,
    thisMemory: 'the current memory',
    nothing: 'Nothing differs. The timer is read back and compared.',
    field: 'Value',
    from: 'Timer holds',
    to: 'Will hold',
    wasRead: 'Was read',
    moved: {
      timer: {
        title: 'The timer holds something else than was shown.',
        advice: 'Nothing was written. This is what a write would change now.',
      },
      model: {
        title: 'Whose timer this is has changed since this was shown.',
        advice: 'Nothing was written. Look at the names of the models.',
      },
      edits: {
        title: 'The program has changed since this was shown.',
        advice: 'Nothing was written. This is what a write would change now.',
      },
    },
    unkept: {
      title: 'This device could not keep a backup of what the timer holds now.',
      advice: 'Nothing was written yet. Write without it?',
    },
    /** What a table of values is called: by what its columns are of. */
    sideBySide: (names: readonly string[]) => `Values: ${names.join(', ')}`,
    withoutCopy: 'Write without a backup',
    notWithout: 'Do not write',
    safety: 'The propeller is off or the model is held, and the timer is not armed.',
    acknowledge: 'I have read this and want to write it anyway.',
    move: {
      why: 'This timer seems to keep positions only where its servos stand. Unless the servos move, it will probably not keep these.',
      label: 'Move the servos to each function before its positions are stored',
      hint: 'The servos will move then: hold the model safely, with nothing in their way.',
      notHeld: {
        title: 'The timer acknowledged the positions but did not keep them.',
        advice:
          'This timer probably keeps them only where its servos stand. Write again, and let the servos move to each function.',
      },
      again: 'Write again…',
    },
    start: (count: number) => (count === 0 ? 'Read back and compare' : `Write ${plural(count, 'change', 'changes')}`),
    cancel: 'Cancel',
    stop: 'Stop',
    close: 'Close',
    stages: {
      read: 'Reading',
      write: 'Writing',
      verify: 'Reading back',
      repair: 'Correcting',
    },
    stopping: 'Stopping after this request',
    verified: { title: 'Verified.', advice: 'The timer was read back after writing and held what was wanted.' },
    verdict: (memory: string, time: string, figures: readonly string[], changes: number) =>
      [`${memory} verified ${time}`, ...figures, plural(changes, 'change', 'changes')].join(' · '),
    inWords: 'In words',
    asItIs: 'as it is',
    insteadOf: (value: string) => `instead of ${value}`,
    wanted: 'To be written',
    readBack: 'Read back',
    differs: {
      title: 'The timer did not take every value.',
      advice: 'The timer was read back. It holds other values here:',
    },
    unknown: {
      title: 'It is not certain what the timer holds.',
      advice:
        'The write was not read back to its end. Read again, then write what still differs. Your changes are kept.',
    },
    refused: 'Nothing was written.',
    held: 'Timer holds now',
    status: { verified: 'verified', differs: 'differs', unknown: 'not known' },
    putBack: 'changed by itself, put back',
    repeats: (count: number) => `The line was disturbed: ${plural(count, 'request was', 'requests were')} repeated.`,
  },
  line,
  report,
  byteOrder: {
    title: 'The times of this timer fall.',
    advice:
      'With the two bytes of each time swapped they would rise. Compare both with what you know of the timer, and choose before you write times.',
    keep: 'They are right as shown',
    exchange: 'Swap them and read again',
  },
  update,
  aboutPage,
  help,
  otherTab: {
    /** @param what empty while that tab has not read a timer. */
    holds: (what: string, since: string) =>
      `Another tab of this page holds the port${what === '' ? '' : `: ${what}`}, since ${since}.`,
    takeOver: 'Take over',
    asking: 'Asking the other tab',
    writing: 'It is writing just now. Wait until it has finished.',
    gone: 'It does not answer. Close it, then click Connect again.',
  },
  link,
  ports,
  aboutTimer,
  knowledge,
  recognition,
  memoryNames,
  recovery,
  memories,
  nextFlight,
  look,
  backups,
  keeping,
  aside,
  removed,
  removedFromLibrary,
  erase,
  framed,
  dateTime: { dateStyle: 'medium', timeStyle: 'short' } as const,
  locale: 'en-GB',
  edits,
  bench,
  overview,
  theme,
  settings,
  views,
  strip,
  shortDt,
  palette,
  density,
  parts,
  timeline: {
    title: 'Timeline',
    compareWith: 'Compare with',
    compareNothing: 'nothing',
    /** What the timer holds, as far as that is known. */
    compareHeld: { now: 'the timer', once: 'the last reading', not: 'the last reading, not certain' },
    picture: 'Servo positions over time',
    description: ({ servos, functions, dt, motorStop }: TimelineFacts) =>
      `${plural(servos, 'servo', 'servos')} and ${plural(functions, 'function', 'functions')} over time, DT at ${dt}${motorStop === null ? '' : `, motor stop at ${motorStop}`}.`,
    keys: 'Left and right go from mark to mark, up and down from servo to servo. Plus and minus zoom, 0 shows all, Shift with an arrow moves the view.',
    keysToEdit:
      'Left and right go from mark to mark, up and down from servo to servo. Plus and minus zoom, 0 shows all, Shift with an arrow moves the view. Enter goes to the handles: the arrows move them, Escape comes back.',
    ask: 'Point or tap to read',
    /** While a handle is moved: the further away the pointer is, the finer. */
    finer: 'Finer',
    finest: 'Step by step',
    front: 'Servo in hand',
    stands: (servo: string, position: number | string) => `${servo} ${position}`.trim(),
    steps: (position: number) => plural(position, 'step', 'steps'),
    stepsUnit: 'steps',
    unknownValue: '?',
    notKnown: 'Not known: the times fall',
    zero: '0 s',
    tools: 'View',
    trueScale: 'True time scale',
    zoomIn: 'Zoom in',
    zoomOut: 'Zoom out',
    fit: 'Show all',
    asTable: 'As a table',
    tableCaption: 'When each function begins and ends, and where the servos stand',
    from: 'From',
    until: 'Until',
    motorRuns: 'Motor runs',
    passing: { passed: 'skipped', back: 'not known' },
    passedOver: (slot: string, next: string) => `${slot} is skipped: ${next} comes at the same time.`,
    goesBack: (next: string, slot: string) =>
      `${next} comes before ${slot}. It is not known what the timer does in the shaded part. The dotted lines go back in the order of the functions.`,
    more: (count: number) => `And ${count} more.`,
  },
  preview,
  /** While a job goes on over a bad line. */
  disturbed: (repeats: number, seconds: number) =>
    `Line disturbed: ${plural(repeats, 'request', 'requests')} repeated, ends in ${seconds} s at the latest`,
  dismiss: 'Dismiss',
  connection,
  timer,
  notes,
  findings,
  unreadable,
};
