import type { TimerProgram } from '../program/index.js';
import { type CommandName, encodeRequest, type Identity } from '../protocol/index.js';
import { askMemory } from './current-memory.js';
import { TimerError, type TimerErrorCode, throwIfAborted } from './errors.js';
import type { ClientJob } from './job.js';
import { bytesOf, type Progress } from './progress.js';
import { readContent } from './read-program.js';

/** The exchanges of {@link select}. */
export const SELECT: readonly CommandName[] = ['GETSWVER', 'SETMEMORY', 'GETSWVER', 'GETMEMORY', 'GETMEMORY'];
/** The exchanges of {@link MemoryRoundTrip.begin}. */
const BEGIN: readonly CommandName[] = ['GETSWVER', 'GETMEMORY', 'GETMEMORY'];

/**
 * Makes a memory current (SETMEMORY) on the timer that was identified, and asks until it has said twice that it is (GETMEMORY). It is what
 * flies next, so one answer is not enough.
 * @throws TimerError `other-timer`, `other-memory`, or as Exchange; CodecError when the timer has no such memory.
 */
export async function select(job: ClientJob, memory: number): Promise<void> {
  requireIndex(memory, job.identity);
  await job.exchange.requireIdentity(job.signal);
  await makeCurrent(job, memory);
}

/** @throws CodecError `out-of-range` when a timer has no such memory. */
export function requireIndex(memory: number, identity: Identity): void {
  encodeRequest({ name: 'SETMEMORY', memory }, { identity });
}

/** @returns false when the timer does not say which memory is current. */
async function makeCurrent(job: ClientJob, memory: number): Promise<boolean> {
  const { exchange, signal } = job;
  await exchange.ask({ name: 'SETMEMORY', memory }, signal);
  await exchange.requireIdentity(signal);
  const now = await askMemory(job, { expected: memory, twice: true });
  if (now.memory === null || (now.memory === memory && !now.renumbered)) return now.memory !== null;
  const details = { expected: now.renumbered ? null : memory, found: now.memory };
  throw new TimerError('other-memory', `memory ${now.memory} is current, not ${memory}`, details);
}

/** A way through several memories that begins and ends at the one that is current. Its progress is that of the whole way. */
export class MemoryRoundTrip {
  /** The memory that was current before, counted from 0. */
  readonly original: number;
  readonly #job: ClientJob;
  #onOriginal: ((original: number) => unknown) | undefined;
  readonly #total: number;
  /** The memory that was last selected; null when that is not certain. */
  #at: number | null;
  /** Bytes of the parts of the way that are done. */
  #done: number;

  private constructor(
    original: number,
    job: ClientJob,
    total: number,
    onOriginal: ((original: number) => unknown) | undefined,
  ) {
    this.original = original;
    this.#at = original;
    this.#job = job;
    this.#onOriginal = onOriginal;
    this.#total = total;
    this.#done = bytesOf(BEGIN, job.identity);
  }

  /**
   * Asks which memory is current.
   * @param plan all that will be asked between here and the way back.
   * @param numbered whether the caller has named memories by their numbers.
   * @param onOriginal told of that memory before the first other one is selected.
   * @throws TimerError `memory-unknown`, also when the answer shows that the numbers were wrong; `other-timer`; as Exchange.
   */
  static async begin(
    job: ClientJob,
    plan: readonly CommandName[],
    numbered: boolean,
    onOriginal?: (original: number) => unknown,
  ): Promise<MemoryRoundTrip> {
    const all: CommandName[] = [...BEGIN, ...plan, ...SELECT];
    job.exchange.begin(all);
    await job.exchange.requireIdentity(job.signal);
    const { memory: original, renumbered } = await askMemory(job, { twice: true });
    if (original === null) throw new TimerError('memory-unknown', 'the timer does not say which memory is current');
    if (renumbered && numbered) {
      throw new TimerError('memory-unknown', 'the timer counts its memories otherwise than was assumed');
    }
    return new MemoryRoundTrip(original, job, bytesOf(all, job.identity), onOriginal);
  }

  /**
   * Does the work and makes the first memory current again, also when the work fails or the signal asks to stop.
   * @throws TimerError `memory-left` when that cannot be done; what the work throws.
   */
  async run(work: () => Promise<void>): Promise<void> {
    const { exchange, identity } = this.#job;
    let failure: { readonly error: unknown } | undefined;
    try {
      await exchange.budget.keepTimeFor(SELECT, identity, work);
    } catch (error) {
      failure = { error };
      // Something else has selected one.
      if (codeOf(error) === 'other-memory') this.#at = null;
    }
    await this.#goBack(failure?.error);
    if (failure) throw failure.error;
  }

  /**
   * Makes a memory current, unless it is, and reads it.
   * @throws TimerError `memory-unknown`, `other-memory`; as Exchange.
   */
  async read(memory: number, plan: readonly CommandName[], idleThrottle: boolean): Promise<TimerProgram> {
    return this.part(memory, [...SELECT, ...plan], async (job) => {
      if (memory !== this.#at) await this.#select(job, memory);
      return readContent(job, 'read', { idleThrottle, memory });
    });
  }

  /** Does one part of the way. Its own stages are reported as parts of the whole. */
  async part<T>(memory: number, plan: readonly CommandName[], work: (job: ClientJob) => Promise<T>): Promise<T> {
    const { identity, onProgress } = this.#job;
    const size = bytesOf(plan, identity);
    const begin = this.#done;
    let stagesDone = 0;
    let last = 0;
    const report = (progress: Progress): void => {
      // A stage that begins adds to those before it.
      if (progress.done === 0) stagesDone += last;
      last = progress.done;
      const done = Math.min(this.#total, begin + Math.min(size, stagesDone + last));
      onProgress?.({ ...progress, memory, done, total: this.#total });
    };
    const result = await work({ ...this.#job, onProgress: report });
    this.#done = begin + size;
    return result;
  }

  async #select(job: ClientJob, memory: number): Promise<void> {
    const tell = this.#onOriginal;
    this.#onOriginal = undefined;
    if (tell) await job.exchange.budget.waitFor(() => tell(this.original));
    await job.exchange.requireIdentity(job.signal);
    throwIfAborted(job.signal);
    const before = this.#at;
    this.#at = null;
    try {
      if (await makeCurrent(job, memory)) this.#at = memory;
    } catch (error) {
      const { request, sent } = error instanceof TimerError ? error.details : {};
      // It never went out, so nothing has changed.
      if (request === 'SETMEMORY' && sent === 0) this.#at = before;
      throw error;
    }
    if (this.#at === null) {
      throw new TimerError('memory-unknown', 'the timer does not say which memory is current');
    }
  }

  async #goBack(cause: unknown): Promise<void> {
    if (this.#at === this.original) return;
    let failure: unknown;
    try {
      // Nothing is sent to a timer that is not the one that was left. Whoever asked to stop asked for this too.
      if (this.#job.exchange.usable && codeOf(cause) !== 'other-timer') {
        return await this.#select({ ...this.#job, signal: undefined }, this.original);
      }
    } catch (error) {
      failure = error;
    }
    const details = { expected: this.original, found: this.#at };
    const request = isSelectUnanswered(cause) || isSelectUnanswered(failure) ? { request: 'SETMEMORY' as const } : {};
    throw new TimerError(
      'memory-left',
      'the first memory is not current again',
      { ...details, ...request },
      cause ?? failure,
    );
  }
}

function codeOf(error: unknown): TimerErrorCode | undefined {
  return error instanceof TimerError ? error.code : undefined;
}

function isSelectUnanswered(error: unknown): boolean {
  return error instanceof TimerError && error.code === 'no-answer' && error.details.request === 'SETMEMORY';
}
