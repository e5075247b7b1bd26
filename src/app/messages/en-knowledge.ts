import { apart } from './apart.js';
import { whole } from './dotted.js';
import { plural } from './plural.js';

/** What is known about the content of a timer, and what is not. */
export const knowledge = {
  /** For a memory whose content is uncertain. */
  title: 'Not certain',
  uncertain: (memory: string, values: string) => `It is not known what ${memory} holds: ${values}.`,
  noFly: 'Do not fly before it is read.',
  since: (time: string) => `A write was interrupted on ${time}.`,
  thisMemory: 'the current memory',
  /** For a timer that is not connected. */
  memoryOf: (memory: string, timer: string) => `${memory} of ${timer}`,
  /** @param other while another timer of the same kind is connected. */
  timer: (name: string, firmware: string, simulated: boolean, other: boolean) =>
    `${other ? 'another' : 'the'} ${simulated ? 'simulated ' : ''}${name} ${firmware}`,
  dt: 'DT',
  motorStop: 'motor stop',
  either: (name: string, before: string, goal: string) => `${name} is ${before} or ${goal}`,
  /** @param more how many further values there are. */
  list: (named: readonly string[], more: number) =>
    more > 0
      ? `${named.join(', ')}, and ${whole(plural(more, 'more value', 'more values'))} ${more === 1 ? 'is' : 'are'} not certain`
      : named.join(' and '),
  connect: 'Connect and read',
  forget: 'Forget this…',
  forgetSure: 'Forget it only if you have read that timer elsewhere, or no longer have it.',
  forgetNow: 'Forget it now',

  /** In place of “No changes”. */
  verified: (time: string) => `As in the timer, verified ${time}`,
  readAt: (time: string) => `As in the timer, read ${time}`,
  /** @param time null when it was not kept. */
  lastReadAt: (time: string | null) => (time === null ? 'As last read' : `As last read ${time}`),
  /** For a setting of the library, by its model and name. */
  ofSetting: (name: string, changes: number) =>
    changes === 0 ? `${apart(name)}: saved` : `${apart(name)}: ${plural(changes, 'change', 'changes')} not saved`,
  /** For a program that is no longer what was saved under this name. */
  changed: (name: string) => `${name}, changed`,
  ofModel: (name: string, model: string) => `${name} of ${model}`,
  /** For a program that was made here. */
  made: 'New program, in no timer yet',
  unknown: (memory: string) => `Not known what ${memory} holds`,
  unfinished: (count: number) => `${plural(count, 'field has', 'fields have')} no value yet`,
  hints: {
    now: 'Marked fields differ from what the timer holds.',
    /** @param time null when it was not kept. */
    once: (time: string | null) => `Marked fields differ from what was last read${time === null ? '' : `, ${time}`}.`,
  },
  /** Under a changed value: its old value. */
  marks: {
    now: (value: string) => `was ${value}`,
    once: (value: string) => `last read ${value}`,
  },
  /** For screen readers. */
  notCertain: ', not certain now',
  /** The program that it is compared with. */
  held: {
    now: 'Timer holds',
    once: 'Last read',
  },
};
