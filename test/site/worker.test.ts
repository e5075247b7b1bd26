import type { Page } from 'playwright';
import { describe, expect, test } from 'vitest';
import { LANGUAGES } from '../../src/app/messages/first.js';
import { type Answer, publish, update, visited } from './host.js';

async function isDrawn(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Try a simulated F1Q timer' }).waitFor();
  // Not the picture of it alone, which is there before any script: the page has said which view it shows.
  await page.locator('html[data-view]').waitFor();
}

const lies: [string, (body: Uint8Array) => Answer][] = [
  ['its own page for a script', () => ({ type: 'text/html', body: '<!doctype html><title>Welcome</title>' })],
  ['its own page as a script', () => ({ body: '<!doctype html><title>Welcome</title>' })],
  ['half of a script', (body) => ({ body: body.subarray(0, body.length / 2) })],
  ['a 404', () => ({ status: 404, body: 'gone' })],
  ['a 503', () => ({ status: 503, type: 'text/html', body: 'later' })],
];
test('a host that sends wrong files for a new version changes nothing, and right files are used', async () => {
  const { host, page, script } = await visited();
  publish(host, 'A new version');
  for (const [what, lie] of lies) {
    host.lie = (address) => (address === script ? lie(host.files.get(script) as Uint8Array) : undefined);
    expect(await update(page), `the host sends ${what}`).toBe('redundant');
    for (const offline of [false, true]) {
      await page.context().setOffline(offline);
      await page.reload();
      await isDrawn(page);
      expect(await page.title(), `the host sends ${what}`).toBe('Sidus Timer');
    }
    await page.context().setOffline(false);
  }
  host.lie = () => undefined;
  expect(await update(page)).toBe('installed');
  await page.getByRole('button', { name: 'Use it now' }).click();
  await expect.poll(() => page.title()).toBe('A new version');
  await isDrawn(page);
});

/** Takes some of what is kept away, as a browser may that has no room. */
function lose(page: Page, ending: string): Promise<number> {
  return page.evaluate(async (end) => {
    let lost = 0;
    for (const name of await caches.keys()) {
      const cache = await caches.open(name);
      for (const request of await cache.keys())
        if (request.url.endsWith(end)) lost += Number(await cache.delete(request));
    }
    return lost;
  }, ending);
}

/** The names of what the page has kept, without what the build adds to them. */
function keptNames(page: Page): Promise<string[]> {
  return page.evaluate(async () => {
    const found = await Promise.all((await caches.keys()).map(async (name) => (await caches.open(name)).keys()));
    return found
      .flat()
      .map(({ url }) => url.replace(/.*\//, '').replace(/-[\w-]{8}\./, '.'))
      .sort();
  });
}

test('the worker keeps what the page needs, and letters of another language once they were used', async () => {
  const { host, page } = await visited();
  const readCzech = (): Promise<number> =>
    page.evaluate(async () => (await document.fonts.load('16px "Inter Variable"', 'ř')).length);
  const isNeeded = (name: string): boolean => !/\.(?:js|css)$/.test(name);
  const needed = [
    'LICENSES.txt',
    'connection.html',
    'favicon.svg',
    'index.html',
    'inter-latin-wght-normal.woff2',
    ...LANGUAGES.map((code) => (code === 'en' ? 'manifest.webmanifest' : `manifest.${code}.webmanifest`)),
  ].sort();
  expect((await keptNames(page)).filter(isNeeded)).toEqual(needed);

  expect(await readCzech()).toBe(1);
  const withCzech = [...needed, 'inter-latin-ext-wght-normal.woff2'].sort();
  await expect.poll(async () => (await keptNames(page)).filter(isNeeded)).toEqual(withCzech);
  publish(host, 'A new version');
  expect(await update(page)).toBe('installed');
  await page.getByRole('button', { name: 'Use it now' }).click();
  await expect.poll(() => page.title()).toBe('A new version');
  await expect.poll(async () => (await keptNames(page)).filter(isNeeded)).toEqual(withCzech);
  await page.context().setOffline(true);
  await page.reload();
  await isDrawn(page);
  expect(await readCzech()).toBe(1);
});

describe('a kept file that is gone', () => {
  test('is fetched again', async () => {
    const { page } = await visited();
    for (const ending of ['.js', '.css', 'index.html']) {
      expect(await lose(page, ending), `kept files that end in ${ending}`).toBeGreaterThan(0);
      for (const offline of [false, true]) {
        await page.context().setOffline(offline);
        await page.reload();
        await isDrawn(page);
      }
      await page.context().setOffline(false);
    }
  });

  test('is replaced by the present version when the host does not have it either', async () => {
    const { host, page } = await visited();
    // A version all of whose files have other names.
    for (const [name, body] of [...host.files]) {
      const isText = /\.(?:js|css|html)$/.test(name) && name !== 'sw.js';
      host.files.delete(name);
      host.files.set(
        name.replace('assets/', 'next/'),
        isText ? Buffer.from(body).toString().replaceAll('assets/', 'next/') : body,
      );
    }
    expect(await lose(page, '.js')).toBeGreaterThan(0);
    await page.reload();
    await isDrawn(page);
  });

  test('comes from the host with the whole page when everything is gone', async () => {
    const { page } = await visited();
    await page.evaluate(async () => {
      for (const name of await caches.keys()) await caches.delete(name);
    });
    await page.reload();
    await isDrawn(page);
  });
});

test('the way out deletes the kept page and its worker, and the page comes from the host', async () => {
  const { host, page } = await visited();
  host.files.set('sw.js', host.files.get('kill-sw.js') as Uint8Array);
  host.files.set(
    'index.html',
    String(host.files.get('index.html')).replace('<title>Sidus Timer', '<title>From the host'),
  );
  /** Not waited for: the page may be loaded again before the answer is here. */
  const look = (): Promise<void> =>
    page.evaluate(() => void navigator.serviceWorker.getRegistration().then((found) => found?.update()));
  await expect
    .poll(async () => {
      await look();
      return page.title();
    })
    .toBe('From the host');
  await isDrawn(page);
  await expect.poll(() => page.evaluate(() => caches.keys())).toEqual([]);
  // Also while the host goes on serving it: what is shown is what the host has now.
  host.files.set('index.html', String(host.files.get('index.html')).replace('From the host', 'From the host again'));
  await page.reload();
  await isDrawn(page);
  expect(await page.title()).toBe('From the host again');
  await expect.poll(() => page.evaluate(() => caches.keys())).toEqual([]);
});
