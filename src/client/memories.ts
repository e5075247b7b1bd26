import { requireShape, sameKind, type TimerProgram } from '../program/index.js';
import { CodecError, type CommandName, encodeReply, encodeRequest, type Identity } from '../protocol/index.js';
import { TimerError } from './errors.js';
import { type Job, questionsFor } from './read-program.js';
import { SELECT, Tour } from './tour.js';
import { type WriteReport, writeContent } from './write-program.js';

/** What a job on several memories tells on the way. It waits for an answer that is a promise; when that fails, so does the job. */
export interface MemoriesHooks {
  /** The memory that is current, before the first other one is selected: to be kept until it is current again. Counted from 0. */
  readonly onHome?: ((home: number) => unknown) | undefined;
  /** What a memory holds, before the first SET in it: to be kept as a backup. */
  readonly onMemory?: ((read: TimerProgram, goal: TimerProgram) => unknown) | undefined;
}

/** What several memories hold. */
export interface MemoriesRead {
  /** The memory that was current before and is again, counted from 0. */
  readonly home: number;
  /** In the order in which they were asked for. */
  readonly programs: TimerProgram[];
}

/** What became of one memory of several. */
export interface MemoryReport {
  /** Counted from 0. */
  readonly memory: number;
  /** What it held before. */
  readonly before: TimerProgram;
  readonly report: WriteReport;
}

/** What became of a write into several memories. */
export interface MemoriesReport {
  /** The memory that was current before, counted from 0. */
  readonly home: number;
  /** Whether it is current again, by the timer's own word. */
  readonly isHome: boolean;
  /** The memories in which the write began, in the order of the goals. */
  readonly memories: readonly MemoryReport[];
  /** What stopped it: `memory-left` whenever {@link isHome} is false; null when nothing did. */
  readonly stopped: TimerError | CodecError | null;
}

/**
 * Reads several memories one after the other, and makes the one current again that was.
 * @throws CodecError when the timer has no such memory; TimerError `memory-unknown`: both before anything is selected. `memory-left`, or
 * as Exchange with the first memory current again.
 */
export async function readMemories(
  job: Job,
  memories: readonly number[],
  idleThrottle: boolean,
  { onHome }: MemoriesHooks,
): Promise<MemoriesRead> {
  const { exchange, identity } = job;
  for (const memory of memories) requireMemory(memory, identity);
  const plan = readPlan(identity, idleThrottle);
  const tour = await Tour.begin(
    job,
    memories.flatMap(() => [...SELECT, ...plan]),
    onHome,
  );
  const programs: TimerProgram[] = [];
  const readOnce: number[] = [];
  await tour.run(async () => {
    for (const [index, memory] of memories.entries()) {
      programs[index] = await tour.read(memory, plan, idleThrottle);
      if (!exchange.damaged) readOnce.push(index);
    }
    if (!exchange.damaged) return;
    // They were believed on a single reading before damage was seen.
    for (const index of readOnce) programs[index] = await tour.read(memories[index] as number, plan, idleThrottle);
  });
  return { home: tour.home, programs };
}

/**
 * Writes several memories one after the other: selects it, reads it afresh, hands that to the caller, writes what differs from the goal,
 * reads back. Then makes the one current again that was. It goes on to the next memory only when nothing stopped the write of the one
 * before.
 * @throws before anything is selected: TimerError `memory-unknown` (also for a goal without one), `other-timer`, CodecError when a goal
 * cannot be carried. Later only what a hook throws, with the first memory current again. Of all else the report tells.
 */
export async function writeMemories(
  job: Job,
  goals: readonly TimerProgram[],
  hooks: MemoriesHooks,
  moveServos = false,
): Promise<MemoriesReport> {
  for (const goal of goals) requireGoal(job, goal);
  const plan = goals.flatMap((goal) => [
    ...SELECT,
    ...readPlan(goal.identity, asksThrottle(goal)),
    ...wholeWrite(goal, moveServos),
  ]);
  const tour = await Tour.begin(job, plan, hooks.onHome);
  const memories: MemoryReport[] = [];
  const write = async (goal: TimerProgram): Promise<void> => {
    const memory = goal.memory as number;
    const before = await tour.read(memory, readPlan(goal.identity, asksThrottle(goal)), asksThrottle(goal));
    await job.exchange.budget.waitFor(() => hooks.onMemory?.(before, goal));
    const report = await tour.part(memory, wholeWrite(goal, moveServos), (part) =>
      writeContent(part, before, goal, moveServos),
    );
    memories.push({ memory, before, report });
    if (report.stopped) throw report.stopped;
  };
  let stopped: MemoriesReport['stopped'] = null;
  try {
    await tour.run(async () => {
      for (const goal of goals) await write(goal);
    });
  } catch (error) {
    if (!(error instanceof TimerError || error instanceof CodecError)) throw error;
    stopped = error;
  }
  return { home: tour.home, isHome: stopped?.code !== 'memory-left', memories, stopped };
}

function requireMemory(memory: number, identity: Identity): void {
  encodeRequest({ name: 'SETMEMORY', memory }, { identity });
}

/** All goals must fit before any is written. A position past the last step may stand where the timer holds the same. */
function requireGoal({ identity }: Job, goal: TimerProgram): void {
  requireShape(goal);
  if (!sameKind(identity, goal.identity)) throw new TimerError('other-timer', 'a goal is for another kind of timer');
  if (goal.memory === null) throw new TimerError('memory-unknown', 'a goal does not say for which memory it is');
  requireMemory(goal.memory, identity);
  encodeRequest({ name: 'SETTIMERS', times: goal.timers }, { identity });
  encodeReply({ name: 'GETSERVOPOS', positions: goal.positions }, { identity });
  if (goal.idleThrottle !== null) encodeRequest({ name: 'SETLOWRPM', idleThrottle: goal.idleThrottle }, { identity });
}

function asksThrottle({ idleThrottle }: TimerProgram): boolean {
  return idleThrottle !== null;
}

function readPlan(identity: Identity, idleThrottle: boolean): CommandName[] {
  return ['GETSWVER', ...questionsFor(identity, idleThrottle)];
}

/** The exchanges of writing every value of a program and reading it back. */
function wholeWrite(goal: TimerProgram, moveServos: boolean): CommandName[] {
  const positions = goal.positions.flat().map((): CommandName => 'SETSERVO');
  const moves = goal.timers.flatMap((): CommandName[] => (moveServos ? ['MOVETOFUNC'] : []));
  const throttle: CommandName[] = asksThrottle(goal) ? ['SETLOWRPM'] : [];
  return [
    'GETMEMORY',
    'SETTIMERS',
    ...moves,
    ...positions,
    ...throttle,
    ...readPlan(goal.identity, asksThrottle(goal)),
  ];
}
