import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { type Progress, TimerError, type TimerErrorCode } from '../../client/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { Knowledge } from './knowledge.js';
import type { Link } from './link.js';
import type { Notices } from './notices.js';
import type { Safety } from './safety.js';

/**
 * What a job does: the bench moves servos or motor, `look` reads another memory, `memories` several, `frame` is one
 * sent by hand.
 */
export type JobKind = 'read' | 'select' | 'look' | 'write' | 'memories' | 'bench' | 'frame';

/** A job on the wire, as it is seen from outside. */
export interface Job {
  readonly kind: JobKind;
  /** The memory that is being made current, or looked at, counted from 0; null when the job is another. */
  readonly memory: number | null;
  readonly progress: Progress | null;
  /** It was asked to stop; the request under way comes to its end. */
  readonly stopping: boolean;
  /** It waits for the pilot's answer, and nothing moves on the wire: see {@link JobContext.ask}. */
  readonly asking: boolean;
}

/** What a job is handed: the way to stop it, the ear for how far it has come, and what makes sure that it may go on. */
export interface JobContext {
  readonly signal: AbortSignal;
  readonly onProgress: (progress: Progress) => void;
  /**
   * To be called after whatever was waited for, before the next byte: the world may have changed meanwhile.
   * @throws TimerError `closed` when the connection is no longer the one on which the job began; `aborted` when the
   * pilot has asked to stop, or has taken back that it is safe.
   */
  readonly stillOn: () => void;
  /** Waits until the pilot has said whether to go on. A lost connection, or a stop, is a no. */
  readonly ask: () => Promise<boolean>;
}

/** How a job ended. */
export type JobEnd<T> =
  | { readonly good: true; readonly value: T }
  | {
      readonly good: false;
      /** What ended it; null when it did not begin, since another one holds the wire or there is none. */
      readonly error: unknown;
      /** The connection is gone, or is another: that says so itself, once. */
      readonly lost: boolean;
    };

/** What is done on the connection on which a job began. */
export type Work<T> = (connection: TimerConnection, options: JobContext) => Promise<T>;

interface RunnerOptions {
  readonly link: Link;
  readonly safety: Safety;
  readonly notices: Notices;
  readonly knowledge: Knowledge;
}

/** Jobs that change what a timer holds, or which memory is current: not to be cut off in the middle. */
const WRITING: ReadonlySet<JobKind> = new Set(['write', 'memories']);

/**
 * The one owner of the wire: every byte that goes to a timer after the connecting belongs to one of its jobs, and there
 * is one at a time.
 */
export class JobRunner {
  readonly #job = signal<Job | null>(null, { name: 'job' });
  readonly #claims = signal<ReadonlySet<object>>(new Set(), { name: 'claims' });
  /** The job under way. */
  readonly job: ReadonlySignal<Job | null> = this.#job;
  /** A job, or the way to a timer, holds the wire. */
  readonly busy: ReadonlySignal<boolean>;
  /** A timer is connected, and nothing holds the wire. */
  readonly ready: ReadonlySignal<boolean>;
  /** Bytes move that must not be cut off: by leaving the page, or for another tab. */
  readonly writing: ReadonlySignal<boolean> = computed(() => {
    const job = this.#job.value;
    return job !== null && WRITING.has(job.kind) && !job.asking;
  });
  /** A dialog shows what is about to be sent, or what became of it: the bench sends nothing behind it. */
  readonly claimed: ReadonlySignal<boolean> = computed(() => this.#claims.value.size > 0);
  readonly #link: Link;
  readonly #safety: Safety;
  readonly #notices: Notices;
  readonly #knowledge: Knowledge;
  #stop = new AbortController();
  #answer: ((goOn: boolean) => void) | null = null;

  constructor({ link, safety, notices, knowledge }: RunnerOptions) {
    this.#link = link;
    this.#safety = safety;
    this.#notices = notices;
    this.#knowledge = knowledge;
    this.busy = computed(() => this.#job.value !== null || link.busy.value);
    this.ready = computed(() => link.connection.value !== null && !this.busy.value);
  }

  /**
   * Runs one job and says what went wrong with it. A timer that no longer answers is waited for.
   * @param memory see {@link Job.memory}.
   * @returns whether it came to its end.
   */
  async run(kind: JobKind, work: Work<void>, memory: number | null = null): Promise<boolean> {
    const end = await this.perform(kind, work, memory);
    this.report(end);
    return end.good;
  }

  /**
   * Runs one job, bound to the connection on which it begins, and hands back how it ended; whoever calls it says so.
   */
  async perform<T>(kind: JobKind, work: Work<T>, memory: number | null = null): Promise<JobEnd<T>> {
    const connection = this.#link.connection.value;
    if (!connection || this.busy.value) return { good: false, error: null, lost: connection === null };
    const stop = new AbortController();
    this.#stop = stop;
    const { strays } = connection.client;
    this.#notices.dismiss();
    this.#job.value = { kind, memory, progress: null, stopping: false, asking: false };
    try {
      const value = await work(connection, this.#optionsOf(connection, stop.signal));
      if (connection.client.strays > strays) this.#notices.sayIfSilent('strays');
      return { good: true, value };
    } catch (error) {
      const lost = this.#link.connection.value !== connection;
      // The head must not go on naming a timer that is no longer there: whoever answers is asked what it is, and read.
      if (!lost && error instanceof TimerError && error.code === 'other-timer') this.#link.recheck();
      return { good: false, error, lost };
    } finally {
      this.#knowledge.jobOver();
      this.#job.value = null;
      void this.#link.learn();
    }
  }

  /**
   * Says what ended a job, unless the connection did: that says so itself. That another memory was left current is said
   * in any case.
   */
  report(end: JobEnd<unknown>): void {
    if (end.good || end.error === null) return;
    const isLeft = end.error instanceof TimerError && end.error.code === 'memory-left';
    if (isLeft || !end.lost) this.#notices.report(end.error);
  }

  /**
   * Asks the job under way to stop, if there is one; one that has asked the pilot takes it for a no.
   * @returns when there is none any more.
   */
  stop(): Promise<void> {
    if (this.#answer) this.answer(false);
    else this.#abort();
    return this.ended();
  }

  /** The pilot's answer to a job that has asked: see {@link JobContext.ask}. */
  answer(goOn: boolean): void {
    const answer = this.#answer;
    this.#answer = null;
    this.#change({ asking: false, ...(goOn ? {} : { stopping: true }) });
    answer?.(goOn);
  }

  /** Settles when no job is under way, and whoever began the last one has taken it in. */
  ended(): Promise<void> {
    return new Promise((resolve) => {
      const stop = effect(() => {
        if (this.#job.value) return;
        queueMicrotask(() => {
          stop();
          resolve();
        });
      });
    });
  }

  /**
   * The connection has come to its end: what is under way ends. A write tells what became of it by how the connection
   * failed.
   */
  connectionOver(): void {
    if (this.#answer) this.answer(false);
    if (this.#job.peek()?.kind !== 'write') this.#abort();
  }

  /** @param on whether the owner shows what is about to be sent, or what became of it. */
  claim(owner: object, on: boolean): void {
    if (this.#claims.peek().has(owner) === on) return;
    const claims = new Set(this.#claims.peek());
    if (on) claims.add(owner);
    else claims.delete(owner);
    this.#claims.value = claims;
  }

  #optionsOf(connection: TimerConnection, signal: AbortSignal): JobContext {
    const wasSafe = this.#safety.confirmed.value;
    return {
      signal,
      onProgress: (progress) => {
        if (this.#stop.signal === signal) this.#change({ progress });
      },
      stillOn: () => {
        if (this.#link.connection.value !== connection) {
          throw new TimerError('closed', 'the connection is another by now');
        }
        if (signal.aborted) throw new TimerError('aborted', 'stopped on request');
        if (wasSafe && !this.#safety.confirmed.value) throw new TimerError('aborted', 'it is no longer safe');
      },
      ask: async () => {
        if (this.#link.connection.value !== connection) return false;
        this.#change({ asking: true });
        return await new Promise<boolean>((resolve) => {
          this.#answer = resolve;
        });
      },
    };
  }

  #abort(): void {
    this.#stop.abort();
    this.#change({ stopping: true });
  }

  #change(part: Partial<Job>): void {
    const job = this.#job.peek();
    if (job) this.#job.value = { ...job, ...part };
  }
}

/** What ended a job, by code; a job that was stopped since the connection is gone was not stopped by the pilot. */
export function stoppedBy({ error, lost }: Extract<JobEnd<unknown>, { good: false }>): TimerErrorCode | 'unexpected' {
  // It did not even begin.
  if (error === null) return 'closed';
  if (!(error instanceof TimerError)) return 'unexpected';
  return error.code === 'aborted' && lost ? 'port-lost' : error.code;
}
