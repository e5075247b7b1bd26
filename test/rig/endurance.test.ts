import { env, stdout } from 'node:process';
import type { CDPSession } from 'playwright';
import { expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { Pilot } from './pilot.js';
import { Rig } from './rig.js';

/** RIG_CYCLES=1000 is the full run. */
const { RIG_CYCLES = '100' } = env;
const CYCLES = Number(RIG_CYCLES);
/** So many fill what the page keeps of the line, which then grows no more. */
const FIRST = 80;

/** Bytes of the JavaScript heap that are in use after collection. */
async function heapOf(devTools: CDPSession): Promise<number> {
  // What is collected may let go of more.
  for (let times = 0; times < 3; times++) await devTools.send('HeapProfiler.collectGarbage');
  return (await devTools.send('Runtime.getHeapUsage')).usedSize;
}

test(`connected, read and disconnected ${CYCLES} times, the heap of the page stays flat`, {
  timeout: 60_000 + 2000 * CYCLES,
}, async () => {
  const rig = await Rig.start();
  const pilot = new Pilot(await rig.open());
  const devTools = await pilot.page.context().newCDPSession(pilot.page);
  await devTools.send('HeapProfiler.enable');

  /** The page's own buttons, pressed by the page itself as soon as they can be. */
  const cycle = (times: number) =>
    pilot.page.evaluate(
      async ({ times, connect, disconnect, read }) => {
        const press = (name: string, also?: string): Promise<void> =>
          new Promise((resolve) => {
            const find = (text: string) =>
              [...document.querySelectorAll('button')].find(
                ({ textContent, disabled, ariaDisabled }) =>
                  textContent === text && !disabled && ariaDisabled !== 'true',
              );
            const look = (): boolean => {
              const button = find(name);
              if (!button || (also && !find(also))) return false;
              watch.disconnect();
              button.click();
              resolve();
              return true;
            };
            const watch = new MutationObserver(look);
            const options = { subtree: true, childList: true, attributes: true, characterData: true };
            if (!look()) watch.observe(document.body, options);
          });
        for (let done = 0; done < times; done++) {
          await press(connect);
          // That it can be read again says that it was read.
          await press(disconnect, read);
        }
      },
      { times, connect: en.header.connect, disconnect: en.header.disconnect, read: en.program.read },
    );

  await cycle(FIRST);
  const heaps: [cycles: number, bytes: number][] = [];
  let done = 0;
  const begin = performance.now();
  for (const part of [0.1, 0.25, 0.5, 0.75, 1]) {
    await cycle(Math.round(CYCLES * part) - done);
    done = Math.round(CYCLES * part);
    await pilot.button(en.header.connect).waitFor();
    heaps.push([part, await heapOf(devTools)]);
  }
  const seconds = (performance.now() - begin) / 1000;
  const told = heaps.map(([part, bytes]) => `${Math.round(CYCLES * part)}: ${(bytes / 1e6).toFixed(3)} MB`).join(', ');
  stdout.write(`Heap after so many cycles (${(seconds / CYCLES).toFixed(2)} s each): ${told}.\n`);

  const all = FIRST + CYCLES;
  // Once to connect, once after the reading.
  expect(rig.timer.core.answered.filter(({ name }) => name === 'GETSWVER')).toHaveLength(2 * all);
  expect(rig.timer.core.answered.filter(({ name }) => name === 'GETSERVOPOS')).toHaveLength(all);
  await expect.poll(() => rig.sessions, { timeout: 60_000 }).toEqual({ opened: all, closed: all });
  // At first the engine itself still grows: it compiles what runs often, and remembers what it has seen.
  const [half, end] = [heaps[2], heaps[4]].map((heap) => heap?.[1] ?? 0) as [number, number];
  expect(end / half, told).toBeLessThan(1.03);
});
