export type System = 'windows' | 'mac' | 'linux' | 'chromeos' | 'android' | 'ios' | 'other';
export type Browser = 'chrome' | 'edge' | 'opera' | 'brave' | 'firefox' | 'other';

/**
 * The pilot's system and browser, as far as the browser tells. It only chooses sentences. What a browser can do, the
 * page asks the browser itself.
 */
export interface Platform {
  readonly system: System;
  readonly browser: Browser;
  /** Whether it is a phone or a tablet. */
  readonly mobile: boolean;
}

/** The part of `navigator` that tells one browser from another. */
export interface Nameplate {
  readonly userAgent: string;
  readonly userAgentData?: {
    readonly platform?: string;
    readonly brands?: readonly { readonly brand: string }[];
  };
  /** Only Brave has it. Its user agent is that of Chrome. */
  readonly brave?: unknown;
  /** An iPad claims to be a Macintosh, but only the iPad has a touch screen. */
  readonly maxTouchPoints?: number;
}

/** By the names that `navigator.userAgentData.platform` uses. */
const SYSTEMS: Readonly<Record<string, System>> = {
  Windows: 'windows',
  macOS: 'mac',
  Linux: 'linux',
  'Chrome OS': 'chromeos',
  'Chromium OS': 'chromeos',
  Android: 'android',
  iOS: 'ios',
};

/** The first match counts: most browsers also name those that they imitate. */
const BROWSERS: readonly (readonly [Browser, RegExp])[] = [
  ['other', /SamsungBrowser|YaBrowser|Vivaldi|UCBrowser|DuckDuckGo|MiuiBrowser|HuaweiBrowser|Opera Mini|; wv\)/],
  ['edge', /\bEdg(?:e|A|iOS)?\//],
  ['opera', /\b(?:OPR|OPT|OPX|OPiOS)\//],
  ['firefox', /\b(?:Firefox|FxiOS)\//],
  ['chrome', /\b(?:HeadlessChrome|Chrome|Chromium|CriOS)\//],
];

/** Reads these properties of a browser, such as `navigator`. */
export function platformOf(nameplate: Nameplate): Platform {
  const { userAgent, userAgentData, brave } = nameplate;
  const system = systemOf(nameplate);
  const isBrave = brave !== undefined || userAgentData?.brands?.some(({ brand }) => brand === 'Brave');
  return {
    system,
    browser: isBrave ? 'brave' : (BROWSERS.find(([, pattern]) => pattern.test(userAgent))?.[0] ?? 'other'),
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

/** Why a browser has no Web Serial, where its name tells more than that. */
export type UnsupportedReason = 'brave' | 'ios' | 'android';

/** @returns null when the name does not tell: an old browser, an unknown one, or one that should have it. */
export function whyUnsupported({ system, browser }: Platform): UnsupportedReason | null {
  if (system === 'ios' || system === 'android') return system;
  return browser === 'brave' ? browser : null;
}
