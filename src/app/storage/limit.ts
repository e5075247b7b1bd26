/**
 * Why the browser did not store something, or did not give it back.
 * - `slow`: it has not answered in time. It may still do it.
 * - `blocked`: an older version of this page holds the storage.
 * - `full`: there is no room.
 * - `newer`: a newer version of this page has changed the storage.
 * - `missing`: the browser has no storage for this page, or it is switched off.
 * - `failed`: anything else.
 */
export type StorageErrorCode = 'slow' | 'blocked' | 'full' | 'newer' | 'missing' | 'failed';

/** The error of the browser's storage. */
export class StorageError extends Error {
  override readonly name = 'StorageError';
  readonly code: StorageErrorCode;

  constructor(code: StorageErrorCode, message: string, options?: ErrorOptions) {
    super(message, options);
    this.code = code;
  }

  /** The error of a browser as a code. A StorageError stays as it is. */
  static of(cause: unknown): StorageError {
    if (cause instanceof StorageError) return cause;
    const { name = '', message = String(cause) } = cause instanceof Error ? cause : {};
    return new StorageError(CODES[name] ?? 'failed', message, { cause });
  }
}

/** By the names of the browsers' errors. */
const CODES: Readonly<Record<string, StorageErrorCode>> = {
  QuotaExceededError: 'full',
  VersionError: 'newer',
  SecurityError: 'missing',
};

/** How long the storage may take for one call, in milliseconds. */
const STORAGE_LIMIT = 5000;

/** How many earlier questions have been answered, while one waits for its turn. */
type Signs = () => number;

/**
 * Calls back once nothing has happened for `ms` milliseconds: after each sign the time begins anew.
 * @returns ends it.
 */
function afterSilence(ms: number, callback: () => void, signs: Signs): () => void {
  let timer: ReturnType<typeof setTimeout>;
  const wait = (): void => {
    const before = signs();
    timer = setTimeout(() => (signs() === before ? callback() : wait()), ms);
  };
  wait();
  return () => clearTimeout(timer);
}

/**
 * The answer of the storage, if it comes in time: a browser may leave a question open for ever. A late answer is
 * ignored.
 * @param work a promise, or a function that gives one. An error that the function throws counts as a rejection.
 * @param ms how long to wait, in milliseconds.
 * @param signs default: it does not wait for others.
 * @throws StorageError
 */
export async function withinLimit<T>(
  work: Promise<T> | (() => Promise<T>),
  ms: number = STORAGE_LIMIT,
  signs: Signs = () => 0,
): Promise<T> {
  let end = (): void => {};
  const limit = new Promise<never>((_, reject) => {
    end = afterSilence(ms, () => reject(new StorageError('slow', `nothing within ${ms} ms`)), signs);
  });
  try {
    return await Promise.race([typeof work === 'function' ? work() : work, limit]);
  } catch (cause) {
    throw StorageError.of(cause);
  } finally {
    end();
  }
}

/** Hears how the storage works. */
export interface StorageWatch {
  /** The storage has given something back, or kept it; also when that came too late for the caller. */
  answered(shelf: string, kind: StorageCall): void;
  /** The storage has refused something, or has not answered for a while. */
  failed(shelf: string, kind: StorageCall, code: StorageErrorCode): void;
}

/** The two kinds of calls: to give something back, or to store or delete something. */
export type StorageCall = 'read' | 'change';

/** After this many milliseconds without an answer, the failure is reported. */
const SAID_AFTER = 3000;
/**
 * How long a storage may take that did not answer before: nobody should wait for it again and again. In milliseconds.
 */
const SHORT_LIMIT = 250;

/** Asks some shelves of a storage, and waits only as long as its earlier answers make sensible. */
export class StorageQuestions {
  readonly #watch: StorageWatch;
  readonly #shelves: readonly string[];
  #limit = STORAGE_LIMIT;
  #changes: Promise<unknown> = Promise.resolve();
  /** Sends those that wait for their turn, in their order. */
  readonly #waiting = new Set<() => void>();
  /** How many changes have been answered, each in its turn. */
  #answers = 0;

  constructor(watch: StorageWatch, ...shelves: string[]) {
    this.#watch = watch;
    this.#shelves = shelves;
  }

  /**
   * @param now at once, with the changes before it: the pilot leaves the page, and no answer may come any more.
   * @throws StorageError
   */
  async ask<T>(kind: StorageCall, work: () => Promise<T>, now = false): Promise<T> {
    const limit = this.#limit;
    // A late change must not undo a later one: changes go one by one, however long that takes.
    const waits = kind === 'change' && !now;
    const answer = new Promise<T>((resolve, reject) => {
      const send = (): void => {
        if (!this.#waiting.delete(send)) return;
        const sent = async (): Promise<T> => work();
        sent().then(resolve, reject);
      };
      this.#waiting.add(send);
      if (waits) void this.#changes.then(send);
      else if (kind === 'read') send();
      else for (const each of this.#waiting) each();
    });
    // Thousands of changes take long on any disk. The storage is slow only when it answers none of them.
    const signs = (): number => (waits ? this.#answers : 0);
    const fail = (code: StorageErrorCode): void => {
      for (const shelf of this.#shelves) this.#watch.failed(shelf, kind, code);
    };
    const say = (): void => fail('slow');
    const end = afterSilence(Math.min(limit, SAID_AFTER), say, signs);
    // Without the results: each would hold the one before, for as long as the page is open.
    if (kind === 'change') this.#changes = Promise.allSettled([this.#changes, answer]).then(() => {});
    answer.then(
      () => {
        end();
        if (waits) this.#answers++;
        this.#limit = STORAGE_LIMIT;
        for (const shelf of this.#shelves) this.#watch.answered(shelf, kind);
      },
      (cause) => {
        end();
        if (waits) this.#answers++;
        this.#limit = STORAGE_LIMIT;
        fail(StorageError.of(cause).code);
      },
    );
    try {
      return await withinLimit(answer, limit, signs);
    } catch (error) {
      if (error instanceof StorageError && error.code === 'slow') this.#limit = SHORT_LIMIT;
      throw error;
    }
  }
}
