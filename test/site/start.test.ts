import { expect, inject, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { AppPage } from './app-page.js';
import { newPage } from './page.js';

test('a storage of a newer version has its own sentence', async () => {
  const page = await newPage();
  // It names its icon: else the browser looks for one, at a time that nobody knows.
  const body = '<!doctype html><link rel="icon" href="data:,">';
  await page.route('**/*', (route) => route.fulfill({ body, contentType: 'text/html' }));
  await page.goto(inject('site'));
  await page.evaluate(
    () =>
      new Promise((resolve) => {
        const opening = indexedDB.open('sidus-timer', 1000);
        opening.onsuccess = () => resolve(opening.result.close());
      }),
  );
  await page.unroute('**/*');
  await page.goto(inject('site'));
  await page.getByText(en.keeping.title).waitFor();
});

test('inside a frame the page does not work, and says where it does', async () => {
  const page = await newPage({}, []);
  await page.route('**/outer', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<iframe src="${inject('site')}" width="600" height="400"></iframe>`,
    }),
  );
  // As from a host that cannot send the header against frames.
  await page.route(inject('site'), async (route) => {
    const response = await route.fetch();
    const { 'content-security-policy': _, ...headers } = response.headers();
    await route.fulfill({ response, headers });
  });
  await page.goto(`${new URL(inject('site')).origin}/outer`);
  const frame = page.frameLocator('iframe');
  await frame.getByRole('heading', { name: en.framed.title }).waitFor();
  await expect.poll(() => frame.getByRole('button').count()).toBe(0);
  await expect.poll(() => frame.getByRole('link').getAttribute('href')).toBe(inject('site'));
  // Nothing was started or stored that the other page could reach.
  const inside = page.frames().find((each) => each.url() === inject('site'));
  const left = await inside?.evaluate(async () => [
    (await indexedDB.databases()).length,
    (await navigator.serviceWorker.getRegistrations()).length,
    (await navigator.locks.query()).held?.length,
    (await caches.keys()).length,
    localStorage.length + sessionStorage.length,
    // It can be read in dark and light: the theme is set.
    document.documentElement.getAttribute('data-theme'),
  ]);
  expect(left).toEqual([0, 0, 0, 0, 0, 'light']);
});

/** Makes a program with the defaults of the dialog. */
async function make(app: AppPage): Promise<void> {
  await app.button(en.newProgram.title).click();
  await app.button(en.newProgram.make).click();
  await app.table.waitFor();
}

test('a program is made without a timer, survives a reload, and is written after Connect', async () => {
  const app = await AppPage.open({ bench: { granted: true } });
  await make(app);
  await app.text(en.knowledge.made).waitFor();
  await app.type('Function 4, S2', '70');
  await app.kept();
  await app.reload();
  await expect.poll(() => app.valueOf('Function 4, S2')).toBe('70');
  expect(await app.bench(({ sets, rates }) => [sets, rates]), 'nothing was sent and no port was opened').toEqual([
    [],
    [],
  ]);
  await app.button(en.program.connectAndWrite).click();
  await app.dialog.getByRole('checkbox', { name: /^The propeller is off/ }).check();
  await app.dialog.getByRole('button', { name: /^Write \d+ changes$/ }).click();
  await app.result('Verified.');
  const { times, positions } = await app.bench(({ content }) => content);
  expect([times[10], positions[1]?.[4], positions[1]?.[5]]).toEqual([18000, 70, 65]);
});

test('a kept program is deleted after one question', async () => {
  const app = await AppPage.open({ bench: {} });
  await app.button(en.newProgram.title).click();
  await app.button(en.newProgram.make).click();
  await app.table.waitFor();
  await app.button(en.header.closeProgram).click();
  await app.button(/^Open F1Q, new/).waitFor();
  await app.button(/^Delete: F1Q/).click();
  await app.page.getByRole('listitem').getByRole('button', { name: 'Delete', exact: true }).click();
  await app.button(/^Open F1Q, new/).waitFor({ state: 'detached' });
});

test('the advice during the search for a timer fills the page, and another port is one click away', async () => {
  const app = await AppPage.open({ bench: {} });
  await app.bench((bench) => bench.sleep());
  await app.button('Connect').click();
  await app.page.getByRole('heading', { name: en.link.stages.steps.switch }).waitFor();
  expect(await app.page.evaluate(() => document.activeElement?.tagName)).toBe('H1');
  await expect.poll(() => app.page.getByRole('button').allInnerTexts()).toEqual([en.header.choosePort, 'Stop']);
  await app.button('Stop').click();
  await app.button('Connect').waitFor();
});
