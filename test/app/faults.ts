import { SHELF_CALLS, SHELVES } from '../../src/app/storage/index.js';
import { MemoryStore } from './bench/bench.js';

type ShelfName = (typeof SHELVES)[number];
type CallName = keyof typeof SHELF_CALLS;

/** One door to the storage: `drafts.save`. */
export type Door = `${ShelfName}.${CallName}`;

/** Every call of every shelf, by the code's own lists: a new one is among them unasked. */
export const DOORS: readonly Door[] = SHELVES.flatMap((shelf) =>
  (Object.keys(SHELF_CALLS) as CallName[]).map((call): Door => `${shelf}.${call}`),
);

/** What a browser may do instead of answering. */
export const FAULTS = {
  refuses: () => Promise.reject(new DOMException('The disk is gone.', 'UnknownError')),
  'is full': () => Promise.reject(new DOMException('No room.', 'QuotaExceededError')),
  'is newer': () => Promise.reject(new DOMException('Version 9.', 'VersionError')),
  throws: () => {
    throw new TypeError('There is none.');
  },
  hangs: () => new Promise<void>(() => {}),
  'comes late': () => new Promise<void>((resolve) => setTimeout(resolve, 7000)),
} satisfies Record<string, () => Promise<void>>;
export type FaultName = keyof typeof FAULTS;

/** A storage of which each call can be made to fail, or to wait, before it does what it should. */
export class FaultyStore extends MemoryStore {
  /** What stands before a call. Default: nothing. */
  before: (door: Door) => Promise<unknown> | undefined = () => undefined;

  constructor() {
    super();
    for (const door of DOORS) {
      const [name, call] = door.split('.') as [ShelfName, CallName];
      const shelf = this[name] as unknown as Record<CallName, (...given: unknown[]) => Promise<unknown>>;
      const own = shelf[call].bind(shelf);
      // Not an async function: what throws at once does so here, too.
      shelf[call] = (...given) => {
        const wait = this.before(door);
        return wait ? wait.then(() => own(...given)) : own(...given);
      };
    }
  }

  /** The same records, in the storage of the next page. */
  next(): FaultyStore {
    const store = new FaultyStore();
    for (const shelf of SHELVES) {
      for (const [key, record] of this[shelf].records) store[shelf].records.set(key, structuredClone(record) as never);
    }
    return store;
  }

  /** This door fails, from now on. */
  fail(door: Door, fault: FaultName): void {
    this.before = (each) => (each === door ? FAULTS[fault]() : undefined);
  }
}
