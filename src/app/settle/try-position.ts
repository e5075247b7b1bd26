import { TimerError, type WriteReport } from '../../client/index.js';
import {
  type Change,
  checkProgram,
  differences,
  fieldKey,
  type ProgramField,
  type TimerProgram,
} from '../../program/index.js';
import { MAX_POSITION } from '../../protocol/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { withValues } from '../editing/edit.js';
import type { JobContext } from '../timer/job-runner.js';
import type { Session } from '../work/session.js';
import { strayed } from '../write/sending.js';
import type { Tried } from './conclusions.js';

/** How far the servo is moved, in steps: enough to be seen, and towards the middle, where nothing is in its way. */
const FAR = 15;
const MIDDLE = 65;

type Position = Extract<ProgramField, { kind: 'position' }>;

/** A position to try, and the value for it. */
export interface Cell {
  readonly field: Position;
  readonly value: number;
}

/**
 * A position whose servo and function have different numbers, so that it shows in which order a timer takes the two
 * (row 9 of docs/protocol.md). Neither start nor DT. Null when there is none that can be put back.
 */
export function cellOf(program: TimerProgram): Cell | null {
  const { functions, servos } = program.identity;
  const positionAt = (servo: number, slot: number): number | undefined => program.positions[servo]?.[slot];
  for (let slot = 1; slot < functions; slot++) {
    for (let servo = 0; servo < servos; servo++) {
      const held = positionAt(servo, slot) as number;
      const exchanged = positionAt(slot, servo);
      if (servo === slot || held > MAX_POSITION || (exchanged ?? 0) > MAX_POSITION) continue;
      const towards = held < MIDDLE ? 1 : -1;
      const value = held + towards * FAR;
      // A timer that takes the servo first must show it.
      return { field: { kind: 'position', servo, slot }, value: value === exchanged ? value + towards : value };
    }
  }
  return null;
}

type TryParts = Pick<Session, 'editor' | 'knowledge' | 'recovery' | 'reader' | 'notices' | 'servoMoves' | 'simulated'>;

/**
 * Writes one position, reads it back, and puts back what was there, verified by a reading. Before the first byte it is
 * noted that the old value has to be put back: whatever cuts it off is an unfinished write whose goal is the old value.
 * @param before what the timer holds, by a fresh reading.
 * @param at the slot at which the servos stand; null when that is not known.
 * @throws TimerError `changed` when the timer does not hold what it held before; any error of the wire.
 */
export async function tryPosition(
  { editor, knowledge, recovery, reader, notices, servoMoves, simulated }: TryParts,
  { client }: TimerConnection,
  options: JobContext,
  { before, cell, at }: { readonly before: TimerProgram; readonly cell: Cell; readonly at: number | null },
): Promise<Tried> {
  const { servo, slot } = cell.field;
  const order = client.quirksAssumed.servoFirst ? 'servo-first' : 'function-first';
  const wanted = withValues(before, [cell]);
  const kept = await recovery.begin(wanted, before, simulated.peek(), before);
  try {
    options.stillOn();
    if (!kept) notices.say('not-backed-up');
    if (!kept) throw new TimerError('aborted', 'not without a backup');
  } catch (error) {
    // Nothing was sent.
    await knowledge.ended(before);
    throw error;
  }
  editor.sent();
  servoMoves.mayMove();
  const despite = [...checkProgram(before), ...checkProgram(wanted)].map(({ code }) => code);
  const { signal, onProgress } = options;
  const touched = [cell.field, exchangedOf(cell.field)].map(fieldKey);
  const first = { baseline: before, despite, signal, onProgress };
  const report = await client.writeProgram(wanted, first).catch(async (error: unknown) => {
    // It throws only before it sends a value.
    await knowledge.ended(before);
    throw error;
  });
  const isTouched = ({ field }: Change): boolean => touched.includes(fieldKey(field));
  // A stop must not leave it as it is.
  const held = report.held ?? (report.stopped?.code === 'aborted' ? await client.readProgram() : null);
  const changed = held ? differences(before, held) : [];
  let last = report;
  // Whatever else has changed is not this page's to put back: it may be another timer.
  if (held && changed.length > 0 && changed.every(isTouched)) {
    // Stopped before the client has noticed it.
    const isExchanged = changed.every(({ field }) => fieldKey(field) === touched[1]);
    if (isExchanged) client.assume({ servoFirst: order !== 'servo-first' });
    last = await client.writeProgram(before, { baseline: held, despite, onProgress });
  }
  for (const one of [report, last]) {
    const other = strayed([one]);
    if (other !== null) knowledge.doubt(other);
  }
  if (last.held) reader.took(last.held);
  const isBack = last.held !== null && differences(before, last.held).length === 0;
  if (report.stopped || last.stopped || !isBack) {
    throw report.stopped ?? last.stopped ?? new TimerError('changed', 'the timer does not hold what it held before');
  }
  return { servo, slot, order, at, end: endOf(report, cell) };
}

function endOf({ result, values }: WriteReport, { field, value }: Cell): Tried['end'] {
  const beside = values.filter(({ asked }) => !asked).map((each) => fieldKey(each.field));
  if (result === 'verified' && beside.length === 0) return 'kept';
  const isTaken = values.some(({ asked, held }) => asked && held === value);
  if (isTaken || result === 'unknown') return 'unclear';
  if (beside.length === 0) return 'unchanged';
  return beside.length === 1 && beside[0] === fieldKey(exchangedOf(field)) ? 'exchanged' : 'unclear';
}

function exchangedOf({ servo, slot }: Position): Position {
  return { kind: 'position', servo: slot, slot: servo };
}
