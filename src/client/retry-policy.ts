import { wireTime } from '../line/index.js';
import { type CommandName, exchangeSize, frameSize, type Identity, MAX_DATA } from '../protocol/index.js';

// How long the client waits, how often it asks again, and when it gives up: all numbers stand here. Schedule makes of
// them the time that a job takes at most. The protocol page explains them under "Rules for a client".

/** The speed of the line, and how slow a timer may be. */
export interface LineTiming {
  /** Bits a second. */
  readonly baudRate: number;
  /** Milliseconds beyond the time of the bytes that a reply may take. */
  readonly margin: number;
}

/** How much is done to get an answer. */
export interface RetryPolicy {
  /** How often the request goes out at most. */
  readonly tries?: number | undefined;
  /**
   * The same when nothing at all comes of it although the timer answers other requests, and no damage was seen that
   * could be why.
   */
  readonly unanswered?: number | undefined;
  /** A late reply to the same question, asked before, will do as well: then no fence has to tell the two apart. */
  readonly anyReply?: boolean | undefined;
  /**
   * Whether a letter that belongs to another command may be taken only where this timer was seen to use it. Default
   * false.
   */
  readonly strict?: boolean | undefined;
  /** Makes sure, before the request goes out behind something that stayed unanswered, that it still may. */
  readonly beforeRepeat?: (() => Promise<void>) | undefined;
}

/** How an answer is believed. */
export interface Belief<Answer> extends RetryPolicy {
  /** What was known before, or a reading: counts as the first of two. */
  readonly before?: Answer | undefined;
  /** Never believes a single answer. */
  readonly twice?: boolean | undefined;
}

/** Milliseconds without a byte after which the line counts as silent. */
export const SILENCE = 60;
/** Milliseconds after which draining a line that never falls silent is given up. */
export const DRAIN = 1000;
/**
 * Milliseconds after which an unanswered request can no longer be answered. It is the bound of the law that a late
 * reply is never taken for a later request's: a timer that answers later than this breaks it.
 */
export const LATEST_REPLY = 3000;
/** Bytes of the longest frame. */
export const LONGEST_FRAME = frameSize(MAX_DATA);

/** How often a question, or the questions for a memory, are asked at most to find two answers in a row that agree. */
export const READS = 6;
/**
 * How often a reading of a memory is started again at most, because the memory changed or frames came that nobody asked
 * for.
 */
export const ATTEMPTS = 4;
/**
 * How often a request goes out at most. A request and reply of 62 bytes pass one in two times when 1 % of all bytes are
 * damaged.
 */
export const SENDS = 20;
/**
 * How often it goes out at most when nothing at all comes of it while fences are answered, and no damage was seen: the
 * timer does not answer this request.
 */
export const UNANSWERED = 10;
/** The same for a question that not every timer is known to answer. */
export const UNANSWERED_OPTIONAL = 6;
/** How often such a question goes out at most when this timer was found not to answer it. */
export const TRIES_OF_UNANSWERED = 2;
/** Exchanges in a row without an answer, fences included, after which a line that damages is given up. */
export const MISSES = 12;
/**
 * Exchanges in a row in which nothing came at all, after which a timer that has answered before is not there: it fell
 * asleep.
 */
export const SILENT = 7;
/**
 * The same for a timer that has not answered yet, or not since it was given up, and before a request that must not be
 * repeated.
 */
export const SILENT_AT_FIRST = 3;
/** Replies with a right checksum and impossible content after which that is how this timer answers. */
export const BAD_REPLIES = 3;
/** Milliseconds that a job may lose to damage, beyond twice what its exchanges can take. */
export const LOST_TO_DAMAGE = 45_000;
/**
 * Milliseconds of those that are kept for what has to be done at its end: reading back, going back to the first memory.
 */
export const KEPT_FOR_THE_END = 15_000;

/** Milliseconds that so many bytes and the timer's thinking may take before the request counts as unanswered. */
export function replyTime(bytes: number, { baudRate, margin }: LineTiming): number {
  return wireTime(bytes, baudRate) + margin;
}

/** Milliseconds for which a wait goes on at most while bytes are still coming: one longest frame. */
export function overtime({ baudRate }: LineTiming): number {
  return wireTime(LONGEST_FRAME, baudRate) + SILENCE;
}

/** Several exchanges one after another: how many, and the bytes of all their requests and replies. */
export interface Exchanges {
  readonly count: number;
  readonly bytes: number;
}

/** These exchanges with a timer; with one that has not said what it is, each may have the longest frames. */
export function exchangesOf(names: readonly CommandName[], identity: Identity | null): Exchanges {
  let bytes = 0;
  for (const name of names) {
    const size = identity ? exchangeSize(name, identity) : { request: LONGEST_FRAME, reply: LONGEST_FRAME };
    bytes += size.request + size.reply;
  }
  return { count: names.length, bytes };
}

/**
 * Milliseconds that these exchanges take at most: the own answer of each does not come, and something else does until
 * the end.
 */
export function longestExchanges({ count, bytes }: Exchanges, timing: LineTiming): number {
  return wireTime(bytes, timing.baudRate) + count * (timing.margin + overtime(timing) + SILENCE);
}

/** The same for one. */
export function longestExchange(name: CommandName, identity: Identity | null, timing: LineTiming): number {
  return longestExchanges(exchangesOf([name], identity), timing);
}

/**
 * Milliseconds that making sure of one's own replies takes at most: draining, then a fence or the wait until nothing
 * older can come.
 */
export function longestFence(timing: LineTiming): number {
  return DRAIN + SILENCE + Math.max(LATEST_REPLY, replyTime(2 * LONGEST_FRAME, timing) + overtime(timing) + SILENCE);
}
