/**
 * Why the browser did not keep something, or did not give it back.
 * - `slow`: it has not answered in time. It may still do it.
 * - `blocked`: another tab holds an older version of the storage.
 * - `full`: there is no room.
 * - `newer`: a newer version of this page has arranged the storage.
 * - `missing`: the browser has no storage for this page, or it is switched off.
 * - `failed`: anything else.
 */
export type StorageErrorCode = 'slow' | 'blocked' | 'full' | 'newer' | 'missing' | 'failed';

/** What the storage of the browser says instead of doing what it was asked for. */
export class StorageError extends Error {
  override readonly name = 'StorageError';
  readonly code: StorageErrorCode;

  constructor(code: StorageErrorCode, message: string, options?: ErrorOptions) {
    super(message, options);
    this.code = code;
  }

  /** Whatever a browser has thrown, by code; a StorageError stays what it is. */
  static of(cause: unknown): StorageError {
    if (cause instanceof StorageError) return cause;
    const { name = '', message = String(cause) } = cause instanceof Error ? cause : {};
    return new StorageError(CODES[name] ?? 'failed', message, { cause });
  }
}

/** By the name of what browsers throw. */
const CODES: Readonly<Record<string, StorageErrorCode>> = {
  QuotaExceededError: 'full',
  VersionError: 'newer',
  SecurityError: 'missing',
};

/** So long the storage has for one thing, in milliseconds. */
export const STORAGE_LIMIT = 5000;

/**
 * What the storage gives, if it gives it in time: a browser may leave a question open for ever. What comes later is
 * skipped.
 * @param work a promise, or what begins it: whatever that throws at once is a rejection, too.
 * @param ms milliseconds.
 * @throws StorageError
 */
export async function withinLimit<T>(work: Promise<T> | (() => Promise<T>), ms: number = STORAGE_LIMIT): Promise<T> {
  let giveUp: ReturnType<typeof setTimeout> | undefined;
  const limit = new Promise<never>((_, reject) => {
    giveUp = setTimeout(() => reject(new StorageError('slow', `nothing within ${ms} ms`)), ms);
  });
  try {
    return await Promise.race([typeof work === 'function' ? work() : work, limit]);
  } catch (cause) {
    throw StorageError.of(cause);
  } finally {
    clearTimeout(giveUp);
  }
}

/** Told how the storage does. */
export interface StorageWatch {
  /** Something was given back, or kept: also when it came too late for whoever had asked. */
  answered(shelf: string, kind: StorageCall): void;
  /** Something was refused, or has not come for a while. */
  failed(shelf: string, kind: StorageCall, code: StorageErrorCode): void;
}

/** What can be asked of the storage: to give something back, or to keep something, or to throw it away. */
export type StorageCall = 'read' | 'change';

/** After so long it is said that the storage does not answer, in milliseconds. */
const SAID_AFTER = 3000;
/** So long a storage has that did not answer before: nobody has to wait for it again and again. */
const SHORT_LIMIT = 250;

/** Asks one shelf of a storage, and waits no longer than makes sense by what it did before. */
export class StorageQuestions {
  readonly #watch: StorageWatch;
  readonly #shelf: string;
  #limit = STORAGE_LIMIT;
  #changes: Promise<unknown> = Promise.resolve();

  constructor(watch: StorageWatch, shelf: string) {
    this.#watch = watch;
    this.#shelf = shelf;
  }

  /**
   * @param now at once, and not after the changes before it: the page is left, and nothing that is waited for comes
   * back to it.
   * @throws StorageError
   */
  async ask<T>(kind: StorageCall, work: () => Promise<T>, now = false): Promise<T> {
    const limit = this.#limit;
    const say = setTimeout(() => this.#watch.failed(this.#shelf, kind, 'slow'), Math.min(limit, SAID_AFTER));
    // A change that comes late must not undo the one after it: they go one by one, however long that takes.
    const answer = kind === 'change' && !now ? this.#changes.then(work) : (async () => work())();
    if (kind === 'change') this.#changes = Promise.allSettled([this.#changes, answer]);
    answer.then(
      () => {
        clearTimeout(say);
        this.#limit = STORAGE_LIMIT;
        this.#watch.answered(this.#shelf, kind);
      },
      (cause) => {
        clearTimeout(say);
        this.#limit = STORAGE_LIMIT;
        this.#watch.failed(this.#shelf, kind, StorageError.of(cause).code);
      },
    );
    try {
      return await withinLimit(answer, limit);
    } catch (error) {
      if (error instanceof StorageError && error.code === 'slow') this.#limit = SHORT_LIMIT;
      throw error;
    }
  }
}
