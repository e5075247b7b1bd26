import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { PATIENCE } from '../../../src/app/browser/read-file.js';
import { type ChosenFile, writeFile } from '../../../src/app/browser/save-file.js';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** A file on a drive that hangs at one step until it is mended. It notes what was done. */
function hanging(at: string): { file: ChosenFile; done: string[]; mend: () => void } {
  const done: string[] = [];
  let mend = (): void => {};
  const mended = new Promise<void>((resolve) => {
    mend = resolve;
  });
  const step = async (name: string): Promise<void> => {
    if (name === at) await mended;
    done.push(name);
  };
  const stream = {
    write: () => step('write'),
    close: () => step('close'),
    abort: () => step('abort'),
  } as Partial<FileSystemWritableFileStream> as FileSystemWritableFileStream;
  const createWritable = (): Promise<FileSystemWritableFileStream> => step('open').then(() => stream);
  return { file: { name: 'a.sidus', createWritable }, done, mend: () => mend() };
}

it('writes all of it', async () => {
  const { file, done } = hanging('nowhere');
  await writeFile(file, 'a');
  expect(done).toEqual(['open', 'write', 'close']);
});

it.each([
  { at: 'open', all: ['open', 'abort'] },
  { at: 'write', all: ['open', 'abort', 'write'] },
  // The stream of a browser lets a close that has begun go on.
  { at: 'close', all: ['open', 'write', 'abort', 'close'] },
])('gives up a drive that hangs at $at after a minute, and aborts what was begun', async ({ at, all }) => {
  const { file, done, mend } = hanging(at);
  const ended = vi.fn();
  void writeFile(file, 'a').catch(ended);
  await vi.advanceTimersByTimeAsync(PATIENCE - 1);
  expect(ended).not.toHaveBeenCalled();
  await vi.advanceTimersByTimeAsync(1);
  expect(ended).toHaveBeenCalledOnce();
  mend();
  await vi.advanceTimersByTimeAsync(0);
  expect(done).toEqual(all);
});

it('lets a second text wait until the first is in the file, so that the newer one stays', async () => {
  const { file, done, mend } = hanging('close');
  const first = writeFile(file, 'a');
  const second = writeFile(file, 'b');
  await vi.advanceTimersByTimeAsync(PATIENCE - 1);
  expect(done).toEqual(['open', 'write']);
  mend();
  await Promise.all([first, second]);
  expect(done).toEqual(['open', 'write', 'close', 'open', 'write', 'close']);
});

it('does not write over a close that was given up and may still land', async () => {
  const { file, done, mend } = hanging('close');
  const first = vi.fn();
  void writeFile(file, 'a').catch(first);
  await vi.advanceTimersByTimeAsync(PATIENCE);
  expect(first).toHaveBeenCalledOnce();
  const second = vi.fn();
  void writeFile(file, 'b').catch(second);
  await vi.advanceTimersByTimeAsync(PATIENCE);
  expect(second).toHaveBeenCalledOnce();
  expect(done).toEqual(['open', 'write', 'abort']);
  mend();
  await writeFile(file, 'c');
  expect(done).toEqual(['open', 'write', 'abort', 'close', 'open', 'write', 'close']);
});
