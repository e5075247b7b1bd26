import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { type Progress, TimerError, type TimerErrorCode } from '../../client/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { Knowledge } from './knowledge.js';
import type { Link } from './link.js';
import type { Notices } from './notices.js';
import type { Safety } from './safety.js';

/**
 * The kinds of jobs. `bench` moves servos or motor, `look` reads another memory, `memories` works on several, `frame`
 * sends a frame by hand.
 */
export type JobKind = 'read' | 'select' | 'look' | 'write' | 'memories' | 'bench' | 'frame';

/** A job on the wire, as others see it. */
export interface Job {
  readonly kind: JobKind;
  /** The memory that is being selected or looked at, counted from 0; null in any other job. */
  readonly memory: number | null;
  readonly progress: Progress | null;
  /** Whether it was asked to stop. The request in progress still comes to its end. */
  readonly stopping: boolean;
  /** Whether it waits for the pilot's answer, with nothing moving on the wire: see {@link JobContext.ask}. */
  readonly asking: boolean;
}

/** What a job gets: a signal to stop, a way to report progress, and checks whether it may go on. */
export interface JobContext {
  readonly signal: AbortSignal;
  readonly onProgress: (progress: Progress) => void;
  /**
   * Call it after every wait and before the next byte: the world may have changed.
   * @throws TimerError `closed` when the connection is no longer the one on which the job began; `stood-still`;
   * `aborted` when the pilot has asked to stop, or no longer says that it is safe.
   */
  readonly stillOn: () => void;
  /** Asks the pilot whether to go on, and waits. A lost connection or a stop counts as no. */
  readonly ask: () => Promise<boolean>;
}

/** How a job ended. */
export type JobEnd<T> =
  | { readonly good: true; readonly value: T }
  | {
      readonly good: false;
      /** What ended it; null when it did not begin, because another job has the wire or no timer is connected. */
      readonly error: unknown;
      /** Whether the connection was lost or replaced. That is reported once, elsewhere. */
      readonly lost: boolean;
    };

/** The work of a job, on the connection on which it began. */
export type Work<T> = (connection: TimerConnection, options: JobContext) => Promise<T>;

export interface RunnerParts {
  readonly link: Link;
  readonly safety: Safety;
  readonly notices: Notices;
  readonly knowledge: Knowledge;
  /** Hears that a job is over. */
  readonly recovery: { jobOver(): void };
}

/** Jobs that change what a timer holds, or which memory is current. They must not be cut off. */
const WRITING: ReadonlySet<JobKind> = new Set(['write', 'memories']);

/**
 * The one owner of the wire. Every byte to a timer after connecting belongs to one of its jobs,
 * and there is one job at a time.
 */
export class JobRunner {
  readonly #job = signal<Job | null>(null, { name: 'job' });
  readonly #claimed = signal(false, { name: 'claimed' });
  /** The job in progress. */
  readonly job: ReadonlySignal<Job | null> = this.#job;
  /** Whether a job, or connecting, has the wire. */
  readonly busy: ReadonlySignal<boolean>;
  /** Whether a timer is connected and nothing has the wire. */
  readonly ready: ReadonlySignal<boolean>;
  /** Whether bytes move that must not be cut off by leaving the page. */
  readonly writing: ReadonlySignal<boolean> = computed(() => {
    const job = this.#job.value;
    return job !== null && WRITING.has(job.kind) && !job.asking;
  });
  /** Whether a dialog shows what is about to be sent, or its result. Then the bench sends nothing. */
  readonly claimed: ReadonlySignal<boolean> = this.#claimed;
  readonly #parts: RunnerParts;
  #stop = new AbortController();
  #answer: ((goOn: boolean) => void) | null = null;

  constructor(parts: RunnerParts) {
    this.#parts = parts;
    const { link } = parts;
    this.busy = computed(() => this.#job.value !== null || link.busy.value);
    this.ready = computed(() => link.connection.value !== null && !this.busy.value);
  }

  /**
   * Runs one job and reports what went wrong. If the timer no longer answers, the link waits for it.
   * @param memory see {@link Job.memory}.
   * @returns whether it succeeded.
   */
  async run(kind: JobKind, work: Work<void>, memory: number | null = null): Promise<boolean> {
    const end = await this.perform(kind, work, memory);
    this.report(end);
    return end.good;
  }

  /** Runs one job on the present connection and returns how it ended. The caller reports that. */
  async perform<T>(kind: JobKind, work: Work<T>, memory: number | null = null): Promise<JobEnd<T>> {
    const { link, notices, knowledge, recovery } = this.#parts;
    const connection = link.connection.value;
    if (!connection || this.busy.value) return { good: false, error: null, lost: connection === null };
    const stop = new AbortController();
    this.#stop = stop;
    const { strays } = connection.client;
    notices.dismiss();
    this.#job.value = { kind, memory, progress: null, stopping: false, asking: false };
    try {
      const value = await work(connection, this.#optionsOf(connection, stop.signal));
      if (connection.client.strays > strays) notices.sayIfSilent('strays');
      return { good: true, value };
    } catch (error) {
      const lost = link.connection.value !== connection;
      // The head must not show a timer that is gone: asks the one that answers for its identity, and reads it.
      if (!lost && error instanceof TimerError && error.code === 'other-timer') link.recheck();
      return { good: false, error, lost };
    } finally {
      knowledge.jobOver();
      recovery.jobOver();
      this.#job.value = null;
      void link.learn();
    }
  }

  /**
   * Reports what ended a job. A lost connection is reported elsewhere, but that another memory was left current is
   * reported in any case.
   */
  report(end: JobEnd<unknown>): void {
    if (end.good || end.error === null) return;
    const isLeft = end.error instanceof TimerError && end.error.code === 'memory-left';
    if (isLeft || !end.lost) this.#parts.notices.report(end.error);
  }

  /**
   * Asks the job in progress to stop, if there is one. A job that has asked the pilot takes it for a no.
   * @returns a promise that settles when no job is left.
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

  /** Settles when no job is in progress and the caller of the last one has its result. */
  ended(): Promise<void> {
    return this.#when((job) => job === null);
  }

  /** Settles when nothing moves on the wire: the job has ended, or asks the pilot. */
  still(): Promise<void> {
    return this.#when((job) => job === null || job.asking);
  }

  #when(isSo: (job: Job | null) => boolean): Promise<void> {
    return new Promise((resolve) => {
      const stop = effect(() => {
        if (!isSo(this.#job.value)) return;
        queueMicrotask(() => {
          stop();
          resolve();
        });
      });
    });
  }

  /**
   * The connection has ended, so the job in progress ends. How the connection failed tells a write what became of it.
   */
  connectionOver(): void {
    if (this.#answer) this.answer(false);
    if (this.#job.peek()?.kind !== 'write') this.#abort();
  }

  /** A dialog opens that shows what is about to be sent, or its result; or it is closed. */
  claim(on: boolean): void {
    this.#claimed.value = on;
  }

  #optionsOf(connection: TimerConnection, signal: AbortSignal): JobContext {
    const { link, safety } = this.#parts;
    const { connection: present } = link;
    const wasSafe = safety.confirmed.value;
    const { client } = connection;
    const { standstills } = client;
    return {
      signal,
      onProgress: (progress) => {
        if (this.#stop.signal === signal) this.#change({ progress });
      },
      stillOn: () => {
        if (present.value !== connection) {
          throw new TimerError('closed', 'the connection is another by now');
        }
        if (client.standstills > standstills) throw new TimerError('stood-still', 'the page stood still');
        if (signal.aborted) throw new TimerError('aborted', 'stopped on request');
        if (wasSafe && !safety.confirmed.value) throw new TimerError('aborted', 'it is no longer safe');
      },
      ask: async () => {
        if (present.value !== connection) return false;
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

/** The code of what ended a job. A job that stopped because the connection was lost was not stopped by the pilot. */
export function stoppedBy({ error, lost }: Extract<JobEnd<unknown>, { good: false }>): TimerErrorCode | 'unexpected' {
  // It did not even begin.
  if (error === null) return 'closed';
  if (!(error instanceof TimerError)) return 'unexpected';
  return error.code === 'aborted' && lost ? 'port-lost' : error.code;
}
