import { batch } from '@preact/signals';
import { TimerError, type WriteReport } from '../../client/index.js';
import { checkProgram, type Finding } from '../../program/index.js';
import { CodecError } from '../../protocol/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { JobContext } from '../timer/job-runner.js';
import type { Session } from '../work/session.js';
import { NotedRoundTrip, type RoundTripParts } from './noted-round-trip.js';
import {
  isOfScreen,
  isOwn,
  isPart,
  type MemoriesPlan,
  type MemoryChange,
  type MemoryEnd,
  type Outcome,
  type Review,
  tripOf,
} from './plan.js';

export type SendingParts = RoundTripParts & Pick<Session, 'knowledge' | 'recognition' | 'servoMoves' | 'link'>;

type Stopped = TimerError | CodecError | null;

/** One write on the wire, and what it has done so far. */
export class Sending {
  /** Whether the pilot asked to stop, though it may have come to its end. */
  isStopping = false;
  readonly #parts: SendingParts;
  readonly #review: Review;
  readonly #despite: readonly Finding['code'][];
  /** The memories in which writing has begun. */
  readonly #begun = new Set<number | null>();
  readonly #reports = new Map<number | null, WriteReport>();
  /** Whether the pilot goes on without a backup. */
  #agreed = false;
  #notHeld = false;

  /** @param despite the serious findings that the pilot has read. */
  constructor(parts: SendingParts, review: Review, despite: readonly Finding[]) {
    this.#parts = parts;
    this.#review = review;
    this.#despite = despite.map(({ code }) => code);
  }

  /** What became of each memory. */
  get outcome(): Omit<Outcome, 'stopped'> {
    const other = strayed([...this.#reports.values()]);
    const ends = this.#review.changes.map((change): MemoryEnd => {
      const { memory } = change;
      const report = this.#reports.get(memory) ?? null;
      const seen = report?.result ?? (this.#begun.has(memory) ? 'unknown' : 'untouched');
      return { memory, state: memory === other ? 'unknown' : seen, change, report };
    });
    return { ends, notHeld: this.#notHeld, strayed: other };
  }

  /** Writes what was shown, on the connection where it was shown. */
  async run(connection: TimerConnection, options: JobContext): Promise<void> {
    const { plan, changes } = this.#review;
    if (connection !== this.#review.connection) throw new TimerError('closed', 'it was shown for another connection');
    const writing = plan.kind === 'edits' ? this.#writeEdits(options) : this.#writeMemories(plan, options);
    const stopped = await writing.catch((error: unknown) => {
      if (error instanceof TimerError || error instanceof CodecError) return error;
      // After any other error nobody knows what was sent.
      throw error;
    });
    for (const { memory, before } of changes) {
      // Where the write did not even begin, nothing was sent.
      if (this.#reports.has(memory) || !this.#begun.delete(memory)) continue;
      await this.#parts.knowledge.ended(before);
    }
    this.isStopping = options.signal.aborted;
    if (stopped) throw stopped;
  }

  async #writeEdits(options: JobContext): Promise<Stopped> {
    const { editor, knowledge, recovery, recognition, servoMoves, link } = this.#parts;
    const { connection, changes, model, plan } = this.#review;
    const [change] = changes as [MemoryChange];
    const { before, goal, memory } = change;
    const { signal, onProgress } = options;
    const isSimulated = link.simulated.value;
    await this.#begin(change, options);
    const moveServos = servoMoves.take();
    const write = { baseline: before, despite: this.#despite, moveServos, signal, onProgress };
    const report = await connection.client.writeProgram(goal, write);
    const { held, stopped, result } = report;
    this.#reports.set(memory, report);
    this.#notHeld = servoMoves.wanted(moveServos, [report]);
    batch(() => {
      if (held) {
        // A complete read back leaves nothing to find out later.
        if (!stopped) void knowledge.ended(before);
        knowledge.read(held, Date.now(), result === 'verified');
        if (stopped) recovery.wasRead(held, isSimulated);
        if (isPart(plan)) editor.rebase(held);
        else editor.wrote(held);
        if (result === 'verified') recognition.wrote(model);
      }
      this.#doubt();
    });
    return stopped;
  }

  async #writeMemories(plan: MemoriesPlan, options: JobContext): Promise<Stopped> {
    const { knowledge, reader, editor, servoMoves } = this.#parts;
    const { connection, changes } = this.#review;
    const { client, identity } = connection;
    const trip = new NotedRoundTrip(this.#parts, tripOf(plan));
    const goals = changes.map(({ goal }) => goal);
    const moveServos = servoMoves.take();
    const { memories, stopped, original } = await client.writeMemories(goals, {
      ...options,
      // What was in a memory or is kept is copied as it is; the pilot has seen each change.
      despite: isOfScreen(plan) ? this.#despite : goals.flatMap((goal) => checkProgram(goal).map(({ code }) => code)),
      baselines: changes.map(({ before }) => before),
      moveServos,
      onOriginal: (original) => trip.leave(identity, original),
      onMemory: async (read, goal) => {
        const change = changes.find(({ memory }) => memory === goal.memory);
        if (!change) throw new TimerError('closed', 'it was not shown');
        await this.#begin({ ...change, before: read }, options);
      },
    });
    for (const { memory, before, report } of memories) {
      this.#reports.set(memory, report);
      // Nothing is waited for: another timer may be there when the storage answers.
      if (report.held && !report.stopped) void knowledge.ended(before);
      if (report.held) reader.took(report.held, report.result === 'verified');
      if (report.held && isOwn(plan)) editor.wrote(report.held);
    }
    this.#doubt();
    this.#notHeld = servoMoves.wanted(moveServos, [...this.#reports.values()]);
    await trip.wasRestored(identity, original, stopped);
    return stopped;
  }

  /**
   * Goal and backup are kept before the first byte goes into a memory: whatever happens, its content can then be
   * explained. Where the browser does not keep them, the pilot is asked, once.
   */
  async #begin({ memory, before, goal, changes }: MemoryChange, options: JobContext): Promise<void> {
    const { recovery, link } = this.#parts;
    options.stillOn();
    this.#begun.add(memory);
    const kept = changes.length === 0 || (await recovery.begin(before, goal, link.simulated.value));
    options.stillOn();
    if (kept) return;
    this.#agreed ||= await options.ask();
    if (!this.#agreed) throw new TimerError('aborted', 'not without a copy');
    options.stillOn();
  }

  /** Of a memory that may have taken values of another one nothing is known. */
  #doubt(): void {
    const other = strayed([...this.#reports.values()]);
    if (other !== null) this.#parts.knowledge.doubt(other);
  }
}

/**
 * The memory, counted from 0, that became current during a write, and so may have taken some of its values: a request
 * does not say for which memory it is. Null for none, and where nothing was to be changed: nothing was sent then.
 */
export function strayed(reports: readonly WriteReport[]): number | null {
  const report = reports.find(({ stopped }) => stopped?.code === 'other-memory');
  return report?.values.some(({ asked }) => asked) ? (report.stopped?.details.found ?? null) : null;
}
