import type { TimerProgram } from '../program/index.js';
import type { Identity, ReplyOf } from '../protocol/index.js';
import { TimerError } from './errors.js';
import type { Exchange, Patience } from './exchange.js';
import { TRIES_OF_UNANSWERED, UNANSWERED_OPTIONAL } from './patience.js';
import { type OnProgress, StageProgress } from './progress.js';
import type { QuirkCode, Quirks } from './quirks.js';

/** What a job of the client works with. */
export interface Job {
  readonly exchange: Exchange;
  readonly identity: Identity;
  readonly signal: AbortSignal | undefined;
  readonly onProgress: OnProgress;
  readonly quirks: Quirks;
  /** The index of the reply as a memory counted from 0. */
  readonly memoryOf: (reply: ReplyOf<'GETMEMORY'>) => number | null;
}

const ALWAYS = ['GETMEMORY', 'GETTIMERS', 'GETSERVOPOS'] as const;
type Question = (typeof ALWAYS)[number] | 'GETLOWRPM' | 'GETSWVER';

/** The questions that a timer is asked for its program: only Q is known to have a motor. */
export function questionsFor({ timerClass }: Identity, idleThrottle: boolean): Question[] {
  return timerClass === 'Q' || idleThrottle ? [...ALWAYS, 'GETLOWRPM'] : [...ALWAYS];
}

/**
 * Reads what the current memory holds. When damage is first seen on the way, all that was believed on a single reading, the identity
 * included, is read again until two agree.
 * @throws TimerError `other-timer` when that shows another identity; as Exchange.
 */
export async function readContent(job: Job, stage: 'read' | 'verify', idleThrottle = false): Promise<TimerProgram> {
  const { exchange, identity, signal } = job;
  const questions = questionsFor(identity, idleThrottle);
  const progress = new StageProgress(stage, questions, job);
  const replies = new Map<Question, ReplyOf<Question> | null>();
  const single = new Map<Question, ReplyOf<Question>>([['GETSWVER', { name: 'GETSWVER', identity }]]);

  const ask = async (name: Question, how: Patience & { before?: ReplyOf<Question> } = {}): Promise<void> => {
    const { reply, agreed } = await exchange.read({ name }, signal, how);
    replies.set(name, reply);
    if (!agreed) single.set(name, reply);
  };
  const askOptional = async (name: Question, quirk: QuirkCode): Promise<void> => {
    const isKnown = job.quirks.found.has(quirk);
    try {
      await ask(name, isKnown ? { tries: TRIES_OF_UNANSWERED } : { unanswered: UNANSWERED_OPTIONAL });
    } catch (error) {
      // Not known to be answered by every timer, and nothing else depends on it. But one that answers nothing else either sleeps.
      const isUnanswered =
        error instanceof TimerError && (error.code === 'no-answer' || (isKnown && error.code === 'unstable'));
      if (!isUnanswered || !exchange.awake) throw error;
      replies.set(name, null);
      job.quirks.note(quirk);
    }
  };

  for (const name of questions) {
    if (name === 'GETMEMORY') await askOptional(name, 'memory-unknown');
    else if (name === 'GETLOWRPM') await askOptional(name, 'idle-throttle-unanswered');
    else await ask(name);
    progress.finished(name);
  }
  if (exchange.damaged) {
    for (const [name, reply] of [...single]) await ask(name, { before: reply });
  }
  const again = replies.get('GETSWVER') as ReplyOf<'GETSWVER'> | undefined;
  if (again && JSON.stringify(again.identity) !== JSON.stringify(identity)) {
    throw new TimerError('other-timer', 'another timer answers than the one that was identified');
  }
  const { times } = replies.get('GETTIMERS') as ReplyOf<'GETTIMERS'>;
  if (rises(times.map(swapBytes)) && !rises(times)) job.quirks.note('times-big-endian');
  const memory = replies.get('GETMEMORY') as ReplyOf<'GETMEMORY'> | null;
  return {
    identity,
    memory: memory && job.memoryOf(memory),
    timers: times,
    positions: (replies.get('GETSERVOPOS') as ReplyOf<'GETSERVOPOS'>).positions,
    idleThrottle: (replies.get('GETLOWRPM') as ReplyOf<'GETLOWRPM'> | null | undefined)?.idleThrottle ?? null,
  };
}

/** Whether the functions follow one another. Column 0 takes no part: it is the motor stop, or reserved. */
function rises(times: readonly number[]): boolean {
  return times.every((time, column) => column < 2 || time >= (times[column - 1] as number));
}

function swapBytes(time: number): number {
  return ((time & 0xff) << 8) | (time >> 8);
}
