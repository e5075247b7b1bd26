import { afterEach, describe, expect, it, vi } from 'vitest';
import { decodedPicture } from '../../../src/app/browser/picture.js';
import { pictureSize } from '../../../src/app/browser/picture-size.js';

/** A picture as a browser makes it. */
async function made(type: string, width: number, height: number): Promise<Uint8Array<ArrayBuffer>> {
  const canvas = new OffscreenCanvas(width, height);
  const pen = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D;
  pen.fillStyle = 'red';
  pen.fillRect(0, 0, width, height / 2);
  return new Uint8Array(await (await canvas.convertToBlob({ type })).arrayBuffer());
}

/** The same picture, which says that it has another size. */
function claiming(bytes: Uint8Array<ArrayBuffer>, at: number, sides: readonly number[], size: 2 | 4) {
  const changed = bytes.slice();
  const view = new DataView(changed.buffer);
  for (const [place, side] of sides.entries()) {
    if (size === 2) view.setUint16(at + 2 * place, side);
    else view.setUint32(at + 4 * place, side);
  }
  return changed;
}

/** Where a JPEG has its height, and after it its width. */
function heightAt(bytes: Uint8Array): number {
  return bytes.findIndex((byte, at) => byte === 0xff && bytes[at + 1] === 0xc0) + 5;
}

/** A segment of a JPEG, put after its beginning. */
function withSegment(bytes: Uint8Array, marker: number, content: readonly number[]): Uint8Array<ArrayBuffer> {
  const length = content.length + 2;
  return new Uint8Array([
    ...bytes.slice(0, 2),
    ...[0xff, marker, length >> 8, length & 0xff],
    ...content,
    ...bytes.slice(2),
  ]);
}

/** What a camera adds that was held upright. */
const UPRIGHT = [
  ...new TextEncoder().encode('Exif\0\0II*\0\b\0\0\0'),
  ...[1, 0, 0x12, 1, 3, 0, 1, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0],
];

const sizeOf = (picture: ImageBitmap | string): unknown =>
  typeof picture === 'string' ? picture : [picture.width, picture.height];

/** What becomes of a file, and whether the browser was asked to decode it. */
async function taken(...parts: BlobPart[]): Promise<readonly [unknown, boolean]> {
  const decode = vi.spyOn(globalThis, 'createImageBitmap');
  const picture = await decodedPicture(new Blob(parts, { type: 'image/jpeg' }), 200);
  return [sizeOf(picture), decode.mock.calls.length > 0];
}

afterEach(() => vi.restoreAllMocks());

describe('a picture from a file', () => {
  it.each(['image/jpeg', 'image/png', 'image/webp'])('%s is decoded in the wanted size', async (type) => {
    expect(await taken(await made(type, 120, 90))).toEqual([[120, 90], true]);
    expect(await taken(await made(type, 1200, 600))).toEqual([[200, 100], true]);
    expect(await taken(await made(type, 600, 1200))).toEqual([[200, 400], true]);
    expect(await taken(await made(type, 4000, 300)), 'a narrow strip keeps its size').toEqual([[4000, 300], true]);
  });

  it('that was taken upright keeps its form', async () => {
    const upright = withSegment(await made('image/jpeg', 1200, 800), 0xe1, UPRIGHT);
    expect(await taken(upright)).toEqual([[200, 300], true]);
  });

  it('is found after everything that a camera puts before it', async () => {
    let bytes = await made('image/jpeg', 120, 90);
    for (let at = 0; at < 5; at++) bytes = withSegment(bytes, 0xe2, Array(60_000).fill(0xff));
    expect(await taken(bytes)).toEqual([[120, 90], true]);
  });

  it('is refused before it is decoded when it would need gigabytes', async () => {
    const [jpeg, png, webp] = await Promise.all([
      made('image/jpeg', 120, 90),
      made('image/png', 120, 90),
      made('image/webp', 120, 90),
    ]);
    const bombs = [
      claiming(jpeg, heightAt(jpeg), [30_000, 30_000], 2),
      claiming(jpeg, heightAt(jpeg), [65_535, 65_535], 2),
      claiming(png, 16, [30_000, 30_000], 4),
      claiming(png, 16, [0xffff_ffff, 0xffff_ffff], 4),
      new Uint8Array([...new TextEncoder().encode('GIF89a'), 0xff, 0xff, 0xff, 0xff]),
      new Uint8Array([...webp.slice(0, 12), ...new TextEncoder().encode('VP8X'), ...Array(14).fill(0xff)]),
      new Uint8Array([
        ...[0, 0, 0, 24],
        ...new TextEncoder().encode('ftypavif'),
        ...Array(12).fill(0),
        ...new TextEncoder().encode('ispe'),
        ...[0, 0, 0, 0, 0, 0, 0xff, 0xff, 0, 0, 0xff, 0xff],
      ]),
    ];
    for (const bomb of bombs) expect(await taken(bomb)).toEqual(['too-large', false]);
    // What Chromium itself makes of it.
    expect(pictureSize(bombs[0]?.buffer as ArrayBuffer)).toEqual({ width: 30_000, height: 30_000 });
  });

  it('of 100 MB is refused before it is read', async () => {
    const jpeg = await made('image/jpeg', 120, 90);
    const read = vi.spyOn(Blob.prototype, 'arrayBuffer');
    expect(await taken(jpeg, new Uint8Array(100_000_000))).toEqual(['too-large', false]);
    expect(read).not.toHaveBeenCalled();
  });

  it('is refused when it is not a picture, or has no size', async () => {
    const jpeg = await made('image/jpeg', 120, 90);
    const beginnings = Array.from({ length: heightAt(jpeg) + 3 }, (_, length) => jpeg.slice(0, length));
    const others = ['', 'no picture', '<svg xmlns="http://www.w3.org/2000/svg" width="1e9" height="1e9"/>', '%PDF-1.4'];
    for (const file of [...beginnings, ...others, claiming(jpeg, heightAt(jpeg), [0, 120], 2)]) {
      expect(await taken(file)).toEqual(['unreadable', false]);
    }
    const endless = new Uint8Array(20_000_000).fill(0xff);
    endless[1] = 0xd8;
    expect(await taken(endless)).toEqual(['unreadable', false]);
    // It has a size, and nothing after it.
    expect(await taken(jpeg.slice(0, heightAt(jpeg) + 10))).toEqual(['unreadable', true]);
  });

  it.each(['image/jpeg', 'image/png', 'image/webp'])(
    '%s that was cut off or damaged anywhere is a picture or none',
    async (type) => {
      const whole = await made(type, 240, 180);
      const step = Math.ceil(whole.length / 60);
      for (let at = 0; at < whole.length; at += step) {
        const damaged = whole.slice();
        damaged.fill(at % 256, at, at + 3);
        for (const file of [whole.slice(0, at), damaged]) {
          const [found] = await taken(file);
          if (typeof found === 'string') expect(['unreadable', 'too-large']).toContain(found);
          else expect(found).toEqual([expect.any(Number), expect.any(Number)]);
        }
      }
    },
  );
});
