import type { ReplyOf } from '../protocol/index.js';
import { TimerError } from './errors.js';
import type { ClientJob } from './job.js';
import { type Belief, type RetryPolicy, TRIES_OF_UNANSWERED, UNANSWERED_OPTIONAL } from './retry-policy.js';

/** Which memory is current. */
export interface CurrentMemory {
  /** Counted from 0; null when the timer does not say. */
  readonly memory: number | null;
  /** Whether the question was answered, with whatever. */
  readonly answered: boolean;
  /**
   * Whether the answer has shown that this timer counts its memories differently than assumed: no earlier number is
   * right.
   */
  readonly renumbered: boolean;
}

export interface MemoryQuestion {
  /** What it should be; null: the timer did not say. A single answer is believed when it says so, unless `twice`. */
  readonly expected?: number | null | undefined;
  /** Believes no single answer. */
  readonly twice?: boolean | undefined;
  /** Whether no answer, or none that makes sense, is no failure. */
  readonly optional?: boolean | undefined;
}

/**
 * Asks which memory is current (GETMEMORY). An answer that is not expected, or that changes how memories are counted,
 * is believed only when two in a row agree: the numbers of all memories depend on it.
 * @throws TimerError as Exchange.
 */
export async function askMemory(
  job: ClientJob,
  { expected, twice, optional }: MemoryQuestion = {},
): Promise<CurrentMemory> {
  const { quirks } = job;
  const fromOne = quirks.assumed.memoriesFromOne === true;
  const before: ReplyOf<'GETMEMORY'> | undefined =
    expected === undefined || twice ? undefined : { name: 'GETMEMORY', memory: expected };
  const reply = await ask(job, { before, twice }, optional === true);
  if (!reply) return { memory: null, answered: false, renumbered: false };
  const memory = await judge(job, reply, twice || before !== undefined);
  return { memory, answered: true, renumbered: fromOne !== (quirks.assumed.memoriesFromOne === true) };
}

/**
 * Makes sure that a memory is current.
 * @throws TimerError `other-memory` or `memory-unknown` when it is not; `other-timer`; as Exchange.
 */
export async function requireMemory(
  job: ClientJob,
  expected: number | null,
  how: Omit<MemoryQuestion, 'expected'> = {},
): Promise<CurrentMemory> {
  const now = await askMemory(job, { expected, ...how });
  if (now.memory === expected && !now.renumbered) return now;
  // Of another timer it says nothing.
  await job.exchange.requireIdentity(job.signal);
  const details = { expected: now.renumbered ? null : expected, found: now.memory };
  if (now.memory === null)
    throw new TimerError('memory-unknown', 'the timer does not say which memory is current', details);
  throw new TimerError('other-memory', `memory ${now.memory} is current, not ${expected}`, details);
}

/** @returns undefined when it may stay unanswered, and does. */
async function ask(
  { exchange, signal, quirks }: ClientJob,
  belief: Belief<ReplyOf<'GETMEMORY'>>,
  optional: boolean,
): Promise<ReplyOf<'GETMEMORY'> | undefined> {
  const isKnown = quirks.found.has('memory-unknown');
  const policy = optional ? policyFor(isKnown) : {};
  try {
    return await exchange.read({ name: 'GETMEMORY' }, signal, { ...belief, ...policy });
  } catch (error) {
    if (!optional || !isNoAnswer(error, isKnown) || !exchange.awake) throw error;
    quirks.note('memory-unknown');
    return undefined;
  }
}

/** How long a question is asked that not every timer is known to answer. */
export function policyFor(isKnownUnanswered: boolean): RetryPolicy {
  return isKnownUnanswered ? { tries: TRIES_OF_UNANSWERED } : { unanswered: UNANSWERED_OPTIONAL };
}

/** Whether this timer does not answer such a question, or not with anything that makes sense. */
export function isNoAnswer(error: unknown, isKnownUnanswered: boolean): error is TimerError {
  if (!(error instanceof TimerError)) return false;
  return error.code === 'no-answer' || error.code === 'bad-reply' || (isKnownUnanswered && error.code === 'unstable');
}

/** @param agreed whether two answers have said so. */
async function judge(job: ClientJob, reply: ReplyOf<'GETMEMORY'>, agreed: boolean): Promise<number | null> {
  const { exchange, identity, quirks, signal } = job;
  const isUsual = (memory: number | null): boolean => memory !== null && memory >= 0 && memory < identity.memories;
  if (isUsual(reply.memory)) return reply.memory;
  const { memory } = agreed ? reply : await exchange.read({ name: 'GETMEMORY' }, signal, { before: reply });
  if (memory === null) {
    quirks.note('memory-unknown');
    return null;
  }
  if (isUsual(memory)) return memory;
  // How many memories it has was perhaps misread.
  await exchange.requireIdentity(signal);
  if (memory < 0) {
    // No timer that counts from 1 has a memory 0.
    quirks.drop('memories-from-one');
    quirks.unassume('memoriesFromOne');
    return 0;
  }
  if (memory === identity.memories && !quirks.assumed.memoriesFromOne) {
    // One more than the last that is counted from 0: this timer counts from 1.
    quirks.note('memories-from-one');
    quirks.assume({ memoriesFromOne: true });
    return memory - 1;
  }
  quirks.note('memory-impossible', { index: memory + (quirks.assumed.memoriesFromOne ? 1 : 0) });
  return null;
}
