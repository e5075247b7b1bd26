import type { Frame, RejectionReason } from '../protocol/index.js';

/** One thing seen on the line: a frame that was sent, a frame that came, or bytes that belong to no frame. */
export interface LineEntry {
  /** Milliseconds since 1970, by the client's clock. */
  readonly time: number;
  readonly direction: 'out' | 'in';
  /** The bytes as they went or came. */
  readonly bytes: Uint8Array;
  /** Null for bytes that belong to no frame. */
  readonly frame: Frame | null;
  /** Why bytes belong to no frame; null for a frame. */
  readonly rejected: RejectionReason | null;
}

/**
 * In what this timer or its adapter departs from the reading of the protocol that is taken for right.
 *
 * - `timers-reply-66`: GETTIMERS was answered with 66 (row 2 of the contradictions).
 * - `unlock-reply-6a`: UNLOCK was answered with 6A (row 3).
 * - `memory-unknown`: the reply to GETMEMORY has no index, or none came (row 4).
 * - `bare-checksum`: the reply to GETLOWRPM carries its command byte as checksum (row 5).
 * - `servo-first`: SETSERVO changed the cell with function and servo exchanged (row 9).
 * - `memories-from-one`: the timer counts its memories from 1 (row 14).
 * - `positions-unchanged`: SETSERVO was acknowledged and nothing changed (row 15).
 * - `echo`: the adapter returns the bytes that are sent (row 16).
 * - `idle-throttle-unanswered`: a timer of class Q did not answer GETLOWRPM.
 */
export type QuirkCode =
  | 'timers-reply-66'
  | 'unlock-reply-6a'
  | 'memory-unknown'
  | 'bare-checksum'
  | 'servo-first'
  | 'memories-from-one'
  | 'positions-unchanged'
  | 'echo'
  | 'idle-throttle-unanswered';
