import type { TimerProgram } from '../../program/index.js';
import type { ModelRecord } from '../storage/index.js';
import type { Session } from './session.js';

/** What a memory of a model's timer holds, as far as it is known. */
export interface HeldNow {
  readonly program: TimerProgram;
  /** When it was seen, in milliseconds since 1970. */
  readonly at: number;
  /** Whether it was read on the present connection. */
  readonly now: boolean;
}

/**
 * What a memory of a model's timer holds now, if that timer is connected; else what it last held.
 * @param memory counted from 0; null for a timer that does not say which memory is current.
 * @returns null when neither is known.
 */
export function heldNow(
  { connection, modelAtHand, knowledge, link }: Session,
  { key, verified }: ModelRecord,
  memory: number | null,
  simulated: boolean,
): HeldNow | null {
  const isHere = connection.value !== null && modelAtHand.value?.id === key && link.simulated.value === simulated;
  const known = isHere ? knowledge.of(memory) : null;
  if (known?.state === 'read') return { program: known.program, at: known.at, now: true };
  // After an interrupted write nobody knows.
  if (known?.state === 'uncertain') return null;
  const last = verified.find((held) => held.program.memory === memory && (held.simulated ?? false) === simulated);
  return last ? { program: last.program, at: last.at, now: false } : null;
}
