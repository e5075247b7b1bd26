import {
  answers,
  type CommandName,
  decodeReply,
  exchangeSize,
  type Frame,
  frameSize,
  type Identity,
  type Reply,
  type Request,
} from '../protocol/index.js';
import type { Quirks } from './quirks.js';
import { LONGEST_FRAME } from './retry-policy.js';

/**
 * What became of something that was sent once, when its time was up or its answer came.
 *
 * - `answer`: its own answer came.
 * - `bad`: one came with a right checksum and an impossible content; `error` says what.
 * - `damaged`: bytes came that belong to no frame, or an error of the line.
 * - `stray`: whole frames came, and none of them was the answer.
 * - `silent`: nothing came, but perhaps an echo.
 */
export type Outcome<Answer> = AnswerOutcome<Answer> | { readonly kind: 'damaged' | 'stray' | 'silent' };

/** What a frame says as the answer to what was sent. */
export type AnswerOutcome<Answer> =
  | { readonly kind: 'answer'; readonly answer: Answer }
  | { readonly kind: 'bad'; readonly error: unknown };

/** A request, and how its reply is known. */
export interface Question {
  readonly request: Request;
  /** What the timer said of itself; null before it has. */
  readonly identity: Identity | null;
  /**
   * Whether a letter that belongs to another command may be taken for the reply's: `known` where this timer was seen to
   * use it. Default: it may not.
   */
  readonly misprints?: 'known' | 'yes';
}

/**
 * Looks at a frame as the reply to a question, and notes its form.
 * @param isBare whether its letter stands in place of its sum.
 * @returns undefined when it is no reply to that.
 */
export function asReply(
  frame: Frame,
  { request, identity, misprints }: Question,
  quirks: Quirks,
  isBare: boolean,
): AnswerOutcome<Reply> | undefined {
  const letter = answers(frame.code, request.name);
  if (!letter) return undefined;
  const match = isBare ? 'misprint' : letter;
  if (match === 'misprint' && !(misprints && quirks.mayMisprint(request.name, misprints))) return undefined;
  let reply: Reply;
  try {
    reply = decodeReply(frame, { identity: identity ?? undefined, quirks: quirks.assumed, pending: request });
  } catch (error) {
    return { kind: 'bad', error };
  }
  // The sum of a reply with the value 0 is its letter in any case.
  if (reply.name !== 'GETLOWRPM' || reply.idleThrottle !== 0) quirks.noteForm(request.name, match);
  return { kind: 'answer', answer: reply };
}

/** Bytes that the reply to a request takes at most. */
export function replySize(name: CommandName, identity: Identity | null): number {
  if (identity) return exchangeSize(name, identity).reply;
  // Before the timer is known only GETSWVER has a reply of known size; that to a fence may be the longest.
  return name === 'GETSWVER' ? frameSize(9) : LONGEST_FRAME;
}
