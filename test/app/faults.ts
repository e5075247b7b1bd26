import { SHELF_CALLS, SHELVES } from '../../src/app/storage/index.js';
import { MemoryStore } from './bench/bench.js';

type ShelfName = (typeof SHELVES)[number];
type CallName = keyof typeof SHELF_CALLS;

/** One call of the storage: `drafts.save`. */
export type Door = `${ShelfName}.${CallName}` | 'change';

/**
 * Every call of every shelf, from the lists of the code itself, so that a new one is included without any change here.
 */
const DOORS: readonly Door[] = [
  'change',
  ...SHELVES.flatMap((shelf) => (Object.keys(SHELF_CALLS) as CallName[]).map((call): Door => `${shelf}.${call}`)),
];

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

/**
 * A storage whose calls can each be made to fail, or to wait first. As a browser, it makes the changes of a shelf in
 * the order in which they are asked for.
 */
export class FaultyStore extends MemoryStore {
  /** What comes before a call. Default: nothing. */
  before: (door: Door) => Promise<unknown> | undefined = () => undefined;
  /** The last change of each shelf. */
  readonly #changes = new Map<ShelfName, Promise<unknown>>();

  constructor() {
    super();
    const change = this.change.bind(this);
    this.change = (given) => {
      const wait = this.before('change');
      return wait ? wait.then(() => change(given)) : change(given);
    };
    for (const door of DOORS) {
      if (door === 'change') continue;
      const [name, call] = door.split('.') as [ShelfName, CallName];
      const shelf = this[name] as unknown as Record<CallName, (...given: unknown[]) => Promise<unknown>>;
      const own = shelf[call].bind(shelf);
      // Not an async function, so that an error that is thrown at once is thrown here, too.
      shelf[call] = (...given) => {
        const wait = this.before(door);
        if (SHELF_CALLS[call] === 'read') return wait ? wait.then(() => own(...given)) : own(...given);
        const before = Promise.allSettled([this.#changes.get(name)]);
        const change = Promise.all([before, wait]).then(() => own(...given));
        this.#changes.set(name, change);
        return change;
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

  /** From now on this call fails. @returns whether it has been made since. */
  fail(door: Door, fault: FaultName): () => boolean {
    let isMet = false;
    this.before = (each) => {
      if (each !== door) return undefined;
      isMet = true;
      return FAULTS[fault]();
    };
    return () => isMet;
  }

  /** @returns the calls that are made from now on, each once. */
  listen(): ReadonlySet<Door> {
    const made = new Set<Door>();
    this.before = (door) => void made.add(door);
    return made;
  }
}
