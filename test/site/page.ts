import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import {
  type Browser,
  type BrowserContext,
  type BrowserContextOptions,
  chromium,
  type LaunchOptions,
  type Page,
} from 'playwright';
import { expect, inject, onTestFinished } from 'vitest';

declare module 'vitest' {
  // What setup.js makes for the tests of this folder.
  interface ProvidedContext {
    /** Where the built page is served, at the root of a host. */
    site: string;
    /** Where it is served again, below one. */
    siteUnderPath: string;
    launch: LaunchOptions;
  }
}

/** Milliseconds after which something hangs: a slow and busy machine may take its time for what takes a moment. */
const PATIENCE = 120_000;

/** One for all files that a process of tests goes through; it goes when the process does. */
let browser: Promise<Browser> | undefined;

/**
 * A page in a profile of its own, with nothing stored.
 * @param found where the errors are put that it reports, or another page of the same profile; whatever the content
 * security policy stops is one
 */
export async function newProfile(found: string[], options?: BrowserContextOptions): Promise<Page> {
  browser ??= chromium.launch(inject('launch'));
  const context = await (await browser).newContext(options);
  context.setDefaultTimeout(PATIENCE);
  context.on('weberror', (error) => found.push(error.error().message));
  context.on('console', (message) => message.type() === 'error' && found.push(message.text()));
  return context.newPage();
}

/**
 * A page in a profile of its own, with nothing stored, for one test. The test fails, too, when an error is reported.
 * @param faults given, the errors are put there instead, for the test to judge
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

/** A profile that a test has left, swept for the next one. */
interface Profile {
  /** An empty tab, the only one. */
  readonly page: Page;
  readonly found: string[];
  /** What it was made with: who wants the same can have it. */
  readonly made: string;
}

/** As many as are worth their memory, the latest first. */
const swept: Profile[] = [];
const SWEPT_MOST = 3;

/**
 * A page for one test, in a profile through which others may have gone before: nothing is stored, but the worker of the
 * page and the compiled scripts are there, as for a pilot who comes again. That takes half of the time of a profile of
 * its own. The test fails, too, when an error is reported.
 */
export async function newVisit(options: BrowserContextOptions = {}): Promise<Page> {
  const made = JSON.stringify(options);
  const used = swept.find((each) => each.made === made);
  if (used) swept.splice(swept.indexOf(used), 1);
  const found = used?.found ?? [];
  const page = used?.page ?? (await newProfile(found, options));
  onTestFinished(async ({ task }) => {
    const next = task.result?.state === 'fail' ? undefined : await sweep(page.context());
    if (!next) await page.context().close();
    expect(found).toEqual([]);
    if (next) swept.unshift({ page: next, found, made });
    for (const { page: old } of swept.splice(SWEPT_MOST)) await old.context().close();
  });
  return page;
}

/** What a page stores, in the words of the browser: all but its worker, and what that keeps. */
export const STORED = 'cookies,file_systems,indexeddb,local_storage';

/** Leaves one empty tab, and of what is stored only what the worker of the page keeps. */
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

/** A page in a profile that a browser keeps: in the others nothing can be installed. */
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
