import { CodecError, type Request } from '../protocol/index.js';
import { fieldsOf, type ProgramField, requireShape, sameLayout, type TimerProgram, valueAt } from './program.js';

/** One value in which two programs differ. */
export interface Change {
  /** Which value it is. */
  readonly field: ProgramField;
  /** The value in the first program; null for an idle throttle that is not known. */
  readonly from: number | null;
  /** The value in the second program; null for an idle throttle that is not known. */
  readonly to: number | null;
}

/**
 * The values in which two programs differ, times first, then positions servo by servo, then idle throttle. Which memory
 * a program comes from does not count.
 * @throws CodecError `wrong-count` when the two do not have the same slots and servos.
 * @example
 * ```ts
 * import { TimerClient } from 'sidus-timer/client';
 * import { differences, withValue } from 'sidus-timer/program';
 * import { VirtualTimer } from 'sidus-timer/simulator';
 *
 * const timer = new TimerClient(new VirtualTimer());
 * const program = await timer.readProgram();
 * await timer.close();
 * const [change] = differences(program, withValue(program, { kind: 'time', slot: 1 }, 42));
 * console.log(change?.field.kind, change?.to); // time 42
 * ```
 */
export function differences(from: TimerProgram, to: TimerProgram): Change[] {
  requireShape(from);
  requireShape(to);
  if (!sameLayout(from.identity, to.identity)) {
    throw new CodecError('wrong-count', 'identity', 'the two programs are for timers of different layouts');
  }
  return fieldsOf(from.identity)
    .map((field) => ({ field, from: valueAt(from, field), to: valueAt(to, field) }))
    .filter((change) => change.from !== change.to);
}

/**
 * The fewest requests that turn one program into the other: one SETTIMERS with all times if any time differs, a
 * SETSERVO for each position, a SETLOWRPM. An idle throttle that is null in `to` gives no request.
 * @throws CodecError `wrong-count`, see {@link differences}.
 */
export function changeRequests(from: TimerProgram, to: TimerProgram): Request[] {
  const changes = differences(from, to);
  const requests: Request[] = [];
  if (changes.some(({ field }) => field.kind === 'time')) requests.push({ name: 'SETTIMERS', times: to.times });
  for (const { field, to: value } of changes) {
    if (value === null) continue;
    if (field.kind === 'position') {
      requests.push({ name: 'SETSERVO', function: field.slot, servo: field.servo, position: value });
    } else if (field.kind === 'idleThrottle') {
      requests.push({ name: 'SETLOWRPM', idleThrottle: value });
    }
  }
  return requests;
}
