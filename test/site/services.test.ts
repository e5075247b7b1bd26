import type { CDPSession, Page } from 'playwright';
import { afterAll, beforeAll, describe, expect, inject, test } from 'vitest';
import { SERVICES, type ServiceName, type Uses } from '../../src/app/browser/services.js';
import { en } from '../../src/app/messages/en.js';
import { newPage, newProfile, STORED } from './page.js';

const { lacks, storage } = en.keeping;

/** What a browser may do to one service: to all of it, or to one of the calls that the page makes. */
interface Fault {
  readonly name: ServiceName;
  readonly of: 'navigator' | 'window';
  readonly call: string | null;
  readonly how: 'is missing' | 'throws' | 'refuses' | 'is silent' | 'throws when made';
}

/** Every fault of a service, from the list of what the page uses: a new call is among them unasked. */
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
function breakIt({ name, of, call, how }: Fault): void {
  const scope = (of === 'navigator' ? navigator : window) as unknown as Record<string, unknown>;
  const target = scope[name] as object & { readonly prototype?: object };
  // This browser has no such service on this system.
  if (target === undefined && call !== null) return;
  const fail = (): unknown => {
    if (how === 'refuses') return Promise.reject(new DOMException('Not here.', 'NotAllowedError'));
    if (how === 'is silent') return new Promise(() => {});
    throw new DOMException('Not here.', 'SecurityError');
  };
  if (call === null) {
    if (how === 'is missing') Object.defineProperty(scope, name, { value: undefined });
    else if (how === 'throws') Object.defineProperty(scope, name, { get: fail });
    else Object.defineProperty(scope, name, { value: fail });
    return;
  }
  const holder = (target.prototype ?? Object.getPrototypeOf(target)) as Record<string, unknown>;
  const isCall = typeof Object.getOwnPropertyDescriptor(holder, call)?.get === 'undefined';
  const own = isCall ? (holder[call] as (...given: unknown[]) => unknown) : undefined;
  // The two storages of settings have one prototype.
  const broken = function (this: unknown, ...given: unknown[]): unknown {
    return name.endsWith('Storage') && this !== target ? own?.apply(this, given) : fail();
  };
  Object.defineProperty(holder, call, isCall ? { value: broken } : { get: broken });
}

/** Runs in the page before its own scripts: no fault shuts the way to what is kept, and nothing of the tab is. */
function keepAWay(): void {
  // It would outlive the page, where the same tab is used again.
  if (location.protocol !== 'about:') sessionStorage.clear();
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
  }
}

/** The page is drawn, reads, takes what is typed, and keeps it or says that it does not. */
async function works(page: Page): Promise<void> {
  await page.goto(inject('site'));
  await page.getByRole('button', { name: 'Try a simulated F1Q timer' }).click();
  const field = page.getByRole('textbox', { name: 'DT time' });
  await field.waitFor();
  expect(await page.evaluate(() => window.keptTimes()), 'kept at first').toEqual([]);
  await field.fill('4:00');
  await field.press('Enter');
  await expect.poll(() => field.inputValue()).toBe('4:00');
  const said = page.getByText(en.keeping.title);
  const keptOrSaid = async (): Promise<boolean> =>
    (await page.evaluate(() => window.keptTimes())).includes(24_000) || (await said.isVisible());
  await expect.poll(keptOrSaid, { message: 'kept, or said not to be' }).toBe(true);
}

/** What is said of a fault of one of these calls, or of the whole. */
type Sentence = readonly [sentence: string | null, ...calls: (string | null)[]];
const NOTHING: Sentence = [null];
const SAID: Partial<Record<ServiceName, Sentence>> = {
  locks: [lacks.locks, null, 'request'],
  BroadcastChannel: [lacks.channel, null, 'addEventListener'],
  indexedDB: [storage.missing, null, 'open'],
  localStorage: [lacks.settings, null, 'setItem', 'removeItem'],
  sessionStorage: [lacks.settings, null, 'setItem', 'removeItem'],
  serviceWorker: [lacks.offline, null, 'register', 'controller', 'addEventListener'],
};

describe('the page is drawn and works, whatever a browser does to', () => {
  /** A page that is used again and again, with nothing kept: a new one would take twice the time. */
  interface Lane {
    readonly page: Page;
    readonly devTools: CDPSession;
  }
  const found: string[] = [];
  let lanes: readonly Lane[] = [];
  const openLane = async (): Promise<Lane> => {
    const page = await newProfile(found);
    await page.addInitScript(keepAWay);
    return { page, devTools: await page.context().newCDPSession(page) };
  };
  beforeAll(async () => {
    lanes = await Promise.all(Array.from({ length: 4 }, openLane));
  });
  afterAll(() => Promise.all(lanes.map(({ page }) => page.context().close())));

  const journey = async ({ page, devTools }: Lane, fault: Fault): Promise<void> => {
    const { origin } = new URL(inject('site'));
    // The worker stays where it is not what is broken: to fetch and keep the page anew takes longer than all else.
    const kept = fault.name === 'serviceWorker' || fault.name === 'caches' ? 'all' : STORED;
    await devTools.send('Storage.clearDataForOrigin', { origin, storageTypes: kept });
    const broken = await page.addInitScript(breakIt, fault);
    await works(page);
    const [sentence, ...calls] = SAID[fault.name] ?? NOTHING;
    if (sentence && calls.includes(fault.call)) await page.getByRole('status').filter({ hasText: sentence }).waitFor();
    await broken.dispose();
    await page.goto('about:blank');
  };

  test.for(Object.keys(SERVICES) as ServiceName[])('%s', async (name) => {
    const faults = [...faultsOf(name)];
    const goThrough = async (lane: Lane): Promise<void> => {
      for (let fault = faults.shift(); fault; fault = faults.shift()) {
        const why = `where ${name} ${fault.call ?? ''} ${fault.how}`;
        await journey(lane, fault).catch((cause) => {
          throw new Error(why, { cause });
        });
      }
    };
    await Promise.all(lanes.map(goThrough));
    expect(found.splice(0), 'errors').toEqual([]);
  });
});

test('a storage that never answers is said, and the page works', async () => {
  const page = await newPage();
  await page.addInitScript(keepAWay);
  await page.addInitScript(() => {
    const { open } = IDBFactory.prototype;
    IDBFactory.prototype.open = function (name) {
      return Object.assign(open.call(this, `other ${name}`), { addEventListener: () => {} });
    };
  });
  await works(page);
  await page.getByRole('status').filter({ hasText: storage.slow }).waitFor();
});
