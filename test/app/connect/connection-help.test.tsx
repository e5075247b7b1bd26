import { readFileSync } from 'node:fs';
import { fireEvent, render, screen } from '@testing-library/preact';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { Browser, Platform, System } from '../../../src/app/browser/platform.js';
import { type HelpCode, type HelpStepCode, helpFor, udevRule } from '../../../src/app/connect/connection-help.js';
import { ConnectionHelp, connectionSaid } from '../../../src/app/connect/connection-help-view.js';
import { en } from '../../../src/app/messages/en.js';
import { CopyText } from '../../../src/app/ui/copy-text.js';
import type { PortInfo } from '../../../src/serial/index.js';

const FTDI: PortInfo = { usbVendorId: 0x0403, usbProductId: 0x6001 };
const SPP: PortInfo = { bluetoothServiceClassId: '00001101-0000-1000-8000-00805f9b34fb' };
const ADDRESS = 'https://timers.example/set/';
const SYSTEMS = Object.keys(en.help.systems) as System[];
const BROWSERS: readonly Browser[] = ['chrome', 'edge', 'opera', 'brave', 'firefox', 'safari', 'other'];
const CODES = [...Object.keys(en.connection), 'waiting', 'still-waiting'] as HelpCode[];

function on(system: System, browser: Browser = 'chrome', version: number | null = 138): Platform {
  return { system, browser, version, mobile: system === 'android' || system === 'ios' };
}

/** The codes of the steps for this system, and what there is to copy. */
function steps(code: HelpCode, platform: Platform, info: PortInfo | null = null, address = ADDRESS) {
  const { here } = helpFor(code, { platform, info, address, rateSet: true });
  return { codes: here.map((step) => step.code), copy: here.flatMap((step) => step.copy) };
}

describe('the udev rule', () => {
  it.each([
    ['0403', '6001', FTDI],
    ['10c4', 'ea60', { usbVendorId: 0x10c4, usbProductId: 0xea60 }],
    ['0001', '0000', { usbVendorId: 1, usbProductId: 0 }],
  ])('has the numbers %s and %s of the port', (vendor, product, info) => {
    expect(udevRule(info)).toBe(
      `SUBSYSTEM=="tty", ATTRS{idVendor}=="${vendor}", ATTRS{idProduct}=="${product}", TAG+="uaccess", ENV{ID_MM_DEVICE_IGNORE}="1", ENV{ID_MM_PORT_IGNORE}="1"`,
    );
  });

  it.each([
    [null],
    [{}],
    [SPP],
    [{ usbVendorId: 0x0403 }],
    [{ usbVendorId: -1, usbProductId: 0x6001 }],
    [{ usbVendorId: 0x0403, usbProductId: 0x10000 }],
    [{ usbVendorId: 0x0403, usbProductId: 1.5 }],
  ])('is not shown for a port that says %o', (info) => {
    expect(udevRule(info)).toBeNull();
    expect(steps('busy', on('linux'), info).codes).not.toContain('udev-rule');
  });

  it('is put by one command into a file that udev reads before it gives ports away, and loaded by another', () => {
    const { here } = helpFor('busy', { platform: on('linux'), info: FTDI, address: ADDRESS, rateSet: false });
    expect(here.find(({ code }) => code === 'udev-rule')?.copy).toEqual([
      `echo '${udevRule(FTDI)}' | sudo tee -a /etc/udev/rules.d/60-sidus-timer.rules`,
      'sudo udevadm control --reload && sudo udevadm trigger --subsystem-match=tty',
    ]);
  });
});

describe('what to do', () => {
  it('has a sentence for every step in every situation, and each step once', () => {
    const used = new Set<HelpStepCode>();
    for (const code of CODES) {
      for (const system of SYSTEMS) {
        for (const browser of BROWSERS) {
          for (const info of [null, FTDI, SPP]) {
            const address = 'http://timers.example/';
            const { here, elsewhere } = helpFor(code, {
              platform: on(system, browser),
              info,
              address,
              rateSet: info === FTDI,
            });
            const codes = here.map((step) => step.code);
            expect(new Set(codes).size, `a step comes twice: ${code} ${system} ${browser}`).toBe(codes.length);
            expect(elsewhere.map((other) => other.system)).not.toContain(system);
            for (const list of [here, ...elsewhere.map((other) => other.steps)]) {
              for (const step of list) used.add(step.code);
            }
          }
        }
      }
    }
    expect([...used].sort()).toEqual(Object.keys(en.help.steps).sort());
  });

  it('says where a report goes: to the address that the package names', () => {
    const { bugs } = JSON.parse(readFileSync('package.json', 'utf8')) as { bugs: string };
    expect(steps('bad-reply', on('windows')).copy).toEqual([bugs]);
    expect(en.timer['bad-reply'].advice).toContain(`(${bugs.replace('https://', '')})`);
  });

  it.each<[HelpCode, Platform, PortInfo | null, readonly HelpStepCode[]]>([
    ['busy', on('windows'), FTDI, ['close-tabs', 'programs-windows', 'replug']],
    ['busy', on('mac'), FTDI, ['close-tabs', 'programs-mac', 'holder-mac', 'replug']],
    [
      'busy',
      on('linux'),
      FTDI,
      [
        'close-tabs',
        'modem-manager',
        'programs-linux',
        'holder-linux',
        'group',
        'group-arch',
        'udev-rule',
        'chromium-snap',
        'replug',
      ],
    ],
    ['busy', on('chromeos'), FTDI, ['close-tabs', 'linux-container', 'replug']],
    ['busy', on('android'), FTDI, ['close-tabs', 'programs-android', 'replug']],
    ['busy', on('linux'), SPP, ['bluetooth-one', 'bluetooth-again', 'close-tabs']],
    ['nothing-chosen', on('windows'), null, ['cable', 'drivers-windows', 'pl2303-windows', 'pair-windows']],
    ['nothing-chosen', on('mac'), null, ['cable', 'accessory-mac', 'drivers-mac', 'pair-mac']],
    ['nothing-chosen', on('linux'), null, ['cable', 'kernel-linux', 'brltty', 'chromium-snap', 'pair-linux']],
    [
      'nothing-chosen',
      on('linux', 'firefox'),
      null,
      ['cable', 'kernel-linux', 'brltty', 'firefox-snap', 'pair-linux', 'firefox-bluetooth'],
    ],
    ['nothing-chosen', on('chromeos'), null, ['cable', 'linux-container', 'pair-chromeos']],
    ['nothing-chosen', on('android'), null, ['pair-android', 'android-cable']],
    ['unplugged', on('linux'), FTDI, ['cable', 'brltty']],
    ['unplugged', on('linux'), SPP, ['bluetooth-one', 'bluetooth-again']],
    ['lost', on('windows'), FTDI, ['cable', 'usb-power']],
    ['lost', on('linux', 'firefox'), FTDI, ['cable', 'brltty', 'firefox-reload']],
    ['unplugged', on('mac', 'firefox'), FTDI, ['cable', 'firefox-reload']],
    ['lost', on('windows', 'firefox'), SPP, ['bluetooth-one', 'bluetooth-again']],
    ['lost', on('windows'), SPP, ['bluetooth-one', 'bluetooth-again']],
    ['waiting', on('windows'), FTDI, ['wake', 'near', 'battery', 'other-port-waiting', 'rate-waiting']],
    ['still-waiting', on('windows'), FTDI, ['battery', 'rate-waiting']],
    ['bad-reply', on('windows'), FTDI, ['near', 'other-port', 'rate', 'report']],
    ['not-allowed', on('android'), null, ['ask-again', 'site-permission-mobile']],
    ['unsupported', on('windows', 'brave'), null, ['brave-flag', 'brave-relaunch']],
    ['unsupported', on('android', 'brave'), null, []],
    ['unsupported', on('mac', 'safari'), null, []],
  ])('%s on %o, port %o: %j', (code, platform, info, codes) => {
    expect(steps(code, platform, info).codes).toEqual(codes);
  });

  it.each<[Browser, readonly string[]]>([
    ['chrome', ['chrome://settings/content/serialPorts', 'chrome://policy']],
    ['edge', ['edge://settings/content/serialPorts', 'edge://policy']],
    ['opera', ['opera://settings/content/serialPorts', 'opera://policy']],
    ['brave', ['brave://settings/content/serialPorts', 'brave://policy']],
    ['firefox', ['about:addons']],
    ['other', []],
  ])('says where %s keeps the permission', (browser, copy) => {
    expect(steps('not-allowed', on('windows', browser)).copy).toEqual(copy);
  });

  it.each([
    ['http://timers.example/set/?m=2#dt', ['https://timers.example/set/?m=2#dt']],
    ['http://192.168.1.20:4173/', []],
    ['file:///home/pilot/index.html', []],
  ])('gives the https address of %s: %j', (address, copy) => {
    expect(steps('insecure', on('windows'), null, address)).toEqual({
      codes: copy.length > 0 ? ['https', 'this-computer'] : ['this-computer'],
      copy,
    });
  });

  it('gives the address of the page and what the server must say where a policy forbids', () => {
    expect(steps('policy', on('windows')).copy).toEqual([
      ADDRESS,
      'Permissions-Policy: serial=(self)',
      'allow="serial"',
    ]);
  });
});

describe('the sentence', () => {
  it('is about this browser when its name tells why it cannot', () => {
    expect(connectionSaid('unsupported', on('windows', 'firefox', 140)).advice).toContain('151 or later');
    expect(connectionSaid('unsupported', on('ios', 'safari')).title).toBe(
      'No browser on an iPhone or iPad can reach a timer.',
    );
    expect(connectionSaid('unsupported', on('windows', 'other'))).toBe(en.connection.unsupported);
    expect(connectionSaid('busy', on('windows', 'firefox', 140))).toBe(en.connection.busy);
  });

  it.each(Object.entries(en.help.unsupported))('about %s says what still works', (_, { advice }) => {
    expect(advice).toMatch(/Everything but the connection works here too\.$/);
  });
});

describe('the help under a notice', () => {
  it('shows the steps for this system, and folds up those of the others', () => {
    render(<ConnectionHelp code="busy" platform={on('linux')} info={FTDI} rateSet={false} />);
    const folds = screen.getAllByRole('group').map((fold) => fold.querySelector('summary')?.textContent);
    expect(folds).toEqual(['What to do', 'On Windows', 'On macOS', 'On ChromeOS', 'On Android']);
    const [mine, windows] = screen.getAllByRole('list', { hidden: true });
    expect(mine?.textContent).toContain('idVendor}=="0403"');
    expect(mine?.textContent).not.toContain('Tera Term');
    expect(windows?.textContent).toContain('Tera Term');
  });

  it('is not shown when the sentence says everything', () => {
    const { container } = render(
      <ConnectionHelp code="unsupported" platform={on('ios', 'safari')} info={null} rateSet={false} />,
    );
    expect(container.textContent).toBe('');
  });

  it('says nothing about a rate that nobody has set, but how to set one for an adapter that restarts', () => {
    const last = (rateSet: boolean, info: PortInfo) =>
      helpFor('waiting', { platform: on('windows'), info, address: ADDRESS, rateSet }).here.at(-1)?.code;
    expect([last(false, FTDI), last(true, FTDI), last(false, SPP)]).toEqual([
      'restarts',
      'rate-waiting',
      'other-port-waiting',
    ]);
    expect(en.help.steps.restarts).toMatch(/DTR.*rate/);
  });

  it('brings the head of the page into sight when it is opened there', () => {
    const help = <ConnectionHelp code="busy" platform={on('windows')} info={FTDI} rateSet={false} />;
    const { container } = render(<header class="top">{help}</header>);
    const scrolled: unknown[] = [];
    const spy = vi.spyOn(HTMLElement.prototype, 'scrollIntoView').mockImplementation(function (this: HTMLElement) {
      scrolled.push(this);
    });
    const details = container.querySelector('details') as HTMLDetailsElement;
    fireEvent(details, new Event('toggle'));
    expect(scrolled, 'nothing scrolls while it is folded up').toEqual([]);
    details.open = true;
    fireEvent(details, new Event('toggle'));
    expect(scrolled[0]).toBe(container.querySelector('.top'));
    spy.mockRestore();
  });

  it('is folded up again when the trouble changes', () => {
    const fold = (): HTMLDetailsElement => screen.getAllByRole<HTMLDetailsElement>('group')[0] as HTMLDetailsElement;
    const { rerender } = render(<ConnectionHelp code="busy" platform={on('windows')} info={FTDI} rateSet={false} />);
    fold().open = true;
    rerender(<ConnectionHelp code="busy" platform={on('windows')} info={FTDI} rateSet={false} />);
    expect(fold().open).toBe(true);
    rerender(<ConnectionHelp code="waiting" platform={on('windows')} info={FTDI} rateSet={false} />);
    expect(fold().open).toBe(false);
  });

  it('gives the address of this very page', () => {
    render(<ConnectionHelp code="policy" platform={on('windows')} info={null} rateSet={false} />);
    expect(screen.getByText(location.href)).toBeTruthy();
  });
});

describe('a line to copy', () => {
  beforeEach(() => getSelection()?.removeAllRanges());
  afterEach(() => void vi.unstubAllGlobals());

  /** In the place of the clipboard, which a page without a click or without https does not have. */
  function clipboard(writeText: ((text: string) => Promise<void>) | undefined) {
    vi.stubGlobal('navigator', { clipboard: writeText && { writeText } });
  }

  it('is copied, and says so until the pilot does something else', async () => {
    const copied: string[] = [];
    clipboard(async (text) => void copied.push(text));
    render(<CopyText text="lsof /dev/cu.*" />);
    fireEvent.click(screen.getByRole('button', { name: 'Copy' }));
    fireEvent.blur(await screen.findByRole('button', { name: 'Copied' }));
    expect(copied).toEqual(['lsof /dev/cu.*']);
    expect(await screen.findByRole('button', { name: 'Copy' })).toBeTruthy();
  });

  it.each([
    ['there is none', undefined],
    ['it is forbidden', () => Promise.reject(new DOMException('Not now.', 'NotAllowedError'))],
  ])('is selected for copying by hand when the clipboard fails: %s', async (_, writeText) => {
    clipboard(writeText);
    render(<CopyText text="lsof /dev/cu.*" />);
    fireEvent.click(screen.getByRole('button', { name: 'Copy' }));
    expect(await screen.findByRole('button', { name: 'Marked' })).toBeTruthy();
    expect(screen.getByRole('status').textContent).toBe('Marked');
    expect(getSelection()?.toString()).toBe('lsof /dev/cu.*');
  });

  it('is selected by a click on it', () => {
    render(<CopyText text="lsof /dev/cu.*" />);
    fireEvent.click(screen.getByText('lsof /dev/cu.*'));
    expect(getSelection()?.toString()).toBe('lsof /dev/cu.*');
  });
});
