import { Readable } from 'node:stream';
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { encodeFrame, type Frame, frames } from '../../src/protocol/index.js';

async function all(chunks: AsyncIterable<Uint8Array> | Iterable<Uint8Array>): Promise<Frame[]> {
  const found: Frame[] = [];
  for await (const frame of frames(chunks)) found.push(frame);
  return found;
}

it('are found in a stream, however it is cut, and in the unfinished rest at its end', async () => {
  const sent = [encodeFrame(0x6b), encodeFrame(0x62, [1, 2, 0x45]), encodeFrame(0x76, [9])];
  // A false header that asks for more than comes hides the last frame until the end.
  const bytes = [...sent.slice(0, 2).flatMap((each) => [...each]), 0, 0, 0, 0, 0x30, ...(sent[2] as Uint8Array)];
  await fc.assert(
    fc.asyncProperty(fc.array(fc.integer({ min: 1, max: 12 }), { minLength: 1 }), async (sizes) => {
      const chunks: Uint8Array[] = [];
      for (let at = 0, turn = 0; at < bytes.length; turn++) {
        const size = sizes[turn % sizes.length] as number;
        chunks.push(Uint8Array.from(bytes.slice(at, at + size)));
        at += size;
      }
      expect((await all(chunks)).map(({ code, data }) => encodeFrame(code, data))).toEqual(sent);
      expect(await all(Readable.from(chunks))).toEqual(await all(chunks));
    }),
    { numRuns: 50 },
  );
});

it('end with the error of the stream, and release it when the reader stops', async () => {
  let isCancelled = false;
  const stream = new ReadableStream<Uint8Array>({
    pull: (controller) => controller.enqueue(encodeFrame(0x6b)),
    cancel: () => {
      isCancelled = true;
    },
  });
  for await (const { code } of frames(stream)) {
    expect(code).toBe(0x6b);
    break;
  }
  expect([isCancelled, stream.locked]).toEqual([true, false]);
  const broken = new ReadableStream<Uint8Array>({ pull: (controller) => controller.error(new Error('gone')) });
  await expect(all(broken)).rejects.toThrow('gone');
});

it('are found in a stream where `for await` takes none, as in Chrome before 124 and Safari', async () => {
  const stream = new Blob([encodeFrame(0x6b)]).stream();
  Object.defineProperty(stream, Symbol.asyncIterator, { value: undefined });
  expect(await all(stream)).toEqual([{ code: 0x6b, data: new Uint8Array() }]);
  expect(stream.locked).toBe(false);
});
