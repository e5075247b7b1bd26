import type { TimerProgram } from '../program/index.js';
import type { CommandName, Identity } from '../protocol/index.js';
import { askMemory, isNoAnswer, policyFor, requireMemory } from './current-memory.js';
import { TimerError } from './errors.js';
import type { ClientJob } from './job.js';
import type { Progress } from './progress.js';
import { ATTEMPTS, READS } from './retry-policy.js';

/** The requests that read the content of a memory. Only Q is known to have a motor. */
function contentQuestions({ timerClass }: Identity, idleThrottle: boolean | undefined): CommandName[] {
  return timerClass === 'Q' || idleThrottle ? ['GETTIMERS', 'GETSERVOPOS', 'GETLOWRPM'] : ['GETTIMERS', 'GETSERVOPOS'];
}

/** How a program is read. */
export interface ReadingOptions {
  /** Asks for the idle throttle also on a timer of another class than Q. */
  readonly idleThrottle?: boolean | undefined;
  /**
   * The memory that must be current at the beginning and at the end; null: the timer does not say. Default: any, but
   * the same all the time.
   */
  readonly memory?: number | null | undefined;
  /** Believes nothing that another timer, a late reply or a misprinted letter could have caused. */
  readonly strict?: boolean | undefined;
  /** What the memory is believed to hold. Counts as the first of two readings. */
  readonly known?: TimerProgram | undefined;
}

/** The exchanges of {@link readContent} when nothing goes wrong. */
export function readingPlan(identity: Identity, { idleThrottle, strict, known }: ReadingOptions): CommandName[] {
  const content = contentQuestions(identity, idleThrottle);
  const ends: CommandName[] = ['GETMEMORY', 'GETSWVER'];
  if (!strict) return ['GETMEMORY', ...content, ...ends];
  return ['GETSWVER', 'GETMEMORY', ...content, ...(known ? [] : content), ...ends];
}

/** What the current memory holds. */
export interface ProgramRead extends TimerProgram {
  /**
   * The times may be wrong: they would rise if the two bytes of each were swapped (quirk `times-big-endian`). Ask the
   * pilot, then `assume({ bigEndianTimes })` and read again. Left out where nothing speaks for that.
   */
  readonly byteOrderOpen?: true;
}

export type MemoryValues = Pick<TimerProgram, 'times' | 'positions' | 'idleThrottle'>;

/**
 * Reads what the current memory holds. It asks for the current memory before and after, then for the identity, so it
 * notices another memory or another timer. One reading is enough if nothing speaks against it: there was no damage on
 * the line, no request was repeated, and no frame came that nobody asked for. Otherwise, and always when `strict`, two
 * readings in a row must agree. A strict reading starts again when an unexpected frame comes.
 * @throws TimerError `other-timer`; `other-memory` or `memory-unknown` when the wrong memory is current; `unstable` or
 * `crowded` when no two readings agree or the memory changes all the time; as Exchange.
 */
export async function readContent(job: ClientJob, stage: Progress['stage'], how: ReadingOptions): Promise<ProgramRead> {
  const { exchange, identity, signal } = job;
  const { strict = false, known } = how;
  exchange.schedule.enter(stage);
  let previous: MemoryValues | undefined = known;
  const seen = exchange.watch();
  for (let i = 0; i < ATTEMPTS; i++) {
    const seenNow = exchange.watch();
    if (strict) await exchange.requireIdentity(signal);
    const current =
      how.memory === undefined ? await askMemory(job, { optional: true }) : await requireMemory(job, how.memory);

    const content = await agreedContent(job, how, previous).catch((error: unknown) =>
      withPart(job, strict, current.memory, error),
    );

    const isSameMemory = !current.answered || (await isStillCurrent(job, current.memory, how));
    await exchange.requireIdentity(signal);
    const isBelieved = strict ? seenNow().strays === 0 : content.agreed || !exchange.damaged;
    if (isSameMemory && isBelieved) {
      const doubt = job.quirks.byteOrderOpen ? { byteOrderOpen: true as const } : {};
      return { identity, memory: current.memory, ...content.content, ...doubt };
    }
    previous = strict || !isSameMemory ? known : content.content;
  }
  throw exchange.unbelievable(`not one of ${ATTEMPTS} readings was undisturbed`, 'GETMEMORY', seen());
}

/**
 * When either times or positions come damaged in the same way each time, reads the others, to be looked at.
 * @throws what ended the reading, with what could be read all the same.
 */
async function withPart(
  { exchange, identity, signal }: ClientJob,
  strict: boolean,
  memory: number | null,
  error: unknown,
): Promise<never> {
  const isPart = error instanceof TimerError && error.details.alike && !strict;
  if (!isPart) throw error;
  const { details, message } = error;
  const part =
    details.request === 'GETSERVOPOS'
      ? { times: (await exchange.read({ name: 'GETTIMERS' }, signal, { twice: true })).times }
      : { positions: (await exchange.read({ name: 'GETSERVOPOS' }, signal, { twice: true })).positions };
  await exchange.requireIdentity(signal);
  throw new TimerError(error.code, message, { ...details, part: { identity, memory, ...part } });
}

async function isStillCurrent(job: ClientJob, memory: number | null, how: ReadingOptions): Promise<boolean> {
  if (how.memory !== undefined) return (await requireMemory(job, how.memory)).memory === memory;
  const now = await askMemory(job, { expected: memory, optional: true });
  return now.memory === memory && !now.renumbered;
}

/**
 * Reads the content until it can be believed.
 * @param before an earlier reading, or what is expected: counts as the first of two.
 */
export async function agreedContent(
  job: ClientJob,
  { strict, idleThrottle }: ReadingOptions,
  before: MemoryValues | undefined,
): Promise<{ content: MemoryValues; agreed: boolean }> {
  let previous = before;
  let request: CommandName = 'GETTIMERS';
  const seen = job.exchange.watch();
  for (let i = 0; i < READS; i++) {
    const { content, doubtful } = await readOnce(job, strict, idleThrottle);
    if (previous && textOf(content) === textOf(previous)) {
      noteByteOrder(job, content.times);
      return { content, agreed: true };
    }
    if (!strict && !doubtful && !previous) return { content, agreed: false };
    if (previous) request = differing(previous, content);
    previous = content;
  }
  throw job.exchange.unbelievable(`no two of ${READS} readings agreed`, request, seen());
}

/** @returns the content, and whether anything speaks against believing it alone. */
async function readOnce(
  job: ClientJob,
  strict: boolean | undefined,
  idleThrottle: boolean | undefined,
): Promise<{ content: MemoryValues; doubtful: boolean }> {
  const { exchange, identity, signal, quirks } = job;
  const seen = exchange.watch();
  const { times } = await exchange.ask({ name: 'GETTIMERS' }, signal, { strict });
  const { positions } = await exchange.ask({ name: 'GETSERVOPOS' }, signal, { strict });
  const wasRepeated = seen().repeats > 0;
  const wasMalformed = quirks.found.has('idle-throttle-malformed');
  let throttle: number | null = null;
  if (contentQuestions(identity, idleThrottle).includes('GETLOWRPM')) throttle = await askIdleThrottle(job);
  const content = { times, positions, idleThrottle: throttle };
  const isMisprint = quirks.isMisprintNew('GETTIMERS') || quirks.isMisprintNew('GETLOWRPM');
  const isOdd =
    isMisprint || !isByteOrderKnown(job, times) || quirks.found.has('idle-throttle-malformed') !== wasMalformed;
  return { content, doubtful: exchange.damaged || wasRepeated || isOdd };
}

/**
 * Not every timer is known to answer this, and nothing else depends on it.
 * But a timer that answers nothing else either is asleep.
 */
async function askIdleThrottle({ exchange, signal, quirks }: ClientJob): Promise<number | null> {
  const isKnown = quirks.found.has('idle-throttle-unanswered') || quirks.isAlike('GETLOWRPM');
  try {
    const { idleThrottle } = await exchange.ask({ name: 'GETLOWRPM' }, signal, policyFor(isKnown));
    if (idleThrottle === null) quirks.note('idle-throttle-malformed');
    return idleThrottle;
  } catch (error) {
    if (!isNoAnswer(error, isKnown) || !exchange.awake) throw error;
    if (quirks.isAlike('GETLOWRPM')) return null;
    quirks.note(error.code === 'bad-reply' ? 'idle-throttle-malformed' : 'idle-throttle-unanswered');
    return null;
  }
}

/** The first request whose values differ between two readings. */
function differing(a: MemoryValues, b: MemoryValues): CommandName {
  if (JSON.stringify(a.times) !== JSON.stringify(b.times)) return 'GETTIMERS';
  return JSON.stringify(a.positions) === JSON.stringify(b.positions) ? 'GETLOWRPM' : 'GETSERVOPOS';
}

function textOf({ times, positions, idleThrottle }: MemoryValues): string {
  return JSON.stringify([times, positions, idleThrottle]);
}

/**
 * What the times show about their byte order, if anything. `this`: as it is now. `other`:
 * they rise only with the bytes swapped.
 */
function byteOrderOf(times: readonly number[]): 'this' | 'other' | undefined {
  const isThis = rises(times);
  const isOther = rises(times.map(swapBytes));
  return isThis === isOther ? undefined : isThis ? 'this' : 'other';
}

/** Whether these times show nothing new about their byte order. */
function isByteOrderKnown({ quirks }: ClientJob, times: readonly number[]): boolean {
  const isSuspected = quirks.found.has('times-big-endian');
  return byteOrderOf(times) !== (isSuspected ? 'this' : 'other') || quirks.assumed.bigEndianTimes === true;
}

function noteByteOrder(job: ClientJob, times: readonly number[]): void {
  if (isByteOrderKnown(job, times)) return;
  if (byteOrderOf(times) === 'other') job.quirks.note('times-big-endian');
  else job.quirks.found.delete('times-big-endian');
}

/** Whether the times of the functions rise. Slot 0 does not count: it is the motor stop, or reserved. */
function rises(times: readonly number[]): boolean {
  return times.every((time, slot) => slot < 2 || time >= (times[slot - 1] as number));
}

function swapBytes(time: number): number {
  return ((time & 0xff) << 8) | (time >> 8);
}
