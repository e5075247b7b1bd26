import { apart } from './apart.js';
import { plural } from './plural.js';

/** Two programs side by side. */
const compare = {
  title: 'Compare',
  open: 'Compare…',
  back: 'Library',
  first: 'Compare',
  second: 'with',
  swap: 'Swap',
  screen: 'On the screen',
  screenOf: (name: string) => `On the screen: ${name}`,
  timer: (memory: string) => `Timer, ${memory}`,
  groups: { now: 'Now', settings: 'Settings', backups: 'Backups' },
  setting: (model: string | null, name: string) => (model === null ? name : `${apart(model)} · ${apart(name)}`),
  backup: (memory: string, when: string, model: string | null) =>
    model === null ? `${memory} · ${when}` : `${apart(model)} · ${memory} · ${when}`,
  nothing: 'There is nothing to compare with: this device has no other program of this class and layout.',
  picture: (first: string, second: string) => `Timeline of ${first} and ${second}`,
  /** A button beside a value of the other program. */
  take: 'Take',
  /** The same for a screen reader, which does not know the row. */
  takeOf: (field: string, value: string) => `Take ${value} for ${field}`,
  takeHint: 'Press Take to copy a value into the program on the screen. Undo takes it back.',
  following: 'Values cannot be taken while the servos follow.',
  openFirst: (name: string) => `Open ${name} to take values into it`,
};

/** The backups of a model, on its page. */
const modelBackups = {
  title: 'Backups',
  empty: 'Before each write, the page keeps here what the timer of this model holds.',
  hint: 'All backups of the last two days stay, one for each of the 30 days before, and one for each earlier month.',
  same: 'as the timer holds it now',
  differs: (count: number) => `${plural(count, 'value differs', 'values differ')} from what it holds now`,
  sameThen: (when: string) => `as the timer held it ${when}`,
  differsThen: (count: number, when: string) =>
    `${plural(count, 'value differs', 'values differ')} from what it held ${when}`,
  simulated: (count: number) => `Of simulated timers (${count})`,
  load: 'Load into the table',
  loadOf: (what: string) => `Load into the table: ${what}`,
  compareOf: (what: string) => `Compare: ${what}`,
  cannot: 'It does not fit the connected timer.',
  more: (count: number) => `Show ${count} more`,
};

/** Comparisons. The parts of the page that show them load these sentences. */
export const comparingMessages = { compare, modelBackups };
