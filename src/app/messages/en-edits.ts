import type { FindingCode } from '../../program/index.js';
import type { RefusalCode } from '../editing/edit.js';
import type { StepCode } from '../editing/history.js';
import type { PasteProblemCode } from '../editing/paste.js';
import type { UnreadableReason } from '../editing/units.js';
import { whole } from './dotted.js';

type Params = Readonly<Record<string, string>>;

/** The name of a step after “Undo” and “Redo”. */
const steps: Record<StepCode, (params: Params) => string> = {
  change: ({ what }) => `change of ${what}`,
  shift: ({ what, by }) => `shift from ${what} by ${by}`,
  'step-servo': ({ what, steps, from }) => `${what} by ${steps}${from === '' ? '' : `, from ${from}`}`,
  paste: ({ count }) => `paste of ${count}`,
  fill: ({ count }) => `fill down of ${count}`,
  'revert-all': () => 'putting back everything',
  open: ({ what }) => `opening ${what}`,
  'keep-tried': () => 'keeping what was tried',
};

/** What prevents an edit, or a pasted cell, besides the reasons of the checks and the fields. */
const refused: Record<
  Exclude<RefusalCode | PasteProblemCode, FindingCode | UnreadableReason> | 'unreadable',
  (params: Params) => string
> = {
  start: () => 'The start has no time to change.',
  'later-out-of-range': ({ min, max }) => `A later function would be outside ${min} to ${max}.`,
  unreadable: () => 'A text that is no value is in the way. Correct it first.',
  'interval-disagrees': () => 'This interval does not fit the times of the two rows.',
  'no-place': () => 'The program has no such place.',
  twice: () => 'This place comes twice, with different values.',
  'too-large': ({ cells }) => `The table is too large: at most ${cells} cells are read. The rest was left out.`,
};

const counted = (count: number, name: string): string => `${count} ${name}${count === 1 ? '' : 's'}`;
const cells = (count: number): string => counted(count, 'value');

/** Undo, redo, and edits of many fields at once. */
export const edits = {
  redoButton: 'Redo',
  undo: (step: string) => `Undo ${step}`,
  redo: (step: string) => `Redo ${step}`,
  steps,
  /** What was opened. */
  opened: (name: string) => (name === '' ? 'another program' : `“${name}”`),
  refused,
  beforeLaunch: 'This would be before launch.',
  nothingDone: 'Nothing was changed.',
  cells,
  /** “DT: 3:00 min → 6:00 min”. */
  change: (field: string, from: string, to: string) => `${field}: ${whole(from)} → ${whole(to)}`,
  field: {
    putBack: (field: string) => `Put back ${field}`,
    /** Names a button that shows the figure: its name has to hold what can be read on it. */
    putBackTo: (field: string, figure: string) => `Put ${field} back to ${figure}`,
  },
  /** The sheet of keys for touch screens. */
  sheet: {
    title: (field: string) => `Keys for ${field}`,
    erase: 'Delete the last digit',
    putBack: 'Put back',
    selectRange: 'Select range',
    /** Where the focus goes: in the same row, or in the row above or below. */
    goTo: (name: string) => `Go to ${name}`,
  },
  table: {
    explain: 'What the values are',
    interval: 'After',
    /** In the cell of an interval: the short name of the row that it counts from. */
    countedFrom: (row: string) => `from ${row}`,
    /** Where there is room for only one of the two columns. */
    switch: 'Time or After',
    intervalOf: (slot: string) => `${slot} interval`,
    range: {
      title: 'Selected range',
      pick: 'Now tap another cell.',
      size: (rows: number, columns: number, functions: boolean) =>
        `${counted(rows, functions ? 'function' : 'row')}, ${counted(columns, 'column')}`,
      paste: 'Paste…',
      fillDown: 'Fill down',
      clipboardClosed: 'There is nothing to paste that this page may see. Tap the first field and paste there.',
    },
    /** Of a row or a servo. */
    tools: (name: string) => `Tools for ${name}`,
  },
  /** All positions of a servo. */
  stepServo: {
    title: (servo: string) => `All positions of ${servo}`,
    now: (lowest: number, highest: number) => `Now ${lowest === highest ? lowest : `${lowest} to ${highest}`}`,
    by: 'By, in steps',
    step: 'Step',
    signed: (steps: number) => `${steps < 0 ? '−' : '+'}${Math.abs(steps)}`,
    which: 'Which',
    all: 'All functions',
    from: (slot: string) => `From ${slot} on`,
    /** What would not go as far. */
    stops: (steps: string, what: string, count: number, at: number) =>
      `${steps}: ${what} ${count === 1 ? 'stops' : 'stop'} at ${at}.`,
  },
  shift: {
    open: 'Shift…',
    /** What is shifted: a row and all rows after it. DT is the last. */
    from: (row: string, isLast: boolean) => (isLast ? row : `${row} and all after`),
    by: 'By, in seconds',
    earlier: 'Earlier',
    later: 'Later',
    moveDt: 'Move DT too',
    /** Usually they follow each other. */
    functions: (numbers: readonly number[]) => {
      const [first = 0] = numbers;
      const last = numbers.at(-1) ?? first;
      if (first === last) return `function ${first}`;
      return `functions ${last - first + 1 === numbers.length ? `${first} to ${last}` : numbers.join(', ')}`;
    },
    moved: (time: string, later: boolean) => `Moved ${time} s ${later ? 'later' : 'earlier'}`,
  },
  pasting: {
    /** Above names of rows and columns in the copied text, each with a choice beside it. */
    asks: 'These names are not known. Say what they mean:',
    choose: 'Choose',
    leaveOut: 'Leave out',
    table: 'What goes where',
    lead: (count: number) => `This changes ${count === 0 ? 'nothing' : cells(count)}.`,
    /** In a table, an ambiguous text is read in one way only, so the page says which. */
    reading: (field: string, text: string, time: string) => `${field}: “${text}” is read as ${time}.`,
    problems: 'This cannot be pasted:',
    /** Where a problem is that belongs to no field: in the text that was copied. */
    place: (row: number, column: number) => `Row ${row}, column ${column} of the copied text`,
    problem: (place: string, text: string, reason: string) => `${place}${text === '' ? '' : `, “${text}”`}: ${reason}`,
    apply: 'Paste',
  },
  presets: {
    title: 'DT presets',
    use: (time: string) => `DT ${time}`,
    refused: 'Type times such as 20 s or 2:30, up to 10:55 min, at most 24.',
  },
  fix: (value: string) => `Set to ${value}`,
  fixOf: (field: string, value: string) => `Set to ${value}: ${field}`,
};
