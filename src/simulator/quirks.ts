import type { CommandName, LayoutQuirks } from '../protocol/index.js';

/**
 * How a timer, or its adapter, may differ from the usual reading of the protocol. The row numbers are those of the open
 * questions in docs/protocol.md. All switches are off by default.
 */
export interface TimerQuirks extends LayoutQuirks {
  /** Zeros before each reply: the source's examples print four, a real timer sent five (row 1). Default 5. */
  readonly zeros?: 4 | 5;
  /** GETTIMERS is answered with 66, the letter of the reply to SETTIMERS (row 2). */
  readonly timersReplyAs66?: boolean;
  /** UNLOCK is answered with 6A, the letter of the reply to MOVETOFUNC (row 3). */
  readonly unlockReplyAs6A?: boolean;
  /** The reply to GETMEMORY carries no index (row 4). */
  readonly memoryReplyEmpty?: boolean;
  /** The reply to GETLOWRPM carries the bare command byte in place of its checksum (row 5). */
  readonly bareChecksumReply?: boolean;
  /** The reply to GETLOWRPM has 3 as its length, and still its byte of data, as one print of the source (row 6). */
  readonly idleThrottleLength3?: boolean;
  /** The replies to these requests add their length to the checksum (row 21). */
  readonly lengthInSum?: readonly CommandName[];
  /** SETMEMORY and SETLOWRPM are accepted only with the bare command byte in place of their checksum (row 5). */
  readonly bareChecksumRequests?: boolean;
  /** The timer rounds times down to multiples of this many hundredths of a second (row 13). Default 1. */
  readonly timeStep?: number;
  /** Only class Q answers GETLOWRPM (row 19). */
  readonly idleThrottleOnQOnly?: boolean;
  /** SETSERVO is acknowledged, but kept only for the function to which the servos were last moved (row 15). */
  readonly servoNeedsMove?: boolean;
  /** SETSERVO is acknowledged, but never kept (row 15). */
  readonly servoIgnored?: boolean;
  /**
   * Whether SETSERVO alone moves the servo (rows 15 and 17 of docs/protocol.md leave it open): never; `there`: only
   * while the servos stand at that function; always. Default `there`.
   */
  readonly setMoves?: 'never' | 'there' | 'always';
  /** The adapter returns every byte that is sent to the timer (row 16). */
  readonly echo?: boolean;
}
