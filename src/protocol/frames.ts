import { FrameDecoder, type FrameDecoderOptions } from './decoder.js';
import type { Frame } from './frame.js';

/** The part of a `ReadableStream` of bytes that {@link frames} uses, with the types of the DOM or of Node. */
export interface ByteStream {
  /** Locks the stream. */
  getReader(): {
    read(): Promise<{ readonly done: boolean; readonly value?: Uint8Array | undefined }>;
    cancel(): Promise<void>;
    releaseLock(): void;
  };
}

/**
 * Gives the frames in a stream of chunks. The stream is a `ReadableStream` of bytes, or anything that `for await`
 * takes: a stream of Node, an array. When the stream ends, it looks for frames in the unfinished rest. A false header
 * can hide a frame until more bytes come. Where the line may stay silent for long, use a {@link FrameDecoder} and its
 * `idle()` instead.
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
  chunks: ByteStream | AsyncIterable<Uint8Array> | Iterable<Uint8Array>,
  options: FrameDecoderOptions = {},
): AsyncGenerator<Frame, void, undefined> {
  const decoder = new FrameDecoder(options);
  for await (const chunk of 'getReader' in chunks ? read(chunks) : chunks) yield* decoder.push(chunk);
  yield* decoder.idle();
}

/** Not every browser, and not every TypeScript, knows a `ReadableStream` as something that `for await` takes. */
async function* read(stream: ByteStream): AsyncGenerator<Uint8Array, void, undefined> {
  const reader = stream.getReader();
  try {
    for (let next = await reader.read(); next.value; next = await reader.read()) yield next.value;
  } finally {
    // As `for await` does: whoever stops reads nothing more. After an end or an error it changes nothing.
    await reader.cancel().catch(() => {});
    reader.releaseLock();
  }
}
