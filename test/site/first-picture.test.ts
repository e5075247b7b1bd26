import type { Page, Route } from 'playwright';
import { describe, expect, inject, test } from 'vitest';
import { AppPage } from './app-page.js';
import { newPage, PHONE } from './page.js';

/** What the page is made of, which is fetched when the first picture was drawn. */
const PAGE_SCRIPT = /assets\/open-page-[\w-]+\.js$/;

/** The script of the page is asked for, and does not come before it is let through. */
async function heldBack(page: Page): Promise<{ asked: Promise<void>; release: () => Promise<void> }> {
  let note = (_: Route): void => {};
  const asked = new Promise<Route>((resolve) => {
    note = resolve;
  });
  await page.route(PAGE_SCRIPT, (route) => note(route));
  return { asked: asked.then(() => {}), release: async () => (await asked).continue() };
}

/** The page itself is there: it has said how high rows are. */
async function works(page: Page): Promise<void> {
  await page.locator('html[data-density]').waitFor();
  await page.evaluate(() => document.fonts.ready);
}

/** Where everything stands, and what it looks like. */
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

describe('the start stands in the page as it comes:', () => {
  const LARGE = { viewport: { width: 1280, height: 800 } };
  test.for([
    ['a desktop', LARGE],
    ['a phone', PHONE],
    ['a phone at night', { ...PHONE, colorScheme: 'dark' as const }],
  ] as const)('on %s nothing moves when the page takes its place', async ([, options]) => {
    const page = await newPage({ ...options, reducedMotion: 'reduce' });
    // What this browser adds of its own is not meant: that it is ready offline, that it has no serial ports.
    // Nor is what is told to who comes for the first time.
    await page.addInitScript(() => localStorage.setItem('sidus-timer/first-steps', 'true'));
    await page.addInitScript(() => Object.defineProperty(navigator, 'serviceWorker', { value: undefined }));
    await page.addInitScript(inject('workbench'));
    const { asked, release } = await heldBack(page);
    await page.goto(inject('site'));
    await asked;
    await page.evaluate(() => document.fonts.ready);
    const before = await picture(page);
    const connect = await page.getByRole('button', { name: 'Connect', exact: true }).elementHandle();
    await release();
    await works(page);
    expect(await connect?.evaluate((button) => button.isConnected)).toBe(true);
    // Without a worker the page says that it is not kept.
    await page.locator('.notices').evaluate((notices) => notices.replaceChildren());
    expect(await picture(page)).toEqual(before);
    expect(before.length).toBeGreaterThan(40);
  });

  test.for([
    ['a desktop', LARGE],
    ['a phone', PHONE],
  ] as const)('on %s the first steps come where room was kept for them', async ([, options]) => {
    const page = await newPage({ ...options, reducedMotion: 'reduce' });
    const { asked, release } = await heldBack(page);
    await page.goto(inject('site'));
    await asked;
    await page.evaluate(() => document.fonts.ready);
    const cards = page.locator('.start-cards');
    const before = await cards.boundingBox();
    await release();
    await page.locator('.first-steps').waitFor();
    expect(await cards.boundingBox()).toEqual(before);
    await page.getByRole('button', { name: 'Skip', exact: true }).click();
    await page.unroute(PAGE_SCRIPT);
    await page.reload();
    await works(page);
    expect(await page.locator('.first-steps-room').count(), 'they are not told again').toBe(0);
  });

  test('Connect is done when the page is there, with the right of the click that came before', async () => {
    const app = await AppPage.open({ bench: {}, isFirstVisit: true });
    const { asked, release } = await heldBack(app.page);
    // Not the worker of the first visit: it would answer by itself.
    await app.page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.unregister());
    await app.page.reload();
    await asked;
    await app.button('New program…').click();
    await app.button('Connect').click();
    await expect.poll(() => app.button('Connect').getAttribute('aria-disabled')).toBe('true');
    await expect.poll(() => app.button('New program…').getAttribute('aria-disabled')).toBeNull();
    await release();
    await app.hasRead();
    await expect.poll(() => app.page.getByRole('dialog').count(), { message: 'of two clicks the last counts' }).toBe(0);
  });

  test('when the page cannot be loaded it says so, and is loaded again by a click', async () => {
    const page = await newPage({}, []);
    await page.route(PAGE_SCRIPT, (route) => route.abort());
    await page.goto(inject('site'));
    await page.getByRole('alert').getByText('The page could not be loaded whole.').waitFor();
    await page.unroute(PAGE_SCRIPT);
    await page.getByRole('button', { name: 'Load it again' }).click();
    await works(page);
    await expect.poll(() => page.getByRole('alert').count()).toBe(0);
  });

  test('at the address of another view it is not shown', async () => {
    const page = await newPage();
    const { asked, release } = await heldBack(page);
    await page.goto(`${inject('site')}#settings`);
    await asked;
    expect(await page.getByRole('heading').count()).toBe(0);
    await release();
    await page.getByRole('heading', { name: 'Settings' }).waitFor();
  });

  test('without scripts one sentence stands there instead', async () => {
    const page = await newPage({ javaScriptEnabled: false });
    await page.goto(inject('site'));
    expect(await page.locator('noscript').isVisible()).toBe(true);
    await expect.poll(() => page.getByRole('button').count()).toBe(0);
  });
});
