import { apart } from './apart.js';
import { plural } from './plural.js';

/** “Sidus library 2026-11-25.sidus.json”, whose date does not break. A long name must be able to. */
const fileName = (name: string): string => `“${apart(name.length > 40 ? name : name.replaceAll('-', '-\u2060'))}”`;

const ENTRY = { models: 'Model', settings: 'Program', flights: 'Flight' };

/** A place in a library file: the number of its entry from 1, and empty texts for what there is not. */
interface Place {
  readonly kind: keyof typeof ENTRY;
  readonly number: number;
  readonly name: string;
  readonly slot: string;
  readonly field: string;
}

/** “Program “calm morning”, function 2, time” */
const placed = ({ kind, number, name, slot, field }: Place): string =>
  [
    `${ENTRY[kind]} ${name === '' ? `${number} in the file` : `“${apart(name)}”`}`,
    /^\d/.test(slot) ? `function ${slot}` : slot,
    field.replace(/^positions\[(\d+)\]$/, (_, servo) => `S${Number(servo) + 1}`),
  ]
    .filter(Boolean)
    .join(', ');

/** The library as files: export, import, and the reminder to export. */
export const filesMessages = {
  export: {
    all: 'Export all…',
    one: 'Export…',
    /** Given to the browser as a download. It does not say whether it has saved the file. */
    downloaded: (name: string, what: string) =>
      `${fileName(name)} goes to your downloads: ${what}. Check that it is there.`,
    /** Added to the name of the program that wrote a file. */
    without: (kind: keyof typeof ENTRY) => `without ${kind}`,
    partly: (name: string, what: string, missing: readonly (keyof typeof ENTRY)[]) =>
      `${fileName(name)} is not complete. It holds ${what}. The browser cannot read the ${missing.join(' and ')} now: close other tabs of this page, and export again.`,
    tooLarge: 'The library is too large for one file. Export its models one by one.',
    failed: 'The file could not be made. Load the page again and try once more.',
  },
  import: {
    button: 'Import…',
    title: (name: string) => `Import ${name}`,
    lead: (date: string, what: string) => `Saved ${date}. It holds ${what || 'nothing'}.`,
    ignored: (count: number) =>
      `${plural(count, 'entry is', 'entries are')} of a newer version of this page and ${count === 1 ? 'is' : 'are'} left out.`,
    nothing: 'You have all of this already.',
    differs: 'What differs',
    ways: { newer: 'Take the newer', both: 'Keep both' },
    /** The facts of a model: its name, notes, servos. */
    itself: 'the model itself',
    flightOf: (day: string) => `flight of ${day}`,
    /** What happens to entries that differ. */
    wayText: {
      newer: 'What is newer here, or has the same date, stays.',
      both: 'Both stay. The one from the file gets a number after its name.',
    },
    unknownModel: 'A model that is not here',
    group: {
      fresh: (what: string) => `New: ${what}`,
      same: (what: string) => `The same: ${what}`,
      fileNewer: (what: string) => `Newer in the file: ${what}`,
      deviceNewer: (what: string) => `Not newer in the file: ${what}`,
      /** An entry that has another name here than in the file. */
      fileName: (here: string, file: string) => `${apart(file)} (here: ${apart(here)})`,
    },
    take: (count: number) => (count === 0 ? 'Nothing to import' : `Import ${count}`),
    /** Why there is nothing to import, and what to do. */
    allStays: 'Nothing in the file is newer. Choose “Keep both” to import it, too.',
    done: (what: string, name: string) => `Imported from ${fileName(name)}: ${what}.`,
    undo: 'Undo the import',
    undone: 'The import was undone. Later changes stay.',
  },
  refused: {
    title: (name: string) => `${name} cannot be imported`,
    nothing: 'Nothing was imported.',
    again: 'Export the file again, or ask its sender for a new one.',
    /** @param place null outside of all entries. @param wanted and `found`, as the check of the file says it. */
    fault: (line: number, place: Place | null, wanted: string, found: string) =>
      `Line\u00a0${line}${place ? `, ${placed(place)}` : ''}: expected ${wanted}, found ${found}.`,
    damaged: 'The file is damaged or not complete.',
    files: {
      'too-large': 'The file is too large for a library.',
      gone: 'The file could not be read. Choose it again.',
      several: 'Import one file at a time.',
    },
    format: 'This is not a library file of Sidus Timer.',
    newer: 'A newer version of this page made it. Load the page again while you are online.',
  },
  reminder: (changes: number) =>
    `${plural(changes, 'change', 'changes')} of the library ${changes === 1 ? 'is' : 'are'} only on this device. If you lose it, only a file brings ${changes === 1 ? 'it' : 'them'} back.`,
};
