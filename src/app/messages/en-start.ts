import { FIRST_VERSIONS } from '../browser/platform.js';
import { plural } from './plural.js';

/** The start, before anything was read. The words for waiting are in en-link.ts. */
export const start = {
  title: 'Set your Sidus timer',
  lead: 'Read what it holds, change it, write it, and see it verified. Nothing leaves this device.',
  adapter: 'Plug in the adapter',
  firefox: 'Firefox asks for a permission first, and for the port each time this page is loaded.',
  /** What a phone can connect to. */
  android: `A phone connects over Bluetooth; a cable needs Android ${FIRST_VERSIONS.androidCable} and Chrome ${FIRST_VERSIONS.android}.`,
  readyOffline: 'Ready offline',
  install: 'Install',
  /** The program in the picture. */
  picture: {
    example: 'Example: an F1Q',
    kept: (time: string) => `Kept ${time}`,
  },
  models: {
    title: 'My models',
    none: 'Keep the programs of each model, with notes.',
    programs: (count: number) => plural(count, 'program', 'programs'),
    library: 'Open the library',
  },
  /** Programs that are in no timer. */
  programs: {
    title: 'Not finished',
    /** A program that was made here. */
    made: (timer: string) => `${timer}, new`,
    /** Changes that are in no timer. */
    changesOf: (timer: string) => `${timer}, changes`,
    sure: 'Delete it for good?',
  },
  simulatedTitle: 'No timer with you?',
  simulatedLead: 'A simulated one answers like a real one, byte for byte.',
  simulated: (name: string) => `Try a simulated ${name} timer`,
  backups: (count: number, last: string) =>
    `${plural(count, 'backup', 'backups')}, kept before a write. The last: ${last}.`,
};

/** The dialog that makes a program without a timer. */
export const newProgram = {
  title: 'New program…',
  timerClass: 'Class',
  functions: 'Functions, without start and DT',
  servos: 'Servos',
  from: 'Begin with',
  beginnings: { usual: 'Usual times, servos in the middle', nothing: 'All times and positions 0' },
  caution: 'The positions of your model are not known here. Set each of them before you write.',
  make: 'Make the program',
};
