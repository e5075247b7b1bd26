import { moreMessages } from '../../messages/more.js';
import { servoName } from '../../messages/names.js';
import { plainName } from '../../records/plain-names.js';
import type { Kind } from './import-plan.js';

/** Where in a file a fault stands, as a pilot knows it. */
export interface PlaceInFile {
  readonly kind: Kind;
  /** Among those of its kind, from 1. */
  readonly number: number;
  /** Empty when it has none that can be read. */
  readonly name: string;
  /** The slot of a program: `start`, `2`, `DT`. Empty outside of its slots. */
  readonly slot: string;
  /** The field of the slot or of the entry: `time`, `positions[1]`. */
  readonly field: string;
}

/**
 * @param text of the file.
 * @param path such as `settings[0].program.slots[2].time`.
 * @returns null for a place outside of all entries.
 */
export function placeInFile(text: string, path: string): PlaceInFile | null {
  const [, kind, index, inside = ''] = /^(models|settings|flights)\[(\d+)\]\.?(.*)$/.exec(path) ?? [];
  if (kind === undefined) return null;
  const entry = part(JSON.parse(text.replace(/^\uFEFF/, '')), kind, Number(index));
  const [, at, field = inside] = /^program\.slots\[(\d+)\]\.?(.*)$/.exec(inside) ?? [];
  const slot = at === undefined ? '' : wordOf(part(entry, 'program', 'slots', Number(at), 'slot'));
  return { kind: kind as Kind, number: Number(index) + 1, name: wordOf(part(entry, 'name')), slot, field };
}

/** Where in a file the fault stands, and what stands there: “Line 35, Program “calm”, function 1, time: found 700.” */
export function faultText(fault: { readonly line: number; readonly found: string }, place: PlaceInFile | null): string {
  const { refused: words } = moreMessages.value.files;
  return place === null ? words.fault(fault) : words.faultIn({ ...fault, place: placeText(place) });
}

/** “Program “calm morning”, function 2, time” */
function placeText({ kind, number, name, slot, field }: PlaceInFile): string {
  const { place: words } = moreMessages.value.files.refused;
  return [
    name === '' ? words.unnamed({ kind, number }) : words.entry({ kind, name }),
    /^\d/.test(slot) ? words.function({ number: slot }) : slot,
    field.replace(/^positions\[(\d+)\]$/, (_, servo) => servoName(Number(servo))),
  ]
    .filter(Boolean)
    .join(', ');
}

/** What stands at a place in a value that nobody has checked. */
function part(value: unknown, ...keys: readonly (string | number)[]): unknown {
  return keys.reduce(
    (inner: unknown, key) => (inner as Readonly<Record<string | number, unknown>> | null)?.[key],
    value,
  );
}

function wordOf(value: unknown): string {
  return typeof value === 'string' ? plainName(value) : '';
}
