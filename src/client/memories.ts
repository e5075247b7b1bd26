import { requireShape, sameKind, type TimerProgram } from '../program/index.js';
import { CodecError, encodeReply, encodeRequest } from '../protocol/index.js';
import { requireAgreed } from './despite.js';
import { TimerError } from './errors.js';
import type { ClientJob } from './job.js';
import { MemoryRoundTrip, requireIndex, SELECT } from './memory-round-trip.js';
import type { ReadMemoriesOptions, WriteMemoriesOptions } from './options.js';
import { type ProgramRead, readingPlan } from './read-program.js';
import type { JobPart } from './schedule.js';
import { longestWrite, planWrite } from './write-plan.js';
import { writeContent } from './write-program.js';
import { isHeld, type WriteReport } from './write-report.js';

/** What several memories hold. */
export interface MemoriesRead {
  /** The memory that was current before and is current again, counted from 0. */
  readonly original: number;
  /** In the order in which the caller named the memories. */
  readonly programs: ProgramRead[];
}

/** What became of one memory of several. */
export interface MemoryReport {
  /** Counted from 0. */
  readonly memory: number;
  /** What it held before the write. */
  readonly before: TimerProgram;
  /** What became of the write. */
  readonly report: WriteReport;
}

/** What became of a write into several memories. */
export interface MemoriesReport {
  /** The memory that was current before, counted from 0. */
  readonly original: number;
  /** Whether it is current again, as the timer says. */
  readonly restored: boolean;
  /** The memories in which the write began, in the order of the goals. */
  readonly memories: readonly MemoryReport[];
  /** What stopped the write: `memory-left` whenever {@link restored} is false; null when nothing did. */
  readonly stopped: TimerError | CodecError | null;
}

/**
 * Reads several memories one after the other, and makes the first one current again at the end.
 * @throws CodecError when the timer has no such memory; TimerError `memory-unknown`: both before anything is selected.
 * `memory-left`, or as Exchange with the first memory current again.
 */
export async function readMemories(
  job: ClientJob,
  { memories: chosen, idleThrottle = false, onOriginal, onProgress }: ReadMemoriesOptions,
): Promise<MemoriesRead> {
  const { exchange, identity } = job;
  const memories = chosen ?? Array.from({ length: identity.memories }, (_, memory) => memory);
  for (const memory of memories) requireIndex(memory, identity);
  const names = [...SELECT, ...readingPlan(identity, { idleThrottle })];
  const parts = memories.map((memory): JobPart => ({ stage: 'read', memory, names }));
  const trip = await MemoryRoundTrip.begin(job, { parts, onProgress }, chosen !== undefined, onOriginal);
  const programs: ProgramRead[] = [];
  const readOnce: number[] = [];
  await trip.run(async () => {
    for (const [index, memory] of memories.entries()) {
      programs[index] = await trip.read(memory, idleThrottle);
      if (!exchange.damaged) readOnce.push(index);
    }
    if (!exchange.damaged) return;
    // They were believed on a single reading, before there was damage on the line.
    for (const index of readOnce) programs[index] = await trip.read(memories[index] as number, idleThrottle);
  });
  return { original: trip.original, programs };
}

/**
 * Writes several memories one after the other. It selects each, reads it, hands the reading to the caller, and writes
 * what differs from the goal as `writeProgram` does (which reads again before, and reads back after). It goes on to the
 * next memory only when nothing stopped the one before. At the end it makes the first memory current again.
 * @throws before anything is selected: TimerError `memory-unknown` (also for a goal without a memory), `other-timer`,
 * `serious`, CodecError when a goal cannot be carried. Later it throws only what a hook throws, with the first memory
 * current again. The report names everything else.
 */
export async function writeMemories(
  job: ClientJob,
  goals: readonly TimerProgram[],
  options: WriteMemoriesOptions,
): Promise<MemoriesReport> {
  const { onOriginal, onMemory, onProgress, baselines = [], moveServos = false } = options;
  for (const goal of goals) {
    requireGoal(job, goal);
    requireAgreed(goal, options);
  }
  for (const baseline of baselines) {
    requireShape(baseline);
    if (!sameKind(job.identity, baseline.identity))
      throw new TimerError('other-timer', 'a baseline is of another timer');
  }
  const parts = goals.flatMap((goal) => memoryParts(goal, goal.memory as number, moveServos));
  const trip = await MemoryRoundTrip.begin(job, { parts, onProgress }, true, onOriginal);
  const memories: MemoryReport[] = [];
  const write = async (goal: TimerProgram): Promise<void> => {
    const memory = goal.memory as number;
    const before = await trip.read(memory, asksThrottle(goal));
    requireBelieved(baselines, before);
    await job.exchange.schedule.waitFor(() => onMemory?.(before, goal));
    const report = await writeContent(job, planWrite(before, goal, moveServos));
    memories.push({ memory, before, report });
    if (report.stopped) throw report.stopped;
  };
  let stopped: MemoriesReport['stopped'] = null;
  try {
    await trip.run(async () => {
      for (const goal of goals) await write(goal);
    });
  } catch (error) {
    if (!(error instanceof TimerError || error instanceof CodecError)) throw error;
    stopped = error;
  }
  return { original: trip.original, restored: stopped?.code !== 'memory-left', memories, stopped };
}

/** @throws TimerError `stale` when a memory holds something else than its baseline. */
function requireBelieved(baselines: readonly TimerProgram[], held: TimerProgram): void {
  const believed = baselines.find(({ memory }) => memory === held.memory);
  if (!believed || isHeld(believed, held)) return;
  throw new TimerError('stale', `memory ${held.memory} holds something else than was believed`, { held });
}

/**
 * All goals must fit before any is written.
 * A goal may keep a position past the last step where the timer holds the same one.
 */
function requireGoal({ identity }: ClientJob, goal: TimerProgram): void {
  requireShape(goal);
  if (!sameKind(identity, goal.identity)) throw new TimerError('other-timer', 'a goal is for another kind of timer');
  if (goal.memory === null) throw new TimerError('memory-unknown', 'a goal does not say for which memory it is');
  requireIndex(goal.memory, identity);
  encodeRequest({ name: 'SETTIMERS', times: goal.times });
  encodeReply({ name: 'GETSERVOPOS', positions: goal.positions });
  if (goal.idleThrottle !== null) encodeRequest({ name: 'SETLOWRPM', idleThrottle: goal.idleThrottle });
}

function asksThrottle({ idleThrottle }: TimerProgram): boolean {
  return idleThrottle !== null;
}

/** Everything that one memory can need: select and read it, change all of it, read it back. */
function memoryParts(goal: TimerProgram, memory: number, moveServos: boolean): JobPart[] {
  const first = readingPlan(goal.identity, { idleThrottle: asksThrottle(goal) });
  const [reading, ...rest] = longestWrite(goal, moveServos).map((part) => ({ ...part, memory })) as [
    JobPart,
    ...JobPart[],
  ];
  return [{ ...reading, names: [...SELECT, ...first, ...reading.names] }, ...rest];
}
