import { wireTime } from '../line/index.js';
import { type CommandName, exchangeSize, frameSize, type Identity, MAX_DATA } from '../protocol/index.js';

// How long the client waits, how often it repeats, and when it gives up: all numbers stand here. Schedule works out
// from them how long a job takes at most. "Rules for a client" in docs/protocol.md explains them.

/** The speed of the line, and how slow a timer may be. */
export interface LineTiming {
  /** Bits a second. */
  readonly baudRate: number;
  /** How long a reply may take beyond the time of its bytes, in milliseconds. */
  readonly margin: number;
}

/** How much effort an answer is worth. */
export interface RetryPolicy {
  /** How often the request goes out at most. */
  readonly tries?: number | undefined;
  /**
   * The same when nothing at all comes back, although the timer answers other requests and no damage could explain it.
   */
  readonly unanswered?: number | undefined;
  /** Accepts a late reply to the same question, asked before. Then no fence has to tell the two apart. */
  readonly anyReply?: boolean | undefined;
  /** Whether a misprinted letter is accepted only where this timer was seen to use it. Default false. */
  readonly strict?: boolean | undefined;
  /** Runs before a request goes out after one that got no answer. Rejects when the request must not go out any more. */
  readonly beforeRepeat?: (() => Promise<void>) | undefined;
}

/** When an answer is believed. */
export interface Belief<Answer> extends RetryPolicy {
  /** An earlier reading, or what was known before. Counts as the first of two. */
  readonly before?: Answer | undefined;
  /** Never believes a single answer. */
  readonly twice?: boolean | undefined;
}

/** Milliseconds without a byte after which the line counts as silent. */
export const SILENCE = 60;
/** Milliseconds after which waiting for silence is given up, on a line that never falls silent. */
export const DRAIN = 1000;
/**
 * Milliseconds after which an unanswered request can no longer be answered. On this rests the rule that a late reply is
 * never taken for the reply to a later request. A timer that answers even later breaks it.
 */
export const LATEST_REPLY = 3000;
/**
 * When something happens so many milliseconds after its time, the program stood still: the computer slept, or something
 * held the program up. Meanwhile anything may have come under the head.
 */
export const STANDSTILL = 10_000;
/** Bytes of the longest frame. */
export const LONGEST_FRAME = frameSize(MAX_DATA);

/** How often a question, or the questions for a memory, are asked at most until two answers in a row agree. */
export const READS = 6;
/**
 * How often the reading of a memory starts again at most,
 * because the memory changed or frames came that nobody asked for.
 */
export const ATTEMPTS = 4;
/**
 * How often a request goes out at most.
 * When 1 % of all bytes are damaged, about half of all exchanges of 62 bytes succeed.
 */
export const SENDS = 20;
/**
 * How often it goes out at most when nothing at all comes back while fences are answered and there is no damage: this
 * timer does not answer this request.
 */
export const UNANSWERED = 10;
/** The same for a question that not every timer is known to answer. */
export const UNANSWERED_OPTIONAL = 6;
/** How often such a question goes out at most to a timer that was found not to answer it. */
export const TRIES_OF_UNANSWERED = 2;
/** On a line with damage: exchanges in a row without an answer, fences included, after which the client gives up. */
export const MISSES = 12;
/** Exchanges in a row without any byte, after which a timer that has answered before counts as asleep. */
export const SILENT = 7;
/**
 * The same for a timer that has not answered yet, or not since it was given up;
 * also before a request that must not be repeated.
 */
export const SILENT_AT_FIRST = 3;
/** Replies with a right checksum and impossible content after which the client takes that for this timer's answer. */
export const BAD_REPLIES = 3;
/**
 * Damaged replies to one request, all with the same bytes, after which they are no accident, while fences between them
 * are answered: noise is random.
 */
export const ALIKE = 3;
/** Milliseconds that a job may lose to damage, beyond twice the longest time of its exchanges. */
export const LOST_TO_DAMAGE = 45_000;
/** How many of those milliseconds are reserved for the end of a job: reading back, returning to the first memory. */
export const KEPT_FOR_THE_END = 15_000;

/** Milliseconds that the bytes and the timer itself may take, before the request counts as unanswered. */
export function replyTime(bytes: number, { baudRate, margin }: LineTiming): number {
  return wireTime(bytes, baudRate) + margin;
}

/**
 * Milliseconds after which an unanswered request counts as one that can no longer be answered. Of a timer that is known
 * to be slow it takes longer than {@link LATEST_REPLY}, so that one that answers even later is noticed.
 */
export function latestReply({ margin }: LineTiming): number {
  return Math.max(LATEST_REPLY, 2 * margin);
}

/** How long a wait goes on at most while bytes still come, in milliseconds: the time of one longest frame. */
export function overtime({ baudRate }: LineTiming): number {
  return wireTime(LONGEST_FRAME, baudRate) + SILENCE;
}

/** Several exchanges in a row: their number, and the bytes of all their requests and replies. */
export interface Exchanges {
  readonly count: number;
  readonly bytes: number;
}

/** Counts these exchanges. A timer that has not said what it is may use the longest frames. */
export function exchangesOf(names: readonly CommandName[], identity: Identity | null): Exchanges {
  let bytes = 0;
  for (const name of names) {
    const size = identity ? exchangeSize(name, identity) : { request: LONGEST_FRAME, reply: LONGEST_FRAME };
    bytes += size.request + size.reply;
  }
  return { count: names.length, bytes };
}

/**
 * The longest time of these exchanges in milliseconds:
 * no answer of their own comes, and other bytes come until the end.
 */
export function longestExchanges({ count, bytes }: Exchanges, timing: LineTiming): number {
  return wireTime(bytes, timing.baudRate) + count * (timing.margin + overtime(timing) + SILENCE);
}

/** The same for one exchange. */
export function longestExchange(name: CommandName, identity: Identity | null, timing: LineTiming): number {
  return longestExchanges(exchangesOf([name], identity), timing);
}

/**
 * The longest time of a fence in milliseconds: waiting for silence, then the fence itself or the wait until no older
 * reply can come.
 */
export function longestFence(timing: LineTiming): number {
  return (
    DRAIN + SILENCE + Math.max(latestReply(timing), replyTime(2 * LONGEST_FRAME, timing) + overtime(timing) + SILENCE)
  );
}
