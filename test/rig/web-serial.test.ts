import type { Page } from 'playwright';
import { expect, test } from 'vitest';
import { encodeRequest } from '../../src/protocol/index.js';
import { fromHex } from '../tools/bytes.js';
import { Rig } from './rig.js';

// The page's own Web Serial, without the page's program: what the journeys stand on.

const PATIENCE = { timeout: 60_000 };

const identify = [...encodeRequest({ name: 'GETSWVER' })];
const identity = [...fromHex('00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45')];

/** Notes from now on what the page is told of its ports. */
async function listen(page: Page): Promise<() => Promise<string[]>> {
  await page.evaluate(async () => {
    const note = ({ type }: Event) => document.body.append(` ${type}`);
    for (const type of ['connect', 'disconnect']) navigator.serial.addEventListener(type, note);
    // When this is answered, the browser knows of the listeners.
    await navigator.serial.getPorts();
  });
  return async () => (await page.locator('body').innerText()).match(/(dis)?connect\b/g) ?? [];
}

test('the plug can be pulled after any byte, and no later byte arrives', async () => {
  const rig = await Rig.start();
  const page = await rig.open();
  for (const bytes of [1, 5, 17]) {
    const passed = [...rig.passed.toPage];
    void rig.unplugAfter(bytes, 'toPage');
    const [got, error] = await page.evaluate(async (request) => {
      const [port] = await navigator.serial.getPorts();
      await port?.open({ baudRate: 9600 });
      await port?.writable?.getWriter().write(Uint8Array.from(request));
      const reader = port?.readable?.getReader();
      const got: number[] = [];
      try {
        for (;;) got.push(...((await reader?.read())?.value ?? []));
      } catch (error) {
        return [got, String(error)] as const;
      }
    }, identify);
    expect(rig.passed.toPage).toEqual([...passed, ...identity.slice(0, bytes)]);
    // In Chromium the news that the port is gone can overtake the last bytes.
    expect(identity.slice(0, bytes).slice(0, got.length)).toEqual(got);
    expect(error).toContain('The device has been lost.');
    const told = await listen(page);
    await rig.plug();
    await expect.poll(told, PATIENCE).toContain('connect');
  }
  const before = rig.passed.fromPage.length;
  void rig.unplugAfter(4, 'fromPage');
  await page.evaluate(async (request) => {
    const [port] = await navigator.serial.getPorts();
    await port?.open({ baudRate: 9600 });
    await port?.writable?.getWriter().write(Uint8Array.from(request));
    await port?.readable
      ?.getReader()
      .read()
      .catch(() => {});
  }, identify);
  expect(rig.passed.fromPage.slice(before)).toEqual(identify.slice(0, 4));
});
