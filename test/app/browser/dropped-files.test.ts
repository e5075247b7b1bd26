import { afterEach, expect, it, vi } from 'vitest';
import { holdDroppedFiles, takeDroppedFiles } from '../../../src/app/browser/dropped-files.js';

const FILE = new File(['{}'], 'a.sidus');
const ends: (() => void)[] = [];
afterEach(() => {
  for (const end of ends.splice(0)) end();
  document.body.replaceChildren();
});

/** What a browser tells of something that is dropped on the page. @returns whether the page keeps it out. */
function drop(files: File[] | null): boolean {
  const event = new Event('drop', { bubbles: true, cancelable: true });
  Object.assign(event, { dataTransfer: { types: files ? ['Files'] : ['text/plain'], files: files ?? [] } });
  document.body.dispatchEvent(event);
  return event.defaultPrevented;
}

it('a file never replaces the page; a text goes where the browser puts it', () => {
  holdDroppedFiles();
  expect([drop([FILE]), drop(null)]).toEqual([true, false]);
});

it('files go to the part of the page that takes them, for as long as it is there and no dialog is open', () => {
  const take = vi.fn();
  ends.push(takeDroppedFiles(take));
  drop([FILE]);
  drop(null);
  expect(take.mock.calls).toEqual([[[FILE]]]);
  const dialog = document.createElement('dialog');
  dialog.setAttribute('open', '');
  document.body.append(dialog);
  drop([FILE]);
  dialog.remove();
  ends.splice(0)[0]?.();
  drop([FILE]);
  expect(take).toHaveBeenCalledTimes(1);
});
