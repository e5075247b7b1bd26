import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { PHONE } from './page.js';

const VIEWS = ['Program', 'Memories', 'Bench', 'Library', 'Line', 'Settings'] as const;

const heading = (app: AppPage): Promise<string> =>
  app.page.getByRole('main').getByRole('heading', { level: 1 }).innerText();

test('each view has an address: Back leads through them, and a reload shows the same', async () => {
  const app = await AppPage.connected();
  for (const view of VIEWS) {
    await app.goTo(view);
    await expect.poll(() => heading(app)).toContain(view);
    const named = view === 'Program' ? 'Sidus Timer' : `${view} · Sidus Timer`;
    await expect
      .poll(async () => [new URL(app.page.url()).hash, await app.page.title()])
      .toEqual([`#${view.toLowerCase()}`, named]);
  }
  for (const view of [...VIEWS].reverse().slice(1)) {
    await app.page.goBack();
    await expect.poll(() => heading(app)).toContain(view);
  }
  await app.goTo('Memories');
  await app.reload();
  await expect.poll(() => heading(app)).toBe('Memories');
});

test('the heading stands at the same place in every view', async () => {
  for (const size of [{}, { viewport: { width: 820, height: 1180 }, hasTouch: true }]) {
    const app = await AppPage.connected(size);
    /** The middle of its letters. */
    const place = (name: string): Promise<number> =>
      app.page.getByRole('heading', { level: 1, name, exact: true }).evaluate((heading) => {
        const letters = document.createRange();
        letters.selectNodeContents(heading);
        const { top, bottom } = letters.getBoundingClientRect();
        return Math.round((top + bottom) / 2);
      });
    await app.goTo('Memories');
    const first = await place('Memories');
    for (const name of ['Bench', 'Library', 'Line', 'Settings', 'Help', 'Print']) {
      await app.page.evaluate((view) => location.assign(`#${view}`), name.toLowerCase());
      await expect.poll(() => place(name), { message: name }).toBe(first);
    }
    await app.page.evaluate(() => location.assign('#library/flights'));
    await expect.poll(() => place('Flights'), { message: 'Flights' }).toBe(first);
  }
});

test('a view is as it was left: the focus, the scroll position, and what was typed', async () => {
  const app = await AppPage.connected({ viewport: { width: 900, height: 560 } });
  await app.field('Function 9, S2').fill('7');
  const scrolled = await app.page.evaluate(() => scrollY);
  expect(scrolled).toBeGreaterThan(0);
  await app.goTo('Memories');
  await expect.poll(() => app.page.evaluate(() => scrollY)).toBe(0);
  await app.page.goBack();
  const inHand = app.field('Function 9, S2');
  await expect.poll(() => inHand.evaluate((input) => input === document.activeElement)).toBe(true);
  await expect
    .poll(async () => [await app.page.evaluate(() => scrollY), await inHand.inputValue()])
    .toEqual([scrolled, '7']);
  await app.changes(1).waitFor();
});

test('a table with many servos is as far to the side as it was left', async () => {
  const app = await AppPage.connected({ ...PHONE, bench: { identity: { servos: 6 } } });
  const scroller = app.page.locator('.table-scroller');
  await scroller.evaluate((table) => table.scrollTo(90, 0));
  await app.goTo('Memories');
  await app.page.goBack();
  await expect.poll(() => scroller.evaluate((table) => table.scrollLeft)).toBe(90);
});

test('a command that is possible can be found by its name and done with Enter', async () => {
  const app = await AppPage.open({ bench: { granted: true } });
  await app.hasParts();
  const palette = app.page.getByRole('dialog', { name: en.palette.title });
  const command = async (words: string): Promise<void> => {
    await app.page.keyboard.press('Control+k');
    await palette.waitFor();
    await app.page.keyboard.type(words);
    await app.page.keyboard.press('Enter');
    await palette.waitFor({ state: 'hidden' });
  };
  await command('connect');
  await app.hasRead();
  await app.type('DT time', '4:00');
  await command('undo');
  await expect.poll(() => app.valueOf('DT time')).toBe('3:00');
  await command('memo');
  await expect.poll(() => heading(app)).toBe('Memories');

  await app.page.keyboard.press('Control+k');
  await app.page.keyboard.type('write');
  await palette.getByRole('option', { name: 'Write…' }).waitFor();
  await app.page.keyboard.type(' nothing like this');
  await palette.getByRole('status').getByText(en.palette.nothing).waitFor();
  await app.page.keyboard.press('Escape');
  await palette.waitFor({ state: 'hidden' });
  // It is closed over no question: nothing may hide what is asked.
  await app.goTo('Program');
  await app.type('DT time', '5:00');
  await app.page.keyboard.press('Control+k');
  await palette.getByRole('option', { name: 'Write 1 change…' }).waitFor();
  await app.page.keyboard.press('Escape');
  await palette.waitFor({ state: 'hidden' });
  await app.review();
  await app.page.keyboard.press('Control+k');
  await expect.poll(() => palette.count()).toBe(0);
});

test('the strip shows in every view what flies next, DT, motor stop and what is known', async () => {
  for (const size of [PHONE, {}]) {
    const app = await AppPage.connected(size);
    const strip = app.page.locator('.strip-line');
    for (const view of VIEWS) {
      await app.goTo(view);
      const said = (await strip.innerText()).replace(/\s+/g, ' ');
      for (const what of ['F1Q', 'M1', 'DT 3:00', '10.0']) expect(said).toContain(what);
      await strip.getByText(/As in the timer, read \d\d:\d\d/).waitFor({ state: 'attached' });
    }
    await app.goTo('Program');
    await app.type('DT time', '0:20');
    await expect.poll(() => strip.innerText()).toMatch(/Short DT/i);
  }
});
