import { plural } from './plural.js';

/** Any two programs that are at hand, side by side. */
export const compare = {
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
  setting: (model: string | null, name: string) => (model === null ? name : `${model} · ${name}`),
  backup: (memory: string, when: string, model: string | null) =>
    model === null ? `${memory} · ${when}` : `${model} · ${memory} · ${when}`,
  nothing: 'There is nothing to compare with: this device has no other program of this class and layout.',
  picture: (first: string, second: string) => `Timeline of ${first} and ${second}`,
  /** A button beside a value of the other one. */
  take: 'Take',
  /** The same for who does not see the row. */
  takeOf: (field: string, value: string) => `Take ${value} for ${field}`,
  takeHint: 'Take copies a value of the other program into the one on the screen. Undo takes it back.',
  following: 'Values cannot be taken while the servos follow.',
  openFirst: (name: string) => `Open ${name} to take values into it`,
};

/** The backups of a model, on its page. */
export const modelBackups = {
  title: 'Backups',
  empty: 'What the timer of this model holds is kept here before each write.',
  hint: 'All backups of today are kept, then one for each day of a month, then one for each month.',
  same: 'as the timer holds it now',
  differs: (count: number) => `${plural(count, 'value differs', 'values differ')} from what it holds now`,
  sameThen: (when: string) => `as the timer held it ${when}`,
  differsThen: (count: number, when: string) =>
    `${plural(count, 'value differs', 'values differ')} from what it held ${when}`,
  simulated: (count: number) => `Of simulated timers (${count})`,
  load: 'Load into the table',
  loadOf: (what: string) => `Load into the table: ${what}`,
  compareOf: (what: string) => `Compare: ${what}`,
  cannot: 'It does not fit the timer that is connected.',
  more: (count: number) => `Show ${count} more`,
};

export const comparing = { compare, modelBackups };
