import type { Nameplate } from './platform.js';

/** Where a service is found, and what is used of it. */
export interface Uses {
  readonly of: 'navigator' | 'window';
  /** Called or made itself. */
  readonly made?: true;
  /** What answers at once. */
  readonly now: readonly string[];
  /** What answers by a promise. */
  readonly later: readonly string[];
}

/**
 * All that this page asks of a browser and that a browser may lack, refuse or leave unanswered. There is no other way
 * to them: the linter holds the global names, the compiler what is not listed here, and with each fault of each of them
 * the built page is tested.
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
  // Its answers are events: all of them come through `open`.
  indexedDB: { of: 'window', now: ['open'], later: [] },
  localStorage: { of: 'window', now: ['getItem', 'setItem', 'removeItem', 'key', 'length'], later: [] },
  sessionStorage: { of: 'window', now: ['getItem', 'setItem', 'removeItem', 'key', 'length'], later: [] },
  BroadcastChannel: { of: 'window', made: true, now: ['postMessage', 'addEventListener', 'close'], later: [] },
  matchMedia: { of: 'window', made: true, now: [], later: [] },
  CloseWatcher: { of: 'window', made: true, now: ['addEventListener', 'destroy'], later: [] },
  mediaDevices: { of: 'navigator', now: [], later: ['getUserMedia'] },
  BarcodeDetector: { of: 'window', made: true, now: [], later: ['detect'] },
  // Called for the navigator.
  share: { of: 'navigator', made: true, now: [], later: [] },
  AudioContext: { of: 'window', made: true, now: [], later: ['resume', 'close'] },
  showSaveFilePicker: { of: 'window', made: true, now: [], later: [] },
  launchQueue: { of: 'window', now: ['setConsumer'], later: [] },
} as const satisfies Record<string, Uses>;

declare global {
  // Not of every browser, and so not of TypeScript's.
  var showSaveFilePicker: (options: {
    readonly suggestedName: string;
    readonly types: readonly { readonly accept: Readonly<Record<string, readonly string[]>> }[];
  }) => Promise<FileSystemFileHandle>;
  var launchQueue: { setConsumer(consumer: (launch: { readonly files?: readonly FileSystemHandle[] }) => void): void };
}

export type ServiceName = keyof typeof SERVICES;

type Whole = Navigator & typeof globalThis;
/** As much of a service as is used here; what is called or made as a whole is whole. */
export type Service<Name extends ServiceName> = Whole[Name] extends (...given: never[]) => unknown
  ? Whole[Name]
  : Whole[Name] extends { readonly prototype: unknown }
    ? Whole[Name]
    : Pick<Whole[Name], Extract<(typeof SERVICES)[Name]['now' | 'later'][number], keyof Whole[Name]>>;

/** What the browser has under this name; null where it has none, or does not hand it out. */
export function service<Name extends ServiceName>(name: Name): Service<Name> | null {
  return tried(() => ((SERVICES[name].of === 'navigator' ? navigator : globalThis) as Whole)[name] as Service<Name>);
}

/** What the browser says of itself. */
export function nameplate(): Nameplate & Pick<Navigator, 'platform' | 'onLine'> {
  return navigator;
}

/** What this gives; null where it gives nothing or throws. */
export function tried<T>(work: () => T): NonNullable<T> | null {
  try {
    return work() ?? null;
  } catch {
    return null;
  }
}

/** So long a browser has for what should take a moment, in milliseconds. */
const MOMENT = 3000;

/**
 * What the browser answers to what should take it a moment.
 * @param ms for so long it is waited for, in milliseconds. Default: 3 s.
 * @throws what it says, or an Error when it has not answered by then.
 */
export function answerOf<T>(ask: () => Promise<T>, ms = MOMENT): Promise<T> {
  return new Promise((resolve, reject) => {
    const giveUp = setTimeout(() => reject(new Error('the browser does not answer')), ms);
    const asked = async (): Promise<T> => ask();
    asked()
      .then(resolve, reject)
      .finally(() => clearTimeout(giveUp));
  });
}
