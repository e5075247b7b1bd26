import { env, stdout } from 'node:process';
import type { CDPSession } from 'playwright';
import { expect, test } from 'vitest';
import { COMMANDS, type CommandName } from '../../src/protocol/index.js';
import { en } from '../tools/en.js';
import { Pilot } from './pilot.js';
import { Rig } from './rig.js';

/** RIG_CYCLES=1200 is the full run. */
const { RIG_CYCLES = '120' } = env;
const CYCLES = Number(RIG_CYCLES);
/** So many fill what the page keeps of the line, which then grows no more. */
const FIRST = 80;
/** What is held is counted after each of them. */
const PARTS = 3;

/** What the page itself makes, by the kinds of a heap snapshot. Compiled code and the engine's notes are not its. */
const MADE = ['object', 'closure', 'array', 'string', 'concatenated string', 'sliced string', 'regexp', 'bigint'];

interface Snapshot {
  snapshot: { meta: { node_fields: string[]; node_types: [string[]] } };
  nodes: number[];
  strings: string[];
}

/** How many things of each kind the page still holds after collection; elements by their tag. */
async function heldBy(devTools: CDPSession): Promise<Map<string, number>> {
  // What is collected may let go of more.
  for (let times = 0; times < 3; times++) await devTools.send('HeapProfiler.collectGarbage');
  const chunks: string[] = [];
  const note = ({ chunk }: { chunk: string }): void => void chunks.push(chunk);
  devTools.on('HeapProfiler.addHeapSnapshotChunk', note);
  await devTools.send('HeapProfiler.takeHeapSnapshot', { reportProgress: false });
  devTools.off('HeapProfiler.addHeapSnapshotChunk', note);
  const { snapshot, nodes, strings } = JSON.parse(chunks.join('')) as Snapshot;
  const { node_fields, node_types } = snapshot.meta;
  const held = new Map<string, number>();
  for (let at = 0; at < nodes.length; at += node_fields.length) {
    const [type, name] = nodes.slice(at, at + 2) as [number, number];
    const kind = node_types[0][type] ?? '';
    const element = kind === 'native' && /^<[a-z]+/.exec(strings[name] ?? '')?.[0];
    const key = element || (MADE.includes(kind) ? kind : '');
    if (key) held.set(key, (held.get(key) ?? 0) + 1);
  }
  return held;
}

test(`connected, read and disconnected ${CYCLES} times, the page holds no more than before`, {
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
  const begin = performance.now();
  const held = [await heldBy(devTools)];
  for (let part = 0; part < PARTS; part++) {
    await cycle(CYCLES / PARTS);
    await pilot.button(en.header.connect).waitFor();
    held.push(await heldBy(devTools));
  }
  const seconds = (performance.now() - begin) / 1000;

  // What comes once, at its own time, is in one part only; a leak is in each.
  const grown = [...(held.at(-1) ?? [])].map(([kind]) => ({
    kind,
    by: Math.min(...held.slice(1).map((after, at) => (after.get(kind) ?? 0) - (held[at]?.get(kind) ?? 0))),
  }));
  const told =
    grown
      .filter(({ by }) => by > 0)
      .map(({ kind, by }) => `${by} ${kind}`)
      .join(', ') || 'nothing';
  stdout.write(
    `Each ${CYCLES / PARTS} cycles left at least this behind: ${told} (${(seconds / CYCLES).toFixed(2)} s a cycle).\n`,
  );

  const all = FIRST + CYCLES;
  // Once to connect, once after the reading.
  const asked = (name: CommandName): number[] => rig.requests.filter((code) => code === COMMANDS[name].request);
  expect(asked('GETSWVER')).toHaveLength(2 * all);
  expect(asked('GETSERVOPOS')).toHaveLength(all);
  await expect.poll(() => rig.sessions, { timeout: 60_000 }).toEqual({ opened: all, closed: all });
  expect(held.at(-1)?.get('object'), 'the snapshot was understood').toBeGreaterThan(1000);
  expect(
    grown.filter(({ by }) => by >= (0.8 * CYCLES) / PARTS),
    told,
  ).toEqual([]);
});
