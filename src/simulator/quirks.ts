import type { LayoutQuirks } from '../protocol/index.js';

/**
 * How a timer may differ from the usual reading of the protocol. Each is a contradiction in the source that nobody has
 * settled with a real timer yet. All are off by default.
 */
export interface TimerQuirks extends LayoutQuirks {
  /** Zeros before each reply: the source's examples print four, a real timer sent five. Default 5. */
  readonly zeros?: 4 | 5;
  /** GETTIMERS is answered with 66, the letter of SETTIMERS. */
  readonly timersReplyAs66?: boolean;
  /** UNLOCK is answered with 6A, the letter of MOVETOFUNC. */
  readonly unlockReplyAs6A?: boolean;
  /** The reply to GETMEMORY carries no index. */
  readonly memoryReplyEmpty?: boolean;
  /** The reply to GETLOWRPM carries the bare command byte where its checksum belongs. */
  readonly bareChecksumReply?: boolean;
  /** SETMEMORY and SETLOWRPM are taken only with the bare command byte where their checksum belongs. */
  readonly bareChecksumRequests?: boolean;
  /** Times are kept in steps of so many hundredths of a second, rounded down. Default 1. */
  readonly timeStep?: number;
  /** GETLOWRPM is answered on class Q only. */
  readonly idleThrottleOnQOnly?: boolean;
  /** SETSERVO is answered, but kept only for the function the servos were last moved to. */
  readonly servoNeedsMove?: boolean;
  /**
   * Whether SETSERVO alone moves the servo (rows 15 and 17 of the protocol page leave it open): never, when the servos
   * stand at that function, or whatever function they stand at. Default `there`.
   */
  readonly setMoves?: 'never' | 'there' | 'always';
  /** The adapter returns every byte that is sent to the timer. */
  readonly echo?: boolean;
}
