import type { CodecErrorCode } from '../../protocol/index.js';
import { plural } from './plural.js';

/** So many of each, as far as there are any: “2 models, 1 setting”. */
const counted = ({ models, settings, flights }: { models: number; settings: number; flights: number }): string =>
  [
    models > 0 && plural(models, 'model', 'models'),
    settings > 0 && plural(settings, 'setting', 'settings'),
    flights > 0 && plural(flights, 'flight', 'flights'),
  ]
    .filter(Boolean)
    .join(', ');

const BROKEN = 'A value in it cannot be right.';

/** The library as files: export, import, and the word that it is time for an export. */
export const files = {
  counted,
  export: {
    all: 'Export all…',
    one: 'Export…',
    again: (name: string) => `Save to ${name}`,
    another: 'Export to another file…',
    saving: (name: string) => `Saving ${name}`,
    /** It is in a file that the pilot has chosen. */
    saved: (name: string, what: string) => `Saved to ${name}: ${what}.`,
    /** The browser has it. */
    downloaded: (name: string, what: string) => `${name} is in your downloads: ${what}.`,
    notWritten: (name: string) => `${name} could not be written. This browser puts it into your downloads instead.`,
    tooLarge: 'The library is too large for one file. Export its models one by one.',
    nothing: 'There is nothing to export yet.',
    failed: 'The file could not be made. Load the page again and try once more.',
  },
  import: {
    button: 'Import…',
    title: (name: string) => `Import ${name}`,
    reading: 'Reading the file',
    drop: 'Drop the file to see what is in it',
    lead: (date: string, by: string) => `Written ${date}${by === '' ? '' : ` by ${by}`}.`,
    holds: (what: string) => (what === '' ? 'There is nothing in it.' : `In it: ${what}.`),
    ignored: (count: number) =>
      `${plural(count, 'entry', 'entries')} of a kind that this version of the page does not know will be left out.`,
    nothing: 'You have all of this already.',
    differs: 'What differs',
    ways: { newer: 'Take the newer', both: 'Keep both', skip: 'Leave out' },
    /** Of a model of which nothing differs: in place of the first. */
    bring: 'Import',
    /** What differs of a model by itself: its name, notes, servos. */
    itself: 'the model itself',
    flightOf: (day: string) => `flight of ${day}`,
    more: (count: number) => `and ${count} more`,
    /** What becomes of what differs. */
    wayText: {
      newer: 'Where yours is newer, yours stays.',
      both: 'The one from the file comes beside yours, with a number behind its name.',
      skip: 'Nothing of these models is imported.',
    },
    loose: 'Without a model',
    unknownModel: 'A model that is not here',
    group: {
      way: (name: string) => `${name}: what becomes of it`,
      fresh: (what: string) => `New: ${what}`,
      same: (what: string) => `The same: ${what}`,
      fileNewer: (what: string) => `Newer in the file: ${what}`,
      deviceNewer: (what: string) => `Newer here: ${what}`,
    },
    take: (count: number) => `Import ${count}`,
    cancel: 'Cancel',
    close: 'Close',
    shut: 'This browser does not give the library back just now. An import could replace newer settings with older ones.',
    importing: (name: string, done: number, of: number) => `Importing ${name}: ${done} of ${of}`,
    done: (what: string, name: string) => `Imported from ${name}: ${what}.`,
    unkept: 'This browser has not kept all of it: what is on the screen lasts until the page is closed.',
    undo: 'Undo the import',
    undone: 'The import was undone.',
    partlyUndone: 'The import was undone. What was changed since then stays.',
    dismiss: 'Dismiss',
  },
  refused: {
    title: (name: string) => `${name} cannot be imported`,
    nothing: 'Nothing was imported.',
    line: (line: number, column: number) => `Line ${line}, column ${column}.`,
    field: (path: string) => `Entry: ${path}.`,
    between: (min: number, max: number) => `It must be ${min} to ${max}.`,
    characters: (min: number, max: number) => `It must have ${min} to ${max} characters.`,
    files: {
      'too-large': 'The file is too large for a library.',
      'no-text': 'The file is no text.',
      gone: 'The file could not be read. Is it still there?',
      several: 'Import one file at a time.',
      failed: 'The file could not be read. Load the page again and try once more.',
    },
    /** Of a file that cannot be read, by what is wrong with it. */
    kinds: {
      format: 'This is not a library file of Sidus Timer.',
      text: 'The text of the file is broken.',
      end: 'The file is not whole: it ends too early.',
      encoding: 'The letters of the file cannot be read. Save it as UTF-8.',
    } as Readonly<Record<string, string>>,
    codes: {
      'newer-version': 'A newer version of this page made this file. Load the page again to get that version.',
      'too-large': 'The file is too large, or nested too deep, for a library.',
      duplicate: 'Something stands twice that must stand once.',
      'out-of-range': 'A value is out of its range.',
      'wrong-count': 'A list does not have as many entries as the timer wants.',
      'bad-identity': 'No timer is as it says here.',
      'wrong-type': 'A value is missing, or of the wrong kind.',
      'not-an-integer': 'A value must be a whole number.',
      'unknown-word': 'A word stands here that does not belong here.',
    } as Readonly<Partial<Record<CodecErrorCode, string>>>,
    other: BROKEN,
  },
  reminder: {
    text: (changes: number, days: number) =>
      `${plural(changes, 'change', 'changes')} since the last export, ${days} days ago. Models, settings and flights are on this device alone.`,
    never: (entries: number) =>
      `${plural(entries, 'entry', 'entries')} of your library ${entries === 1 ? 'is' : 'are'} on this device alone. If the device is lost, only a file brings them back.`,
    later: 'Not now',
  },
};
