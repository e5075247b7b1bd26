import { plural } from './plural.js';

/** Before anything was read. */
export const start = {
  title: 'Set your Sidus timer',
  lead: 'Read what it holds, change it, write it, and see it verified. Nothing leaves this device.',
  steps: {
    adapter: 'Plug in the adapter',
    wake: 'Wake the timer: press its switch briefly',
    near: 'Hold it closer than 20 cm',
  },
  /** What Firefox does in its own way. */
  firefox: {
    /** Where the page comes by https. */
    addOn: 'Firefox first asks to add a permission for this page: allow it, then choose the port.',
    port: 'Firefox asks for the port anew each time this page is loaded.',
  },
  readyOffline: 'Ready offline',
  install: 'Install',
  help: 'Help',
  settings: 'Settings',
  /** The program that is drawn. */
  picture: {
    example: 'Example: an F1Q',
    notKept: 'no backup is kept here yet',
    kept: (time: string) => `kept ${time}`,
  },
  models: {
    title: 'My models',
    none: 'Keep programs under the model that they are for, with notes.',
    settings: (count: number) => plural(count, 'setting', 'settings'),
    library: 'Open the library',
    all: (count: number) => `All ${count} models`,
  },
  programs: {
    title: 'My programs',
    none: 'Make one without a timer, and write it later.',
    make: 'New program…',
    /** A program that was made here. */
    made: (timer: string) => `${timer}, new`,
    madeAt: (time: string) => `made ${time}`,
    /** Changes that no timer has. */
    changesOf: (timer: string) => `${timer}, changes`,
    changedAt: (time: string) => `changed ${time}`,
    /** Before its name, for who hears it. */
    open: 'Open',
    remove: 'Delete',
    removeOf: (what: string, when: string) => `Delete ${what}, ${when}`,
    sure: 'Delete it for good?',
    keep: 'Keep it',
  },
  simulatedTitle: 'No timer at hand?',
  simulatedLead: 'A simulated one answers like a real one, byte for byte.',
  simulated: (name: string) => `Try a simulated ${name} timer`,
  backups: {
    title: 'Backups',
    none: 'Before every write, what the timer held is kept here.',
    kept: (count: number, last: string) =>
      `${plural(count, 'backup', 'backups')}, kept before a write. The last: ${last}.`,
    look: 'Look at them',
  },
};

/** That the page can be installed. */
export const installHint = {
  title: 'Keep Sidus Timer at hand.',
  ways: {
    button: 'Installed, it has a window and an icon of its own.',
    share:
      'Tap Share, then Add to Home Screen. In a tab, what is kept here may be deleted when you do not come back for seven days. On the Home Screen the page may begin with an empty library: export yours to a file first.',
    dock: 'In Safari, choose File, then Add to Dock. The page may begin with an empty library there: export yours to a file first.',
  },
  notNow: 'Not now',
};

/** The dialog that makes a program without a timer. */
export const newProgram = {
  title: 'New program',
  lead: 'For a timer that is not here. Connect it later: the program is then loaded over what it holds.',
  timerClass: 'Class',
  functions: 'Functions, without start and DT',
  servos: 'Servos',
  from: 'Begin with',
  beginnings: { usual: 'Usual times, all servos in the middle', nothing: 'Nothing: all times and positions 0' },
  caution: 'The positions of your model are not known here. Set each of them before you write.',
  make: 'Make the program',
  cancel: 'Cancel',
};
