import type { CodecErrorCode } from '../../protocol/index.js';
import { apart } from './apart.js';
import { whole } from './dotted.js';
import { plural } from './plural.js';

/** “2 models, 1 setting”: only kinds that there are. */
const counted = ({ models, settings, flights }: { models: number; settings: number; flights: number }): string =>
  [
    models > 0 && whole(plural(models, 'model', 'models')),
    settings > 0 && whole(plural(settings, 'setting', 'settings')),
    flights > 0 && whole(plural(flights, 'flight', 'flights')),
  ]
    .filter(Boolean)
    .join(', ');

/** “Sidus library 2026-11-25.sidus.json”, whose date does not break. A long name must be able to. */
const fileName = (name: string): string => `“${apart(name.length > 40 ? name : name.replaceAll('-', '-\u2060'))}”`;

const ENTRY = { models: 'Model', settings: 'Setting', flights: 'Flight' };

/** A place in a library file: the number of its entry from 1, and empty texts for what there is not. */
interface Place {
  readonly kind: keyof typeof ENTRY;
  readonly number: number;
  readonly name: string;
  readonly slot: string;
  readonly field: string;
}

const BROKEN = 'A value in the file cannot be right.';

/** The library as files: export, import, and the reminder to export. */
export const filesMessages = {
  counted,
  export: {
    all: 'Export all…',
    one: 'Export…',
    again: (name: string) => `Save to ${name}`,
    another: 'Export to another file…',
    saving: (name: string) => `Saving ${fileName(name)}`,
    /** Saved to a file that the pilot has chosen. */
    saved: (name: string, what: string) => `Saved to ${fileName(name)}: ${what}.`,
    /** Given to the browser as a download. It does not say whether it has saved the file. */
    downloaded: (name: string, what: string) =>
      `This browser puts ${fileName(name)} into your downloads: ${what}. Check that it is there.`,
    notWritten: (name: string) =>
      `${fileName(name)} could not be written. This browser puts it into your downloads instead.`,
    /** Added to the name of the program that wrote a file. */
    without: (kind: keyof typeof ENTRY) => `without ${kind}`,
    partly: (name: string, what: string, missing: readonly (keyof typeof ENTRY)[]) =>
      `${fileName(name)} is not complete. It holds ${what}. The browser cannot read the ${missing.join(' and ')} now: close other tabs of this page, and export again.`,
    unread: 'The browser cannot read the library now. Close other tabs of this page and try again.',
    tooLarge: 'The library is too large for one file. Export its models one by one.',
    nothing: 'There is nothing to export yet.',
    failed: 'The file could not be made. Load the page again and try once more.',
  },
  import: {
    button: 'Import…',
    title: (name: string) => `Import ${name}`,
    reading: 'Reading the file',
    drop: 'Drop the file to see what is in it',
    lead: (date: string, by: string) => `Saved ${date}${by === '' ? '' : ` by ${apart(by)}`}.`,
    holds: (what: string) => (what === '' ? 'It holds nothing.' : `It holds ${what}.`),
    ignored: (count: number) =>
      `This version of the page does not know what ${plural(count, 'entry is', 'entries are')}. The import leaves ${count === 1 ? 'it' : 'them'} out.`,
    nothing: 'You have all of this already.',
    differs: 'What differs',
    ways: { newer: 'Take the newer', both: 'Keep both', skip: 'Leave out' },
    /** For a model without differences: in place of the first choice. */
    bring: 'Import',
    /** The same where neither is newer. */
    keep: 'Keep what is here',
    /** The facts of a model: its name, notes, servos. */
    itself: 'the model itself',
    flightOf: (day: string) => `flight of ${day}`,
    more: (count: number) => `and ${count} more`,
    /** What happens to entries that differ. */
    wayText: {
      newer: 'What is newer here, or has the same date, stays as it is.',
      both: 'Both stay. The one from the file gets a number after its name.',
      skip: 'Nothing is imported for a model that is left out.',
    },
    loose: 'Without a model',
    unknownModel: 'A model that is not here',
    group: {
      way: (name: string) => `${name}: what to do with it`,
      fresh: (what: string) => `New: ${what}`,
      same: (what: string) => `The same: ${what}`,
      fileNewer: (what: string) => `Newer in the file: ${what}`,
      deviceNewer: (what: string) => `Newer here: ${what}`,
      sameDate: (what: string) => `Differs, same date: ${what}`,
      /** An entry that has another name here than in the file. */
      fileName: (here: string, file: string) => `${apart(file)} (here: ${apart(here)})`,
      hereName: (here: string, file: string) => `${apart(here)} (in the file: ${apart(file)})`,
    },
    take: (count: number) => (count === 0 ? 'Nothing to import' : `Import ${count}`),
    /** Why there is nothing to import, and what to do. */
    allStays: 'What is here stays: nothing in the file is newer. Choose “Keep both” to import it, too.',
    allLeftOut: 'Everything in the file is left out.',
    shut: 'The browser cannot read the library now. An import could replace newer settings with older ones.',
    importing: (name: string, done: number, of: number) => `Importing ${fileName(name)}: ${done} of ${of}`,
    done: (what: string, name: string) => `Imported from ${fileName(name)}: ${what}.`,
    unkept: 'This browser could not store all of it. What you see is lost when you close this page.',
    undo: 'Undo the import',
    undoing: (done: number, of: number) => `Undoing the import: ${done} of ${of}`,
    undone: 'The import was undone.',
    partlyUndone: 'The import was undone. What has changed since then stays.',
    undoUnkept:
      'This browser could not store that the import was undone. When you load the page again, it may be back.',
  },
  refused: {
    title: (name: string) => `${name} cannot be imported`,
    nothing: 'Nothing was imported.',
    line: (line: number, column: number) => `Line\u00a0${line}, column\u00a0${column}.`,
    /** Where a fault stands: “Setting “calm morning”, function 2, time.” */
    place: ({ kind, number, name, slot, field }: Place) =>
      [
        `${ENTRY[kind]} ${name === '' ? `${number} in the file` : `“${apart(name)}”`}`,
        /^\d/.test(slot) ? `function ${slot}` : slot,
        field.replace(/^positions\[(\d+)\]$/, (_, servo) => `S${Number(servo) + 1}`),
      ]
        .filter(Boolean)
        .join(', ')
        .concat('.'),
    again: 'Export the file again, or ask its sender for a new one.',
    between: (min: number, max: number) => `It must be ${min} to ${max}.`,
    characters: (min: number, max: number) => `It must have ${min} to ${max} characters.`,
    files: {
      'too-large': 'The file is too large for a library.',
      'no-text': 'The file is not text.',
      gone: 'The file could not be read. Is it still there?',
      several: 'Import one file at a time.',
      failed: 'The file could not be read. Load the page again and try once more.',
    },
    /** Why a file cannot be read, by the kind of fault. */
    kinds: {
      format: 'This is not a library file of Sidus Timer.',
      text: 'The text of the file is broken.',
      end: 'The file is not complete: it ends too early.',
      encoding: 'The letters of the file cannot be read. Save it as UTF-8.',
    } as Readonly<Record<string, string>>,
    codes: {
      'newer-version': 'A newer version of this page made this file. Load the page again to get that version.',
      'too-large': 'The file is too large or too deeply nested for a library.',
      duplicate: 'Something is there twice that may be there only once.',
      'out-of-range': 'A value is out of its range.',
      'wrong-count': 'A list has too many or too few entries for the timer.',
      'bad-identity': 'No timer can describe itself like this.',
      'wrong-type': 'A value is missing, or of the wrong kind.',
      'not-an-integer': 'A value must be a whole number.',
      'unknown-word': 'This word is not allowed here.',
    } as Readonly<Partial<Record<CodecErrorCode, string>>>,
    other: BROKEN,
  },
  reminder: {
    text: (changes: number, days: number) =>
      `${plural(changes, 'change', 'changes')} since the last export, ${days} days ago. Models, settings and flights are only on this device.`,
    never: (entries: number) =>
      `${plural(entries, 'entry', 'entries')} of your library ${entries === 1 ? 'is' : 'are'} only on this device. If you lose the device, only a file brings them back.`,
    later: 'Not now',
  },
};
