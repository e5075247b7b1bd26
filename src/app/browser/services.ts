import type { Nameplate } from './platform.js';

/** Where the browser has a service, and which parts of it the page uses. */
export interface Uses {
  readonly of: 'navigator' | 'window';
  /** Whether the service itself is called or constructed. */
  readonly made?: true;
  /** Methods that answer at once. */
  readonly now: readonly string[];
  /** Methods that answer with a promise. */
  readonly later: readonly string[];
}

/**
 * Everything that this page asks of a browser and that a browser may lack, refuse or leave unanswered. There is no
 * other way to these services: the linter forbids the global names, the compiler any method that is not listed, and the
 * tests try every fault of each with the built page.
 */
export const SERVICES = {
  serial: { of: 'navigator', now: ['addEventListener', 'removeEventListener'], later: ['getPorts', 'requestPort'] },
  locks: { of: 'navigator', now: [], later: ['request'] },
  storage: { of: 'navigator', now: [], later: ['persist'] },
  clipboard: { of: 'navigator', now: [], later: ['readText', 'writeText'] },
  serviceWorker: {
    of: 'navigator',
    now: ['addEventListener', 'controller'],
    later: ['register', 'getRegistration'],
  },
  caches: { of: 'window', now: [], later: ['keys', 'delete'] },
  // It answers with events; all of them come through `open`.
  indexedDB: { of: 'window', now: ['open'], later: [] },
  localStorage: { of: 'window', now: ['getItem', 'setItem', 'removeItem', 'key', 'length'], later: [] },
  BroadcastChannel: { of: 'window', made: true, now: ['postMessage', 'addEventListener'], later: [] },
  matchMedia: { of: 'window', made: true, now: [], later: [] },
  CloseWatcher: { of: 'window', made: true, now: ['addEventListener', 'destroy'], later: [] },
  // Must be called on the navigator.
  share: { of: 'navigator', made: true, now: [], later: [] },
  launchQueue: { of: 'window', now: ['setConsumer'], later: [] },
} as const satisfies Record<string, Uses>;

declare global {
  // Not every browser has it, so TypeScript does not declare it.
  var launchQueue: { setConsumer(consumer: (launch: { readonly files?: readonly FileSystemHandle[] }) => void): void };
}

export type ServiceName = keyof typeof SERVICES;

type Whole = Navigator & typeof globalThis;
/** The listed part of a service. A service that is itself called or constructed comes whole. */
export type Service<Name extends ServiceName> = Whole[Name] extends (...given: never[]) => unknown
  ? Whole[Name]
  : Whole[Name] extends { readonly prototype: unknown }
    ? Whole[Name]
    : Pick<Whole[Name], Extract<(typeof SERVICES)[Name]['now' | 'later'][number], keyof Whole[Name]>>;

/** The browser's service of this name; null where it has none, or refuses it. */
export function service<Name extends ServiceName>(name: Name): Service<Name> | null {
  return tried(() => ((SERVICES[name].of === 'navigator' ? navigator : globalThis) as Whole)[name] as Service<Name>);
}

/** What the browser says about itself. */
export function nameplate(): Nameplate & Pick<Navigator, 'platform' | 'onLine' | 'languages'> {
  return navigator;
}

/** The result of `work`; null where it gives nothing or throws. */
export function tried<T>(work: () => T): NonNullable<T> | null {
  try {
    return work() ?? null;
  } catch {
    return null;
  }
}

/** How long a browser may take for something quick, in milliseconds. */
const MOMENT = 3000;

/** The error of {@link attempt} when no answer has come in time. It may still come. */
export class NoAnswer extends Error {
  override readonly name = 'NoAnswer';
}

/**
 * Waits for an answer of the browser, which may leave a question open for ever. A late answer is ignored.
 * @param ask an error that it throws counts as a rejection.
 * @param ms how long to wait, in milliseconds. Default: 3 s.
 * @throws the error of the browser, or {@link NoAnswer}.
 */
export function attempt<T>(ask: () => Promise<T>, ms = MOMENT): Promise<T> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new NoAnswer(`no answer within ${ms} ms`)), ms);
    const asked = async (): Promise<T> => ask();
    asked()
      .then(resolve, reject)
      .finally(() => clearTimeout(timer));
  });
}
