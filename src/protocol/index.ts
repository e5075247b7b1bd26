/**
 * From bytes to frames to messages and back, and captures as text. Pure: no DOM, no clock, no I/O.
 * @module
 */

export { type CaptureEntry, captureOf, formatCapture, parseCapture } from './capture.js';
export {
  COMMAND_NAMES,
  COMMANDS,
  type Command,
  type CommandName,
  commandOf,
  type Reply,
  type ReplyOf,
  type Request,
  type RequestOf,
} from './commands.js';
export {
  type DecoderQuirks,
  FrameDecoder,
  type FrameDecoderOptions,
  type Rejection,
  type RejectionReason,
} from './decoder.js';
export { CodecError, type CodecErrorCode, type CodecErrorDetails } from './errors.js';
export { type LayoutOptions, type LayoutQuirks, MAX_POSITION, MAX_TIME } from './fields.js';
export {
  type Bytes,
  checksum,
  type EncodeFrameOptions,
  encodeFrame,
  type Frame,
  frameSize,
  MAX_DATA,
  MAX_LENGTH,
  MIN_LENGTH,
  TERMINATOR,
  ZEROS_NEEDED,
  ZEROS_SENT,
} from './frame.js';
export { type ByteStream, frames } from './frames.js';
export { type Identity, isUsualVersion, requireIdentity, slotCount, type TimerClass } from './identity.js';
export {
  answers,
  type CodecOptions,
  type DecodeReplyOptions,
  decodeReply,
  decodeRequest,
  encodeReply,
  encodeRequest,
  exchangeSize,
} from './messages.js';
