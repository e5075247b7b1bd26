import { fieldKey, type ProgramField, type TimerProgram } from '../program/index.js';
import { encodeRequest, type Reply, type Request } from '../protocol/index.js';
import { TimerError, throwIfAborted } from './errors.js';
import type { ClientJob } from './job.js';
import { agreedContent, readContent, readingPlan } from './read-program.js';
import {
  arePositionsKept,
  exchangedCell,
  isExplained,
  isForeign,
  isNoPositionKept,
  repairRequests,
  roundedSlot,
  type WritePlan,
  withRequest,
} from './write-plan.js';
import { isHeld, unasked, verdict, type WriteReport } from './write-report.js';

/**
 * Reads everything afresh and compares it with the baseline. Only if all is the same, it sends what differs, reads
 * everything back and compares again. Values that changed unasked are put back once.
 * @throws before the first SET request: CodecError when the difference cannot be encoded, TimerError `other-timer`,
 * `other-memory`, `memory-unknown`, `stale`, `undecided`, `aborted`, or as Exchange. After that it never throws a
 * TimerError: the report says what stopped it and what is known about each value.
 */
export async function writeContent(job: ClientJob, plan: WritePlan): Promise<WriteReport> {
  const seen = job.exchange.watch();
  await requireWritable(job, plan);
  const write = new Write(job, plan);
  const stopped = await write.run();
  const { acknowledged, held, changedUnasked } = write;
  const result = verdict(plan.goal, plan.asked, changedUnasked.values(), held);
  return {
    ...result,
    held,
    acknowledged,
    repeats: seen().repeats,
    // A missing reply means nothing once a reading has shown everything that was wanted.
    stopped: result.result === 'verified' ? null : stopped,
  };
}

/** Makes sure that everything fits, and that timer, memory and values are those that the pilot saw. */
async function requireWritable(job: ClientJob, { requests, before, baseline }: WritePlan): Promise<void> {
  const { identity, signal, quirks } = job;
  // All of it must fit before any of it is sent.
  for (const request of requests) encodeRequest(request, { identity, quirks: quirks.assumed });
  const held = await readContent(job, 'read', before);
  if (!isHeld(baseline, held))
    throw new TimerError('stale', 'the timer holds something else than the baseline', { held });
  if (quirks.byteOrderOpen && requests.some(({ name }) => name === 'SETTIMERS')) {
    throw new TimerError('undecided', 'the byte order of the times is in doubt', { request: 'SETTIMERS' });
  }
  throwIfAborted(signal);
  job.exchange.requireGoing();
}

/** A write from its first SET request on. */
class Write {
  /** SET requests that were acknowledged. */
  acknowledged = 0;
  /** What the timer held at the last fresh read; null when none came after the last request. */
  held: TimerProgram | null = null;
  /** Values that changed without being asked, by field key. */
  readonly changedUnasked = new Map<string, ProgramField>();
  readonly #job: ClientJob;
  readonly #plan: WritePlan;
  /** The times in the last acknowledgement. */
  #timesSaid: readonly number[] | null = null;

  constructor(job: ClientJob, plan: WritePlan) {
    this.#job = job;
    this.#plan = plan;
  }

  /** @returns what stopped the write; null when nothing did. */
  async run(): Promise<TimerError | null> {
    const { quirks } = this.#job;
    let stopped = await this.#send('write', this.#plan);
    if (!stopped || isUnanswered(stopped)) stopped = (await this.#readBack()) ?? stopped;
    const { held } = this;
    if (!held) return stopped;
    if (isForeign(this.#plan, held, this.#job.exchange.damaged)) {
      return new TimerError('changed', 'more values differ from what was read than this write can have changed');
    }
    this.#noteCells(held, stopped === null);
    const servoFirst = quirks.assumed.servoFirst === true;
    const repair = repairRequests(this.#plan, held, this.#job.exchange.damaged, servoFirst);
    if (repair.requests.length === 0) return stopped;
    const { assumed } = quirks;
    quirks.assumed = { ...assumed, ...repair.quirks };
    stopped = await this.#send('repair', { ...this.#plan, baseline: held, requests: repair.requests });
    quirks.assumed = assumed;
    return (await this.#readBack()) ?? stopped;
  }

  /** Sends the requests, and reserves time to see what came of them, whatever the line does. */
  #send(stage: 'write' | 'repair', plan: WritePlan): Promise<TimerError | null> {
    const { exchange, identity } = this.#job;
    const { schedule } = exchange;
    const work = async (): Promise<void> => {
      this.held = null;
      schedule.enter(stage);
      let expected = plan.baseline;
      for (const [index, request] of plan.requests.entries()) {
        const sent = { ...plan, requests: plan.requests.slice(0, index + 1) };
        const reply = await askNoting(this.#job, request, () => requireSame(this.#job, sent, expected));
        if (reply.name === 'SETTIMERS') this.#timesSaid = reply.times;
        expected = withRequest(expected, request, this.#timesSaid);
        if (request.name !== 'MOVETOFUNC') this.acknowledged++;
      }
    };
    return attempt(() => schedule.keepTimeFor(readingPlan(identity, plan.after), work));
  }

  #readBack(): Promise<TimerError | null> {
    const { goal, asked, after, moveServos } = this.#plan;
    const { quirks } = this.#job;
    return attempt(async () => {
      const held = await readContent(this.#job, 'verify', after);
      this.held = held;
      for (const { field } of unasked(held, goal, asked)) this.changedUnasked.set(fieldKey(field), field);
      const slot = roundedSlot(this.#plan, this.#timesSaid, held);
      if (slot !== null) {
        quirks.note('times-rounded', { slot, sent: goal.times[slot] as number, held: held.times[slot] as number });
      }
      if (!moveServos && arePositionsKept(this.#plan, held)) {
        quirks.found.delete('positions-unchanged');
        quirks.unassume('positionsNeedMove');
      }
    });
  }

  /** Notes what the positions that were read back show about this timer. */
  #noteCells(held: TimerProgram, acknowledged: boolean): void {
    const { quirks, exchange } = this.#job;
    const cell = exchangedCell(this.#plan, held);
    if (cell) quirks.note('servo-first', { servo: cell.servo, slot: cell.slot });
    // Positions that never reached the timer show nothing, and on a line with damage an acknowledgement may belong to
    // another request.
    else if (acknowledged && !exchange.damaged && isNoPositionKept(this.#plan, held)) {
      quirks.note('positions-unchanged');
      quirks.assume({ positionsNeedMove: true });
    }
  }
}

/** Whether line and timer may go on after a request was given up. */
function isUnanswered({ code }: TimerError): boolean {
  return code === 'no-answer' || code === 'bad-reply' || code === 'unstable';
}

/**
 * Sends a request. Notes a SETSERVO without an answer,
 * if it would be out of range for a timer that takes the servo first.
 */
async function askNoting(
  { exchange, identity, signal, quirks }: ClientJob,
  request: Request,
  beforeRepeat: () => Promise<void>,
): Promise<Reply> {
  try {
    return await exchange.ask(request, signal, { beforeRepeat });
  } catch (error) {
    const isSilent = error instanceof TimerError && error.code === 'no-answer';
    if (isSilent && request.name === 'SETSERVO' && request.function >= identity.servos) {
      quirks.note('servo-unanswered', { servo: request.servo, slot: request.function });
    }
    throw error;
  }
}

/**
 * During silence, another timer of the same kind may have taken the place of this one. Asking for the identity does not
 * tell them apart, but what they hold does.
 * @param expected what the timer holds if it took everything that it acknowledged and nothing else.
 * @throws TimerError `changed` when two readings agree on content that this write cannot have caused; as Exchange.
 */
async function requireSame(job: ClientJob, plan: WritePlan, expected: TimerProgram): Promise<void> {
  const { content } = await agreedContent(job, plan.after, expected);
  if (isExplained(plan, { ...expected, ...content }, job.exchange.damaged)) return;
  throw new TimerError('changed', 'after silence the timer holds what this write cannot have brought about');
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
