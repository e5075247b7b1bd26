import type { System } from '../browser/platform.js';
import { cableOnAndroid, unsupported } from './en-browsers.js';

const systems: Record<System, string> = {
  windows: 'Windows',
  mac: 'macOS',
  linux: 'Linux',
  chromeos: 'ChromeOS',
  android: 'Android',
  ios: 'iPhone and iPad',
  other: 'another system',
};

/** One sentence for each step. Its code exists only by standing in this list. */
const steps = {
  'close-tabs': 'Close other tabs and windows that show this page, or press Disconnect in them.',
  'programs-windows':
    'Close programs that use serial ports: Arduino IDE, PuTTY, Tera Term, RealTerm, CoolTerm, Betaflight Configurator, Cura, PrusaSlicer. Some go on running after you close their window: end them in the corner of the taskbar or in the Task Manager.',
  'programs-mac':
    'Close programs that use serial ports: Arduino IDE, CoolTerm, Serial, Cura, PrusaSlicer, and a Terminal that runs “screen”.',
  'programs-linux':
    'Close programs that use serial ports: Arduino IDE, minicom, picocom, screen, PuTTY, CuteCom, Cura, PrusaSlicer, OctoPrint.',
  'programs-android': 'Close other apps that use the adapter, such as a serial terminal or a drone configurator.',
  'holder-mac': 'This command in the Terminal names the program that holds a port:',
  'holder-linux': 'This command in a terminal names the program that holds a port:',
  'modem-manager':
    'ModemManager often holds a new adapter for some seconds, to see whether it is a modem. This page tries again for 15 seconds. When it has given up, press Connect again.',
  group:
    'Linux may not let you use serial ports. On Debian, Ubuntu, Mint, Fedora and openSUSE this command allows it. Log out and in again afterwards:',
  'group-arch': 'On Arch and Manjaro use this one:',
  'udev-rule':
    'Or allow only this kind of adapter, and keep ModemManager away from it. Run both commands, then unplug the adapter and plug it in again:',
  'chromium-snap':
    'Chromium from the Ubuntu store (a “snap”) needs a permission to reach the adapter. Run this, then close Chromium and open it again:',
  'firefox-snap':
    'Firefox from the Ubuntu store (a “snap”) sees no serial ports. Use the one from mozilla.org, or Chrome.',
  'linux-container':
    'The Linux of a Chromebook may have taken the adapter. Switch the adapter off in the Settings, under Linux development environment, Manage USB devices.',
  replug:
    'Unplug the adapter, wait five seconds, plug it in again and press Connect. If that does not help, restart the computer.',
  cable: 'Plug the adapter in directly, without a hub, and try another cable. Many USB cables only charge.',
  'drivers-windows':
    'Open the Device Manager. A yellow mark on the adapter means that its driver is missing. Connect the computer to the internet: Windows Update often brings the driver. The makers have it, too: CP210x at silabs.com, VCP at ftdichip.com, CH341SER (for CH340) at wch-ic.com, PL2303 at prolific.com.tw.',
  'pl2303-windows':
    'If the Device Manager says “This is not Prolific PL2303”, “Please contact your supplier” or “Code 10”, the chip is a copy or an old one, and the driver refuses it. Use another adapter.',
  'drivers-mac':
    'macOS 11 and later have the drivers for FTDI, CP210x, CH340 and PL2303 built in. For an older macOS, get the driver from the maker of the chip.',
  'accessory-mac':
    'A MacBook asks whether an accessory may connect: allow it. The setting is in System Settings, under Privacy & Security.',
  'kernel-linux':
    'The drivers are built in. Plug the adapter in. This command shows whether Linux has seen it, as ttyUSB0 or ttyACM0:',
  brltty:
    'If the adapter disappears at once, brltty may have taken it. That program is for Braille displays. It mistakes CH340, CP210x and some FTDI adapters for such a display. If nobody needs a Braille display here, remove brltty, then unplug the adapter and plug it in again:',
  'android-cable': cableOnAndroid,
  'pair-windows':
    'Over Bluetooth: pair the adapter first, in Settings, Bluetooth & devices. The code is often 1234 or 0000.',
  'pair-mac':
    'Over Bluetooth: pair the adapter first, in System Settings, Bluetooth, and allow Bluetooth for the browser under Privacy & Security. The code is often 1234 or 0000.',
  'pair-linux': 'Over Bluetooth: pair the adapter first, in the Bluetooth settings. The code is often 1234 or 0000.',
  'pair-chromeos': 'Over Bluetooth: pair the adapter first, in Settings, Bluetooth. The code is often 1234 or 0000.',
  'pair-android':
    'Pair the adapter first, in the Bluetooth settings of Android, and let Chrome use nearby devices when it asks. The code is often 1234 or 0000.',
  'firefox-reload':
    'Firefox keeps the port of an adapter that has failed. If the connection does not come back by itself, load this page again. What you typed is kept.',
  'firefox-bluetooth': 'Firefox does not list Bluetooth adapters. Use Chrome, Edge or Opera for them.',
  'bluetooth-one':
    'A Bluetooth adapter talks to one device at a time. Disconnect it from any other phone or computer, or switch Bluetooth off there.',
  'bluetooth-again':
    'Is the adapter switched on, charged, and not more than a few metres away? Switch it off and on, wait until it blinks, then press Connect.',
  'usb-power':
    'If it happens again and again, open the Device Manager, USB Root Hub, Power Management. There, clear the box that lets the computer turn the device off.',
  wake: 'The timer falls asleep after one or two minutes. Press its switch briefly. Nothing is lost.',
  near: 'Hold the infrared head closer than 20\u00a0cm, pointed at the timer, and shade both from the sun.',
  battery:
    'Is the battery of the timer charged and plugged in? When its battery is empty, a timer stands at its DT position.',
  'other-port': 'Press “Choose a port”: the timer may be on another adapter.',
  'other-port-waiting': 'The timer may be on another adapter. Press “Choose another port”.',
  rate: 'Let this page find the rate, or choose the rate of your adapter. 9600 baud is the most likely.',
  'rate-waiting':
    'You have set a rate, and it may be wrong for your adapter. Press Stop, open Settings, “Serial settings”, and press “Usual settings”. Then connect again: the page finds the rate by itself.',
  restarts:
    'Some adapters restart each time their port is opened (DTR resets them), and hear nothing for some seconds. If yours does, set its rate in Settings, “Serial settings”: then the port is opened only once. The page itself leaves DTR as the browser sets it.',
  'usual-settings':
    'Open Settings, “Serial settings”, and press “Usual settings”: 8 data bits, no parity and 1 stop bit. Every adapter takes them.',
  report:
    'If it happens again with the timer awake and near: switch Expert on in the settings, open Line and press “Copy report”. Send the report to the maintainers, at this address:',
  'ask-again': 'Press Connect again, and allow the port when the browser asks.',
  'site-permission':
    'This address lists the pages that may not use serial ports. Open it in a tab. If this page is in the list, remove it:',
  'site-permission-firefox':
    'When you allow it, Firefox adds a small permission for this page. To see what it has added, open this address in a tab:',
  'site-permission-mobile':
    'Tap the icon beside the address, then Permissions. Allow serial ports, or reset all permissions.',
  managed:
    'A school or a company may forbid serial ports on its computers. If “Serial” is listed at this address, only the administrator can change that:',
  'brave-flag': 'Open this address in a tab, and set Web Serial API to Enabled:',
  'brave-relaunch': 'Press Relaunch there, and come back to this page.',
  https: 'Open this address instead:',
  'this-computer':
    'Without https, serial ports work only where the page comes from this computer itself, as http://localhost. Everything but the connection works here too.',
  'own-tab': 'Open this address in its own tab, not inside another page:',
  'policy-header': 'For the owner of the server: if it sends a Permissions-Policy, this one allows serial ports:',
  'policy-frame':
    'For the owner of the page around this one: its frame needs this attribute. Everything but the connection works here too.',
};

/** What to do, step by step, when a timer cannot be reached. */
export const help = {
  title: 'What to do',
  /** Below the steps for a timer that does not answer. */
  titleStill: 'If it still does not answer',
  /** The heading over the folded steps of another system. */
  on: (system: string) => `On ${system}`,
  systems,
  unsupported,
  steps,
  copy: 'Copy',
  copied: 'Copied',
  /** The browser has no clipboard for this page. The text is selected, so that the pilot can copy it. */
  marked: 'Marked',
};
