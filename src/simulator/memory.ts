import { encodeReply, type Hundredths, type Identity, MAX_TIME, slotCount } from '../protocol/index.js';

/** What one memory of the virtual timer holds. */
export interface MemoryContent {
  /** The time of each slot. Slot 0 is the motor stop on class Q. */
  times: Hundredths[];
  /** `[servo][slot]`, steps 0..130. A timer may hold 131..255, too. */
  positions: number[][];
}

/** The positions in the one reply that is known from a real timer: 15, 25 ... 115, continued in the same steps. */
const FIRST_POSITION = 15;
const POSITION_STEP = 10;
const POSITIONS_KNOWN = 11;

/** Times of an ordinary flight, in hundredths of a second: one function every half second, DT last. */
const FUNCTION_STEP = 50;
const DT = 18000;
const MOTOR_STOP = 1000;

/**
 * What a memory of a new virtual timer holds: rising times, a DT of 3 minutes, and for each servo the positions of the
 * one reply that is known from a real timer. In each further memory the DT is 30 s longer, so that the memories differ.
 * @param memory counted from 0.
 */
export function firstContent(identity: Identity, memory: number): MemoryContent {
  const slots = slotCount(identity);
  const dt = Math.min(MAX_TIME, DT + 3000 * memory);
  const motorStop = identity.timerClass === 'Q' ? MOTOR_STOP : 0;
  const times = Array.from({ length: slots }, (_, slot) => {
    if (slot === 0) return motorStop;
    return slot === identity.functions ? dt : Math.min(dt - slots + slot, motorStop + FUNCTION_STEP * slot);
  });
  const row = Array.from({ length: slots }, (_, slot) => FIRST_POSITION + POSITION_STEP * (slot % POSITIONS_KNOWN));
  return { times, positions: Array.from({ length: identity.servos }, () => [...row]) };
}

/**
 * Makes sure that a timer of this layout can answer with what a memory holds.
 * @throws CodecError `wrong-count`, `not-an-integer` or `out-of-range`.
 */
export function requireContent({ times, positions }: MemoryContent, identity: Identity): void {
  encodeReply({ name: 'GETTIMERS', times }, { identity });
  encodeReply({ name: 'GETSERVOPOS', positions }, { identity });
}
