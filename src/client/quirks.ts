import { COMMANDS, type CommandName, type LayoutQuirks, type Request } from '../protocol/index.js';

/**
 * How this timer or its adapter differs from the usual reading of the protocol. The row numbers are those of the open
 * questions in docs/protocol.md.
 *
 * - `timers-reply-66`: GETTIMERS was answered with 66 (row 2).
 * - `unlock-reply-6a`: UNLOCK was answered with 6A (row 3).
 * - `memory-unknown`: the reply to GETMEMORY has no index, or none came (row 4).
 * - `memory-impossible` (index): GETMEMORY is answered with an index that this timer cannot have (row 4).
 * - `bare-checksum`: the reply to GETLOWRPM carries its command byte as checksum (row 5).
 * - `times-big-endian`: the times fall, but rise when the two bytes of each are swapped (row 7). This is a hint, not a
 *   proof: no time is written before the pilot has chosen.
 * - `servo-first` (servo, slot): SETSERVO changed this cell: function and servo were exchanged (row 9).
 * - `servo-unanswered` (servo, slot): a SETSERVO got no answer while others did. For a timer that takes the servo
 *   first, it would be out of range (row 9).
 * - `times-rounded` (slot, sent, held): SETTIMERS was answered with another time than was sent (row 13).
 * - `memories-from-one`: the timer counts its memories from 1 (row 14).
 * - `positions-unchanged`: SETSERVO was acknowledged and nothing changed (row 15).
 * - `echo`: the adapter returns the bytes that are sent (row 16).
 * - `idle-throttle-unanswered`: GETLOWRPM got no answer (row 19).
 * - `identity-unusual`: the firmware is not three digits, or a separator of the identity no space (row 22).
 * - `idle-throttle-malformed`: the reply to GETLOWRPM does not have one byte of data (row 6).
 * - `replies-alike` (a letter for each request, under its name): each reply to these requests comes damaged in the
 *   same way (rows 6 and 21). What they ask for stays unknown.
 *
 * These change how values are read or where they go. They are found only when two replies agree, and dropped again when
 * the timer contradicts them: `timers-reply-66`, `bare-checksum`, `times-big-endian`, `memories-from-one`,
 * `positions-unchanged`, `identity-unusual`.
 */
export type QuirkCode =
  | 'timers-reply-66'
  | 'unlock-reply-6a'
  | 'memory-unknown'
  | 'memory-impossible'
  | 'bare-checksum'
  | 'times-big-endian'
  | 'servo-first'
  | 'servo-unanswered'
  | 'times-rounded'
  | 'memories-from-one'
  | 'positions-unchanged'
  | 'echo'
  | 'idle-throttle-unanswered'
  | 'idle-throttle-malformed'
  | 'replies-alike'
  | 'identity-unusual';

/** The facts of a quirk by name, as {@link QuirkCode} lists them. Times in hundredths of a second. */
export type QuirkParams = Readonly<Record<string, number>>;

/**
 * What to assume about a timer: found in an earlier session, or chosen by the pilot. For what is left out,
 * docs/protocol.md decides.
 */
export interface AssumedQuirks extends LayoutQuirks {
  /** SETMEMORY and SETLOWRPM go out with the bare command byte in place of their checksum (row 5). */
  readonly bareChecksumRequests?: boolean;
  /**
   * The timer keeps positions only for the function at which the servos stand (row 15). Assumed once
   * `positions-unchanged` was found. This alone moves nothing: each write must allow it, see `moveServos`.
   */
  readonly positionsNeedMove?: boolean;
  /** Each request goes out with four zeros in front, as the examples of the source print it (row 1). */
  readonly fourZeros?: boolean;
}

/**
 * The requests whose reply the source prints, in one place, with another letter or with its letter in place of the
 * checksum; and the identity, in which five bytes are as in the source's example on all timers that are known.
 */
const MISPRINTS: Partial<Record<CommandName, QuirkCode>> = {
  GETTIMERS: 'timers-reply-66',
  UNLOCK: 'unlock-reply-6a',
  GETLOWRPM: 'bare-checksum',
  GETSWVER: 'identity-unusual',
};

/** What one timer does differently: found on the line, or assumed. */
export class Quirks {
  readonly found = new Map<QuirkCode, QuirkParams>();
  assumed: AssumedQuirks;
  /** How many replies came in the misprinted form. Below 0: the timer has used the right form. */
  readonly #misprints = new Map<CommandName, number>();
  readonly #first: AssumedQuirks;

  constructor(assumed: AssumedQuirks) {
    this.assumed = assumed;
    this.#first = assumed;
  }

  /** Another timer is there: forgets all but what was assumed at the start. */
  reset(): void {
    this.found.clear();
    this.#misprints.clear();
    this.assumed = this.#first;
  }

  /** Keeps the first finding of each kind. */
  note(code: QuirkCode, params: QuirkParams = {}): void {
    if (!this.found.has(code)) this.found.set(code, params);
  }

  /** Each reply to this request was damaged in the same way. */
  noteAlike(name: CommandName): void {
    this.found.set('replies-alike', { ...this.found.get('replies-alike'), [name]: COMMANDS[name].reply });
  }

  isAlike(name: CommandName): boolean {
    return this.found.get('replies-alike')?.[name] !== undefined;
  }

  assume(quirks: AssumedQuirks): void {
    this.assumed = { ...this.assumed, ...quirks };
  }

  /** Stops assuming this. */
  unassume(assumption: keyof AssumedQuirks): void {
    const { [assumption]: _, ...others } = this.assumed;
    this.assumed = others;
  }

  /** Notes the form of a reply: the right one, or that of a misprint. */
  noteForm(name: CommandName, match: 'exact' | 'misprint'): void {
    this.#dropAlike(name);
    const code = MISPRINTS[name];
    if (!code) return;
    if (match === 'exact') {
      // A timer that uses the right form does not use the wrong one: that was a late reply to something else, or
      // damage.
      this.found.delete(code);
      this.#misprints.set(name, Number.NEGATIVE_INFINITY);
      return;
    }
    const count = (this.#misprints.get(name) ?? 0) + 1;
    this.#misprints.set(name, count);
    // Once is enough for UNLOCK: it is not sent again, and only the letter differs.
    if (name === 'UNLOCK' || count > 1) this.note(code);
  }

  /** A whole reply came: damage that was always the same was none of this timer's. */
  #dropAlike(name: CommandName): void {
    const { [name]: letter, ...others } = this.found.get('replies-alike') ?? {};
    if (letter === undefined) return;
    if (Object.keys(others).length > 0) this.found.set('replies-alike', others);
    else this.found.delete('replies-alike');
  }

  /**
   * Whether this timer may answer in the misprinted form.
   * @param how `known`: only if it was seen to do so; `yes`: also if nothing speaks against it.
   */
  mayMisprint(name: CommandName, how: 'known' | 'yes'): boolean {
    const count = this.#misprints.get(name) ?? 0;
    return how === 'known' ? count > 1 : count >= 0;
  }

  /** Whether the last reply came in the misprinted form for the first time. */
  isMisprintNew(name: CommandName): boolean {
    return this.#misprints.get(name) === 1;
  }

  /** Forgets what was found and what was assumed about this timer. */
  forget(): void {
    this.reset();
    this.assumed = {};
  }

  /** Whether this request goes out with a bare checksum. */
  isBare({ name }: Request): boolean {
    return this.assumed.bareChecksumRequests === true && (name === 'SETMEMORY' || name === 'SETLOWRPM');
  }

  /** Whether the byte order of the times is in doubt and the pilot has not chosen. */
  get byteOrderOpen(): boolean {
    return this.found.has('times-big-endian') && this.assumed.bigEndianTimes === undefined;
  }
}
