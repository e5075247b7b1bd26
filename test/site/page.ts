import { type Browser, type BrowserContextOptions, chromium, type LaunchOptions, type Page } from 'playwright';
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
 * A page in a profile of its own, with nothing stored, for one test. The test fails, too, when this page, or another of
 * the same profile, reports an error; whatever the content security policy stops is one.
 * @param faults given, the errors are put there instead, for the test to judge
 */
export async function newPage(options?: BrowserContextOptions, faults?: string[]): Promise<Page> {
  browser ??= chromium.launch(inject('launch'));
  const context = await (await browser).newContext(options);
  context.setDefaultTimeout(PATIENCE);
  const found = faults ?? [];
  context.on('weberror', (error) => found.push(error.error().message));
  context.on('console', (message) => message.type() === 'error' && found.push(message.text()));
  onTestFinished(async () => {
    await context.close();
    if (!faults) expect(found).toEqual([]);
  });
  return context.newPage();
}

/** A phone that is held in one hand. */
export const PHONE: BrowserContextOptions = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
