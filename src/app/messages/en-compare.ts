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

/** How a backup differs from what its timer holds. */
const modelBackups = {
  /** @param when `now`, or the day of the last reading. */
  same: (when: string) => `as in the timer ${when}`,
  differs: (count: number, when: string) => `${plural(count, 'value differs', 'values differ')} from the timer ${when}`,
  now: 'now',
};

/** Comparisons. The parts of the page that show them load these sentences. */
export const comparingMessages = { compare, modelBackups };
