import {
  type Change,
  changeRequests,
  differences,
  fieldKey,
  type ProgramField,
  type TimerProgram,
  valueAt,
  withValue,
} from '../program/index.js';
import { type LayoutQuirks, MAX_POSITION, type Request } from '../protocol/index.js';
import { type ReadingOptions, readingPlan } from './read-program.js';
import type { JobPart } from './schedule.js';
import { unasked } from './write-report.js';

/** How far a timer that rounds may change a time, in hundredths of a second. */
const ROUNDING = 100;

/** What a write has to do, as the pilot agreed to it. */
export interface WritePlan {
  /** What the timer held when it was last read, and what it is to hold. */
  readonly baseline: TimerProgram;
  readonly goal: TimerProgram;
  /** The values to change. */
  readonly asked: readonly Change[];
  /** The requests for these changes, in this order. */
  readonly requests: readonly Request[];
  /** How to read the timer before the first request, and after the last one. */
  readonly before: ReadingOptions;
  readonly after: ReadingOptions;
  /** Whether the servos may move during the write. */
  readonly moveServos: boolean;
}

/** @throws CodecError `wrong-count` when the two programs do not have the same slots and servos. */
export function planWrite(baseline: TimerProgram, goal: TimerProgram, moveServos = false): WritePlan {
  const asked = differences(baseline, goal).filter(({ to }) => to !== null);
  const requests = inOrder(changeRequests(baseline, goal), moveServos);
  // Not undefined, which would allow any memory.
  const memory = baseline.memory ?? null;
  const isThrottleKnown = baseline.idleThrottle !== null || goal.idleThrottle !== null;
  const before: ReadingOptions = { strict: true, memory, known: baseline, idleThrottle: isThrottleKnown };
  // The memory of the baseline, not the one that the goal names as its source.
  const after: ReadingOptions = { strict: true, memory, idleThrottle: goal.idleThrottle !== null };
  return { baseline, goal, asked, requests, before, after, moveServos };
}

/** The parts of a write when nothing goes wrong. */
export function writeParts(plan: WritePlan): JobPart[] {
  const { identity } = plan.goal;
  return [
    { stage: 'read', names: readingPlan(identity, plan.before) },
    { stage: 'write', names: plan.requests.map(({ name }) => name) },
    { stage: 'verify', names: readingPlan(identity, plan.after) },
  ];
}

/** The parts of a write that changes everything. */
export function longestWrite(goal: TimerProgram, moveServos: boolean): JobPart[] {
  const other = (value: number): number => value ^ 1;
  const opposite: TimerProgram = {
    ...goal,
    times: goal.times.map(other),
    positions: goal.positions.map((row) => row.map(other)),
    idleThrottle: goal.idleThrottle === null ? null : other(goal.idleThrottle),
  };
  return writeParts(planWrite(opposite, goal, moveServos));
}

/**
 * The order of the requests. Where servos may move, positions go function by function,
 * each function after a move to it.
 */
function inOrder(requests: readonly Request[], moveServos: boolean): Request[] {
  if (!moveServos) return [...requests];
  const slotOf = (request: Request): number => (request.name === 'SETSERVO' ? request.function : -1);
  const sorted = [...requests].sort((a, b) => slotOf(a) - slotOf(b));
  return sorted.flatMap((request, index): Request[] => {
    const slot = slotOf(request);
    const isNew = slot >= 0 && (index === 0 || slotOf(sorted[index - 1] as Request) !== slot);
    return isNew ? [{ name: 'MOVETOFUNC', function: slot }, request] : [request];
  });
}

/**
 * Whether this write on this timer cannot explain the read back: something else changed the timer, or it is another
 * one. Putting values back would overwrite what somebody wants.
 * @param damaged whether there was damage, which explains values that did not change as wanted.
 */
export function isForeign(plan: WritePlan, held: TimerProgram, damaged: boolean): boolean {
  const { goal, asked } = plan;
  const wrong = unasked(held, goal, asked);
  if (isTooMuch(plan, wrong)) return true;
  // Wanted values did not change while others did, on a good line: the requests probably went to another timer.
  const isExplained = damaged || wrong.some((change) => isExchanged(plan, change));
  return wrong.length > 0 && !isExplained && asked.some(({ field, to }) => valueAt(held, field) !== to);
}

/**
 * Whether the baseline and the requests explain what the timer holds in the middle of a write. A timer may round a
 * time.
 * @param damaged whether there was damage: then each request may also have disturbed another value.
 */
export function isExplained(plan: WritePlan, held: TimerProgram, damaged: boolean): boolean {
  const isSent = plan.requests.some(({ name }) => name === 'SETTIMERS');
  const wrong = differences(held, plan.goal).filter((change) => {
    const { field, from, to } = change;
    if (from === null || to === null || from === valueAt(plan.baseline, field)) return false;
    const isRounded = isSent && field.kind === 'time' && Math.abs(from - to) < ROUNDING;
    return !isRounded && !isExchanged(plan, change);
  });
  return wrong.length === 0 || (damaged && !isTooMuch(plan, wrong));
}

/** What the timer holds after a request, if it takes the request as it was sent. */
export function withRequest(program: TimerProgram, request: Request, said: readonly number[] | null): TimerProgram {
  switch (request.name) {
    case 'SETTIMERS':
      return { ...program, times: said ?? request.times };
    case 'SETSERVO':
      return withValue(program, { kind: 'position', servo: request.servo, slot: request.function }, request.position);
    case 'SETLOWRPM':
      return { ...program, idleThrottle: request.idleThrottle };
    default:
      return program;
  }
}

/** The cell that changed to a position sent for another cell, the one with function and servo exchanged. */
export function exchangedCell(plan: WritePlan, held: TimerProgram): (ProgramField & { kind: 'position' }) | null {
  const found = unasked(held, plan.goal, plan.asked).find((change) => isExchanged(plan, change))?.field;
  return found?.kind === 'position' ? found : null;
}

function isExchanged({ requests }: WritePlan, { field, from: held }: Change): boolean {
  return requests.some(
    (request) =>
      request.name === 'SETSERVO' &&
      field.kind === 'position' &&
      request.function === field.servo &&
      request.servo === field.slot &&
      request.position === held,
  );
}

/** Whether the timer kept none of the positions that were sent. */
export function isNoPositionKept({ asked }: WritePlan, held: TimerProgram): boolean {
  const positions = asked.filter(({ field }) => field.kind === 'position');
  return positions.length > 0 && positions.every(({ field, from }) => valueAt(held, field) === from);
}

/** Whether it kept positions of two functions although nothing moved. Then the servos need not stand there. */
export function arePositionsKept({ asked }: WritePlan, held: TimerProgram): boolean {
  const slots = asked.flatMap(({ field, to }) =>
    field.kind === 'position' && valueAt(held, field) === to ? [field.slot] : [],
  );
  return new Set(slots).size > 1;
}

/** The first time that the timer rounds: the acknowledgement and the read back agree on another time than was sent. */
export function roundedSlot({ goal }: WritePlan, said: readonly number[] | null, held: TimerProgram): number | null {
  const slot = goal.times.findIndex((time, index) => time !== said?.[index] && said?.[index] === held.times[index]);
  return slot < 0 ? null : slot;
}

/**
 * The requests after the read back. Values that changed unasked are put back. Values that did not change as wanted are
 * sent once more only if there was damage on the line. Otherwise the timer rounds, or needs something else, and would
 * do the same again.
 * @param servoFirst whether SETSERVO is now known to carry the servo first. Positions that went to a wrong cell are
 * then put back in that order.
 */
export function repairRequests(
  plan: WritePlan,
  held: TimerProgram,
  damaged: boolean,
  servoFirst: boolean,
): { requests: readonly Request[]; quirks: LayoutQuirks } {
  const { goal, asked, moveServos } = plan;
  const wrong = unasked(held, goal, asked);
  if (exchangedCell(plan, held)) {
    const cells = wrong.filter(({ field }) => field.kind === 'position');
    return { requests: inOrder(requestsFor(held, goal, cells), moveServos), quirks: { servoFirst: !servoFirst } };
  }
  const changes = damaged ? differences(held, goal) : wrong;
  return { requests: inOrder(requestsFor(held, goal, changes), moveServos), quirks: {} };
}

/** The requests for some of the changes only. A position past the last step cannot be put back: nobody can set it. */
function requestsFor(held: TimerProgram, goal: TimerProgram, changes: readonly Change[]): Request[] {
  const kept = new Set(changes.map(({ field }) => fieldKey(field)));
  return changeRequests(held, goal).filter((request) => {
    switch (request.name) {
      case 'SETTIMERS':
        return changes.some(({ field }) => field.kind === 'time');
      case 'SETSERVO':
        return request.position <= MAX_POSITION && kept.has(`position:${request.servo}:${request.function}`);
      default:
        return kept.has('idleThrottle');
    }
  });
}

/**
 * Whether more values changed than the requests can have disturbed:
 * one position for each SETSERVO, all times for SETTIMERS.
 */
function isTooMuch({ requests }: WritePlan, wrong: readonly Change[]): boolean {
  const others = wrong.filter(({ field }) => field.kind !== 'time').length;
  const times = wrong.length > others ? 1 : 0;
  return others + times > requests.filter(({ name }) => name !== 'MOVETOFUNC').length;
}
