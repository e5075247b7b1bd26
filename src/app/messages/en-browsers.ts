import { FIRST_VERSIONS } from '../browser/platform.js';

/** For a page that cannot reach a timer here. */
export const restWorks = 'Everything but the connection works here too.';

/** What an Android phone needs. */
export const android = `Chrome ${FIRST_VERSIONS.android} or later (${FIRST_VERSIONS.androidBluetooth} to ${FIRST_VERSIONS.android - 1} over Bluetooth only); a cable needs Android ${FIRST_VERSIONS.androidCable}`;

/** For every browser about which nothing more is known. docs/connection.md names the first versions. */
export const unsupportedHere = {
  title: 'This browser cannot reach a timer.',
  advice: `On a computer use a current Chrome, Edge, Opera or Firefox; on a phone, Chrome on Android. ${restWorks}`,
};

/** Replaces the sentence above where the browser's name tells more. */
export const unsupported = {
  brave: {
    title: 'Brave reaches a timer only when you allow it.',
    advice: `Open brave://flags/#brave-web-serial-api, set it to Enabled and press Relaunch. ${restWorks}`,
  },
  ios: {
    title: 'No browser on an iPhone or iPad can reach a timer.',
    advice: `Use a computer, or Chrome on an Android phone. ${restWorks}`,
  },
  android: {
    title: unsupportedHere.title,
    advice: `On Android, use ${android}. ${restWorks}`,
  },
};
