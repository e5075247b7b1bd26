import { expect, inject, test } from 'vitest';
import { en } from '../tools/en.js';
import { newKeptPage, newPage } from './page.js';

/** The part of the manifest that these tests use. */
interface Manifest {
  readonly id: string;
  readonly screenshots: readonly { readonly src: string; readonly sizes: string; readonly form_factor: string }[];
  readonly shortcuts: readonly { readonly name: string; readonly url: string }[];
}

for (const site of ['site', 'siteUnderPath'] as const) {
  test(`a browser can install the page at ${new URL(inject(site)).pathname}, and finds nothing wrong with it`, async () => {
    const page = await newKeptPage();
    await page.goto(inject(site));
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    const devtools = await page.context().newCDPSession(page);
    expect(await devtools.send('Page.getInstallabilityErrors')).toEqual({ installabilityErrors: [] });
    const { errors, data } = await devtools.send('Page.getAppManifest');
    expect(errors).toEqual([]);
    const { id } = JSON.parse(data ?? '{}') as Manifest;
    // The id stays the same even if the start address changes: no page is installed twice.
    expect(await devtools.send('Page.getAppId')).toMatchObject({
      appId: new URL(id, new URL(inject(site)).origin).href,
    });
  });
}

test('the screenshots of the manifest have their stated size, are quick to load, and are there in both forms', async () => {
  const page = await newPage();
  await page.goto(inject('site'));
  const { screenshots } = (await (await fetch(new URL('manifest.webmanifest', inject('site')))).json()) as Manifest;
  expect(new Set(screenshots.map((each) => each.form_factor))).toEqual(new Set(['wide', 'narrow']));
  for (const { src, sizes } of screenshots) {
    const address = new URL(src, inject('site')).href;
    const size = await page.evaluate(async (picture) => {
      const image = Object.assign(new Image(), { src: picture });
      await image.decode();
      return `${image.naturalWidth}x${image.naturalHeight}`;
    }, address);
    expect([src, size]).toEqual([src, sizes]);
    expect((await (await fetch(address)).arrayBuffer()).byteLength, `the bytes of ${src}`).toBeLessThan(80_000);
  }
});

test('a shortcut leads to what it names, opens no port, and a reload does not lead there again', async () => {
  const { shortcuts } = (await (await fetch(new URL('manifest.webmanifest', inject('site')))).json()) as Manifest;
  const found: [string, string | undefined, string][] = [];
  for (const { name, url } of shortcuts) {
    const page = await newPage();
    await page.goto(new URL(url, inject('site')).href);
    await page.getByRole('banner').waitFor();
    if (url.includes('?')) await page.waitForFunction(() => document.activeElement?.tagName === 'BUTTON');
    else await page.getByRole('heading', { level: 1 }).waitFor();
    const focused = await page.evaluate(() => document.activeElement?.closest('button')?.textContent ?? undefined);
    await expect.poll(() => page.locator('.link-state').innerText()).toBe(en.link.status.off);
    found.push([name, focused, page.url().replace(inject('site'), '')]);
  }
  expect(found).toEqual([
    ['Connect a timer', 'Connect', ''],
    ['Library', undefined, '#library'],
    ['Simulated timer', 'F1Q', ''],
  ]);
});
