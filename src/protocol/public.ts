/**
 * From bytes to frames to messages and back, and captures as text. Pure: no DOM, no clock, no I/O.
 * @module protocol
 */

export { type AnalysedEntry, analyse } from './analyse.js';
export { type CaptureEntry, captureOf, formatCapture, parseCapture } from './capture.js';
export {
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
export { type Hundredths, type LayoutOptions, type LayoutQuirks, MAX_POSITION, MAX_TIME } from './fields.js';
export { type Bytes, type EncodeFrameOptions, encodeFrame, type Frame } from './frame.js';
export { type ByteStream, frames } from './frames.js';
export { type Identity, slotCount, type TimerClass } from './identity.js';
export {
  type CodecOptions,
  type DecodeReplyOptions,
  decodeReply,
  decodeRequest,
  encodeReply,
  encodeRequest,
} from './messages.js';
