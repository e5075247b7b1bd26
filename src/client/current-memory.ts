import type { ReplyOf } from '../protocol/index.js';
import { TimerError } from './errors.js';
import type { ClientJob } from './job.js';
import { type Belief, type RetryPolicy, TRIES_OF_UNANSWERED, UNANSWERED_OPTIONAL } from './retry-policy.js';

/** What the timer says about its current memory. */
export interface CurrentMemory {
  /** Counted from 0; null when the timer does not say. */
  readonly memory: number | null;
  /** Whether the question got an answer of any kind. */
  readonly answered: boolean;
  /**
   * Whether the answer has shown that this timer counts its memories in another way than assumed. Then no earlier
   * number is right.
   */
  readonly renumbered: boolean;
}

export interface MemoryQuestion {
  /** The expected memory; null: the timer did not say. One answer that agrees with it is believed, unless `twice`. */
  readonly expected?: number | null | undefined;
  /** Believes no single answer: two must agree. */
  readonly twice?: boolean | undefined;
  /** Whether silence, or an answer that makes no sense, is no failure. */
  readonly optional?: boolean | undefined;
}

/**
 * Asks which memory is current (GETMEMORY). An unexpected answer, or one that changes how memories are counted, is
 * believed only when two in a row agree: the numbers of all memories depend on it.
 * @throws TimerError as Exchange.
 */
export async function askMemory(job: ClientJob, { expected, twice, optional }: MemoryQuestion): Promise<CurrentMemory> {
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
export async function requireMemory(job: ClientJob, expected: number | null): Promise<CurrentMemory> {
  const now = await askMemory(job, { expected, optional: true });
  if (now.memory === expected && !now.renumbered) return now;
  // The answer must not come from another timer.
  await job.exchange.requireIdentity(job.signal);
  const details = { expected: now.renumbered ? null : expected, found: now.memory };
  if (now.memory === null)
    throw new TimerError('memory-unknown', 'the timer does not say which memory is current', details);
  throw new TimerError('other-memory', `memory ${now.memory} is current, not ${expected}`, details);
}

/** @returns undefined when there was no answer and none is needed. */
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

/** How often to ask a question that not every timer is known to answer. */
export function policyFor(isKnownUnanswered: boolean): RetryPolicy {
  return isKnownUnanswered ? { tries: TRIES_OF_UNANSWERED } : { unanswered: UNANSWERED_OPTIONAL };
}

/** Whether this timer gave no answer to such a question, or none that makes sense. */
export function isNoAnswer(error: unknown, isKnownUnanswered: boolean): error is TimerError {
  if (!(error instanceof TimerError)) return false;
  return error.code === 'no-answer' || error.code === 'bad-reply' || (isKnownUnanswered && error.code === 'unstable');
}

/** @param agreed whether two answers in a row agree. */
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
  // The number of memories may have been misread.
  await exchange.requireIdentity(signal);
  if (memory < 0) {
    // A timer that counts from 1 has no memory 0.
    quirks.found.delete('memories-from-one');
    quirks.unassume('memoriesFromOne');
    return 0;
  }
  if (memory === identity.memories && !quirks.assumed.memoriesFromOne) {
    // One more than the last index when counting from 0: this timer counts from 1.
    quirks.note('memories-from-one');
    quirks.assume({ memoriesFromOne: true });
    return memory - 1;
  }
  quirks.note('memory-impossible', { index: memory + (quirks.assumed.memoriesFromOne ? 1 : 0) });
  return null;
}
