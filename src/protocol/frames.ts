import { FrameDecoder, type FrameDecoderOptions } from './decoder.js';
import type { Frame } from './frame.js';

/**
 * The frames in a stream of chunks: what `for await` takes, such as a `ReadableStream` of bytes, a stream of Node or an
 * array. At the end of the stream, what is left of an unfinished frame is looked into. A frame that damage has hidden
 * behind a false header may come only with the bytes after it: where the line falls silent for long, use a
 * {@link FrameDecoder} and its `idle()` instead.
 * @param chunks bytes as they come, cut anywhere.
 * @throws what the stream fails with.
 * @example
 * ```ts
 * import { encodeFrame, frames } from 'sidus-timer/protocol';
 *
 * const chunks = [encodeFrame(0x6b), encodeFrame(0x72, [3])];
 * for await (const { code, data } of frames(chunks)) console.log(code, data.length); // 107 0 | 114 1
 * ```
 */
export async function* frames(
  chunks: AsyncIterable<Uint8Array> | Iterable<Uint8Array>,
  options: FrameDecoderOptions = {},
): AsyncGenerator<Frame, void, undefined> {
  const decoder = new FrameDecoder(options);
  for await (const chunk of chunks) yield* decoder.push(chunk);
  yield* decoder.idle();
}
