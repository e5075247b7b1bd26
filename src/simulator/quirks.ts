import type { LayoutQuirks } from '../protocol/index.js';

/**
 * How a timer may differ from the usual reading of the protocol. Each switch stands for a contradiction in the source
 * that no real timer has settled yet. All are off by default.
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
  /** The reply to GETLOWRPM carries the bare command byte in place of its checksum. */
  readonly bareChecksumReply?: boolean;
  /** SETMEMORY and SETLOWRPM are accepted only with the bare command byte in place of their checksum. */
  readonly bareChecksumRequests?: boolean;
  /** The timer rounds times down to multiples of this many hundredths of a second. Default 1. */
  readonly timeStep?: number;
  /** Only class Q answers GETLOWRPM. */
  readonly idleThrottleOnQOnly?: boolean;
  /** SETSERVO is acknowledged, but kept only for the function to which the servos were last moved. */
  readonly servoNeedsMove?: boolean;
  /**
   * Whether SETSERVO alone moves the servo (rows 15 and 17 of docs/protocol.md leave it open): never; `there`: only
   * while the servos stand at that function; always. Default `there`.
   */
  readonly setMoves?: 'never' | 'there' | 'always';
  /** The adapter returns every byte that is sent to the timer. */
  readonly echo?: boolean;
}
