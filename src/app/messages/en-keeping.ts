import { whole } from './dotted.js';
import { plural } from './plural.js';

/** For when the browser does not store, or give back, what it should. */
export const keeping = {
  title: 'This browser does not keep everything.',
  notKept:
    'What you type, backups and the note of an interrupted write last only while this page is open. Export the library. Then close other tabs of this page, or make room on this device.',
  notKnown: 'The browser does not say whether it keeps what you do. Take it as not kept, and export the library.',
  oneTab: 'Use one tab of this page only.',
  emptied: 'The browser has deleted what it kept for this page. Export what you still see.',
  export: 'Export the library…',
};

/** Stored data that cannot be read. */
export const aside = {
  title: (count: number) =>
    count === 1
      ? '1 record could not be read. It is set aside, not deleted.'
      : `${count} records could not be read. They are set aside, not deleted.`,
  write: 'It includes the note of an interrupted write: read the timer before you fly.',
  save: 'Save to a file',
};

/** How many there are of each kind of records. */
type Counts = Partial<Readonly<Record<'models' | 'settings' | 'flights' | 'backups', number>>>;

/** “2 models, 1 program”: only kinds that there are. */
export const counted = ({ models = 0, settings = 0, flights = 0, backups = 0 }: Counts): string =>
  [
    models > 0 && whole(plural(models, 'model', 'models')),
    settings > 0 && whole(plural(settings, 'program', 'programs')),
    flights > 0 && whole(plural(flights, 'flight', 'flights')),
    backups > 0 && whole(plural(backups, 'backup', 'backups')),
  ]
    .filter(Boolean)
    .join(', ');

/** What was deleted a moment ago. */
export const removed = (what: string): string => `Deleted: ${what}.`;

/** Deletes everything that this device keeps. */
export const erase = {
  open: 'Delete everything on this device…',
  lead: 'This deletes all models, programs, flights, backups, unwritten changes and choices of this page from this browser. It cannot be undone. Timers keep what they hold.',
  uncertain:
    'A write was interrupted, and it is not known what that timer holds. Without the note of that write this page cannot warn you: read that timer before you fly.',
  start: 'Delete everything',
  running: 'Deleting',
  failed:
    'Not everything could be deleted. Close other tabs of this page and try again, or delete its data in the settings of the browser.',
};

/** For a page that is shown inside another page. */
export const framed = {
  title: 'Sidus Timer works only in its own tab: another page could cover what you see of your timer.',
  open: 'Open Sidus Timer in its own tab',
};
