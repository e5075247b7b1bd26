import {
  type Change,
  changeRequests,
  differences,
  fieldKey,
  type ProgramField,
  type TimerProgram,
  valueAt,
} from '../program/index.js';
import {
  type CommandName,
  encodeRequest,
  type LayoutQuirks,
  MAX_POSITION,
  type Reply,
  type Request,
} from '../protocol/index.js';
import { TimerError, throwIfAborted } from './errors.js';
import type { ClientJob } from './job.js';
import { StageProgress } from './progress.js';
import { type Reading, readContent, readingPlan } from './read-program.js';

/** What became of one value. */
export interface ValueReport {
  readonly field: ProgramField;
  /** What the timer should hold. */
  readonly wanted: number | null;
  /** What a fresh read gave; null when it is not known. */
  readonly held: number | null;
  /** `verified`: a fresh read gave the wanted value. `differs`: it gave another. `unknown`: there was no fresh read. */
  readonly status: 'verified' | 'differs' | 'unknown';
  /** False for a value that was not to be changed and changed all the same; then `verified` means that it was put back. */
  readonly asked: boolean;
}

export interface WriteReport {
  /** `verified` only when a fresh read equals the whole program that was wanted. */
  readonly result: 'verified' | 'differs' | 'unknown';
  /** All values that were to be changed, and all that changed without being asked. */
  readonly values: readonly ValueReport[];
  /** What the timer holds by the last fresh read; null when there was none after the first SET request. */
  readonly held: TimerProgram | null;
  /** SET requests that were acknowledged. */
  readonly acknowledged: number;
  /** Requests that went out more than once, fences included. */
  readonly repeats: number;
  /** What stopped the write or the reading back; null when nothing did. */
  readonly stopped: TimerError | null;
}

/** The exchanges of a write: see {@link writeContent}. */
export function writePlan(baseline: TimerProgram, goal: TimerProgram, moveServos = false): CommandName[] {
  const requests = changeRequests(baseline, goal).flatMap(({ name }): CommandName[] =>
    moveServos && name === 'SETSERVO' ? ['MOVETOFUNC', name] : [name],
  );
  return [...freshPlan(baseline, goal), ...requests, ...verifyPlan(goal)];
}

/** The exchanges that come before the first SET request. */
export function freshPlan(baseline: TimerProgram, goal: TimerProgram): CommandName[] {
  return readingPlan(goal.identity, freshReading(baseline, goal));
}

/** The exchanges that come behind the last one. */
export function verifyPlan(goal: TimerProgram): CommandName[] {
  return readingPlan(goal.identity, verification(goal));
}

function freshReading(baseline: TimerProgram, goal: TimerProgram): Reading {
  const idleThrottle = baseline.idleThrottle !== null || goal.idleThrottle !== null;
  return { strict: true, memory: baseline.memory, known: baseline, idleThrottle };
}

function verification({ memory, idleThrottle }: TimerProgram): Reading {
  return { strict: true, memory, idleThrottle: idleThrottle !== null };
}

/**
 * Reads everything afresh and compares it with the baseline; only when all is the same sends what differs, reads everything back and
 * compares. What changed without being asked is put back once.
 * @throws before the first SET request: CodecError when the difference cannot be encoded, TimerError `other-timer`, `other-memory`,
 * `memory-unknown`, `stale`, `undecided`, `aborted`, or as Exchange. Afterwards it never throws a TimerError: the report says what stopped
 * it and what is known of each value.
 */
export async function writeContent(
  job: ClientJob,
  baseline: TimerProgram,
  goal: TimerProgram,
  moveServos = false,
): Promise<WriteReport> {
  const { exchange, identity, signal, quirks } = job;
  const { budget } = exchange;
  const before = budget.repeats;
  const asked = differences(baseline, goal).filter(({ to }) => to !== null);
  const requests = changeRequests(baseline, goal);
  // All of it must fit before any of it is sent.
  for (const request of requests) encodeRequest(request, { identity, quirks: quirks.assumed });
  await requireHeld(job, baseline, goal);
  if (quirks.byteOrderOpen && requests.some(({ name }) => name === 'SETTIMERS')) {
    throw new TimerError('undecided', 'the byte order of the times is in doubt', { request: 'SETTIMERS' });
  }
  throwIfAborted(signal);

  // Where the baseline was read, not where the goal says it comes from.
  const reading = verification({ ...goal, memory: baseline.memory });
  const questions = readingPlan(identity, reading);
  const strays = new Map<string, ProgramField>();
  let timesSaid: readonly number[] | null = null;
  const known: { acknowledged: number; held: TimerProgram | null } = { acknowledged: 0, held: null };

  const send = async (stage: 'write' | 'repair', batch: readonly Request[]): Promise<void> => {
    known.held = null;
    const names = batch.map(({ name }) => name);
    const progress = new StageProgress(stage, names, job);
    let standsAt: number | null = null;
    for (const request of batch) {
      if (moveServos && request.name === 'SETSERVO' && request.function !== standsAt) {
        standsAt = request.function;
        await exchange.ask({ name: 'MOVETOFUNC', function: standsAt }, signal);
      }
      const reply = await askNoting(job, request);
      if (reply.name === 'SETTIMERS') timesSaid = reply.times;
      known.acknowledged++;
      progress.finished(request.name);
    }
  };
  const readBack = async (): Promise<void> => {
    const read = await readContent(job, 'verify', reading);
    for (const { field } of unasked(read, goal, asked)) strays.set(fieldKey(field), field);
    known.held = read;
    noteRounding(job, goal, timesSaid, read);
    if (!moveServos) noteKept(job, asked, read);
  };

  /** Values that did not take beside others that nobody asked for, on a good line: the requests probably went to another timer. */
  const isElsewhere = (held: TimerProgram): boolean => {
    const wrong = unasked(held, goal, asked);
    const isExplained = exchange.damaged || wrong.some(({ field, from }) => isExchanged(requests, field, from));
    return wrong.length > 0 && !isExplained && asked.some(({ field, to }) => valueAt(held, field) !== to);
  };

  // Whatever the line does to the requests, there is time left to see what came of them.
  const batch = moveServos ? byColumn(requests) : requests;
  let stopped = await attempt(() => budget.keepTimeFor(questions, identity, () => send('write', batch)));
  if (!stopped || isUnanswered(stopped)) {
    stopped = (await attempt(readBack)) ?? stopped;
  }
  const held = known.held;
  if (held && (changedElsewhere(unasked(held, goal, asked), requests) || isElsewhere(held))) {
    stopped = new TimerError('changed', 'more values differ from what was read than this write can have changed');
  }
  const repair = held && stopped?.code !== 'changed' && repairs(job, held, asked, goal, requests, stopped === null);
  if (repair) {
    const { assumed } = quirks;
    quirks.assumed = { ...assumed, ...repair.quirks };
    stopped = await attempt(() => budget.keepTimeFor(questions, identity, () => send('repair', repair.requests)));
    quirks.assumed = assumed;
    stopped = (await attempt(readBack)) ?? stopped;
  }
  const values = [...asked.map(({ field }) => ({ field, asked: true })), ...[...strays.values()].map(putBack)];
  const verdict = compare(goal, values, known.held);
  // A reply that did not come means nothing once the timer was seen to hold all that was wanted.
  if (verdict.result === 'verified') stopped = null;
  return { ...verdict, ...known, repeats: budget.repeats - before, stopped };
}

/** Whether the line and the timer may go on although a request was given up. */
function isUnanswered({ code }: TimerError): boolean {
  return code === 'no-answer' || code === 'bad-reply' || code === 'unstable';
}

function putBack(field: ProgramField): { field: ProgramField; asked: boolean } {
  return { field, asked: false };
}

/** Positions in the order of the functions, so that the servos move once for each. */
function byColumn(requests: readonly Request[]): Request[] {
  const slot = (request: Request): number => (request.name === 'SETSERVO' ? request.function : -1);
  return [...requests].sort((a, b) => slot(a) - slot(b));
}

/** Asks, and notes a SETSERVO without an answer that a timer which takes the servo first would have found out of range. */
async function askNoting({ exchange, identity, signal, quirks }: ClientJob, request: Request): Promise<Reply> {
  try {
    return await exchange.ask(request, signal);
  } catch (error) {
    const isSilent = error instanceof TimerError && error.code === 'no-answer';
    if (isSilent && request.name === 'SETSERVO' && request.function >= identity.servos) {
      quirks.note('servo-unanswered', { servo: request.servo, slot: request.function });
    }
    throw error;
  }
}

/** The timer rounds when its acknowledgement and the reading back say the same other time than was sent. */
function noteRounding(
  { quirks }: ClientJob,
  { times }: TimerProgram,
  said: readonly number[] | null,
  held: TimerProgram,
): void {
  const slot = times.findIndex((time, index) => time !== said?.[index] && said?.[index] === held.times[index]);
  if (slot < 0) return;
  quirks.note('times-rounded', { slot, sent: times[slot] as number, held: held.times[slot] as number });
}

/** Whoever keeps positions of two functions although nothing moved does not need the servos to stand there. */
function noteKept({ quirks }: ClientJob, asked: readonly Change[], held: TimerProgram): void {
  const slots = asked.flatMap(({ field, to }) =>
    field.kind === 'position' && valueAt(held, field) === to ? [field.slot] : [],
  );
  if (new Set(slots).size > 1) quirks.drop('positions-unchanged', 'positionsNeedMove');
}

/**
 * Nothing may be written into another timer, another memory or over other values than the pilot saw.
 * @throws TimerError `other-timer`, `other-memory`, `memory-unknown`, `stale`.
 */
async function requireHeld(job: ClientJob, baseline: TimerProgram, goal: TimerProgram): Promise<void> {
  const held = await readContent(job, 'read', freshReading(baseline, goal));
  if (isHeld(baseline, held)) return;
  throw new TimerError('stale', 'the timer holds something else than the baseline', { held });
}

/** Whether a memory holds what was believed of it. An idle throttle that was not known may be anything. */
export function isHeld(believed: TimerProgram, held: TimerProgram): boolean {
  return differences(believed, held).every(({ from }) => from === null);
}

async function attempt(work: () => Promise<void>): Promise<TimerError | null> {
  try {
    await work();
    return null;
  } catch (error) {
    if (error instanceof TimerError) return error;
    throw error;
  }
}

/** Values that are not as wanted although nobody asked to change them. */
function unasked(held: TimerProgram, goal: TimerProgram, asked: readonly Change[]): Change[] {
  const changed = new Set(asked.map(({ field }) => fieldKey(field)));
  return differences(held, goal).filter(({ field, to }) => to !== null && !changed.has(fieldKey(field)));
}

/**
 * Whether more values changed by themselves than the requests can have disturbed: each one position, and SETTIMERS any of the times.
 * Then something else changed the timer, or it is another one, and putting back would overwrite what somebody wants.
 */
function changedElsewhere(wrong: readonly Change[], sent: readonly Request[]): boolean {
  const others = wrong.filter(({ field }) => field.kind !== 'time').length;
  const times = wrong.length > others ? 1 : 0;
  return others + times > sent.length;
}

/**
 * What to send after the reading back, or nothing. Values that changed without being asked are put back. Values that did not take
 * are sent once more only when damage was seen on the line: otherwise the timer rounds, or wants something else, and would do so again.
 * @param acknowledged whether each request was.
 */
function repairs(
  job: ClientJob,
  held: TimerProgram,
  asked: readonly Change[],
  goal: TimerProgram,
  sent: readonly Request[],
  acknowledged: boolean,
): { requests: Request[]; quirks: LayoutQuirks } | null {
  const wrong = unasked(held, goal, asked);
  const exchanged = wrong.find(({ field, from }) => isExchanged(sent, field, from))?.field;
  if (exchanged?.kind === 'position') {
    job.quirks.note('servo-first', { servo: exchanged.servo, slot: exchanged.slot });
    const cells = wrong.filter(({ field }) => field.kind === 'position');
    return { requests: requestsFor(held, goal, cells), quirks: { servoFirst: !job.quirks.assumed.servoFirst } };
  }
  const positions = asked.filter(({ field }) => field.kind === 'position');
  // What the timer never took up says nothing of what it does, and on a line that damages an acknowledgement may be another one's.
  if (
    acknowledged &&
    !job.exchange.damaged &&
    positions.length > 0 &&
    positions.every(({ field, from }) => valueAt(held, field) === from)
  ) {
    job.quirks.note('positions-unchanged');
    job.quirks.assume({ positionsNeedMove: true });
  }
  const again = requestsFor(held, goal, job.exchange.damaged ? differences(held, goal) : wrong);
  return again.length > 0 ? { requests: again, quirks: {} } : null;
}

/** Whether a cell changed to a position that was sent for the cell with function and servo exchanged. */
function isExchanged(sent: readonly Request[], field: ProgramField, value: number | null): boolean {
  return sent.some(
    (request) =>
      request.name === 'SETSERVO' &&
      field.kind === 'position' &&
      request.function !== request.servo &&
      request.function === field.servo &&
      request.servo === field.slot &&
      request.position === value,
  );
}

/** The requests for some of the changes only. A position that a timer may hold and nobody can set cannot be put back. */
function requestsFor(held: TimerProgram, goal: TimerProgram, changes: readonly Change[]): Request[] {
  const kept = new Set(changes.map(({ field }) => fieldKey(field)));
  return changeRequests(held, goal).filter((request) => {
    if (request.name === 'SETSERVO' && request.position > MAX_POSITION) return false;
    if (request.name === 'SETTIMERS') return changes.some(({ field }) => field.kind === 'time');
    if (request.name === 'SETLOWRPM') return kept.has('idleThrottle');
    return request.name === 'SETSERVO' && kept.has(`position:${request.servo}:${request.function}`);
  });
}

function compare(
  goal: TimerProgram,
  fields: readonly { field: ProgramField; asked: boolean }[],
  held: TimerProgram | null,
): Pick<WriteReport, 'result' | 'values'> {
  const values = fields.map(({ field, asked }): ValueReport => {
    const wanted = valueAt(goal, field);
    const found = held && valueAt(held, field);
    const status = found === null ? 'unknown' : found === wanted ? 'verified' : 'differs';
    return { field, wanted, held: found, status, asked };
  });
  if (values.some(({ status }) => status === 'differs')) return { result: 'differs', values };
  const known = held !== null && values.every(({ status }) => status === 'verified');
  return { result: known ? 'verified' : 'unknown', values };
}
