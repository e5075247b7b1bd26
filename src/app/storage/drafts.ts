import { type DBSchema, type IDBPDatabase, openDB } from 'idb';
import * as v from 'valibot';
import type { TimerProgram } from '../../program/index.js';

/** What a pilot was working on, under the kind of timer and the memory that it is for. */
export interface Draft {
  readonly key: string;
  /** What the timer held when the work began. */
  readonly baseline: TimerProgram;
  readonly working: TimerProgram;
  /** Texts in fields that are no values yet, by field. */
  readonly texts: Readonly<Record<string, string>>;
  /** Milliseconds since 1970. */
  readonly savedAt: number;
  /** Whether it came from the simulated timer. */
  readonly simulated: boolean;
}

interface DraftSchema extends DBSchema {
  drafts: { key: string; value: unknown };
}

const number = v.pipe(v.number(), v.finite());
const program = v.object({
  identity: v.object({
    timerClass: v.pipe(v.string(), v.regex(/^[!-~]$/)),
    firmware: v.string(),
    functions: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(125)),
    memories: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(255)),
    servos: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(126)),
  }),
  memory: v.nullable(number),
  timers: v.array(number),
  positions: v.array(v.array(number)),
  idleThrottle: v.nullable(number),
});
const shaped = v.pipe(
  program,
  v.check(({ identity: { functions, servos }, timers, positions }) => {
    const columns = functions + 1;
    return timers.length === columns && positions.length === servos && positions.every((row) => row.length === columns);
  }, 'the lists do not have the shape of the identity'),
);
const draftSchema = v.object({
  key: v.string(),
  baseline: shaped,
  working: shaped,
  texts: v.record(v.string(), v.string()),
  savedAt: v.number(),
  simulated: v.boolean(),
});

/** Keeps drafts in the browser, so that what was typed survives a reload, a crash and a flat battery. */
export class DraftStore {
  readonly #open: Promise<IDBPDatabase<DraftSchema>>;

  constructor(name = 'sidus-timer') {
    // Where storage is switched off, opening may throw at once instead of failing later.
    this.#open = Promise.resolve().then(() =>
      openDB<DraftSchema>(name, 1, {
        upgrade: (database) => void database.createObjectStore('drafts', { keyPath: 'key' }),
      }),
    );
    // Whoever asks is told; nobody has asked yet.
    this.#open.catch(() => {});
  }

  async save(draft: Draft): Promise<void> {
    await (await this.#open).put('drafts', draft);
  }

  async remove(key: string): Promise<void> {
    await (await this.#open).delete('drafts', key);
  }

  /** The draft under this key; undefined when there is none or what is stored cannot be read. */
  async load(key: string): Promise<Draft | undefined> {
    return readDraft(await (await this.#open).get('drafts', key));
  }

  /** The draft that was saved last. */
  async newest(): Promise<Draft | undefined> {
    const all = (await (await this.#open).getAll('drafts')).map(readDraft).filter((draft) => draft !== undefined);
    return all.sort((a, b) => b.savedAt - a.savedAt)[0];
  }
}

function readDraft(stored: unknown): Draft | undefined {
  const result = v.safeParse(draftSchema, stored);
  return result.success ? result.output : undefined;
}
