import { android, restWorks } from './en-browsers.js';
import { link } from './en-link.js';

const { steps: waiting } = link.stages;

/** One sentence for each step. Its code exists only by standing in this list. */
const steps = {
  programs:
    'Close other tabs and programs that use the adapter, such as Arduino IDE, PuTTY, a 3D printer program or a drone configurator.',
  replug: 'Unplug the adapter, wait five seconds, plug it in again. If that does not help, restart the computer.',
  cable: 'Plug the adapter in directly, without a hub, and try another cable. Many USB cables only charge.',
  windows:
    'Windows: open the Device Manager. A yellow mark on the adapter means that its driver is missing: connect to the internet and run Windows Update.',
  mac: 'Mac: allow the accessory when the Mac asks. An old macOS needs the driver of the maker.',
  linux: 'Linux may not let you use the adapter. Run this, then log out and in again.',
  'linux-container':
    'The Linux of a Chromebook may have taken the adapter. Switch the adapter off in the Settings, under Linux development environment, Manage USB devices.',
  android: `On Android, use ${android}. ${restWorks}`,
  bluetooth:
    'Bluetooth: pair the adapter in the settings of the system (code 1234 or 0000), keep it on and near, and switch Bluetooth off on other devices that use it.',
  'firefox-finds':
    'Firefox finds no Bluetooth adapters, and none at all when it comes from the Ubuntu store. Use Chrome.',
  'firefox-reload': 'Firefox keeps an adapter that has failed. Load this page again. What you typed is kept.',
  switch: waiting.switch,
  near: waiting.near,
  battery:
    'Is the battery of the timer charged and plugged in? When its battery is empty, a timer stands at its DT position.',
  restarts:
    'Some adapters restart each time their port is opened (DTR resets them), and hear nothing for some seconds. If yours does, set its rate in Settings, “Serial settings”: then the port is opened only once. The page itself leaves DTR as the browser sets it.',
  'usual-settings':
    'Open Settings, “Serial settings”, and press “Usual settings”: the page then finds the rate by itself.',
  report: 'If it happens again: Settings, Expert, Line, “Copy report”. Send it to:',
  address: 'Open this address in a tab:',
};

/** What to do, step by step, when a timer cannot be reached. */
export const help = {
  title: 'What to do',
  steps,
  /** The link to the steps for every system: docs/connection.md. */
  page: 'All steps, for every system',
};
