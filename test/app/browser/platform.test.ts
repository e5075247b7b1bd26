import { expect, it } from 'vitest';
import {
  type Browser,
  type Nameplate,
  platformOf,
  type System,
  type UnsupportedReason,
  whyUnsupported,
} from '../../../src/app/browser/platform.js';

const WINDOWS = 'Mozilla/5.0 (Windows NT 10.0; Win64; x64) AppleWebKit/537.36 (KHTML, like Gecko)';
const MAC = 'Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7) AppleWebKit/537.36 (KHTML, like Gecko)';
const LINUX = 'Mozilla/5.0 (X11; Linux x86_64) AppleWebKit/537.36 (KHTML, like Gecko)';
const ANDROID = 'Mozilla/5.0 (Linux; Android 10; K) AppleWebKit/537.36 (KHTML, like Gecko)';
const IPHONE = 'Mozilla/5.0 (iPhone; CPU iPhone OS 18_5 like Mac OS X) AppleWebKit/605.1.15 (KHTML, like Gecko)';
const IPAD = 'Mozilla/5.0 (iPad; CPU OS 18_5 like Mac OS X) AppleWebKit/605.1.15 (KHTML, like Gecko)';
const CHROME = 'Chrome/138.0.0.0 Safari/537.36';
const PHONE = 'Chrome/137.0.0.0 Mobile Safari/537.36';
const SAFARI = 'Version/18.5 Safari/605.1.15';

it.each<[System, Browser, UnsupportedReason | null, string, Omit<Nameplate, 'userAgent'>?]>([
  ['windows', 'chrome', null, `${WINDOWS} ${CHROME}`],
  ['windows', 'edge', null, `${WINDOWS} ${CHROME} Edg/138.0.0.0`],
  ['windows', 'edge', null, `${WINDOWS} ${CHROME} Edge/18.17763`],
  ['windows', 'opera', null, `${WINDOWS} ${CHROME} OPR/120.0.0.0`],
  ['windows', 'brave', 'brave', `${WINDOWS} ${CHROME}`, { brave: {} }],
  [
    'windows',
    'brave',
    'brave',
    `${WINDOWS} ${CHROME}`,
    { userAgentData: { platform: 'Windows', brands: [{ brand: 'Not)A;Brand' }, { brand: 'Brave' }] } },
  ],
  ['windows', 'firefox', null, 'Mozilla/5.0 (Windows NT 10.0; Win64; x64; rv:152.0) Gecko/20100101 Firefox/152.0'],
  ['windows', 'other', null, `${WINDOWS} Chrome/134.0.0.0 YaBrowser/25.4.0.0 Safari/537.36`],
  ['mac', 'chrome', null, `${MAC} ${CHROME}`, { maxTouchPoints: 0 }],
  ['mac', 'other', null, `${MAC} ${SAFARI}`, { maxTouchPoints: 0 }],
  ['linux', 'chrome', null, `${LINUX} Ubuntu Chromium/85.0.4183.83 Chrome/85.0.4183.83 Safari/537.36`],
  ['linux', 'firefox', null, 'Mozilla/5.0 (X11; Ubuntu; Linux x86_64; rv:140.0) Gecko/20100101 Firefox/140.0'],
  ['linux', 'other', null, `${LINUX} ${CHROME} Vivaldi/5.4`],
  ['chromeos', 'chrome', null, `Mozilla/5.0 (X11; CrOS x86_64 14541.0.0) AppleWebKit/537.36 ${CHROME}`],
  ['chromeos', 'chrome', null, `${LINUX} ${CHROME}`, { userAgentData: { platform: 'Chrome OS' } }],
  ['android', 'chrome', 'android', `${ANDROID} ${PHONE}`],
  ['android', 'edge', 'android', `${ANDROID} ${PHONE} EdgA/137.0.0.0`],
  ['android', 'opera', 'android', `${ANDROID} ${PHONE} OPR/89.0.0.0`],
  ['android', 'brave', 'android', `${ANDROID} ${PHONE}`, { brave: {} }],
  ['android', 'other', 'android', `${ANDROID} SamsungBrowser/28.0 ${PHONE}`],
  ['android', 'other', 'android', `Mozilla/5.0 (Linux; Android 15; Pixel 8; wv) Version/4.0 ${PHONE}`],
  ['android', 'firefox', 'android', 'Mozilla/5.0 (Android 15; Mobile; rv:152.0) Gecko/152.0 Firefox/152.0'],
  ['android', 'chrome', 'android', `${LINUX} ${CHROME}`, { userAgentData: { platform: 'Android' }, maxTouchPoints: 5 }],
  ['ios', 'other', 'ios', `${IPHONE} Version/18.5 Mobile/15E148 Safari/604.1`],
  ['ios', 'chrome', 'ios', `${IPHONE} CriOS/138.0.7204.53 Mobile/15E148 Safari/604.1`],
  ['ios', 'firefox', 'ios', `${IPHONE} FxiOS/152.0 Mobile/15E148 Safari/605.1.15`],
  ['ios', 'edge', 'ios', `${IPAD} Version/18.0 EdgiOS/138.0.3351.65 Mobile/15E148 Safari/605.1.15`],
  ['ios', 'other', 'ios', `${MAC} ${SAFARI}`, { maxTouchPoints: 5 }],
  ['other', 'firefox', null, 'Mozilla/5.0 (Nintendo; rv:152.0) Gecko/20100101 Firefox/152.0'],
  ['other', 'other', null, ''],
])('%s, %s, without Web Serial because of %s: %s %o', (system, browser, reason, userAgent, more) => {
  const platform = platformOf({ ...more, userAgent });
  expect(platform).toEqual({ system, browser, mobile: system === 'android' || system === 'ios' });
  expect(whyUnsupported(platform)).toBe(reason);
});
