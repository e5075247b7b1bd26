import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import {
  type Browser,
  type BrowserContext,
  type BrowserContextOptions,
  chromium,
  firefox,
  type LaunchOptions,
  type Page,
} from 'playwright';
import { expect, inject, onTestFinished } from 'vitest';

declare module 'vitest' {
  // What setup.js provides for the tests of this folder.
  interface ProvidedContext {
    /** Where the built page is served, at the root of a host. */
    site: string;
    /** Where it is served again, below the root. */
    siteUnderPath: string;
    /** With a `channel` it is Firefox. */
    launch: LaunchOptions;
  }
}

/** Milliseconds after which a step counts as hanging: a slow and busy machine needs long for short steps. */
const PATIENCE = 120_000;

const isFirefox = (): boolean => inject('launch').channel !== undefined;

/** One browser for all files of a test process; it ends with the process. */
let browser: Promise<Browser> | undefined;

/**
 * A page in a new profile, with nothing stored.
 * @param found collects the errors that this page, or another one of the profile, reports. What the content
 * security policy stops is an error, too
 */
export async function newProfile(found: string[], options?: BrowserContextOptions): Promise<Page> {
  browser ??= (isFirefox() ? firefox : chromium).launch(inject('launch'));
  const context = await (await browser).newContext(options);
  context.setDefaultTimeout(PATIENCE);
  context.on('weberror', (error) => found.push(error.error().message));
  context.on('console', (message) => {
    // For a file that cannot name an icon, such as the licences, the browser asks by itself.
    const isIcon = message.location().url.endsWith('/favicon.ico');
    if (message.type() === 'error' && !isIcon) found.push(message.text());
  });
  return context.newPage();
}

/**
 * A page in a new profile, with nothing stored, for one test. The test fails when an error is reported.
 * @param faults if given, collects the errors instead, and the test checks them
 */
export async function newPage(options?: BrowserContextOptions, faults?: string[]): Promise<Page> {
  const found = faults ?? [];
  const page = await newProfile(found, options);
  onTestFinished(async () => {
    await page.context().close();
    if (!faults) expect(found).toEqual([]);
  });
  return page;
}

/** A profile from an earlier test, emptied for the next one. */
interface Profile {
  /** An empty tab, the only one. */
  readonly page: Page;
  readonly found: string[];
  /** The options it was made with. A test with the same options can use it. */
  readonly made: string;
}

/** The most that are kept, the latest first. */
const swept: Profile[] = [];
const SWEPT_MOST = 3;

/**
 * A page for one test, in a profile that earlier tests may have used: nothing is stored, but the worker of the
 * page and the compiled scripts are there, as on a second visit. That takes half of the time of a new
 * profile. The test fails when an error is reported.
 */
export async function newVisit(options: BrowserContextOptions = {}): Promise<Page> {
  const made = JSON.stringify(options);
  const used = swept.find((each) => each.made === made);
  if (used) swept.splice(swept.indexOf(used), 1);
  const found = used?.found ?? [];
  const page = used?.page ?? (await newProfile(found, options));
  onTestFinished(async ({ task }) => {
    // Firefox cannot be swept.
    const next = task.result?.state === 'fail' || isFirefox() ? undefined : await sweep(page.context());
    if (!next) await page.context().close();
    expect(found).toEqual([]);
    if (next) swept.unshift({ page: next, found, made });
    for (const { page: old } of swept.splice(SWEPT_MOST)) await old.context().close();
  });
  return page;
}

/** What a page stores, by the browser's names: everything except its worker and the files of that. */
export const STORED = 'cookies,file_systems,indexeddb,local_storage';

/** Leaves one empty tab, and deletes everything stored except the files of the worker. */
async function sweep(context: BrowserContext): Promise<Page> {
  const left = context.pages();
  const page = await context.newPage();
  await Promise.all(left.map((each) => each.close()));
  await context.setOffline(false);
  const devTools = await context.newCDPSession(page);
  for (const address of [inject('site'), inject('siteUnderPath')])
    await devTools.send('Storage.clearDataForOrigin', {
      origin: new URL(address).origin,
      storageTypes: STORED,
    });
  await devTools.detach();
  return page;
}

/** A page in a profile on disk: in the other profiles nothing can be installed. */
export async function newKeptPage(): Promise<Page> {
  const folder = mkdtempSync(join(tmpdir(), 'sidus-timer-profile-'));
  const context = await chromium.launchPersistentContext(folder, inject('launch'));
  context.setDefaultTimeout(PATIENCE);
  onTestFinished(async () => {
    await context.close();
    rmSync(folder, { recursive: true, force: true });
  });
  return context.newPage();
}

/** A phone that is held in one hand. */
export const PHONE: BrowserContextOptions = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

type Touch = 'touchStart' | 'touchMove' | 'touchEnd';

/** A finger that moves: Playwright's own only taps. */
export async function fingerOn(
  page: Page,
): Promise<(type: Touch, ...touchPoints: { x: number; y: number }[]) => Promise<unknown>> {
  const devTools = await page.context().newCDPSession(page);
  return (type, ...touchPoints) => devTools.send('Input.dispatchTouchEvent', { type, touchPoints });
}

/** Sets the theme with the largest letters. Runs in the page, because only the page has the storage. */
export const IN_SUN = (): unknown =>
  location.protocol !== 'about:' && localStorage.setItem('sidus-timer/theme', '"sun"');
