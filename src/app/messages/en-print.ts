import { dotted } from './dotted.js';
import { plural } from './plural.js';

/** The setting sheet. Only the view that prints it needs these sentences. */
export const print = {
  title: 'Print',
  lead: 'Black on white, for the model box and the field.',
  paper: 'Paper',
  papers: {
    a5: 'A5',
    a4: 'A4',
    letter: 'Letter',
    'a4-two': 'A4, two to a page',
    'letter-two': 'Letter, two to a page',
  },
  what: 'On the sheet',
  parts: { timeline: 'Timeline', notes: 'Notes', lines: 'Lines to write on', code: 'QR code' },
  print: (pages: number) => `Print ${plural(pages, 'page', 'pages')}…`,
  failed: 'This browser did not open its print window. Use the print command in its menu.',
  preview: 'Preview',
  page: (page: number, pages: number) => `Page ${page} of ${pages}`,
  nothing: 'Nothing is chosen. Choose settings of the library, or open a program.',
  missing: (count: number) =>
    count === 1
      ? 'One of these settings is not in the library of this device.'
      : `${count} of these settings are not in the library of this device.`,
  left: (count: number) =>
    `${plural(count, 'setting is', 'settings are')} not on this print, which has at most 100. Print the others afterwards.`,
  choose: (chosen: number) => `Settings on this print: ${chosen}`,
  chosenScreen: 'On this print: the program on the screen',
  search: 'Search by model or setting',
  onScreen: 'The program on the screen',
  asRead: (memory: string) => `${memory}, as last read`,
  noModel: 'No model',
  none: 'The library has no such setting.',
  empty: 'The library has no settings to print yet.',
  more: (count: number) => `And ${count} more: search for them.`,
  clear: 'Remove all',

  /** The words on the paper. */
  model: 'Model',
  setting: 'Setting',
  memory: 'Memory',
  timer: (name: string, firmware: string) => (firmware === '' ? name : `${name}, firmware\u00a0${firmware}`),
  simulated: 'simulated timer',
  shortDt: 'Short DT',
  after: 'After',
  positions: 'Times in seconds, from 1\u00a0minute on in min:s. Positions in steps.',
  timelineOf: (lanes: readonly string[]) => `Servo positions over time, one lane for each: ${lanes.join(', ')}`,
  warnings: 'Look at this before you fly',
  notes: 'Notes',
  code: 'QR code of this setting',
  codeHint: 'The camera of a phone can read this setting here, without its note.',
  flights: 'Flights',
  columns: ['Date', 'Round', 'Wind m/s', 'Temp. °C', 'Result', 'Note'],
  printed: (date: string) => `Printed ${date}`,
  continued: (model: string, setting: string) => dotted([model, setting]),
  /** Where the values come from. */
  origins: {
    typed: (date: string) => `Typed, last changed ${date}`,
    timer: (date: string) => `Read from the timer ${date}`,
    simulated: (date: string) => `From a simulated timer ${date}`,
    backup: (date: string) => `From a backup of ${date}`,
    file: (date: string) => `From a file, ${date}`,
    link: (date: string) => `From a link, ${date}`,
  },
  unfinished: (count: number) => `${plural(count, 'field has', 'fields have')} no value yet: the last one is printed`,
};
