import type { SettingSource } from '../../program/index.js';
import { apart } from './apart.js';
import { whole } from './dotted.js';
import { knowledge } from './en-knowledge.js';
import { plural } from './plural.js';

/** Why a setting of the library or from a link cannot be opened now. */
export const obstacles = {
  busy: 'This page is reading, writing or looking for a timer. Wait until it has finished.',
  following: 'The servos follow what you edit. Stop that first.',
  'other-class': 'The connected timer is of another class. Disconnect it to open this setting.',
  'other-layout': 'The connected timer has another number of functions or servos. Disconnect it to open this setting.',
};

/** Models and their settings. The parts of the page that show them load these sentences. */
export const libraryMessages = {
  title: 'Library',
  coming: 'Loading the library',
  unread: 'The browser cannot read the library now. Close other tabs of this page and try again.',
  readAgain: 'Try again',
  empty: {
    title: 'No model yet',
    lead: 'A model holds its settings: programs with a name and notes. They are kept only on this device.',
    hint: 'Make a model, or read a timer and save its program.',
  },
  search: {
    label: 'Search settings',
    placeholder: 'Search',
    found: (count: number) => plural(count, 'setting', 'settings'),
    nothing: 'No setting has all of these words in its name, note, tags or model.',
  },
  models: {
    title: 'Models',
    all: 'All models',
    /** The way back to what stands above. */
    make: 'New model…',
    settings: (count: number) => plural(count, 'setting', 'settings'),
    loose: 'Without a model',
    archive: (count: number) => `Archive (${count})`,
    hideArchive: 'Hide the archive',
    archived: 'archived',
    noClass: 'class not given',
    latest: 'Last changed',
  },
  list: {
    open: 'on the screen',
  },
  model: {
    name: 'Name',
    timerClass: 'Class',
    noClass: 'Not given',
    note: 'Note',
    /** Used where the model's name stands above its settings. */
    facts: 'About this model',
    noSettings: 'No setting yet. Open a program and save it here, or make a new one.',
    makeSetting: 'New setting…',
    servos: 'Servos',
    servosHint: 'What each servo moves, and between which steps.',
    servosUnknown: 'Not known yet.',
    servosNoProgram: 'Save a setting of this model first: it says how many servos there are.',
    servosChange: 'Name the servos…',
    servoWay: (low: number, high: number) => `${low} to ${high} steps`,
    archive: 'Archive',
    unarchive: 'Take out of the archive',
    remove: 'Delete the model',
    withSettings: (count: number) =>
      `If you delete the model, you also delete its ${count === 1 ? 'setting' : `${count}\u00a0settings`}. Undo brings all back.`,
  },
  setting: {
    open: 'Open',
    isOpen: 'On the screen: look at it',
    load: 'Load into the table',
    /** @param count of the values on the screen that differ from the saved ones. */
    loadAgain: (count: number) => `Load again: ${plural(count, 'value goes', 'values go')} back`,
    name: 'Name',
    note: 'Note',
    notePlace: 'Note: what changed, how it flew',
    tags: 'Tags',
    tagsHint: 'Words, separated by commas. For example: calm, fly-off.',
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
    move: 'Model',
    noModel: 'None',
    remove: 'Delete',
    notShown: 'It could not be opened now. Try again.',
    gone: 'This setting is not in the library any more.',
    modelGone: 'This model is not in the library any more.',
    unsaved: (count: number) => `${plural(count, 'change', 'changes')} on the screen not saved`,
    obstacles,
  },
  save: {
    /** Used while nothing of the library is open. */
    open: 'Save to library…',
    /** The button names what it overwrites. @param model empty for none. */
    over: (name: string, model: string) =>
      `Save over ${model === '' ? apart(name) : knowledge.ofModel(apart(name), apart(model))}`,
    undo: (name: string) => `Take back the save of ${apart(name)}`,
    /** A tick: values of one model would go under the name of another. */
    crossing: (from: string, to: string) => `These are values of ${apart(from)}. Save them under ${apart(to)}.`,
    asNew: 'Save as new…',
    title: 'Save to library',
    name: 'Name of the setting',
    namePlace: 'For example: fly-off, calm',
    model: 'Model',
    newModel: 'New model',
    noModel: 'No model',
    modelName: 'Name of the model',
    note: 'Note',
    save: 'Save',
    notSavable: 'A field has no value that a timer can hold. Correct it first.',
    state: (name: string, changes: number, unreadable: number) =>
      changes + unreadable === 0
        ? `${apart(name)}: saved`
        : `${apart(name)}: ${plural(changes + unreadable, 'change', 'changes')} not saved`,
  },
  newModel: {
    title: 'New model',
    make: 'Make the model',
  },
  newSetting: {
    title: 'New setting',
    beginnings: { usual: 'Usual times', nothing: 'Nothing, all 0' },
    make: 'Make the setting',
  },
  unkept: {
    mark: 'not kept by this browser',
  },
  nameNeeded: 'A name is needed. The old name stays.',
};
