import { COMMANDS, type CommandName, commandOf, type Reply, type ReplyOf, type Request } from './commands.js';
import { CodecError } from './errors.js';
import type { Field, LayoutOptions } from './fields.js';
import { type Bytes, type EncodeFrameOptions, encodeFrame, type Frame, frameSize } from './frame.js';
import type { Identity } from './identity.js';

/** All ways in which the bytes of a timer may differ from the usual reading of the protocol. */
export interface CodecOptions extends LayoutOptions, EncodeFrameOptions {}

/** What is known of a reply before it is read. */
export interface DecodeReplyOptions<Name extends CommandName = CommandName> extends LayoutOptions {
  /** The pending request. Without it the letter alone names the reply. */
  readonly pending?: Named<Name> | undefined;
}

/** A command by its name, or a request of that command. */
type Named<Name extends CommandName> = Name | { readonly name: Name; readonly [value: string]: unknown };

type Values = Readonly<Record<string, unknown>>;

/**
 * The bytes of a request.
 * @param options with an identity every value must fit that timer; without one, some timer.
 * @throws CodecError `unknown-command`, `not-an-integer`, `out-of-range` or `wrong-count`, with the field.
 * @example
 * ```ts
 * import { encodeRequest } from 'sidus-timer/protocol';
 *
 * const bytes = encodeRequest({ name: 'SETSERVO', function: 4, servo: 0, position: 65 });
 * console.log(bytes.join(' ')); // 0 0 0 0 0 6 99 4 0 65 168 69
 * ```
 */
export function encodeRequest(request: Request, options: CodecOptions = {}): Bytes {
  const { request: code } = commandNamed(request);
  return encodeFrame(code, encodeFields(requestFields(request.name, options), request, options), options);
}

/**
 * Reads a request, as a timer does.
 * @throws CodecError `unknown-command`, `wrong-length`, `out-of-range`.
 */
export function decodeRequest(frame: Frame<Uint8Array>, options: LayoutOptions = {}): Request {
  const command = commandOf(frame.code);
  if (command?.direction !== 'request') throw unknownCommand(frame);
  const values = decodeFields(requestFields(command.name, options), frame.data, options);
  return { name: command.name, ...values } as Request;
}

/**
 * The bytes of a reply.
 * @throws CodecError `unknown-command`, `not-an-integer`, `out-of-range`, `wrong-count` or `bad-identity`.
 */
export function encodeReply(reply: Reply, options: CodecOptions = {}): Bytes {
  const { reply: code } = commandNamed(reply);
  return encodeFrame(code, encodeFields(replyFields(reply.name), reply, options), options);
}

/**
 * Reads a reply, as the client does. With a pending GETTIMERS it takes the letter 66 for 62, with a pending UNLOCK 6A
 * for 6E: the source prints them so in one place. Take such a reply only when no earlier request can still be answered.
 * @throws CodecError `unexpected-reply` when the frame does not answer the pending request, `unknown-command` when no
 * reply has this letter, `wrong-length`, `out-of-range`, `bad-identity`, `identity-needed`.
 * @returns the reply. With a pending request of a known name, its values are typed.
 * @example
 * ```ts
 * import { decodeReply, encodeReply, FrameDecoder } from 'sidus-timer/protocol';
 *
 * const [frame] = new FrameDecoder().push(encodeReply({ name: 'GETMEMORY', memory: 2 }));
 * if (frame) console.log(decodeReply(frame, { pending: 'GETMEMORY' }).memory); // 2
 * ```
 */
export function decodeReply<Name extends CommandName = CommandName>(
  frame: Frame<Uint8Array>,
  options: DecodeReplyOptions<Name> = {},
): ReplyOf<Name> {
  const { pending } = options;
  const command = commandOf(frame.code);
  if (command?.direction !== 'reply') throw unknownCommand(frame);
  let { name } = command;
  if (pending !== undefined) {
    const asked = typeof pending === 'string' ? pending : pending.name;
    if (!answers(frame.code, asked)) {
      throw new CodecError('unexpected-reply', 'code', `a reply to ${name} does not answer ${asked}`, {
        value: frame.code,
      });
    }
    name = asked;
  }
  return { name, ...decodeFields(replyFields(name), frame.data, options) } as ReplyOf<Name>;
}

/**
 * Whether a frame with this letter answers a request: `exact`, or `misprint` for a letter that the source prints in one
 * place and that belongs to another command. Take a misprint only when no earlier request can still be answered.
 */
export function answers(code: number, asked: CommandName): 'exact' | 'misprint' | undefined {
  const command: { reply: number; misprint?: number } = COMMANDS[asked];
  if (command.reply === code) return 'exact';
  return command.misprint === code ? 'misprint' : undefined;
}

/** Bytes on the wire of a request and of its reply, for a timer of this identity. */
export function exchangeSize(name: CommandName, identity: Identity): { request: number; reply: number } {
  const size = (fields: readonly Field[]): number => frameSize(fields.reduce((sum, f) => sum + f.size(identity), 0));
  return { request: size(requestFields(name, {})), reply: size(replyFields(name)) };
}

/** The row of a message. A caller without types may pass anything. */
function commandNamed(message: { readonly name: CommandName }): (typeof COMMANDS)[CommandName] {
  const name: unknown = (message as { readonly name: CommandName } | null | undefined)?.name;
  if (typeof name === 'string' && Object.hasOwn(COMMANDS, name)) return COMMANDS[name as CommandName];
  throw new CodecError('unknown-command', 'name', 'a message must have the name of a command', { value: name });
}

function requestFields(name: CommandName, { quirks }: LayoutOptions): readonly Field[] {
  if (name === 'SETSERVO' && quirks?.servoFirst) {
    const [functionField, servoField, positionField] = COMMANDS.SETSERVO.sends;
    return [servoField, functionField, positionField];
  }
  return COMMANDS[name].sends;
}

function replyFields(name: CommandName): readonly Field[] {
  return COMMANDS[name].answers;
}

function encodeFields(fields: readonly Field[], values: object, layout: LayoutOptions): readonly number[] {
  return fields.flatMap((field) => field.encode((values as Values)[field.name], layout));
}

function decodeFields(fields: readonly Field[], data: Uint8Array, layout: LayoutOptions): Values {
  if (data.length < fields.length - 1 || (fields.length === 0 && data.length > 0)) {
    throw new CodecError('wrong-length', 'data', `${data.length} bytes do not fit this command`, { bytes: data });
  }
  const values: Record<string, unknown> = {};
  fields.forEach((field, index) => {
    const isLast = index === fields.length - 1;
    values[field.name] = field.decode(data.subarray(index, isLast ? data.length : index + 1), layout);
  });
  return values;
}

function unknownCommand(frame: Frame<Uint8Array>): CodecError {
  const letter = frame.code.toString(16).padStart(2, '0');
  return new CodecError('unknown-command', 'code', `no such command: ${letter}`, { value: frame.code });
}
