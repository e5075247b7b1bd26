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

/** What to do, one sentence for each step. A step that is not here does not exist: its code is typed from this list. */
const steps = {
  'close-tabs': 'Close other tabs and windows that show this program, or press Disconnect in them.',
  'programs-windows':
    'Close programs that use serial ports: Arduino IDE, PuTTY, Tera Term, RealTerm, CoolTerm, Betaflight Configurator, Cura, PrusaSlicer. Some stay in the corner of the taskbar: end them there or in the Task Manager.',
  'programs-mac':
    'Close programs that use serial ports: Arduino IDE, CoolTerm, Serial, Cura, PrusaSlicer, and a Terminal with “screen” in it.',
  'programs-linux':
    'Close programs that use serial ports: Arduino IDE, minicom, picocom, screen, PuTTY, CuteCom, Cura, PrusaSlicer, OctoPrint.',
  'programs-android': 'Close other apps that use the adapter, such as a serial terminal or a drone configurator.',
  'holder-mac': 'This command in the Terminal names the program that holds a port:',
  'holder-linux': 'This command in a terminal names the program that holds a port:',
  'modem-manager':
    'After plugging in, ModemManager often holds a new port for some seconds to see if it is a modem. This program tries again for 15 seconds by itself; when it has given up, click Connect once more.',
  group:
    'You may not be allowed to use serial ports. On Debian, Ubuntu, Mint, Fedora and openSUSE this command allows it; log out and in again afterwards:',
  'group-arch': 'The same on Arch and Manjaro:',
  'udev-rule':
    'Or allow this kind of adapter only, and keep ModemManager away from it. Run both commands, then plug the adapter in again:',
  'chromium-snap':
    'Chromium from the Ubuntu store (a “snap”) needs to be let through to the adapter; close it and open it again afterwards:',
  'firefox-snap':
    'Firefox from the Ubuntu store (a “snap”) sees no serial ports. Use the one from mozilla.org, or Chrome.',
  'linux-container':
    'The Linux of a Chromebook may have taken the adapter: in the Settings, under Linux development environment, Manage USB devices, switch it off.',
  replug:
    'Unplug the adapter, count to five, plug it in again and click Connect. If that does not help, restart the computer.',
  cable: 'Plug the adapter straight in, without a hub, and try another cable: many USB cables only charge.',
  'drivers-windows':
    'Open the Device Manager. A yellow mark on the adapter means that its driver is missing: CP210x from silabs.com, VCP from ftdichip.com, CH341SER from wch-ic.com (for CH340), PL2303 from prolific.com.tw. Windows Update often brings it, so let the computer online once.',
  'pl2303-windows':
    'Does the Device Manager say “This is not Prolific PL2303”, “Please contact your supplier” or “Code 10”: the chip is a copy or an old one, and the present driver refuses it. Use another adapter.',
  'drivers-mac':
    'Since macOS 11 the drivers for FTDI, CP210x, CH340 and PL2303 are built in. An older macOS needs the one of the maker of the chip.',
  'accessory-mac':
    'A MacBook asks whether an accessory may connect: allow it. It stands in the System Settings under Privacy & Security.',
  'kernel-linux':
    'The drivers are built in. Plug the adapter in; this command tells whether Linux has seen it, as ttyUSB0 or ttyACM0:',
  brltty:
    'Does the adapter vanish again at once: brltty, which is for Braille displays, takes CH340, CP210x and some FTDI adapters for one. If nobody needs a Braille display here, remove it and plug the adapter in again:',
  'android-cable': cableOnAndroid,
  'pair-windows':
    'Over Bluetooth: pair the adapter first, in Settings, Bluetooth & devices. The code is often 1234 or 0000.',
  'pair-mac':
    'Over Bluetooth: pair the adapter first, in System Settings, Bluetooth, and allow Bluetooth for the browser under Privacy & Security. The code is often 1234 or 0000.',
  'pair-linux': 'Over Bluetooth: pair the adapter first, in the Bluetooth settings. The code is often 1234 or 0000.',
  'pair-chromeos': 'Over Bluetooth: pair the adapter first, in Settings, Bluetooth. The code is often 1234 or 0000.',
  'pair-android':
    'Pair the adapter first, in the Bluetooth settings of Android, and let Chrome use nearby devices when it asks. The code is often 1234 or 0000.',
  'firefox-bluetooth': 'Firefox does not list Bluetooth adapters: use Chrome, Edge or Opera for one.',
  'bluetooth-one':
    'A Bluetooth adapter talks to one device at a time: disconnect it from any other phone or computer, or switch Bluetooth off there.',
  'bluetooth-again':
    'Is the adapter switched on, charged and within a few metres? Switch it off and on, wait until it blinks, then click Connect.',
  'usb-power':
    'Does it happen again and again: in the Device Manager, under USB Root Hub, Power Management, do not let the computer switch it off.',
  wake: 'The timer falls asleep after one or two minutes. Press its switch briefly; nothing is lost.',
  near: 'Hold the infra-red head closer than 20 cm, pointed at the timer, and shade both from the sun.',
  battery: 'Is the battery of the timer charged and plugged in? A discharged timer stands at its DT position.',
  'other-port': 'Click Choose a port: another adapter may be plugged in as well.',
  'other-port-waiting':
    'Another adapter may be plugged in as well. Press Stop, then click Choose a port and choose the other one.',
  rate: 'Leave the rate to be found, or choose the one that is right for your adapter. 9600 baud is the likeliest.',
  'rate-waiting':
    'A rate that was set by hand under Serial settings may be wrong for your adapter. Press Stop and click Usual settings there: then the rate is found by asking.',
  'usual-settings':
    'Set 8 data bits, no parity and 1 stop bit: those are the usual ones, and every adapter takes them.',
  report: 'Does it come again with the timer awake and near: copy the report under Line, and tell the maintainers.',
  'ask-again': 'Click Connect again, and allow the port when the browser asks.',
  'site-permission':
    'Is this page among those that may not use serial ports: remove it there. Open this address in a tab:',
  'site-permission-firefox':
    'Firefox adds a small permission for this page when you allow it. What it has added stands here; open this address in a tab:',
  'site-permission-mobile': 'Tap the sign beside the address, then Permissions, and allow serial ports or reset all.',
  managed:
    'A computer of a school or a company may forbid serial ports. If “Serial” stands on this page, only its administrator can change that:',
  'brave-flag': 'Open this address in a tab, and set Web Serial API to Enabled:',
  'brave-relaunch': 'Click Relaunch there, and come back to this page.',
  https: 'Open this address instead:',
  'this-computer':
    'Without https, serial ports work only where the page comes from this computer itself, as http://localhost. Everything but the connection works here too.',
  'own-tab': 'Open this address in a tab of its own, not inside another page:',
  'policy-header': 'For whoever runs the server: if it sends a Permissions-Policy, this allows what is needed:',
  'policy-frame':
    'For whoever shows this page in a frame: the frame needs this attribute. Everything but the connection works here too.',
};

/** What to do, step by step, when a timer cannot be reached. */
export const help = {
  title: 'What to do',
  /** Whose steps are folded up here. */
  on: (system: string) => `On ${system}`,
  systems,
  unsupported,
  steps,
  copy: 'Copy',
  copied: 'Copied',
  /** The browser has no clipboard for us: the text is marked, to be copied by hand. */
  marked: 'Marked',
};
