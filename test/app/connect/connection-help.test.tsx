import { readFileSync } from 'node:fs';
import { signal } from '@preact/signals';
import { fireEvent, render, screen, waitFor } from '@testing-library/preact';
import { describe, expect, it, vi } from 'vitest';
import type { Browser, Platform, System } from '../../../src/app/browser/platform.js';
import { type HelpCode, type HelpStepCode, helpFor } from '../../../src/app/connect/connection-help.js';
import { ConnectionHelp, connectionSaid } from '../../../src/app/connect/connection-help-view.js';
import { CopyButton } from '../../../src/app/ui/copy-button.js';
import type { PortInfo } from '../../../src/serial/index.js';
import { CONNECTION_PAGE } from '../../tools/connection-page.js';
import { en } from '../../tools/en.js';

const FTDI: PortInfo = { usbVendorId: 0x0403, usbProductId: 0x6001 };
const SPP: PortInfo = { bluetoothServiceClassId: '00001101-0000-1000-8000-00805f9b34fb' };
/** Nobody has set a rate. */
const LINK = { state: signal({ status: 'off', error: null } as const), settings: signal(null) };
const ADDRESS = 'https://timers.example/set/';
const SYSTEMS: readonly System[] = ['windows', 'mac', 'linux', 'chromeos', 'android', 'ios', 'other'];
const BROWSERS: readonly Browser[] = ['chrome', 'edge', 'opera', 'brave', 'firefox', 'other'];
const CODES = [...Object.keys(en.connection), 'waiting'] as HelpCode[];

function on(system: System, browser: Browser = 'chrome'): Platform {
  return { system, browser, mobile: system === 'android' || system === 'ios' };
}

/** The codes of the steps for this system, and what there is to copy. */
function steps(code: HelpCode, platform: Platform, info: PortInfo | null = null, address = ADDRESS) {
  const here = helpFor(code, { platform, info, address, rateSet: true });
  return { codes: here.map((step) => step.code), copy: here.flatMap(({ copy }) => copy ?? []) };
}

describe('what to do', () => {
  it('is at most four steps in every situation, each once, and each step is of use somewhere', () => {
    const used = new Set<HelpStepCode>();
    for (const code of CODES) {
      for (const system of SYSTEMS) {
        for (const browser of BROWSERS) {
          for (const info of [null, FTDI, SPP]) {
            const address = 'http://timers.example/';
            const here = helpFor(code, { platform: on(system, browser), info, address, rateSet: info === FTDI });
            const codes = here.map((step) => step.code);
            expect(new Set(codes).size, `a step comes twice: ${code} ${system} ${browser}`).toBe(codes.length);
            expect(codes.length, `${code} ${system} ${browser}`).toBeLessThanOrEqual(4);
            for (const step of codes) used.add(step);
          }
        }
      }
    }
    expect([...used].sort()).toEqual(Object.keys(en.help.steps).sort());
  });

  it('says where a report goes: to the address that the package names', () => {
    const { bugs } = JSON.parse(readFileSync('package.json', 'utf8')) as { bugs: string };
    expect(steps('bad-reply', on('windows')).copy).toEqual([bugs]);
  });

  it.each<[HelpCode, Platform, PortInfo | null, readonly HelpStepCode[]]>([
    ['busy', on('windows'), FTDI, ['programs', 'replug']],
    ['busy', on('linux'), FTDI, ['programs', 'linux', 'replug']],
    ['busy', on('linux', 'firefox'), FTDI, ['programs', 'linux', 'replug', 'firefox-reload']],
    ['busy', on('chromeos'), FTDI, ['programs', 'linux-container', 'replug']],
    ['busy', on('linux'), SPP, ['bluetooth', 'programs']],
    ['nothing-chosen', on('windows'), null, ['cable', 'windows', 'bluetooth']],
    ['nothing-chosen', on('mac'), null, ['cable', 'mac', 'bluetooth']],
    ['nothing-chosen', on('linux', 'firefox'), null, ['cable', 'linux', 'firefox-finds']],
    ['nothing-chosen', on('chromeos'), null, ['cable', 'linux-container', 'bluetooth']],
    ['nothing-chosen', on('android'), null, ['android', 'bluetooth']],
    ['unplugged', on('windows'), FTDI, ['cable']],
    ['unplugged', on('linux'), SPP, ['bluetooth']],
    ['lost', on('linux', 'firefox'), FTDI, ['cable', 'linux', 'firefox-reload']],
    ['lost', on('windows', 'firefox'), SPP, ['bluetooth']],
    ['waiting', on('windows'), FTDI, ['switch', 'near', 'battery', 'usual-settings']],
    ['bad-reply', on('windows'), FTDI, ['usual-settings', 'report']],
    ['not-allowed', on('android'), null, []],
    ['unsupported', on('windows', 'brave'), null, ['address']],
    ['unsupported', on('android', 'brave'), null, []],
    ['unsupported', on('mac', 'other'), null, []],
  ])('%s on %o, port %o: %j', (code, platform, info, codes) => {
    expect(steps(code, platform, info).codes).toEqual(codes);
  });

  it.each<[Browser, readonly string[]]>([
    ['edge', ['chrome://settings/content/serialPorts']],
    ['firefox', []],
    ['other', []],
  ])('says where %s keeps the permission', (browser, copy) => {
    expect(steps('not-allowed', on('windows', browser)).copy).toEqual(copy);
  });

  it.each([
    ['http://timers.example/set/?m=2#dt', ['https://timers.example/set/?m=2#dt']],
    ['http://192.168.1.20:4173/', []],
    ['file:///home/pilot/index.html', []],
  ])('gives the https address of %s: %j', (address, copy) => {
    expect(steps('insecure', on('windows'), null, address).copy).toEqual(copy);
  });
});

describe('the sentence', () => {
  it('is about this browser when its name tells why it cannot', () => {
    expect(connectionSaid('unsupported', on('ios', 'other'))).toEqual(en.unsupported.ios);
    expect(connectionSaid('unsupported', on('windows', 'other'))).toEqual(en.connection.unsupported);
    expect(connectionSaid('busy', on('ios', 'other'))).toEqual(en.connection.busy);
  });

  it.each(Object.entries(en.unsupported))('about %s says what still works', (_, { advice }) => {
    expect(advice.endsWith(en.restWorks)).toBe(true);
  });
});

describe('the help under a notice', () => {
  it('shows the steps for this system, and leads to those of all others', () => {
    render(<ConnectionHelp code="busy" platform={on('linux')} info={FTDI} link={LINK} />);
    const shown = screen.getByRole('list', { hidden: true }).textContent;
    for (const code of ['programs', 'linux', 'replug'] as const) expect(shown).toContain(en.help.steps[code]);
    const all = screen.getByRole('link', { name: en.help.page, hidden: true });
    expect(all.getAttribute('href')).toBe(CONNECTION_PAGE);
  });

  it('is not shown when the sentence says everything', () => {
    const { container } = render(
      <ConnectionHelp code="unsupported" platform={on('ios', 'other')} info={null} link={LINK} />,
    );
    expect(container.textContent).toBe('');
  });

  it('says nothing about a rate that nobody has set, but how to set one for an adapter that restarts', () => {
    const last = (rateSet: boolean, info: PortInfo) =>
      helpFor('waiting', { platform: on('windows'), info, address: ADDRESS, rateSet }).at(-1)?.code;
    expect([last(false, FTDI), last(true, FTDI), last(false, SPP)]).toEqual(['restarts', 'usual-settings', 'battery']);
    expect(en.help.steps.restarts).toMatch(/DTR.*rate/);
  });

  it('brings the head of the page into sight when it is opened there', () => {
    const help = <ConnectionHelp code="busy" platform={on('windows')} info={FTDI} link={LINK} />;
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
    const { rerender } = render(<ConnectionHelp code="busy" platform={on('windows')} info={FTDI} link={LINK} />);
    fold().open = true;
    rerender(<ConnectionHelp code="busy" platform={on('windows')} info={FTDI} link={LINK} />);
    expect(fold().open).toBe(true);
    rerender(<ConnectionHelp code="waiting" platform={on('windows')} info={FTDI} link={LINK} />);
    expect(fold().open).toBe(false);
  });

  it('gives the address of this very page', () => {
    render(<ConnectionHelp code="policy" platform={on('windows')} info={null} link={LINK} />);
    expect(screen.getByText(location.href)).toBeTruthy();
  });
});

describe('a line to copy', () => {
  const LINE = 'lsof /dev/cu.*';
  /** In the place of the clipboard, which a page without a click or without https does not have. */
  function clipboard(writeText: ((text: string) => Promise<void>) | undefined) {
    vi.stubGlobal('navigator', { clipboard: writeText && { writeText } });
  }

  it('is copied, and says so until the pilot does something else', async () => {
    const copied: string[] = [];
    clipboard(async (text) => void copied.push(text));
    render(<CopyButton label={en.copy} text={() => LINE} />);
    fireEvent.click(screen.getByRole('button', { name: en.copy }));
    await screen.findByText(en.copied);
    fireEvent.blur(screen.getByRole('button', { name: en.copy }));
    expect(copied).toEqual([LINE]);
    await waitFor(() => expect(screen.getByRole('status').textContent).toBe(''));
  });

  it.each([
    ['there is none', undefined],
    ['it is forbidden', () => Promise.reject(new DOMException('Not now.', 'NotAllowedError'))],
  ])('is shown for copying by hand when the clipboard fails: %s', async (_, writeText) => {
    clipboard(writeText);
    render(<CopyButton label={en.copy} text={() => LINE} />);
    fireEvent.click(screen.getByRole('button', { name: en.copy }));
    const area = await screen.findByRole<HTMLTextAreaElement>('textbox', { name: en.copyByHand });
    expect([area.value, area.selectionStart, area.selectionEnd]).toEqual([LINE, 0, LINE.length]);
    fireEvent.click(screen.getByRole('button', { name: 'Close' }));
    expect(screen.queryByRole('textbox')).toBeNull();
  });
});
