import type { Page } from 'playwright';
import { expect, inject, test } from 'vitest';
import { newPage } from './page.js';

/**
 * What a translator of the browser may touch. It replaces texts by copies that the page no longer reaches: the strip
 * would go on showing the DT from before an edit, and that the program is as in the timer.
 */
const open = (page: Page): Promise<string[]> =>
  page.evaluate(() =>
    [...document.querySelectorAll('*')].flatMap((each) => ((each as HTMLElement).translate ? [each.tagName] : [])),
  );

for (const site of ['site', 'siteUnderPath'] as const) {
  test(`the page at ${new URL(inject(site)).pathname} breaks no rule of its own, has its own font, and all that it names`, async () => {
    const page = await newPage();
    await page.goto(inject(site));
    await page.getByRole('button', { name: 'Connect', exact: true }).first().waitFor();
    expect(await page.title()).toBe('Sidus Timer');
    await expect.poll(() => page.locator('html').getAttribute('lang')).toBe('en');
    expect(await open(page), 'texts that a translator of the browser may replace').toEqual([]);
    expect(await page.locator('meta[name=google]').getAttribute('content')).toBe('notranslate');

    await page.evaluate(() => document.fonts.ready);
    const devtools = await page.context().newCDPSession(page);
    await devtools.send('DOM.enable');
    await devtools.send('CSS.enable');
    const { root } = await devtools.send('DOM.getDocument');
    const { nodeId } = await devtools.send('DOM.querySelector', { nodeId: root.nodeId, selector: 'button' });
    const { fonts } = await devtools.send('CSS.getPlatformFontsForNode', { nodeId });
    expect(fonts.map(({ familyName, isCustomFont }) => [familyName, isCustomFont])).toEqual([['Inter', true]]);
    // The licence of the font goes with it.
    expect(await (await fetch(new URL('LICENSES.txt', inject(site)))).text()).toContain('SIL OPEN FONT LICENSE');

    const named = await page
      .locator('link[href], script[src]')
      .evaluateAll((elements) =>
        elements.map((element) =>
          element instanceof HTMLScriptElement ? element.src : (element as HTMLLinkElement).href,
        ),
      );
    const manifest = named.find((address) => address.endsWith('.webmanifest')) ?? '';
    const { icons, screenshots, shortcuts } = (await (await fetch(manifest)).json()) as {
      icons: { src: string }[];
      screenshots: { src: string }[];
      shortcuts: { url: string; icons: { src: string }[] }[];
    };
    const pictures = [...icons, ...screenshots, ...shortcuts.flatMap((shortcut) => shortcut.icons)];
    const told = [...pictures.map(({ src }) => src), ...shortcuts.map(({ url }) => url)];
    for (const address of [...named, ...told.map((each) => new URL(each, manifest).href)]) {
      expect(address).toContain(inject(site));
      expect((await fetch(address)).status, `the page names ${address}, which must exist`).toBe(200);
    }
  });
}

/** What a foreign script in the page could try, and the rule that stops it. */
const attempts: [rule: string, attempt: () => unknown][] = [
  ['connect-src', () => fetch('favicon.svg')],
  ['connect-src', () => navigator.sendBeacon('favicon.svg', 'told')],
  ['img-src', () => Object.assign(new Image(), { src: 'http://127.0.0.1:9/told' })],
  ['frame-src', () => document.body.append(Object.assign(document.createElement('iframe'), { src: 'favicon.svg' }))],
  ['style-src-attr', () => document.body.setAttribute('style', 'color: red')],
  ['require-trusted-types-for', () => Object.assign(document.body, { innerHTML: '<b></b>' })],
  ['require-trusted-types-for', () => Object.assign(document.createElement('script'), { src: 'told.js' })],
  ['trusted-types', () => Reflect.get(window, 'trustedTypes').createPolicy('another')],
];

test('the page is stopped by its rules', async () => {
  const page = await newPage({}, []);
  await page.goto(inject('site'));
  await page.evaluate(() => {
    addEventListener('securitypolicyviolation', (event) => document.body.classList.add(event.effectiveDirective));
  });
  for (const [rule, attempt] of attempts) {
    await page.evaluate(() => document.body.removeAttribute('class'));
    await page.evaluate(attempt).catch(() => {});
    await page.waitForSelector(`body.${rule}`, { state: 'attached' });
  }
});
