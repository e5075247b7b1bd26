import { plural } from './plural.js';

/** The sheet of a program. Only the view that prints it needs these sentences. */
export const print = {
  paper: 'Paper',
  what: 'On the sheet',
  parts: { lines: 'Lines to write on', code: 'QR code' },
  failed: 'This browser did not open its print window. Use the print command in its menu.',
  nothing: 'Choose programs of the library, or open one.',
  choose: (chosen: number) => `Programs on this print: ${chosen}`,
  clear: 'Remove all',

  /** The words on the paper. */
  simulated: 'simulated timer',
  warnings: 'Look at this before you fly',
  notes: 'Notes',
  codeHint: 'The camera of a phone opens this program, without its note.',
  unfinished: (count: number) => `${plural(count, 'field has', 'fields have')} no value yet: the last one is printed`,
  printed: (date: string) => `Printed ${date}`,
};
