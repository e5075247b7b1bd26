import {
  answers,
  COMMANDS,
  type CommandName,
  decodeReply,
  exchangeSize,
  type Frame,
  frameSize,
  type Identity,
  isUsualVersion,
  MIN_LENGTH,
  type Reply,
  type Request,
  ZEROS_NEEDED,
} from '../protocol/index.js';
import type { Quirks } from './quirks.js';
import { LONGEST_FRAME } from './retry-policy.js';

/**
 * What came of something that was sent once, when its answer came or its time was up.
 * - `answer`: its own answer came.
 * - `bad`: an answer came with a right checksum and an impossible content; `error` says what.
 * - `damaged`: bytes came that belong to no frame, or an error of the line.
 * - `stray`: whole frames came, but none was the answer.
 * - `silent`: nothing came, or only an echo.
 */
export type Outcome<Answer> =
  | AnswerOutcome<Answer>
  | { readonly kind: 'stray' | 'silent' }
  /** `bytes`: all that came since the request went out. */
  | { readonly kind: 'damaged'; readonly bytes: Uint8Array };

/** What a frame means as the answer. */
export type AnswerOutcome<Answer> =
  | { readonly kind: 'answer'; readonly answer: Answer }
  | { readonly kind: 'bad'; readonly error: unknown };

/** A request, and how to recognise its reply. */
export interface Question {
  readonly request: Request;
  /** What the timer said about itself; null before that. */
  readonly identity: Identity | null;
  /**
   * Whether a letter that belongs to another command may stand for the reply. `known`: only where this timer was seen
   * to use it. Default: it may not.
   */
  readonly misprints?: 'known' | 'yes';
}

/**
 * Reads a frame as the reply to a question, and notes the form of the reply.
 * @param isBare whether its command byte stands in place of its checksum.
 * @returns undefined when it is no reply to this question.
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
  if (reply.name === 'GETSWVER') quirks.noteForm('GETSWVER', isUsualVersion(frame.data) ? 'exact' : 'misprint');
  // With the value 0 the bare command byte is the right checksum anyway, so it shows nothing.
  else if (reply.name !== 'GETLOWRPM' || reply.idleThrottle !== 0) quirks.noteForm(request.name, match);
  return { kind: 'answer', answer: reply };
}

/**
 * A damaged reply to a request, from its length byte on: what came after four zeros and has the right letter. Bytes
 * without such a header are noise, and say nothing about the timer.
 * @returns null when there is none.
 */
export function damagedReply(bytes: Uint8Array, name: CommandName): string | null {
  const { reply } = COMMANDS[name];
  const at = bytes.findIndex(
    (letter, i) =>
      letter === reply &&
      (bytes[i - 1] ?? 0) >= MIN_LENGTH &&
      i > ZEROS_NEEDED &&
      bytes.subarray(i - 1 - ZEROS_NEEDED, i - 1).every((byte) => byte === 0),
  );
  return at < 0 ? null : bytes.subarray(at - 1).join(' ');
}

/** The most bytes that the reply to a request can take. */
export function replySize(name: CommandName, identity: Identity | null): number {
  if (identity) return exchangeSize(name, identity).reply;
  // Before the timer is known, only the reply to GETSWVER has a known size. Any other may have the longest.
  return name === 'GETSWVER' ? frameSize(9) : LONGEST_FRAME;
}
