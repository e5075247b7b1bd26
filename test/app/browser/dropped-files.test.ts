import { afterEach, expect, it, vi } from 'vitest';
import { holdDroppedFiles, takeDroppedFiles } from '../../../src/app/browser/dropped-files.js';

const FILE = new File(['{}'], 'a.sidus');
const ends: (() => void)[] = [];
afterEach(() => {
  for (const end of ends.splice(0)) end();
});

/** What a browser tells of something that is moved over the page. */
function tell(type: 'dragover' | 'dragleave' | 'drop', files: File[] | null, out = true) {
  const dataTransfer = { types: files ? ['Files'] : ['text/plain'], files: files ?? [], dropEffect: 'move' };
  const event = new Event(type, { bubbles: true, cancelable: true });
  Object.assign(event, { dataTransfer, relatedTarget: out ? null : document.body });
  document.body.dispatchEvent(event);
  return { isOurs: event.defaultPrevented, effect: dataTransfer.dropEffect };
}

function taker(takes = true) {
  const spies = { takes: () => takes, over: vi.fn(), drop: vi.fn() };
  ends.push(takeDroppedFiles(spies));
  return spies;
}

it('keeps the last dropped file until a part of the page takes it', () => {
  holdDroppedFiles();
  const later = new File(['{}'], 'b.sidus');
  expect(tell('dragover', [FILE])).toEqual({ isOurs: true, effect: 'copy' });
  expect([tell('drop', [FILE]).isOurs, tell('drop', [later]).isOurs]).toEqual([true, true]);
  expect(taker().drop.mock.calls).toEqual([[[later]]]);
  expect(taker().drop, 'only one part of the page gets the file').not.toHaveBeenCalled();
});

it('gives it to that part at once, and keeps the next one when that part has gone', () => {
  const first = taker();
  tell('drop', [FILE]);
  expect(first.drop).toHaveBeenCalledTimes(1);
  ends.splice(0)[0]?.();
  expect(tell('drop', [FILE]).isOurs).toBe(true);
  expect([first.drop, taker().drop].map((spy) => spy.mock.calls.length)).toEqual([1, 1]);
});

it('stops the browser from opening a file that is not wanted now', () => {
  const busy = taker(false);
  expect(tell('dragover', [FILE])).toEqual({ isOurs: true, effect: 'none' });
  expect(tell('drop', [FILE]).isOurs).toBe(true);
  expect([busy.drop.mock.calls, busy.over.mock.calls]).toEqual([[], [[false], [false]]]);
});

it('reports when files are over the page and when they have left it, but not for each part', () => {
  const { over } = taker();
  tell('dragover', [FILE]);
  tell('dragleave', [FILE], false);
  tell('dragleave', [FILE]);
  expect(over.mock.calls).toEqual([[true], [false]]);
});

it('leaves everything else that is dragged to the browser', () => {
  const { drop } = taker();
  expect([tell('dragover', null), tell('drop', null)]).toEqual([
    { isOurs: false, effect: 'move' },
    { isOurs: false, effect: 'move' },
  ]);
  expect(drop).not.toHaveBeenCalled();
});

it('ignores what a part of the page takes itself, and no longer offers to take it', () => {
  const take = (event: Event): void => event.preventDefault();
  document.body.addEventListener('dragover', take);
  document.body.addEventListener('drop', take);
  ends.push(() => {
    document.body.removeEventListener('dragover', take);
    document.body.removeEventListener('drop', take);
  });
  const spies = taker();
  expect(tell('dragover', [FILE])).toEqual({ isOurs: true, effect: 'move' });
  tell('drop', [FILE]);
  expect(spies.drop).not.toHaveBeenCalled();
  expect(spies.over.mock.calls).toEqual([[false], [false]]);
});
