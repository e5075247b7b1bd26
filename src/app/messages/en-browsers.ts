import { FIRST_VERSIONS, type UnsupportedReason } from '../browser/platform.js';
import type { Said } from './en-notices.js';

const restWorks = 'Everything but the connection works here too.';

/** What an Android phone needs. */
const android = `Chrome ${FIRST_VERSIONS.android} or later (${FIRST_VERSIONS.androidBluetooth} to ${FIRST_VERSIONS.android - 1} over Bluetooth only); a cable needs Android ${FIRST_VERSIONS.androidCable}`;

/** What a phone needs for an adapter on a cable. */
export const cableOnAndroid = `An adapter on a cable needs Android ${FIRST_VERSIONS.androidCable} and Chrome ${FIRST_VERSIONS.android} or later. Without them, use a Bluetooth adapter or a computer.`;

/** Where a timer can be reached. For every browser about which nothing more is known. */
export const unsupportedHere: Said = {
  title: 'This browser cannot reach a timer.',
  advice: `On a computer, use Chrome or Edge ${FIRST_VERSIONS.chrome}, Opera ${FIRST_VERSIONS.opera}, Firefox ${FIRST_VERSIONS.firefox}, or a later version. On Android, use ${android}. ${restWorks}`,
};

function tooOld(name: string, first: number, more = ''): Said {
  return {
    title: `This ${name} is too old to reach a timer.`,
    advice: `Update it to version ${first} or later${more}. ${restWorks}`,
  };
}

/** Replaces the sentence above where the browser's name tells more. */
export const unsupported: Record<UnsupportedReason, Said> = {
  'chrome-old': tooOld('Chrome', FIRST_VERSIONS.chrome),
  'edge-old': tooOld('Edge', FIRST_VERSIONS.edge),
  'opera-old': tooOld('Opera', FIRST_VERSIONS.opera),
  brave: {
    title: 'Brave reaches a timer only when you allow it.',
    advice: `Switch its Web Serial on, as told below, or use Chrome or Edge. ${restWorks}`,
  },
  'firefox-old': tooOld(
    'Firefox',
    FIRST_VERSIONS.firefox,
    '. It then asks once to add a permission for this page. It reaches adapters on a cable, but none over Bluetooth',
  ),
  'firefox-mobile': {
    title: 'Firefox on Android cannot reach a timer.',
    advice: `Use ${android}. Or use a computer. ${restWorks}`,
  },
  safari: {
    title: 'Safari cannot reach a timer.',
    advice: `Use Chrome, Edge or Firefox (${FIRST_VERSIONS.firefox} or later) on this Mac. ${restWorks}`,
  },
  ios: {
    title: 'No browser on an iPhone or iPad can reach a timer.',
    advice: `Use a computer, or an Android phone with ${android}. ${restWorks}`,
  },
  android: {
    title: 'This browser cannot reach a timer.',
    advice: `On Android, use ${android}. ${restWorks}`,
  },
};
