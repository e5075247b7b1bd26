import type { TimerProgram } from '../../program/index.js';
import type { Unlike } from './taken.js';

/**
 * Why the servos no longer follow, when the pilot did not end it. `over`: the page went out of sight, another job has
 * the wire, the pilot no longer says that it is safe, or the connection ended. `memory`: another memory is current, or
 * was asked for. `failed`: a command failed. `strayed`: the reading at the end shows that another memory became
 * current, which may have taken positions. `unlike`: a reading shows that the timer does not do what it acknowledges.
 */
export type EndReason = 'over' | 'memory' | 'failed' | 'strayed' | 'unlike';

/** How following ended. */
export interface Ended {
  readonly reason: EndReason;
  /** What the timer was believed to hold at that moment. */
  readonly held: TimerProgram | null;
  /** What the reading after the first position has shown, where the timer did something else. */
  readonly unlike: Unlike | null;
}
