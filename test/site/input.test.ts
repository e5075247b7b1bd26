import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';

test('Enter and the arrows first end the composing of a text, and go to another cell only then', async () => {
  const app = await AppPage.connected();
  const devTools = await app.page.context().newCDPSession(app.page);
  const press = async (key: string, windowsVirtualKeyCode: number): Promise<void> => {
    for (const type of ['keyDown', 'keyUp'] as const)
      await devTools.send('Input.dispatchKeyEvent', { type, key, code: key, windowsVirtualKeyCode });
  };
  const focused = () => app.page.evaluate(() => document.activeElement?.ariaLabel);
  const place = 'Function 2, S1';
  await app.field(place).focus();
  await devTools.send('Input.imeSetComposition', { text: '12', selectionStart: 2, selectionEnd: 2 });
  for (const key of ['ArrowDown', 'Enter']) {
    await press(key, 229);
    expect([key, await focused(), await app.valueOf(place)]).toEqual([key, place, '12']);
  }
  await devTools.send('Input.insertText', { text: '127' });
  expect([await focused(), await app.valueOf(place)]).toEqual([place, '127']);
  await press('Enter', 13);
  expect(await focused()).toBe('Function 3, S1');
});

test('where the storage was full, all is kept once there is room and the pilot comes back to the page', async () => {
  const app = await AppPage.connected({
    before: () => {
      const { put } = IDBObjectStore.prototype;
      IDBObjectStore.prototype.put = () => {
        throw new DOMException('The storage is full.', 'QuotaExceededError');
      };
      addEventListener('room', () => {
        IDBObjectStore.prototype.put = put;
      });
    },
  });
  await app.type('Function 2, S1', '7');
  await app.says(en.keeping.notKept);
  await app.page.evaluate(() => dispatchEvent(new Event('room')) && dispatchEvent(new Event('focus')));
  await app.text(en.keeping.notKept).waitFor({ state: 'detached' });
});
