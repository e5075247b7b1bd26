import type { LayoutQuirks, Request } from '../protocol/index.js';

/**
 * In what this timer or its adapter was found to depart from the reading of the protocol that is taken for right. The rows are
 * those of the open questions on the protocol page.
 *
 * - `timers-reply-66`: GETTIMERS was answered with 66 (row 2).
 * - `unlock-reply-6a`: UNLOCK was answered with 6A (row 3).
 * - `memory-unknown`: the reply to GETMEMORY has no index, or none came (row 4).
 * - `bare-checksum`: the reply to GETLOWRPM carries its command byte as checksum (row 5).
 * - `times-big-endian`: the times fall, and with their bytes exchanged they rise (row 7). A hint, not a proof: times are not
 *   written before the pilot has chosen.
 * - `servo-first` (servo, column): SETSERVO changed this cell, where function and servo are exchanged (row 9).
 * - `servo-unanswered` (servo, column): a SETSERVO got no answer where others did. It would be out of range for a timer that
 *   takes the servo first (row 9).
 * - `times-rounded` (column, sent, held): SETTIMERS was answered with another time than was sent (row 13).
 * - `memories-from-one`: the timer counts its memories from 1 (row 14).
 * - `positions-unchanged`: SETSERVO was acknowledged and nothing changed (row 15).
 * - `echo`: the adapter returns the bytes that are sent (row 16).
 * - `idle-throttle-unanswered`: GETLOWRPM got no answer (row 19).
 */
export type QuirkCode =
  | 'timers-reply-66'
  | 'unlock-reply-6a'
  | 'memory-unknown'
  | 'bare-checksum'
  | 'times-big-endian'
  | 'servo-first'
  | 'servo-unanswered'
  | 'times-rounded'
  | 'memories-from-one'
  | 'positions-unchanged'
  | 'echo'
  | 'idle-throttle-unanswered';

export type QuirkParams = Readonly<Record<string, number>>;

/**
 * What is taken for true of a timer: because it was found in an earlier session, or because the pilot has chosen. What is left out is
 * open, and taken as the protocol page says.
 */
export interface AssumedQuirks extends LayoutQuirks {
  /** SETMEMORY and SETLOWRPM go out with the bare command byte where their checksum belongs (row 5). */
  readonly bareChecksumRequests?: boolean;
  /**
   * Positions are kept only for the function at which the servos stand (row 15). Taken for true once `positions-unchanged` was found. Nothing
   * moves because of it: each write has to be told that it may, see `moveServos`.
   */
  readonly positionsNeedMove?: boolean;
}

/** What is known of one timer's ways: found on the line, or assumed. */
export class Quirks {
  readonly found = new Map<QuirkCode, QuirkParams>();
  assumed: AssumedQuirks;

  constructor(assumed: AssumedQuirks) {
    this.assumed = assumed;
  }

  /** Keeps the first finding of each kind. */
  note(code: QuirkCode, params: QuirkParams = {}): void {
    if (!this.found.has(code)) this.found.set(code, params);
  }

  assume(quirks: AssumedQuirks): void {
    this.assumed = { ...this.assumed, ...quirks };
  }

  /** Whether this request goes out with a bare checksum. */
  isBare({ name }: Request): boolean {
    return this.assumed.bareChecksumRequests === true && (name === 'SETMEMORY' || name === 'SETLOWRPM');
  }

  /** Whether the byte order of the times is in doubt, and nobody has decided. */
  get byteOrderOpen(): boolean {
    return this.found.has('times-big-endian') && this.assumed.bigEndianTimes === undefined;
  }
}
