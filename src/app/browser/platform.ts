export type System = 'windows' | 'mac' | 'linux' | 'chromeos' | 'android' | 'ios' | 'other';
export type Browser = 'chrome' | 'edge' | 'opera' | 'brave' | 'firefox' | 'safari' | 'other';

/**
 * What the pilot sits at, as far as the browser says. It chooses the sentence that is said, and nothing else: what a
 * browser can do is asked of the browser.
 */
export interface Platform {
  readonly system: System;
  readonly browser: Browser;
  /** Major version of the browser as its maker counts; null when it is not said. */
  readonly version: number | null;
  /** A phone or a tablet. */
  readonly mobile: boolean;
}

/** As much of `navigator` as tells one browser from another. */
export interface Nameplate {
  readonly userAgent: string;
  readonly userAgentData?: {
    readonly platform?: string;
    readonly brands?: readonly { readonly brand: string }[];
  };
  /** Brave alone has it: its user agent is that of Chrome. */
  readonly brave?: unknown;
  /** An iPad says that it is a Macintosh; only one of the two has a touch screen. */
  readonly maxTouchPoints?: number;
}

/** By what `navigator.userAgentData.platform` calls them. */
const SYSTEMS: Readonly<Record<string, System>> = {
  Windows: 'windows',
  macOS: 'mac',
  Linux: 'linux',
  'Chrome OS': 'chromeos',
  'Chromium OS': 'chromeos',
  Android: 'android',
  iOS: 'ios',
};

/** The first that fits: most browsers name those that they want to be taken for as well. */
const BROWSERS: readonly (readonly [Browser, RegExp])[] = [
  ['other', /SamsungBrowser|YaBrowser|Vivaldi|UCBrowser|DuckDuckGo|MiuiBrowser|HuaweiBrowser|Opera Mini|; wv\)/],
  ['edge', /\bEdg(?:e|A|iOS)?\/(\d+)/],
  ['opera', /\b(?:OPR|OPT|OPX|OPiOS)\/(\d+)/],
  ['firefox', /\b(?:Firefox|FxiOS)\/(\d+)/],
  ['chrome', /\b(?:HeadlessChrome|Chrome|Chromium|CriOS)\/(\d+)/],
  ['safari', /\bVersion\/(\d+).* Safari\//],
];

/** Reads the nameplate of a browser; `navigator` is one. */
export function platformOf(nameplate: Nameplate): Platform {
  const { userAgent, userAgentData, brave } = nameplate;
  const system = systemOf(nameplate);
  const found = BROWSERS.find(([, pattern]) => pattern.test(userAgent));
  const version = found?.[1].exec(userAgent)?.[1];
  const isBrave = brave !== undefined || userAgentData?.brands?.some(({ brand }) => brand === 'Brave');
  return {
    system,
    browser: isBrave ? 'brave' : (found?.[0] ?? 'other'),
    version: version === undefined ? null : Number(version),
    mobile: system === 'android' || system === 'ios',
  };
}

function systemOf({ userAgent, userAgentData, maxTouchPoints = 0 }: Nameplate): System {
  const said = SYSTEMS[userAgentData?.platform ?? ''];
  if (said) return said;
  if (/iPhone|iPad|iPod/.test(userAgent)) return 'ios';
  if (/Macintosh/.test(userAgent)) return maxTouchPoints > 1 ? 'ios' : 'mac';
  if (/Android/.test(userAgent)) return 'android';
  if (/\bCrOS\b/.test(userAgent)) return 'chromeos';
  if (/Windows/.test(userAgent)) return 'windows';
  return /Linux|X11/.test(userAgent) ? 'linux' : 'other';
}

/** Why a browser without Web Serial has none, where its name tells. */
export type UnsupportedReason =
  | 'chrome-old'
  | 'edge-old'
  | 'opera-old'
  | 'brave'
  | 'firefox-old'
  | 'firefox-mobile'
  | 'safari'
  | 'ios'
  | 'android';

/**
 * The first versions that have Web Serial. Every sentence that names one takes it from here; `docs/using-the-page.md`
 * says the same.
 */
export const FIRST_VERSIONS = {
  chrome: 89,
  edge: 89,
  // Opera counts for itself: 75 is Chromium 89.
  opera: 75,
  firefox: 151,
  /** Chrome on Android, in full. */
  android: 148,
  /** Chrome on Android, over Bluetooth only. */
  androidBluetooth: 138,
  /** Android itself, for an adapter on a cable. */
  androidCable: 17,
} as const;

const TOO_OLD = { chrome: 'chrome-old', edge: 'edge-old', opera: 'opera-old', firefox: 'firefox-old' } as const;

/** @returns null when the name does not tell: another browser, or one that should have it. */
export function whyUnsupported({ system, browser, version }: Platform): UnsupportedReason | null {
  if (system === 'ios') return 'ios';
  if (system === 'android') return browser === 'firefox' ? 'firefox-mobile' : 'android';
  if (browser === 'brave') return browser;
  // Safari is on a Mac; on Linux a browser of the same make calls itself so.
  if (browser === 'safari') return system === 'mac' ? 'safari' : null;
  if (browser === 'other' || version === null) return null;
  return version < FIRST_VERSIONS[browser] ? TOO_OLD[browser] : null;
}
