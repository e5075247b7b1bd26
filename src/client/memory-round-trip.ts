import { type CommandName, encodeRequest, type Identity } from '../protocol/index.js';
import { askMemory } from './current-memory.js';
import { TimerError, type TimerErrorCode, throwIfAborted } from './errors.js';
import type { ClientJob } from './job.js';
import { type ProgramRead, readContent } from './read-program.js';
import type { PlannedJob } from './schedule.js';

/** The exchanges of {@link select}. */
export const SELECT: readonly CommandName[] = ['GETSWVER', 'SETMEMORY', 'GETSWVER', 'GETMEMORY', 'GETMEMORY'];
/** The exchanges of {@link MemoryRoundTrip.begin}. */
const BEGIN: readonly CommandName[] = ['GETSWVER', 'GETMEMORY', 'GETMEMORY'];

/**
 * Makes a memory current (SETMEMORY) on the identified timer, then asks (GETMEMORY) until two answers agree. It is what
 * flies next, so one answer is not enough.
 * @throws TimerError `other-timer`, `other-memory`, or as Exchange; CodecError when the timer has no such memory.
 */
export async function select(job: ClientJob, memory: number): Promise<void> {
  requireIndex(memory, job.identity);
  await job.exchange.requireIdentity(job.signal);
  await makeCurrent(job, memory);
}

/** @throws CodecError `out-of-range` when the timer has no such memory. */
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

/** A round trip through several memories that begins and ends at the current one. */
export class MemoryRoundTrip {
  /** The memory that was current before, counted from 0. */
  readonly original: number;
  readonly #job: ClientJob;
  #onOriginal: ((original: number) => unknown) | undefined;
  /** The memory that was selected last; null when that is not certain. */
  #at: number | null;

  private constructor(original: number, job: ClientJob, onOriginal: ((original: number) => unknown) | undefined) {
    this.original = original;
    this.#at = original;
    this.#job = job;
    this.#onOriginal = onOriginal;
  }

  /**
   * Asks which memory is current.
   * @param planned all exchanges between here and the way back.
   * @param numbered whether the caller named memories by their numbers.
   * @param onOriginal called with the current memory before the first other one is selected.
   * @throws TimerError `memory-unknown`, also when the answer shows that the numbers were wrong; `other-timer`; as
   * Exchange.
   */
  static async begin(
    job: ClientJob,
    { parts, onProgress }: Omit<PlannedJob, 'identity'>,
    numbered: boolean,
    onOriginal?: (original: number) => unknown,
  ): Promise<MemoryRoundTrip> {
    job.exchange.begin({ parts: [{ names: BEGIN }, ...parts, { names: SELECT }], onProgress });
    await job.exchange.requireIdentity(job.signal);
    const { memory: original, renumbered } = await askMemory(job, { twice: true });
    if (original === null) throw new TimerError('memory-unknown', 'the timer does not say which memory is current');
    if (renumbered && numbered) {
      throw new TimerError('memory-unknown', 'the timer counts its memories otherwise than was assumed');
    }
    return new MemoryRoundTrip(original, job, onOriginal);
  }

  /**
   * Does the work, then makes the first memory current again, even when the work fails or the signal asks to stop.
   * @throws TimerError `memory-left` when it cannot be made current; whatever the work throws.
   */
  async run(work: () => Promise<void>): Promise<void> {
    const { schedule } = this.#job.exchange;
    let failure: { readonly error: unknown } | undefined;
    try {
      await schedule.keepTimeFor(SELECT, work);
      // Without a way back.
      if (this.#at === this.original) schedule.finish();
    } catch (error) {
      failure = { error };
      // Somebody else has selected another memory.
      if (codeOf(error) === 'other-memory') this.#at = null;
    }
    await this.#goBack(failure?.error);
    if (failure) throw failure.error;
  }

  /**
   * Makes a memory current, unless it is current already, and reads it.
   * @throws TimerError `memory-unknown`, `other-memory`; as Exchange.
   */
  async read(memory: number, idleThrottle: boolean): Promise<ProgramRead> {
    const { schedule } = this.#job.exchange;
    schedule.memory = memory;
    schedule.enter('read');
    if (memory !== this.#at) await this.#select(this.#job, memory);
    return readContent(this.#job, 'read', { idleThrottle, memory });
  }

  async #select(job: ClientJob, memory: number): Promise<void> {
    const tell = this.#onOriginal;
    this.#onOriginal = undefined;
    if (tell) await job.exchange.schedule.waitFor(() => tell(this.original));
    await job.exchange.requireIdentity(job.signal);
    throwIfAborted(job.signal);
    this.#at = null;
    const isTold = await makeCurrent(job, memory);
    if (!isTold) throw new TimerError('memory-unknown', 'the timer does not say which memory is current');
    this.#at = memory;
  }

  async #goBack(cause: unknown): Promise<void> {
    if (this.#at === this.original) return;
    let failure: unknown;
    try {
      // Another timer gets no request. After a signal to stop, the first memory is restored all the same.
      if (codeOf(cause) !== 'other-timer') {
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
