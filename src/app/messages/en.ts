import { bench } from './en-bench.js';
import { findings, unreadable } from './en-checks.js';
import { edits } from './en-edits.js';
import { help } from './en-help.js';
import { aside, counted, erase, framed, keeping, removed } from './en-keeping.js';
import { knowledge } from './en-knowledge.js';
import { line } from './en-line.js';
import { about as aboutTimer, link, ports } from './en-link.js';
import { look, memories, nextFlight, overview } from './en-memories.js';
import { alike, byteOrder, connection, notes, timer } from './en-notices.js';
import { preview } from './en-preview.js';
import { memoryNames, recognition } from './en-recognition.js';
import { backups, recovery } from './en-recovery.js';
import { settings, theme } from './en-settings.js';
import { shortDt } from './en-short-dt.js';
import { newProgram, start } from './en-start.js';
import { timeline } from './en-timeline.js';
import { aboutPage, update } from './en-update.js';
import { palette, parts, strip, views } from './en-views.js';
import { write } from './en-write.js';
import { plural } from './plural.js';

const slotName = (slot: number, kind: 'start' | 'function' | 'dt'): string =>
  kind === 'start' ? 'Start' : kind === 'dt' ? 'DT' : `Function ${slot}`;

/** What the parts of the page that are loaded first say. Later ones import their sentences themselves. */
export const en = {
  name: 'Sidus Timer',
  classNames: { Q: 'F1Q', B: 'F1B', E: 'F1E' } as Readonly<Record<string, string>>,
  unknownClass: (letter: string) => `Class ${letter}`,
  memoryName: (memory: number) => `M${memory + 1}`,
  servoName: (servo: number) => `S${servo + 1}`,
  slotName,
  /** Where there is little room: only the number. */
  slotShort: (slot: number, kind: 'start' | 'function' | 'dt') =>
    kind === 'function' ? String(slot) : slotName(slot, kind),
  /** Before a sentence about something. */
  about: (name: string) => `${name}:`,
  previous: 'Previous',
  next: 'Next',
  pause: 'Pause',
  /** The key for less of something, for a screen reader. */
  less: (what: string) => `${what}: less`,
  moreOf: (what: string) => `${what}: more`,
  seconds: (time: string) => (time.includes(':') ? time : `${time} s`),
  times: {
    /** “2 min 30 s”, “3 min”, “20 s”. */
    spoken: (minutes: number, seconds: string) =>
      [minutes > 0 && `${minutes} min`, (seconds !== '0' || minutes === 0) && `${seconds} s`].filter(Boolean).join(' '),
    units: { s: 's', min: 'min' },
    /** “10.0 s”, “3:00 min”. */
    figure: (text: string, unit: string) => `${text} ${unit}`,
    /** A time that was typed as seconds and is a minute or more: “230 s, 3:50”. */
    asSeconds: (seconds: string, clock: string) => `${seconds} s, ${clock}`,
    /** The label of the two answers. */
    meaning: (field: string) => `What ${field} means`,
  },

  header: {
    firmware: (firmware: string) => `firmware ${firmware}`,
    simulated: 'simulated',
    connect: 'Connect',
    choosePort: 'Choose another adapter',
    closeProgram: 'Close program',
    disconnect: 'Disconnect',
    stop: 'Stop',
  },
  start,
  newProgram,
  program: {
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
    idleThrottle: 'Idle throttle',
    throttle: 'Idle',
    idleThrottleUnit: 'unit unknown',
    reserved: (time: string) => `reserved ${time}`,
    timeOf: (slot: string) => `${slot} time`,
    motorStopTime: 'Motor stop time',
    positionOf: (slot: string, servo: string) => `${slot}, ${servo}`,
    shortDt: 'Short DT',
    changes: (count: number) => plural(count, 'change', 'changes'),
    undoAll: 'Undo all',
    read: 'Read again',
    connectAndWrite: 'Connect and write…',
    /** @param count of the values that differ. */
    write: (count: number) => (count === 0 ? 'Write…' : `Write ${plural(count, 'change', 'changes')}…`),
    picture: 'Picture',
    table: 'Table',
    /** What prevents a write. Its button goes there. */
    blocked: (field: string, why: string) => `Nothing can be written yet. ${field}: ${why}`,
    findings: 'Checks',
    noFindings: 'Nothing unusual.',
    absolute: 'Shown from launch. It is not known whether this timer counts from launch or from the function before.',
    severity: { error: 'Cannot be written', serious: 'Serious', warning: 'Unusual' },
    reading: 'Reading the timer',
    selecting: 'Changing the memory',
  },
  write,
  line,
  byteOrder,
  update,
  aboutPage,
  help,
  otherTab: {
    /** @param since null until that tab has said it. */
    holds: (since: string | null) => `Sidus Timer is open in another tab${since === null ? '' : `, since ${since}`}.`,
    takeOver: 'Use it here',
    busy: 'The other tab is working with the timer. It opens here as soon as that has ended.',
    gone: 'The other tab does not answer. Close it, then load this page again.',
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
  counted,
  removed,
  erase,
  framed,
  edits,
  bench,
  overview,
  theme,
  settings,
  views,
  strip,
  shortDt,
  palette,
  parts,
  timeline,
  preview,
  /** While requests of a job are repeated. A timer that fell asleep looks like a bad line: both are named. */
  disturbed: (seconds: number) =>
    `Answers are missing or damaged: is the timer awake, and the infrared head close, out of the sun? This ends in ${seconds}\u00a0s at the latest.`,
  cancel: 'Cancel',
  close: 'Close',
  copy: 'Copy',
  copied: 'Copied.',
  dismiss: 'Dismiss',
  done: 'Done',
  undo: 'Undo',
  open: 'Open',
  save: 'Save',
  delete: 'Delete',
  notNow: 'Not now',
  label: { name: 'Name', note: 'Note', model: 'Model', search: 'Search' },
  noModel: 'No model',
  /** After the first of a list. */
  more: (count: number) => `And ${count} more.`,
  showMore: (count: number) => `Show ${count} more`,
  /** A button of a row, for a screen reader, which does not know the row. */
  of: (button: string, name: string) => `${button}: ${name}`,
  notFitting: 'It does not fit the connected timer. Disconnect to open it.',
  notKept: 'This browser has not kept it: it is lost when this page is closed.',
  connection,
  timer,
  alike,
  notes,
  findings,
  unreadable,
};
