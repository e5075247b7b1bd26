import { apart } from './apart.js';
import { plural } from './plural.js';

/** Two programs side by side. */
const compare = {
  title: 'Compare',
  open: 'Compare…',
  second: 'with',
  screen: 'On the screen',
  timer: (memory: string) => `Timer, ${memory}`,
  groups: { now: 'Now', settings: 'Saved programs' },
  setting: (model: string | null, name: string) => (model === null ? name : `${apart(model)} · ${apart(name)}`),
  backup: (memory: string, when: string, model: string | null) =>
    model === null ? `${memory} · ${when}` : `${apart(model)} · ${memory} · ${when}`,
  nothing: 'This device has no other program of this class and layout.',
  /** A button beside a value of the other program. */
  take: 'Take',
  /** The same for a screen reader, which does not know the row. */
  takeOf: (field: string, value: string) => `Take ${value} for ${field}`,
  takeHint: 'Take copies a value into the program on the screen.',
  openFirst: (name: string) => `Open ${name} to take values into it`,
};

/** How a backup differs from what its timer holds. */
const modelBackups = {
  /** @param when `now`, or the day of the last reading. */
  same: (when: string) => `as in the timer ${when}`,
  differs: (count: number, when: string) => `${plural(count, 'value differs', 'values differ')} from the timer ${when}`,
  now: 'now',
};

/** What a saved program held before it was saved over. */
export const versions = {
  title: 'Earlier versions',
  until: (when: string) => `Until\u00a0${when}`,
  /** @param change the first value that was changed then: “DT: 3:00 min → 3:30 min”. @param more how many others. */
  changed: (change: string, more: number) => `then ${change}${more === 0 ? '' : ` and ${more}\u00a0more`}`,
  otherLayout: 'then values for another timer',
  same: 'The saved program holds this now.',
  goBack: 'Go back to this',
};

/** Comparisons. The parts of the page that show them load these sentences. */
export const comparingMessages = { compare, modelBackups };
