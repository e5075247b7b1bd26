import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Page, Route } from 'playwright';
import { describe, expect, inject, test } from 'vitest';
import { en } from '../tools/en.js';
import { sentencesIn } from '../tools/spoken.js';
import { AppPage } from './app-page.js';
import { SITE } from './host.js';
import { newPage, PHONE } from './page.js';

/** The scripts of the page, which are loaded after the first picture is drawn. */
const PAGE_SCRIPT = /assets\/open-page-[\w-]+\.js$/;

/** The browser requests the script of the page, and gets it only when the test lets it through. */
async function heldBack(page: Page): Promise<{ asked: Promise<void>; release: () => Promise<void> }> {
  let note = (_: Route): void => {};
  const asked = new Promise<Route>((resolve) => {
    note = resolve;
  });
  await page.route(PAGE_SCRIPT, (route) => note(route));
  return { asked: asked.then(() => {}), release: async () => (await asked).continue() };
}

/** Waits for the page itself: it then has said which view it shows. */
async function works(page: Page): Promise<void> {
  await page.locator('html[data-view]').waitFor();
  await page.evaluate(() => document.fonts.ready);
}

/** The place and the look of everything. */
function picture(page: Page): Promise<string[]> {
  return page.locator('#app *').evaluateAll((all) =>
    all
      .filter((element) => element.checkVisibility())
      .map((element) => {
        const { x, y, width, height } = element.getBoundingClientRect();
        const { color, backgroundColor, fontSize } = getComputedStyle(element);
        return [element.tagName, ...[x, y, width, height].map(Math.round), color, backgroundColor, fontSize].join(' ');
      }),
  );
}

describe('the start is part of the page as it is sent:', () => {
  const LARGE = { viewport: { width: 1280, height: 800 } };
  test.for([
    ['a desktop', LARGE, 'en'],
    ['a desktop in German', { ...LARGE, locale: 'de-AT' }, 'de'],
    ['a phone', PHONE, 'en'],
    ['a phone in Ukrainian', { ...PHONE, locale: 'uk' }, 'uk'],
    ['a phone at night', { ...PHONE, colorScheme: 'dark' as const }, 'en'],
  ] as const)('on %s nothing moves when the page takes its place', async ([, options, language]) => {
    const { header, start } = await sentencesIn(language);
    const page = await newPage({ ...options, reducedMotion: 'reduce' });
    // Without what depends on the browser: that it is ready offline, that it has no serial ports.
    await page.addInitScript(() => Object.defineProperty(navigator, 'serviceWorker', { value: undefined }));
    await page.addInitScript(inject('workbench'));
    const { asked, release } = await heldBack(page);
    await page.goto(inject('site'));
    await asked;
    await page.evaluate(() => document.fonts.ready);
    await page.getByRole('heading', { name: start.title }).waitFor();
    const before = await picture(page);
    const connect = await page.getByRole('button', { name: header.connect, exact: true }).elementHandle();
    await release();
    await works(page);
    expect(await connect?.evaluate((button) => button.isConnected)).toBe(true);
    // Without a worker the page says that it is not kept.
    await page.locator('.notices').evaluate((notices) => notices.replaceChildren());
    expect(await picture(page)).toEqual(before);
    expect(before.length).toBeGreaterThan(40);
  });

  test('a click on Connect before the page has loaded opens the choice of a port', async () => {
    const app = await AppPage.open({ bench: {}, isFirstVisit: true });
    const { asked, release } = await heldBack(app.page);
    // Not the worker of the first visit: it would answer in place of the test.
    await app.page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.unregister());
    await app.page.reload();
    await asked;
    await app.button(en.newProgram.title).click();
    await app.button('Connect').click();
    await expect.poll(() => app.button('Connect').getAttribute('aria-disabled')).toBe('true');
    await expect.poll(() => app.button(en.newProgram.title).getAttribute('aria-disabled')).toBeNull();
    await release();
    await app.hasRead();
    await expect
      .poll(() => app.page.getByRole('dialog').count(), { message: 'of two clicks only the last counts' })
      .toBe(0);
  });

  test('a language that is chosen before the page has loaded is spoken, and kept', async () => {
    const page = await newPage({ locale: 'de-DE' }, []);
    const { asked, release } = await heldBack(page);
    await page.goto(inject('site'));
    await asked;
    await page.getByRole('combobox').selectOption('uk');
    await release();
    await works(page);
    await page.unroute(PAGE_SCRIPT);
    for (const again of [false, true]) {
      if (again) await page.reload();
      await page.locator('html[data-view][lang=uk]').waitFor();
      await expect.poll(() => page.getByRole('combobox').inputValue()).toBe('uk');
    }
  });

  test('when the page cannot be loaded it says so, and a click loads it again', async () => {
    const page = await newPage({}, []);
    await page.route(PAGE_SCRIPT, (route) => route.abort());
    await page.goto(inject('site'));
    await page.getByRole('alert').getByText(en.first.failed).waitFor();
    await page.unroute(PAGE_SCRIPT);
    await page.getByRole('button', { name: en.first.again }).click();
    await works(page);
    await expect.poll(() => page.getByRole('alert').count()).toBe(0);
  });

  test('when loading takes long the page says so, until it has loaded', async () => {
    const page = await newPage();
    await page.clock.install();
    const { asked, release } = await heldBack(page);
    await page.goto(inject('site'));
    await asked;
    await page.clock.fastForward(14_000);
    expect(await page.getByRole('alert').count()).toBe(0);
    await page.clock.fastForward(2000);
    await page.getByRole('alert').getByText(en.first.failed).waitFor();
    await page.getByRole('button', { name: en.first.again }).waitFor();
    await release();
    await works(page);
    await expect.poll(() => page.getByRole('alert').count()).toBe(0);
  });

  test('the start is not shown at the address of another view', async () => {
    const page = await newPage();
    const { asked, release } = await heldBack(page);
    await page.goto(`${inject('site')}#settings`);
    await asked;
    expect(await page.getByRole('heading').count()).toBe(0);
    await release();
    await page.getByRole('heading', { name: 'Settings' }).waitFor();
  });

  test.for([
    ['opened as a file', 'file'],
    ['without its first script', 'script'],
    ['where scripts are forbidden', 'none'],
  ] as const)('%s one sentence stands there instead', async ([, lack]) => {
    const page = await newPage({ javaScriptEnabled: lack !== 'none', colorScheme: 'dark' }, []);
    if (lack === 'script') await page.route(/assets\/index-[\w-]+\.js$/, (route) => route.abort());
    await page.goto(lack === 'file' ? pathToFileURL(join(SITE, 'index.html')).href : inject('site'));
    await page.locator('.not-started').waitFor();
    expect(await page.locator('body').innerText()).toMatch(/^Sidus Timer has not started\./);
    // As a file it has no styles, either.
    if (lack === 'file') return;
    const colours = await page.locator('body').evaluate((body) => {
      const { color, backgroundColor } = getComputedStyle(body);
      return [color, backgroundColor];
    });
    expect(colours, 'light on dark').toEqual(['rgb(238, 242, 246)', 'rgb(13, 17, 21)']);
    await expect.poll(() => page.getByRole('button').count()).toBe(0);
  });
});

test('the table of a timer is seen before its picture, and stays where it is when that comes', async () => {
  const app = await AppPage.open();
  await app.page.evaluate(() => {
    const seen = { first: '', places: [] as string[], whole: false };
    const table = () => document.querySelector('.program-table');
    const picture = () => document.querySelector('.timeline');
    new MutationObserver((_, observer) => {
      if (!table()) return;
      seen.first = picture() ? 'both' : 'the table';
      observer.disconnect();
    }).observe(document.body, { subtree: true, childList: true });
    const look = (drawn: Element | null): void => {
      if (drawn) seen.places.push(JSON.stringify(drawn.getBoundingClientRect()));
      seen.whole = drawn !== null && picture() !== null;
      if (seen.whole) return;
      requestAnimationFrame(() => {
        const drawn = table();
        // Measured after it was painted, because it can change before that.
        setTimeout(() => look(drawn));
      });
    };
    look(null);
    Object.assign(window, { seen });
  });
  const seen = () =>
    app.page.evaluate(() => (window as unknown as { seen: { first: string; places: string[]; whole: boolean } }).seen);
  await app.trySimulated('F1Q');
  await expect.poll(async () => (await seen()).whole).toBe(true);
  const { first: start, places } = await seen();
  expect(start).toBe('the table');
  expect(new Set(places).size, 'the table stays in one place').toBe(1);
});
