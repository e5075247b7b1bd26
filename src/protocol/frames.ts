import { FrameDecoder, type FrameDecoderOptions } from './decoder.js';
import type { Frame } from './frame.js';

/**
 * Gives the frames in a stream of chunks. The stream is anything that `for await` takes: a `ReadableStream` of bytes, a
 * stream of Node, an array. When the stream ends, it looks for frames in the unfinished rest. A false header can hide a
 * frame until more bytes come. Where the line may stay silent for long, use a {@link FrameDecoder} and its `idle()`
 * instead.
 * @param chunks bytes as they come. A chunk may begin and end anywhere.
 * @throws whatever the stream fails with.
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
