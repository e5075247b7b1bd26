import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { Trail } from './sheet.js';

/** Several kinds of steps, each noted. */
async function work(app: AppPage): Promise<Trail> {
  const trail = new Trail(app);
  const step = async (act: () => Promise<void>): Promise<void> => {
    await trail.note();
    await act();
  };
  await step(() => app.type('DT time', '4:00'));
  await step(() => app.type('Function 2, S1', 'abc'));
  await step(() => app.type('Function 2, S1', '7'));
  await step(() => app.type('Function 3 interval', '1.25'));
  await step(async () => {
    await app.button('Tools for Function 4').click();
    await app.page.getByRole('textbox', { name: en.edits.shift.by }).fill('1');
    await app.button(en.edits.shift.later).click();
  });
  await trail.note();
  return trail;
}

const steps = async (app: AppPage): Promise<(string | null)[]> => [
  await app.undo.getAttribute('aria-label'),
  await app.redo.getAttribute('aria-label'),
];

/** The tab crashes: the page gets no event before it ends. */
async function crash({ page }: AppPage): Promise<void> {
  const crashed = page.waitForEvent('crash');
  const devTools = await page.context().newCDPSession(page);
  // The crashed page cannot answer.
  void devTools.send('Page.crash').catch(() => {});
  await crashed;
}

for (const end of ['is loaded again', 'crashes']) {
  test(`what was done can be undone to the start, and redone, when the page ${end}`, async () => {
    // A crash can reach the worker of the page, too. No other test gets this profile.
    const app = await AppPage.connected({ isFirstVisit: end === 'crashes' });
    const trail = await work(app);
    await app.undo.click();
    const [entries, names] = [await app.entries(), await steps(app)];
    await app.kept();

    if (end === 'crashes') await crash(app);
    else await app.reload();
    const next = end === 'crashes' ? await app.sibling() : app;
    await next.says(en.notes.back.title);
    await expect.poll(() => next.entries()).toEqual(entries);
    await expect.poll(() => steps(next)).toEqual(names);
    await next.connect();
    await expect.poll(() => next.entries(), { message: 'the edits stay after the timer was read' }).toEqual(entries);
    await expect.poll(() => steps(next)).toEqual(names);

    await next.redo.click();
    await trail.continuedBy(next).goBack(() => next.undo.click());
    await next.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
    await trail.continuedBy(next).goForward(() => next.redo.click());
    await next.write();
    await next.result('Verified.');
  });
}

test('a key that is pressed just before the page is left is kept', async () => {
  const app = await AppPage.connected();
  await app.field('Function 2, S1').focus();
  for (const keys of ['7', '89', '456']) {
    // The old page may still be shown for a while, with the same text.
    const loaded = app.page.waitForEvent('load');
    await app.field('Function 2, S1').evaluate(async (field, typed) => {
      const input = field as HTMLInputElement;
      for (const key of typed) {
        input.value = key;
        input.dispatchEvent(new InputEvent('input', { bubbles: true }));
        // The effect of a key begins before the next key comes.
        for (let i = 0; i < 20; i++) await Promise.resolve();
      }
      location.reload();
    }, keys);
    await loaded;
    await app.says(en.notes.back.title);
    await expect.poll(() => app.valueOf('Function 2, S1')).toBe(keys.at(-1));
  }
});
