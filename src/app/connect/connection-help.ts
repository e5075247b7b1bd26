import type { ConnectionErrorCode, PortInfo } from '../../serial/index.js';
import type { Browser, Platform, System } from '../browser/platform.js';
import type { Messages } from '../messages/index.js';

/**
 * What there is help for: a connection that failed, or a timer that does not answer; `still-waiting` where the first
 * steps are shown already.
 */
export type HelpCode = ConnectionErrorCode | 'waiting' | 'still-waiting';

/** Where the help is needed: the same problem has other causes on another system. */
export interface Situation {
  readonly platform: Platform;
  /** The port; null when there is none, or none is known. */
  readonly info: PortInfo | null;
  /** The address of this page. */
  readonly address: string;
  /** Whether the pilot has set a rate. */
  readonly rateSet: boolean;
}

/** One thing to do. messages/ has its sentence under this code. */
export type HelpStepCode = keyof Messages['help']['steps'];

/** Where a pilot reports what went wrong. */
const ISSUES = 'https://github.com/sidus-timer/sidus-timer/issues';

/** Lines to copy that belong to some steps. A step is left out when its lines cannot be made here. */
const COMMANDS: Partial<Readonly<Record<HelpStepCode, (situation: Situation) => readonly string[] | null>>> = {
  'holder-mac': () => ['lsof /dev/cu.*'],
  'holder-linux': () => ['sudo fuser -v /dev/ttyUSB* /dev/ttyACM*'],
  group: () => ['sudo usermod -a -G dialout $USER'],
  'group-arch': () => ['sudo usermod -a -G uucp $USER'],
  'udev-rule': ({ info }) => udevCommands(info),
  'chromium-snap': () => ['sudo snap connect chromium:raw-usb'],
  'kernel-linux': () => ['sudo dmesg | grep -i tty | tail'],
  brltty: () => ['sudo apt remove brltty'],
  'site-permission': ({ platform }) => settingsPage(platform.browser, 'settings/content/serialPorts'),
  'site-permission-firefox': () => ['about:addons'],
  managed: ({ platform }) => settingsPage(platform.browser, 'policy'),
  'brave-flag': () => ['brave://flags/#brave-web-serial-api'],
  https: ({ address }) => httpsAddress(address),
  'own-tab': ({ address }) => [address],
  'policy-header': () => ['Permissions-Policy: serial=(self)'],
  'policy-frame': () => ['allow="serial"'],
  report: () => [ISSUES],
};

/** The steps for every system, before and after those for each system. */
interface Plan {
  readonly first?: readonly HelpStepCode[];
  readonly systems?: Partial<Readonly<Record<System, readonly HelpStepCode[]>>>;
  readonly last?: readonly HelpStepCode[];
}

const BLUETOOTH: Plan = { first: ['bluetooth-one', 'bluetooth-again'] };

/** The steps for Firefox with a port that has failed. */
function firefoxPorts({ browser, mobile }: Platform): readonly HelpStepCode[] {
  return browser === 'firefox' && !mobile ? ['firefox-reload'] : [];
}

/** A rate that the pilot has set may be wrong. To find one, the page opens the port again and again. */
function setRate({ rateSet, info }: Situation): readonly HelpStepCode[] {
  if (rateSet) return ['rate-waiting'];
  // Over Bluetooth there is one rate, and one opening.
  return isBluetooth(info) ? [] : ['restarts'];
}

/** Browsers that Ubuntu installs as snaps, which keep them from serial ports. */
const SNAPS: Partial<Readonly<Record<Browser, readonly HelpStepCode[]>>> = {
  chrome: ['chromium-snap'],
  firefox: ['firefox-snap'],
};

const PLANS: Readonly<Record<HelpCode, (situation: Situation) => Plan>> = {
  unsupported: ({ platform: { browser, mobile } }) =>
    browser === 'brave' && !mobile ? { first: ['brave-flag', 'brave-relaunch'] } : {},
  insecure: () => ({ first: ['https', 'this-computer'] }),
  policy: () => ({ first: ['own-tab', 'policy-header', 'policy-frame'] }),
  'nothing-chosen': ({ platform }) => ({
    first: platform.mobile ? [] : ['cable'],
    systems: {
      windows: ['drivers-windows', 'pl2303-windows', 'pair-windows'],
      mac: ['accessory-mac', 'drivers-mac', 'pair-mac'],
      linux: ['kernel-linux', 'brltty', ...(SNAPS[platform.browser] ?? []), 'pair-linux'],
      chromeos: ['linux-container', 'pair-chromeos'],
      android: ['pair-android', 'android-cable'],
    },
    last: platform.browser === 'firefox' ? ['firefox-bluetooth'] : [],
  }),
  'not-allowed': ({ platform: { browser, mobile } }) => {
    if (mobile) return { first: ['ask-again', 'site-permission-mobile'] };
    if (browser === 'firefox') return { first: ['ask-again', 'site-permission-firefox'] };
    return { first: ['ask-again', 'site-permission', 'managed'] };
  },
  busy: ({ platform, info }) =>
    isBluetooth(info)
      ? { ...BLUETOOTH, last: ['close-tabs'] }
      : {
          first: ['close-tabs'],
          systems: {
            windows: ['programs-windows'],
            mac: ['programs-mac', 'holder-mac'],
            linux: [
              'modem-manager',
              'programs-linux',
              'holder-linux',
              'group',
              'group-arch',
              'udev-rule',
              ...(platform.browser === 'chrome' ? (['chromium-snap'] as const) : []),
            ],
            chromeos: ['linux-container'],
            android: ['programs-android'],
          },
          last: ['replug', ...firefoxPorts(platform)],
        },
  'bad-settings': () => ({ first: ['rate', 'usual-settings'] }),
  unplugged: ({ platform, info }) =>
    isBluetooth(info)
      ? BLUETOOTH
      : {
          first: ['cable'],
          systems: { linux: ['brltty'], chromeos: ['linux-container'] },
          last: firefoxPorts(platform),
        },
  waiting: (here) => ({ first: ['wake', 'near', 'battery', 'other-port-waiting', ...setRate(here)] }),
  'still-waiting': (here) => ({ first: ['battery', ...setRate(here)] }),
  'bad-reply': () => ({ first: ['near', 'other-port', 'rate', 'report'] }),
  lost: ({ platform, info }) =>
    isBluetooth(info)
      ? BLUETOOTH
      : {
          first: ['cable'],
          systems: { windows: ['usb-power'], linux: ['brltty'] },
          last: firefoxPorts(platform),
        },
};

/** One thing to do, with the lines to copy that it mentions. */
export interface HelpStep {
  readonly code: HelpStepCode;
  readonly copy: readonly string[];
}

export interface ConnectionAdvice {
  /** For the pilot's own system. */
  readonly here: readonly HelpStep[];
  /** For the other systems: a pilot may help somebody else, and a system may be mistaken for another. */
  readonly elsewhere: readonly { readonly system: System; readonly steps: readonly HelpStep[] }[];
}

/** What to do about it. Empty when the sentence says everything. */
export function helpFor(code: HelpCode, situation: Situation): ConnectionAdvice {
  const { first = [], systems = {}, last = [] } = PLANS[code](situation);
  const { system } = situation.platform;
  const steps = (codes: readonly HelpStepCode[]): readonly HelpStep[] =>
    codes.flatMap((code) => {
      const copy = COMMANDS[code] ? COMMANDS[code](situation) : [];
      return copy ? [{ code, copy }] : [];
    });
  return {
    here: steps([...first, ...(systems[system] ?? []), ...last]),
    elsewhere: Object.entries(systems)
      .filter(([other]) => other !== system)
      .map(([other, codes]) => ({ system: other as System, steps: steps(codes) })),
  };
}

/**
 * The udev rule that lets the user at the computer use this adapter, and keeps ModemManager from testing whether it is
 * a modem.
 * @returns null for a port without USB numbers.
 */
export function udevRule(info: PortInfo | null): string | null {
  const vendor = hex(info?.usbVendorId);
  const product = hex(info?.usbProductId);
  if (vendor === null || product === null) return null;
  // ModemManager looks at the port for two names: the old one for a whole device and, since 1.10, the one for a port.
  return [
    'SUBSYSTEM=="tty"',
    `ATTRS{idVendor}=="${vendor}"`,
    `ATTRS{idProduct}=="${product}"`,
    'TAG+="uaccess"',
    'ENV{ID_MM_DEVICE_IGNORE}="1"',
    'ENV{ID_MM_PORT_IGNORE}="1"',
  ].join(', ');
}

function udevCommands(info: PortInfo | null): readonly string[] | null {
  const rule = udevRule(info);
  if (rule === null) return null;
  return [
    // Number 60, because systemd gives a tagged port to the user at the screen in rule 73, and ModemManager looks in
    // rules 77 to 80.
    `echo '${rule}' | sudo tee -a /etc/udev/rules.d/60-sidus-timer.rules`,
    'sudo udevadm control --reload && sudo udevadm trigger --subsystem-match=tty',
  ];
}

function hex(id: number | undefined): string | null {
  if (id === undefined || !Number.isInteger(id) || id < 0 || id > 0xffff) return null;
  return id.toString(16).padStart(4, '0');
}

function isBluetooth(info: PortInfo | null): boolean {
  return info?.bluetoothServiceClassId !== undefined;
}

/** Settings pages that a browser opens only when their address is typed. */
const SCHEMES: Partial<Readonly<Record<Browser, string>>> = {
  chrome: 'chrome',
  edge: 'edge',
  opera: 'opera',
  brave: 'brave',
};

function settingsPage(browser: Browser, page: string): readonly string[] | null {
  const scheme = SCHEMES[browser];
  return scheme === undefined ? null : [`${scheme}://${page}`];
}

/**
 * The https address under which this page may be found.
 * A host with a port number of its own rarely has another one for https.
 */
function httpsAddress(address: string): readonly string[] | null {
  const url = new URL(address);
  if (url.protocol !== 'http:' || url.port !== '') return null;
  url.protocol = 'https:';
  return [url.href];
}
