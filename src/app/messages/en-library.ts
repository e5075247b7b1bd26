import type { SettingSource } from '../../program/index.js';
import { apart } from './apart.js';
import { whole } from './dotted.js';
import { en } from './en.js';
import { knowledge } from './en-knowledge.js';
import { plural } from './plural.js';

/** Why a program of the library or from a link cannot be opened now. */
export const obstacles = {
  busy: 'This page is reading, writing or looking for a timer. Wait until it has finished.',
  following: 'The servos follow. Stop that first.',
  'not-fitting': en.notFitting,
};

/** Models and their saved programs. The parts of the page that show them load these sentences. */
export const libraryMessages = {
  unread: 'The browser cannot read the library now. Close other tabs of this page and try again.',
  empty: {
    title: 'No model yet',
    lead: 'A model holds its programs, with names and notes. They are kept only on this device.',
    hint: 'Make a model, or read a timer and save its program.',
  },
  search: {
    label: 'Search programs',
    nothing: 'No program has all of these words.',
  },
  models: {
    title: 'Models',
    all: 'All models',
    /** The way back to what stands above. */
    make: 'New model…',
    settings: (count: number) => plural(count, 'program', 'programs'),
    archive: (count: number) => `Archive (${count})`,
    archived: 'archived',
    latest: 'Last changed',
  },
  list: {
    open: 'on the screen',
  },
  model: {
    timerClass: 'Class',
    noClass: 'Not given',
    /** Used where the model's name stands above its programs. */
    facts: 'About this model',
    noSettings: 'No program yet.',
    servos: 'Servos',
    servosUnknown: 'Save a program of this model first.',
    servoWay: (low: number, high: number) => `${low} to ${high} steps`,
    archive: 'Archive',
    unarchive: 'Take out of the archive',
    remove: 'Delete the model',
    withSettings: (count: number) =>
      count === 1
        ? 'Its program is deleted with it. Undo brings both back.'
        : `Its ${count}\u00a0programs are deleted with it. Undo brings all back.`,
  },
  setting: {
    isOpen: 'On the screen: look at it',
    /** @param count of the values on the screen that differ from the saved ones. */
    loadAgain: (count: number) => `Open again: ${plural(count, 'value goes', 'values go')} back`,
    tags: 'Tags, separated by commas',
    from: {
      typed: 'typed',
      timer: 'read from a timer',
      simulated: 'read from a simulated timer',
      backup: 'from a backup',
      file: 'from a file',
      link: 'from a link',
    } satisfies Record<SettingSource, string>,
    origin: (source: string, time: string) => `${source}, ${time}`,
    timer: (name: string, firmware: string | null, functions: number, servos: number) =>
      [
        name,
        firmware === null ? null : whole(`firmware ${firmware}`),
        whole(plural(functions, 'function', 'functions')),
        whole(plural(servos, 'servo', 'servos')),
      ]
        .filter(Boolean)
        .join(', '),
    notShown: 'It could not be opened. Try again.',
    gone: 'It is not in the library any more.',
  },
  save: {
    /** Used while nothing of the library is open. */
    open: 'Save…',
    /** The button names what it overwrites. @param model empty for none. */
    over: (name: string, model: string) =>
      `Save over ${model === '' ? apart(name) : knowledge.ofModel(apart(name), apart(model))}`,
    undo: (name: string) => `Take back the save of ${apart(name)}`,
    /** A tick: values of one model would go under the name of another. */
    crossing: (from: string, to: string) => `These are values of ${apart(from)}. Save them under ${apart(to)}.`,
    asNew: 'Save as new…',
    /** @param model empty for none. */
    taken: (name: string, model: string) =>
      `There is already a program ${model === '' ? apart(name) : knowledge.ofModel(apart(name), apart(model))}. Type another name, or:`,
    replace: 'Save over it. Its values stay as an earlier version.',
    name: (of: 'program' | 'model') => `Name of the ${of}`,
    namePlace: 'For example: fly-off, calm',
    notSavable: 'A field has no value. Correct it first.',
    state: (name: string, changes: number) =>
      `${apart(name)}: ${changes === 0 ? 'saved' : `${plural(changes, 'change', 'changes')} not saved`}`,
  },
  unkept: {
    mark: 'not kept',
  },
  nameNeeded: 'It needs a name.',
};
