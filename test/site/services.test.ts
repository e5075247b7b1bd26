import type { CDPSession, Page } from 'playwright';
import { afterAll, beforeAll, describe, expect, inject, test } from 'vitest';
import { SERVICES, type ServiceName, type Uses } from '../../src/app/browser/services.js';
import { en } from '../tools/en.js';
import { newPage, newProfile, STORED } from './page.js';

const { notKept, oneTab, title } = en.keeping;

/** A fault of one service in the browser: of the whole service, or of one call. */
interface Fault {
  readonly name: ServiceName;
  readonly of: 'navigator' | 'window';
  readonly call: string | null;
  /** One that works is only noted. */
  readonly how: 'works' | 'is missing' | 'throws' | 'refuses' | 'is silent' | 'throws when made';
}

/** Every fault of a service, made from the list of calls, so a new call is tested without more work. */
function faultsOf(name: ServiceName): readonly Fault[] {
  const { of, now, later, made }: Uses = SERVICES[name];
  const ways = ['is missing', 'throws', ...(made ? (['throws when made'] as const) : [])] as const;
  const whole = ways.map((how): Fault => ({ name, of, call: null, how }));
  const atOnce = [...now, ...later].map((call): Fault => ({ name, of, call, how: 'throws' }));
  const late = later.flatMap((call) =>
    (['refuses', 'is silent'] as const).map((how): Fault => ({ name, of, call, how })),
  );
  return [...whole, ...atOnce, ...late];
}

/** Runs in the page before its own scripts. */
function breakAll(faults: readonly Fault[]): void {
  // The empty page between two journeys uses no service, and may not look at each.
  if (location.protocol === 'about:') return;
  const met = new Set<number>();
  window.met = met;
  for (const [index, { name, of, call, how }] of faults.entries()) {
    const scope = (of === 'navigator' ? navigator : window) as unknown as Record<string, unknown>;
    const target = scope[name] as object & { readonly prototype?: object };
    // This browser does not have this service on this system.
    if (target === undefined && call !== null) continue;
    const fail = (): unknown => {
      met.add(index);
      if (how === 'is missing') return undefined;
      if (how === 'refuses') return Promise.reject(new DOMException('Not here.', 'NotAllowedError'));
      if (how === 'is silent') return new Promise(() => {});
      throw new DOMException('Not here.', 'SecurityError');
    };
    if (call === null) {
      // An arrow function cannot be constructed: the fault is noted when the page gets it.
      const handOut = (): unknown => met.add(index) && (how === 'works' ? target : fail);
      Object.defineProperty(scope, name, { get: how === 'works' || how === 'throws when made' ? handOut : fail });
      continue;
    }
    const holder = (target.prototype ?? Object.getPrototypeOf(target)) as Record<string, unknown>;
    const getter = Object.getOwnPropertyDescriptor(holder, call)?.get;
    const own = (getter ?? holder[call]) as (...given: unknown[]) => unknown;
    const broken = function (this: unknown, ...given: unknown[]): unknown {
      // Both storages of settings share one prototype.
      const isOther = name.endsWith('Storage') && this !== target;
      if (!isOther && how !== 'works') return fail();
      if (!isOther) met.add(index);
      return own.apply(this, given);
    };
    Object.defineProperty(holder, call, getter ? { get: broken } : { value: broken });
  }
}

/** Runs in the page before its own scripts: no fault touches the stored data. */
function keepAWay(): void {
  const open = IDBFactory.prototype.open.bind(indexedDB);
  window.keptTimes = () =>
    new Promise((resolve) => {
      const opening = open('sidus-timer');
      opening.onsuccess = () => {
        const { result } = opening;
        const drafts = result.objectStoreNames.contains('drafts') ? result.transaction('drafts') : null;
        const all = drafts?.objectStore('drafts').getAll();
        const tell = (): void => resolve((all?.result ?? []).map(({ working }) => working.times.at(-1)));
        if (all) all.onsuccess = tell;
        else tell();
        result.close();
      };
    });
}

declare global {
  interface Window {
    /** The DT of each draft that is kept. */
    keptTimes: () => Promise<number[]>;
    /** Which of the faults have happened, by their places in the list. */
    met: Set<number>;
  }
}

/** The page is drawn, reads, accepts typing, and keeps it or says that it does not. */
async function works(page: Page): Promise<void> {
  await page.goto(inject('site'));
  await page.getByRole('button', { name: 'Try a simulated F1Q timer' }).click();
  const field = page.getByRole('textbox', { name: 'DT time' });
  await field.waitFor();
  expect(await page.evaluate(() => window.keptTimes()), 'nothing is kept at first').toEqual([]);
  await field.fill('4:00');
  await field.press('Enter');
  await expect.poll(() => field.inputValue()).toBe('4:00');
  const said = page.getByText(title);
  const keptOrSaid = async (): Promise<boolean> =>
    (await page.evaluate(() => window.keptTimes())).includes(24_000) || (await said.isVisible());
  await expect.poll(keptOrSaid, { message: 'the edit is kept, or the page says that it is not' }).toBe(true);
}

/** The message after a fault of one of these calls, or of the whole service. */
type Sentence = readonly [sentence: string | null, ...calls: (string | null)[]];
const NOTHING: Sentence = [null];
const SAID: Partial<Record<ServiceName, Sentence>> = {
  locks: [oneTab, null, 'request'],
  indexedDB: [notKept, null, 'open'],
  localStorage: [notKept, null, 'setItem', 'removeItem'],
};

/**
 * What the page uses only when a pilot wants it, and not in this test. A fault of an unused call has no effect
 * so all of them are in one run, which fails when one of them is used after all.
 */
const UNASKED: readonly ServiceName[] = ['clipboard', 'caches', 'CloseWatcher', 'share'];
const ASKED = (Object.keys(SERVICES) as ServiceName[]).filter((name) => !UNASKED.includes(name));
/** These have no message and do not disturb each other: one run has a fault of each. */
const QUIET: readonly ServiceName[] = ['serial', 'BroadcastChannel', 'storage', 'matchMedia', 'launchQueue'];

describe('the page is drawn and works, whatever a browser does with', () => {
  /** One page for all runs, with nothing kept: a new one would take twice the time. */
  interface Lane {
    readonly page: Page;
    readonly devTools: CDPSession;
  }
  const found: string[] = [];
  let lanes: readonly Lane[] = [];
  const openLane = async (): Promise<Lane> => {
    const page = await newProfile(found, { viewport: { width: 800, height: 600 }, reducedMotion: 'reduce' });
    await page.addInitScript(keepAWay);
    return { page, devTools: await page.context().newCDPSession(page) };
  };
  beforeAll(async () => {
    lanes = await Promise.all(Array.from({ length: 4 }, openLane));
  });
  afterAll(() => Promise.all(lanes.map(({ page }) => page.context().close())));

  const clear = async ({ devTools }: Lane, storageTypes: string): Promise<void> => {
    await devTools.send('Storage.clearDataForOrigin', { origin: new URL(inject('site')).origin, storageTypes });
  };

  let asking: Promise<ReadonlySet<string>> | undefined;
  /** `locks`, `locks.request`. */
  const keyOf = ({ name, call }: Fault): string => (call === null ? name : `${name}.${call}`);
  /** What a page uses without a fault, on the first and on later visits: a fault of anything else has no effect. */
  const asked = (): Promise<ReadonlySet<string>> => {
    asking ??= (async () => {
      const [lane] = lanes as readonly [Lane];
      const { page } = lane;
      // A service last: to find its calls is to ask for it.
      const noted = (Object.keys(SERVICES) as ServiceName[]).flatMap((name) => {
        const { of, now, later }: Uses = SERVICES[name];
        return [...now, ...later, null].map((call): Fault => ({ name, of, call, how: 'works' }));
      });
      const notes = await page.addInitScript(breakAll, noted);
      const all = new Set<string>();
      for (const kept of ['all', STORED]) {
        await clear(lane, kept);
        await works(page);
        const now = async (): Promise<string[]> =>
          (await page.evaluate(() => [...window.met])).map((index) => keyOf(noted[index] as Fault));
        // Some of it only when something is stored.
        await expect
          .poll(now, { message: 'the page asks for every service of the list' })
          .toEqual(expect.arrayContaining(ASKED));
        for (const each of await now()) all.add(each);
        await page.goto('about:blank');
      }
      await notes.dispose();
      return all;
    })();
    return asking;
  };

  /** @param faults all of them at once */
  const journey = async (lane: Lane, faults: readonly Fault[], areMet: boolean): Promise<void> => {
    const { page } = lane;
    // The worker stays unless it is the faulty part: loading the page again takes longer than everything else.
    await clear(lane, faults.some(({ name }) => name === 'serviceWorker') ? 'all' : STORED);
    const broken = await page.addInitScript(breakAll, faults);
    await works(page);
    const met = (): Promise<number> => page.evaluate(() => window.met.size);
    if (areMet) await expect.poll(met, { message: 'the page has met every fault' }).toBe(faults.length);
    for (const { name, call } of faults) {
      const [sentence, ...calls] = SAID[name] ?? NOTHING;
      if (sentence && calls.includes(call)) await page.getByRole('status').filter({ hasText: sentence }).waitFor();
    }
    await broken.dispose();
    await page.goto('about:blank');
  };

  const goThrough = async (journeys: readonly (readonly Fault[])[], areMet = true): Promise<void> => {
    const left = journeys.filter(({ length }) => length > 0);
    const go = async (lane: Lane): Promise<void> => {
      for (let faults = left.shift(); faults; faults = left.shift()) {
        const why = faults.map(({ name, call, how }) => `${name} ${call ?? ''} ${how}`).join(', ');
        await journey(lane, faults, areMet).catch((cause) => {
          throw new Error(`in a browser where ${why}`, { cause });
        });
      }
    };
    await Promise.all(lanes.map(go));
    expect(found.splice(0), 'errors on the page').toEqual([]);
  };

  /** The faults that happen in this run, and those of calls that it does not make. */
  const sorted = async (name: ServiceName): Promise<{ met: readonly Fault[]; unmet: readonly Fault[] }> => {
    const all = await asked();
    const isMet = (fault: Fault): boolean => all.has(keyOf(fault));
    const faults = faultsOf(name);
    return { met: faults.filter(isMet), unmet: faults.filter((fault) => !isMet(fault) && fault.how === 'throws') };
  };

  test.for(ASKED.filter((name) => !QUIET.includes(name)))('%s', async (name) => {
    const { met } = await sorted(name);
    await goThrough(met.map((fault) => [fault]));
  });

  test(QUIET.join(', '), async () => {
    const rows = await Promise.all(QUIET.map(sorted));
    const most = Math.max(...rows.map(({ met }) => met.length));
    await goThrough(Array.from({ length: most }, (_, at) => rows.flatMap(({ met }) => met.slice(at, at + 1))));
  });

  test('what it is asked for only when that is wanted', async () => {
    const all = await asked();
    expect(UNASKED.filter((name) => all.has(name))).toEqual([]);
    const calls = (await Promise.all(ASKED.map(sorted))).flatMap(({ unmet }) => unmet);
    const whole = UNASKED.flatMap(faultsOf).filter(({ call }) => call === null);
    const ways = ['is missing', 'throws'].map((how) => whole.filter((fault) => fault.how === how));
    await goThrough([calls, ...ways], false);
  });
});

test('a storage that never answers is reported, and the page works', async () => {
  const page = await newPage();
  await page.addInitScript(keepAWay);
  await page.addInitScript(() => {
    const { open } = IDBFactory.prototype;
    IDBFactory.prototype.open = function (name) {
      return Object.assign(open.call(this, `other ${name}`), { addEventListener: () => {} });
    };
  });
  await works(page);
  await page.getByRole('status').filter({ hasText: en.keeping.notKnown }).waitFor();
});
