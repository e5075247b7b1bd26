import type { TimerProgram } from '../program/index.js';
import type { CommandName } from '../protocol/index.js';
import { TimerError, throwIfAborted } from './errors.js';
import { bytesOf, type Progress } from './progress.js';
import { type Job, readContent } from './read-program.js';

/** The exchanges of {@link select}. */
export const SELECT: readonly CommandName[] = ['SETMEMORY', 'GETMEMORY'];

/**
 * Makes a memory current (SETMEMORY) and asks whether it is (GETMEMORY).
 * @returns false when the timer does not say which memory is current.
 * @throws TimerError `other-memory`, or as Exchange; CodecError when the timer has no such memory.
 */
export async function select(job: Job, memory: number): Promise<boolean> {
  await job.exchange.ask({ name: 'SETMEMORY', memory }, job.signal);
  const found = await currentMemory(job);
  if (found === null || found === memory) return found !== null;
  throw new TimerError('other-memory', `memory ${found} is current, not ${memory}`, { expected: memory, found });
}

async function currentMemory({ exchange, signal, memoryOf }: Job): Promise<number | null> {
  const { reply } = await exchange.read({ name: 'GETMEMORY' }, signal);
  return memoryOf(reply);
}

/** A way through several memories that begins and ends at the one that is current. Its progress is that of the whole way. */
export class Tour {
  /** The memory that was current before, counted from 0. */
  readonly home: number;
  readonly #job: Job;
  #onHome: ((home: number) => unknown) | undefined;
  readonly #total: number;
  /** The memory that was last selected; null when that is not certain. */
  #at: number | null;
  /** Bytes of the parts of the way that are done. */
  #done: number;

  private constructor(home: number, job: Job, total: number, onHome: ((home: number) => unknown) | undefined) {
    this.home = home;
    this.#at = home;
    this.#job = job;
    this.#onHome = onHome;
    this.#total = total;
    this.#done = bytesOf(['GETMEMORY'], job.identity);
  }

  /**
   * Asks which memory is current.
   * @param plan all that will be asked between here and the way back.
   * @param onHome told of that memory before the first other one is selected.
   * @throws TimerError `memory-unknown`, or as Exchange.
   */
  static async begin(job: Job, plan: readonly CommandName[], onHome?: (home: number) => unknown): Promise<Tour> {
    const all: CommandName[] = ['GETMEMORY', ...plan, ...SELECT];
    job.exchange.begin(all);
    const home = await currentMemory(job);
    if (home === null) throw new TimerError('memory-unknown', 'the timer does not say which memory is current');
    return new Tour(home, job, bytesOf(all, job.identity), onHome);
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
      if (error instanceof TimerError && error.code === 'other-memory') this.#at = null;
    }
    await this.#goHome(failure?.error);
    if (failure) throw failure.error;
  }

  /**
   * Makes a memory current, unless it is, and reads it.
   * @throws TimerError `memory-unknown`, `other-memory`; as Exchange.
   */
  async read(memory: number, plan: readonly CommandName[], idleThrottle: boolean): Promise<TimerProgram> {
    const read = await this.part(memory, [...SELECT, ...plan], async (job) => {
      if (memory !== this.#at) await this.#select(job, memory);
      return readContent(job, 'read', idleThrottle);
    });
    if (read.memory === memory) return read;
    const details = { expected: memory, found: read.memory };
    throw new TimerError(
      read.memory === null ? 'memory-unknown' : 'other-memory',
      'another memory is current',
      details,
    );
  }

  /** Does one part of the way. Its own stages are reported as parts of the whole. */
  async part<T>(memory: number, plan: readonly CommandName[], work: (job: Job) => Promise<T>): Promise<T> {
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

  async #select(job: Job, memory: number): Promise<void> {
    const tell = this.#onHome;
    this.#onHome = undefined;
    if (tell) await job.exchange.budget.waitFor(() => tell(this.home));
    throwIfAborted(job.signal);
    const before = this.#at;
    this.#at = null;
    try {
      if (await select(job, memory)) this.#at = memory;
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

  async #goHome(cause: unknown): Promise<void> {
    if (this.#at === this.home) return;
    let failure: unknown;
    try {
      // Whoever asked to stop asked for this too.
      if (this.#job.exchange.usable) return await this.#select({ ...this.#job, signal: undefined }, this.home);
    } catch (error) {
      failure = error;
    }
    const details = { expected: this.home, found: this.#at };
    throw new TimerError('memory-left', 'the first memory is not current again', details, cause ?? failure);
  }
}
