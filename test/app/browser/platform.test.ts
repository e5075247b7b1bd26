import { describe, expect, it } from 'vitest';
import {
  type Browser,
  type Nameplate,
  platformOf,
  type System,
  type UnsupportedReason,
  whyUnsupported,
} from '../../../src/app/browser/platform.js';

const WEBKIT = 'AppleWebKit/537.36 (KHTML, like Gecko)';
const WINDOWS = 'Mozilla/5.0 (Windows NT 10.0; Win64; x64)';
const MAC = 'Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7)';
const LINUX = 'Mozilla/5.0 (X11; Linux x86_64)';
const CHROMEOS = 'Mozilla/5.0 (X11; CrOS x86_64 14541.0.0)';
const ANDROID = 'Mozilla/5.0 (Linux; Android 10; K)';
const IPHONE = 'Mozilla/5.0 (iPhone; CPU iPhone OS 18_5 like Mac OS X)';
const IPAD = 'Mozilla/5.0 (iPad; CPU OS 18_5 like Mac OS X)';
const IOS_WEBKIT = 'AppleWebKit/605.1.15 (KHTML, like Gecko)';

type Row = readonly [System, Browser, number | null, UnsupportedReason | null, string, Omit<Nameplate, 'userAgent'>?];

const rows: readonly Row[] = [
  ['windows', 'chrome', 138, null, `${WINDOWS} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36`],
  ['windows', 'chrome', 88, null, `${WINDOWS} ${WEBKIT} Chrome/88.0.4324.190 Safari/537.36`],
  ['windows', 'chrome', 89, null, `${WINDOWS} ${WEBKIT} Chrome/89.0.4389.72 Safari/537.36`],
  ['windows', 'edge', 138, null, `${WINDOWS} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36 Edg/138.0.0.0`],
  ['windows', 'edge', 88, null, `${WINDOWS} ${WEBKIT} Chrome/88.0.4324.182 Safari/537.36 Edg/88.0.705.81`],
  ['windows', 'edge', 18, null, `${WINDOWS} ${WEBKIT} Chrome/64.0.3282.140 Safari/537.36 Edge/18.17763`],
  ['windows', 'opera', 120, null, `${WINDOWS} ${WEBKIT} Chrome/135.0.0.0 Safari/537.36 OPR/120.0.0.0`],
  ['windows', 'opera', 74, null, `${WINDOWS} ${WEBKIT} Chrome/88.0.4324.192 Safari/537.36 OPR/74.0.3911.232`],
  ['windows', 'opera', 75, null, `${WINDOWS} ${WEBKIT} Chrome/89.0.4389.128 Safari/537.36 OPR/75.0.3969.218`],
  ['windows', 'brave', 138, 'brave', `${WINDOWS} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36`, { brave: {} }],
  [
    'windows',
    'brave',
    138,
    'brave',
    `${WINDOWS} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36`,
    { userAgentData: { platform: 'Windows', brands: [{ brand: 'Not)A;Brand' }, { brand: 'Brave' }] } },
  ],
  ['windows', 'firefox', 152, null, 'Mozilla/5.0 (Windows NT 10.0; Win64; x64; rv:152.0) Gecko/20100101 Firefox/152.0'],
  ['windows', 'firefox', 140, null, 'Mozilla/5.0 (Windows NT 10.0; Win64; x64; rv:140.0) Gecko/20100101 Firefox/140.0'],
  ['windows', 'other', null, null, `${WINDOWS} ${WEBKIT} Chrome/134.0.0.0 YaBrowser/25.4.0.0 Safari/537.36`],
  ['mac', 'chrome', 138, null, `${MAC} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36`, { maxTouchPoints: 0 }],
  ['mac', 'edge', 138, null, `${MAC} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36 Edg/138.0.0.0`],
  ['mac', 'opera', 120, null, `${MAC} ${WEBKIT} Chrome/135.0.0.0 Safari/537.36 OPR/120.0.0.0`],
  ['mac', 'brave', 138, 'brave', `${MAC} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36`, { brave: {} }],
  ['mac', 'firefox', 150, null, 'Mozilla/5.0 (Macintosh; Intel Mac OS X 10.15; rv:150.0) Gecko/20100101 Firefox/150.0'],
  ['mac', 'firefox', 151, null, 'Mozilla/5.0 (Macintosh; Intel Mac OS X 10.15; rv:151.0) Gecko/20100101 Firefox/151.0'],
  ['linux', 'safari', 18, null, `Mozilla/5.0 (X11; Linux x86_64) ${IOS_WEBKIT} Version/18.5 Safari/605.1.15`],
  ['mac', 'safari', 18, null, `${MAC} ${IOS_WEBKIT} Version/18.5 Safari/605.1.15`, { maxTouchPoints: 0 }],
  ['linux', 'chrome', 138, null, `${LINUX} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36`],
  ['linux', 'chrome', 85, null, `${LINUX} ${WEBKIT} Ubuntu Chromium/85.0.4183.83 Chrome/85.0.4183.83 Safari/537.36`],
  ['linux', 'edge', 138, null, `${LINUX} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36 Edg/138.0.0.0`],
  ['linux', 'firefox', 152, null, 'Mozilla/5.0 (X11; Linux x86_64; rv:152.0) Gecko/20100101 Firefox/152.0'],
  ['linux', 'firefox', 140, null, 'Mozilla/5.0 (X11; Ubuntu; Linux x86_64; rv:140.0) Gecko/20100101 Firefox/140.0'],
  ['linux', 'other', null, null, `${LINUX} ${WEBKIT} Chrome/105.0.0.0 Safari/537.36 Vivaldi/5.4`],
  ['chromeos', 'chrome', 138, null, `${CHROMEOS} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36`],
  [
    'chromeos',
    'chrome',
    138,
    null,
    `${LINUX} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36`,
    { userAgentData: { platform: 'Chrome OS', brands: [{ brand: 'Chromium' }] } },
  ],
  ['android', 'chrome', 137, 'android', `${ANDROID} ${WEBKIT} Chrome/137.0.0.0 Mobile Safari/537.36`],
  ['android', 'edge', 137, 'android', `${ANDROID} ${WEBKIT} Chrome/137.0.0.0 Mobile Safari/537.36 EdgA/137.0.0.0`],
  ['android', 'opera', 89, 'android', `${ANDROID} ${WEBKIT} Chrome/135.0.0.0 Mobile Safari/537.36 OPR/89.0.0.0`],
  ['android', 'brave', 138, 'android', `${ANDROID} ${WEBKIT} Chrome/138.0.0.0 Mobile Safari/537.36`, { brave: {} }],
  [
    'android',
    'other',
    null,
    'android',
    `${ANDROID} ${WEBKIT} SamsungBrowser/28.0 Chrome/130.0.0.0 Mobile Safari/537.36`,
  ],
  [
    'android',
    'other',
    null,
    'android',
    `Mozilla/5.0 (Linux; Android 15; Pixel 8; wv) ${WEBKIT} Version/4.0 Chrome/138.0.0.0 Mobile Safari/537.36`,
  ],
  ['android', 'firefox', 152, 'android', 'Mozilla/5.0 (Android 15; Mobile; rv:152.0) Gecko/152.0 Firefox/152.0'],
  [
    'android',
    'chrome',
    138,
    'android',
    `${LINUX} ${WEBKIT} Chrome/138.0.0.0 Safari/537.36`,
    { userAgentData: { platform: 'Android' }, maxTouchPoints: 5 },
  ],
  ['ios', 'safari', 18, 'ios', `${IPHONE} ${IOS_WEBKIT} Version/18.5 Mobile/15E148 Safari/604.1`],
  ['ios', 'chrome', 138, 'ios', `${IPHONE} ${IOS_WEBKIT} CriOS/138.0.7204.53 Mobile/15E148 Safari/604.1`],
  ['ios', 'firefox', 152, 'ios', `${IPHONE} ${IOS_WEBKIT} FxiOS/152.0 Mobile/15E148 Safari/605.1.15`],
  ['ios', 'edge', 138, 'ios', `${IPAD} ${IOS_WEBKIT} Version/18.0 EdgiOS/138.0.3351.65 Mobile/15E148 Safari/605.1.15`],
  ['ios', 'safari', 18, 'ios', `${MAC} ${IOS_WEBKIT} Version/18.5 Safari/605.1.15`, { maxTouchPoints: 5 }],
  ['other', 'firefox', 152, null, 'Mozilla/5.0 (Nintendo; rv:152.0) Gecko/20100101 Firefox/152.0'],
  ['other', 'other', null, null, ''],
];

describe('platformOf', () => {
  it.each(
    rows.map(([system, browser, version, reason, userAgent, more]) => ({
      system,
      browser,
      version,
      reason,
      userAgent,
      more,
    })),
  )(
    '$system, $browser $version, without Web Serial because of $reason: $userAgent $more',
    ({ system, browser, version, reason, userAgent, more }) => {
      const platform = platformOf({ ...more, userAgent });
      expect(platform).toEqual({ system, browser, version, mobile: system === 'android' || system === 'ios' });
      expect(whyUnsupported(platform)).toBe(reason);
    },
  );

  it('reads the nameplate of the browser that runs this', () => {
    expect(platformOf(navigator).system).not.toBe('other');
  });
});
