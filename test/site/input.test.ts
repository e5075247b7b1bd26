import { describe, expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage, isInSight } from './app-page.js';

/** How many requests the timer got since the page was loaded. */
const answered = (app: AppPage): Promise<number> => app.bench(({ adapter }) => adapter.timer.core.answered.length);

describe('what no timer can hold is refused at the field', () => {
  const cases: [field: string, text: string, shown: string, reason: string][] = [
    ['Function 2, S1', '131', '131', en.findings['position-out-of-range']({ min: '0', max: '130' })],
    ['DT time', 'soon', 'soon', en.unreadable['not-a-time']],
  ];

  test('with its reason, also through a reload, and Write leads there', async () => {
    const app = await AppPage.open({ bench: {} });
    await app.connect();
    for (const [field, text, shown, reason] of cases) {
      const what = `${field} = ${JSON.stringify(text)}`;
      const name = field === 'DT time' ? 'DT' : field;
      const asked = await answered(app);
      await app.type(field, text);
      await expect.poll(() => app.valueOf(field), { message: what }).toBe(shown);
      await expect.poll(() => app.field(field).getAttribute('aria-invalid'), { message: what }).toBe('true');
      await expect.poll(() => app.reasons(), { message: what }).toContain(`${name}: ${reason}`);
      await app.button(/^Write( \d+ changes?)?…$/).click();
      const cause = app.field(field);
      await expect
        .poll(() => cause.evaluate((input) => input === document.activeElement), { message: `Write leads to ${what}` })
        .toBe(true);
      await expect.poll(() => isInSight(cause), { message: `Write brings ${what} into sight` }).toBe(true);

      await app.kept();
      expect(await answered(app), 'nothing was sent to the timer').toBe(asked);
      await app.reload();
      await expect.poll(() => app.valueOf(field), { message: what }).toBe(shown);
      await app.button('Connect').click();
      await app.isReady();
      await expect.poll(() => app.valueOf(field), { message: what }).toBe(shown);
      await app.text(`Nothing can be written yet. ${name}: ${reason}`).waitFor();
      await app.button('Undo all').click();
      await app.text('Nothing can be written yet.').waitFor({ state: 'hidden' });
    }
  });

  test('a text without an end: the page stays whole', async () => {
    const app = await AppPage.open({ bench: {} });
    await app.connect();
    await app.type('Function 2, S1', '9'.repeat(100_000));
    await app.type('DT time', '<img src=x onerror=alert(1)>'.repeat(100));
    await expect.poll(() => app.reasons()).toHaveLength(2);
    await app.expectNoSidewaysScrolling();
  });
});

test('Enter and the arrows first end the composing of a text, and go to another cell only then', async () => {
  const app = await AppPage.open({ bench: {} });
  await app.connect();
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
  const app = await AppPage.open({
    bench: {},
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
  await app.connect();
  await app.type('Function 2, S1', '7');
  await app.says(en.keeping.notKept);
  await app.page.evaluate(() => dispatchEvent(new Event('room')) && dispatchEvent(new Event('focus')));
  await app.text(en.keeping.notKept).waitFor({ state: 'detached' });
});
