import { plural } from './plural.js';

/** The start, before anything was read. */
export const start = {
  title: 'Set your Sidus timer',
  lead: 'Read what it holds, change it, write it, and see it verified. Nothing leaves this device.',
  steps: {
    adapter: 'Plug in the adapter',
    wake: 'Wake the timer: press its switch briefly',
    near: 'Hold the infrared head closer than 20\u00a0cm',
  },
  /** What Firefox does differently. */
  firefox: {
    /** For a page that was loaded over https. */
    addOn: 'Firefox first asks to add a permission for this page: allow it, then choose the port.',
    port: 'Firefox asks for the port again each time this page is loaded.',
  },
  readyOffline: 'Ready offline',
  install: 'Install',
  help: 'Help',
  settings: 'Settings',
  /** The program in the picture. */
  picture: {
    example: 'Example: an F1Q',
    kept: (time: string) => `kept ${time}`,
  },
  models: {
    title: 'My models',
    none: 'Keep the programs of each model together, with notes.',
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
    /** Changes that are in no timer. */
    changesOf: (timer: string) => `${timer}, changes`,
    changedAt: (time: string) => `changed ${time}`,
    /** Before the name of the program, for screen readers. */
    open: 'Open',
    remove: 'Delete',
    removeOf: (what: string, when: string) => `Delete ${what}, ${when}`,
    sure: 'Delete it for good?',
    keep: 'Keep it',
  },
  simulatedTitle: 'No timer with you?',
  simulatedLead: 'A simulated one answers like a real one, byte for byte.',
  simulated: (name: string) => `Try a simulated ${name} timer`,
  backups: {
    title: 'Backups',
    none: 'Before each write, the page keeps here what the timer held.',
    kept: (count: number, last: string) =>
      `${plural(count, 'backup', 'backups')}, kept before a write. The last: ${last}.`,
    look: 'Look at them',
  },
};

/** The hint that the page can be installed. */
export const installHint = {
  title: 'Install Sidus Timer.',
  ways: {
    button: 'It then has its own window and icon.',
    share:
      'Tap Share, then Add to Home Screen. In a tab, the browser may delete what you keep here when you do not open the page for seven days. On the Home Screen the page may begin with an empty library: export yours to a file first.',
    dock: 'In Safari, choose File, then Add to Dock. The page may begin with an empty library there: export yours to a file first.',
  },
  notNow: 'Not now',
};

/** The dialog that makes a program without a timer. */
export const newProgram = {
  title: 'New program',
  lead: 'For a timer that is not connected. When you connect it, the program is shown as changes. Nothing is written until you press Write.',
  timerClass: 'Class',
  functions: 'Functions, without start and DT',
  servos: 'Servos',
  from: 'Begin with',
  beginnings: { usual: 'Usual times, servos in the middle', nothing: 'All times and positions 0' },
  caution: 'The positions of your model are not known here. Set each of them before you write.',
  make: 'Make the program',
};
