import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { env } from 'node:process';
import type { BrowserContext, CDPSession, Page } from 'playwright';
import { afterAll, beforeAll, describe, expect, inject, test } from 'vitest';
import { PROBES, TOUCHED } from '../mock-serial/probes/index.js';
import { type Hands, labOf, type Probe } from '../mock-serial/probes/lab.js';
import { onMock } from '../mock-serial/probes/on-mock.js';
import { Box, PAGE } from './box.js';
import { Chooser, Screen } from './chooser.js';
import { launchChromium } from './rig.js';

/* The probes of the mock port in an unmodified Chromium. RIG_TABLE names a file for what both say to each of them. */

/**
 * How long nothing must happen before a probe says that nothing will, in milliseconds. A probe that is wrong then is
 * tried again with longer: what a browser notices a moment later is no difference.
 */
const RESTS = [150, 500, 1500, 3000];

let box: Box;
let context: BrowserContext;
let page: Page;
let devtools: CDPSession;
let chooser: Chooser;
const disposals: (() => Promise<unknown>)[] = [];
const table: string[] = [];
/** What the device has received and no probe has taken. */
let received: number[] = [];
let wake = (): void => {};
/** What was last done to the plug. */
let plug: 'plug' | 'unplug' | 'hangup' = 'plug';

const hands: Omit<Hands, 'rest'> = {
  send: async (bytes) => box.send(Uint8Array.from(bytes)),
  async receive(count) {
    while (received.length < count)
      await new Promise<void>((resolve) => {
        wake = resolve;
      });
    return received.splice(0);
  },
  // A pty keeps the claim of a page that has just closed it.
  free: async () => plug === 'plug' && (await box.order('release')),
  async order(what) {
    if (what === 'choose' || what === 'dismiss') {
      await chooser.shows(1);
      await chooser[what]();
      return;
    }
    if (what === 'plug' || what === 'unplug' || what === 'hangup') plug = what;
    await box.order(what, what === 'plug' ? { number: 0 } : {});
  },
};

beforeAll(async () => {
  box = await Box.start(inject('builtPage'));
  disposals.push(() => box.close());
  box.on('data', (bytes) => {
    received.push(...bytes);
    wake();
  });
  const screen = await Screen.start();
  disposals.push(() => screen.close());
  const home = await mkdtemp(join(tmpdir(), 'sidus-profile-'));
  disposals.push(() => rm(home, { recursive: true, force: true, maxRetries: 5 }));
  context = await launchChromium(box, home, screen);
  disposals.push(() => context.close());
  chooser = Chooser.ofChromium(screen, box);
  disposals.push(() => chooser.close());
  for (const [name, hand] of Object.entries(hands)) await context.exposeFunction(`rig_${name}`, hand);
  await hands.order('plug');
  await renew();
});

afterAll(async () => {
  for (const dispose of disposals.reverse()) await dispose();
  const { RIG_TABLE } = env;
  if (RIG_TABLE) await writeFile(RIG_TABLE, `${table.join('\n')}\n`);
});

/** A new tab. */
async function renew(): Promise<void> {
  page = await context.newPage();
  devtools = await context.newCDPSession(page);
}

/** Not Playwright's own way, which counts as a click. @throws Error with what the page throws */
async function evaluate(expression: string, userGesture: boolean): Promise<unknown> {
  const order = { expression, userGesture, awaitPromise: true, returnByValue: true };
  const { result, exceptionDetails } = await devtools.send('Runtime.evaluate', order);
  if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
  return result.value;
}

/** The page, fresh, with the port plugged in and granted. */
async function freshPage(): Promise<void> {
  if (plug === 'hangup') await hands.order('unplug');
  if (plug === 'unplug') await hands.order('plug');
  await page.goto(`${PAGE}nothing`);
  await hands.free();
  received = [];
}

async function inBrowser({ run, opens }: Probe, rest: number, isTouched: boolean): Promise<string> {
  await freshPage();
  // Now and then Chromium refuses at once to show its chooser.
  while (!(await evaluate('navigator.serial.getPorts().then((ports) => ports.length > 0)', false))) {
    const asked = evaluate('navigator.serial.requestPort().then(() => false, () => false)', true);
    const isShown = chooser.shows(1).then(
      () => true,
      () => false,
    );
    if (await Promise.race([asked, isShown])) await chooser.choose();
    await asked;
    await freshPage();
  }
  const program = `(async () => {
    'use strict';
    const { rig_send: send, rig_receive: receive, rig_order: order, rig_free: free } = window;
    const rest = () => new Promise((resolve) => setTimeout(resolve, ${rest}));
    let ports = [];
    while (ports.length === 0) ports = await navigator.serial.getPorts();
    const lab = (${labOf})(navigator.serial, ports[0], { send, receive, order, free, rest });
    if (${opens}) await lab.open();
    return lab.text(await (${run})(lab));
  })()`;
  let onCrash = (): void => {};
  const died = new Promise<string>((resolve) => {
    onCrash = () => resolve('the tab dies');
  });
  page.once('crash', onCrash);
  const said = await Promise.race([evaluate(program, isTouched).catch((error) => String(error)), died]);
  page.off('crash', onCrash);
  if (said === 'the tab dies') {
    await page.close();
    await renew();
  }
  return said as string;
}

describe.each(Object.entries(PROBES))('%s', (subject, probes) => {
  const isTouched = TOUCHED.includes(subject);
  test.each(probes.map((each) => [each.name, each] as const))('%s', async (name, probe) => {
    const { inChromium, way, why } = probe;
    let said = '';
    for (const rest of RESTS) {
      said = await inBrowser(probe, rest, isTouched);
      if (said === inChromium) break;
    }
    const mock = await onMock(probe, isTouched, false);
    table.push(`| ${[subject, name, mock, said, way ?? why ?? ''].join(' | ').replaceAll('\n', ' ')} |`);
    expect(said).toBe(inChromium);
  });
});
