import { LIMITS } from '../../program/index.js';
import { dotted } from '../messages/dotted.js';
import { messages } from '../messages/index.js';
import { memoryName } from '../messages/names.js';
import { beginningOf } from '../records/plain-names.js';
import type { Held, Standing } from '../timer/standing.js';
import type { Session } from './session.js';

/** How the program on the screen differs from what was read. Counts of fields. */
export interface Differing {
  /** Acknowledged by the timer while the servos followed, and not decided on. */
  readonly tried: number;
  readonly changes: number;
  /** Fields with a text that is no value. */
  readonly unfinished: number;
}

/** What kind of program it is when no timer was asked: null for one that was read. */
export type MadeAs = { readonly setting: string; readonly changes: number } | 'new' | null;

/**
 * The one sentence about the program on the screen and the timer. It says “as in the timer” only where every value was
 * read from there.
 * @param memory counted from 0; null when it is not known.
 * @param when the text of a time.
 */
export function standingText(
  standing: Standing,
  { tried, changes, unfinished }: Differing,
  made: MadeAs,
  memory: number | null,
  when: (at: number) => string,
): string {
  const { program, bench, knowledge: words } = messages.value;
  // Tried positions count as in the timer only while its content is certain.
  if (tried > 0 && standing.sure !== 'not') return bench.triedAndWaiting({ tried, waiting: changes });
  // What it would be changed from is not known.
  if (standing.sure === 'not')
    return words.unknown({ memory: memory === null ? words.thisMemory : memoryName(memory) });
  if (changes > 0) return program.changes({ count: changes });
  if (unfinished > 0) return words.unfinished({ count: unfinished });
  if (made === 'new') return words.made;
  if (made) return words.ofSetting({ name: made.setting, changes: made.changes });
  if (standing.at === null || standing.sure === 'once') {
    return standing.at === null ? words.lastRead : words.lastReadAt({ time: when(standing.at) });
  }
  return standing.verified ? words.verified({ time: when(standing.at) }) : words.readAt({ time: when(standing.at) });
}

/** What is said beside the marks of changed fields. */
export function hintText({ sure, at }: Standing, when: (at: number) => string): string {
  const { hints } = messages.value.knowledge;
  if (sure === 'now') return hints.now;
  return at === null ? hints.once : hints.onceAt({ time: when(at) });
}

/** How the program on the screen stands to no timer. */
export function madeAs({ editor, origin, opened }: Pick<Session, 'editor' | 'origin' | 'opened'>): MadeAs {
  if (editor.madeAt.value === null) return null;
  const setting = origin.setting.value?.name;
  if (setting === undefined) return 'new';
  const name = [origin.model.value?.name, setting].filter(Boolean).join(', ');
  return { setting: name, changes: opened.unsaved.value?.changes ?? 0 };
}

/** The name of the program on the screen: of its setting, and whether it is still that; empty when it has none. */
export function programName({ origin, opened }: Pick<Session, 'origin' | 'opened'>): string {
  const name = origin.setting.value?.name ?? '';
  if (name === '' || opened.unsaved.value?.changes === 0) return name;
  const { changed } = messages.value.knowledge;
  return changed({ name: beginningOf(name, LIMITS.name - changed({ name: '' }).length) });
}

/** The name of a memory, and when it was read if it may hold something else by now. */
export function heldName(name: string, { known, sure }: Held, when: (at: number) => string): string {
  if (sure === 'now' || known.state !== 'read') return name;
  return dotted([name, messages.value.knowledge.lastReadAt({ time: when(known.at) })]);
}
