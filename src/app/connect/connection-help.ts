import type { ConnectionErrorCode, PortInfo } from '../../serial/index.js';
import type { Platform, System } from '../browser/platform.js';
import type { PageSentences } from '../messages/sentences.js';

/** What there is help for: a connection that failed, or a timer that does not answer. */
export type HelpCode = ConnectionErrorCode | 'waiting';

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
export type HelpStepCode = keyof PageSentences['help']['steps'];

/** One thing to do, with a line to copy that it mentions. */
export interface HelpStep {
  readonly code: HelpStepCode;
  readonly copy?: string;
}

/** Where a pilot reports what went wrong. */
const ISSUES = 'https://github.com/sidus-timer/sidus-timer/issues';
const LINUX: HelpStep = { code: 'linux', copy: 'sudo usermod -a -G dialout $USER' };

/** Where a system does not find the adapter. */
const DRIVERS: Partial<Readonly<Record<System, HelpStep>>> = {
  windows: { code: 'windows' },
  mac: { code: 'mac' },
  linux: LINUX,
  chromeos: { code: 'linux-container' },
  android: { code: 'android' },
};

/** Where a system keeps the adapter from a browser. */
const HOLDERS: Partial<Readonly<Record<System, HelpStep>>> = { linux: LINUX, chromeos: { code: 'linux-container' } };

/** The steps, in the order in which they help; null for one that is not for this situation. */
const PLANS: Readonly<Record<HelpCode, (situation: Situation) => readonly (HelpStep | HelpStepCode | null)[]>> = {
  unsupported: ({ platform: { browser, mobile } }) => [
    browser === 'brave' && !mobile ? { code: 'address', copy: 'brave://flags/#brave-web-serial-api' } : null,
  ],
  insecure: ({ address }) => [addressStep(httpsAddress(address))],
  policy: ({ address }) => [addressStep(address)],
  'nothing-chosen': ({ platform: { mobile, system, browser } }) => [
    mobile ? null : 'cable',
    DRIVERS[system] ?? null,
    browser === 'firefox' ? 'firefox-finds' : 'bluetooth',
  ],
  'not-allowed': ({ platform }) => [addressStep(permissionsPage(platform))],
  busy: ({ platform, info }) =>
    isBluetooth(info)
      ? ['bluetooth', 'programs']
      : ['programs', HOLDERS[platform.system] ?? null, 'replug', firefoxReload(platform)],
  'bad-settings': () => ['usual-settings'],
  unplugged: failed,
  lost: failed,
  waiting: (here) => ['switch', 'near', 'battery', rateStep(here)],
  'bad-reply': () => ['usual-settings', { code: 'report', copy: ISSUES }],
};

/** What to do about it: at most four steps. Empty when the sentence says everything. */
export function helpFor(code: HelpCode, situation: Situation): readonly HelpStep[] {
  return PLANS[code](situation).flatMap((step) => (typeof step === 'string' ? { code: step } : (step ?? [])));
}

/** An adapter that worked before. */
function failed({ platform, info }: Situation): readonly (HelpStep | HelpStepCode | null)[] {
  if (isBluetooth(info)) return ['bluetooth'];
  return ['cable', HOLDERS[platform.system] ?? null, firefoxReload(platform)];
}

function firefoxReload({ browser }: Platform): HelpStepCode | null {
  return browser === 'firefox' ? 'firefox-reload' : null;
}

/** A rate that the pilot has set may be wrong. To find one, the page opens the port again and again. */
function rateStep({ rateSet, info }: Situation): HelpStepCode | null {
  if (rateSet) return 'usual-settings';
  // Over Bluetooth there is one rate, and one opening.
  return isBluetooth(info) ? null : 'restarts';
}

function addressStep(copy: string | null): HelpStep | null {
  return copy === null ? null : { code: 'address', copy };
}

function isBluetooth(info: PortInfo | null): boolean {
  return info?.bluetoothServiceClassId !== undefined;
}

/**
 * Where a browser on a computer lists the pages that may not use serial ports, which it opens only when the address is
 * typed. Each of them takes this one, and shows it under its own name.
 */
function permissionsPage({ browser, mobile }: Platform): string | null {
  return mobile || browser === 'firefox' || browser === 'other' ? null : 'chrome://settings/content/serialPorts';
}

/**
 * The https address under which this page may be found.
 * A host with a port number of its own rarely has another one for https.
 */
function httpsAddress(address: string): string | null {
  const url = new URL(address);
  if (url.protocol !== 'http:' || url.port !== '') return null;
  url.protocol = 'https:';
  return url.href;
}
