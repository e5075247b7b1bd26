import { cleanup, fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { en } from '../../tools/en.js';
import { type AppBench, idle, MemoryStore, run } from '../bench/bench.js';
import { button, connected, field, goTo, opened, press, type } from '../screen.js';

function choice(name: string): HTMLSelectElement {
  return screen.getByRole<HTMLSelectElement>('combobox', { name });
}

async function choose(name: string, value: string): Promise<void> {
  fireEvent.change(choice(name), { target: { value } });
  await idle(0);
}

async function tickSafety(): Promise<void> {
  fireEvent.click(screen.getByRole('checkbox', { name: /^The propeller is off/ }));
  await idle();
}

/** What stands in the rows of a table, without its head. */
function rows(table: HTMLElement): (string | null)[][] {
  return within(table)
    .getAllByRole('row')
    .slice(1)
    .map((row) => [...row.children].map(({ textContent }) => textContent));
}

/** Whether a screen reader says this text as soon as it is there. */
const isAnnounced = (text: string | RegExp): boolean => screen.getByText(text).closest('[role=status]') !== null;

const FTDI = { usbVendorId: 0x0403, usbProductId: 0x6001 };

describe('the adapters that are known', () => {
  it('are offered by name, and connect by a click', async () => {
    const store = new MemoryStore();
    const before = await connected({ store, info: FTDI, answersAt: 19_200 });
    await run(before.session.timer.disconnect());
    cleanup();
    await opened({ store, info: FTDI, answersAt: 19_200, plug: { granted: true } });
    await goTo('settings');
    expect(screen.getByRole('heading', { name: en.ports.title })).toBeTruthy();
    const known = screen.getByRole('button', { name: en.of({ button: 'Connect', name: en.link.portNames.ftdi }) });
    expect(known.textContent).toBe('Connect');
    fireEvent.click(known);
    await idle();
    await goTo('program');
    expect(field('DT time').value).toBe('3:00');
  });

  it('are forgotten by a click: the browser asks again', async () => {
    const { serial } = await opened({ info: FTDI, plug: { granted: true } });
    await goTo('settings');
    await press(en.of({ button: en.ports.forget, name: en.link.portNames.ftdi }));
    expect(screen.queryByRole('button', { name: /^Connect: / })).toBeNull();
    expect(screen.queryByRole('heading', { name: en.ports.title })).toBeNull();
    expect(await serial.getPorts()).toEqual([]);
    serial.choose(null);
    await goTo('program');
    await press('Connect');
    expect(screen.getByText(en.connection['nothing-chosen'].title)).toBeTruthy();
  });
});

describe('while a timer or its adapter is waited for', () => {
  const waits: [what: string, set: (bench: AppBench, trouble: boolean) => void][] = [
    ['timer', ({ timer: { core } }, trouble) => (trouble ? core.sleep() : core.press())],
    ['adapter', ({ adapter }, trouble) => (trouble ? adapter.unplugAfter(3) : adapter.replug())],
  ];

  it.each(waits)('nothing else can be connected before Stop: the %s', async (_, set) => {
    const bench = await opened({ info: FTDI, plug: { granted: true } });
    set(bench, true);
    await press('Connect');
    const ways = ['Connect', /^Connect: /, /^Try a simulated F1Q/];
    const shown = () => ways.flatMap((name) => screen.queryAllByRole<HTMLButtonElement>('button', { name }));
    expect(shown(), 'the buttons are gone, not only disabled').toEqual([]);
    await press(en.header.stop);
    expect([shown()[0]?.textContent, shown().some(({ disabled }) => disabled)]).toEqual(['Connect', false]);
  });

  it.each(waits)('Connect begins no second attempt: the %s comes back in the first', async (_, set) => {
    const bench = await opened({ info: FTDI, plug: { granted: true } });
    set(bench, true);
    await press('Connect');
    const before = bench.session.link.state.value.status;
    await run(bench.session.timer.connect());
    await run(bench.session.timer.connectTo(bench.port));
    await run(bench.session.timer.trySimulated('Q'));
    expect(bench.session.link.state.value.status).toBe(before);
    set(bench, false);
    await idle();
    expect(field('DT time').value).toBe('3:00');
    expect(bench.session.simulated.value).toBe(false);
  });
});

describe('what to do while no timer answers', () => {
  const near = en.link.stages.steps.near.replace('\u00a0', ' ');
  const help = (): HTMLDetailsElement | null => document.querySelector('details.help');
  const stage = (): string | undefined => screen.queryByRole('heading', { level: 1 })?.textContent ?? undefined;
  const current = (): string | undefined => document.querySelector('[aria-current="step"]')?.textContent ?? undefined;

  /** Connect was clicked, and the timer sleeps. */
  async function asleep(): Promise<AppBench> {
    const bench = await opened({ info: FTDI, plug: { granted: true } });
    bench.timer.core.sleep();
    fireEvent.click(button('Connect'));
    await idle(500);
    return bench;
  }

  it('says what to do when the port does not open, and Stop ends it', async () => {
    const bench = await opened({ info: FTDI, plug: { granted: true } });
    bench.port.open = () => new Promise(() => {});
    fireEvent.click(button('Connect'));
    await idle(4000);
    expect([stage(), screen.queryByRole('button', { name: en.header.choosePort })]).toEqual([
      en.link.status.opening,
      null,
    ]);
    await idle(1500);
    expect(stage()).toBe(en.link.stages.openingLong.title);
    expect(isAnnounced(en.link.stages.openingLong.advice)).toBe(true);
    expect(button(en.header.choosePort).disabled).toBe(false);
    fireEvent.click(button('Stop'));
    await idle(3500);
    expect(button('Connect').disabled).toBe(false);
  });

  it('fills the page and changes with the seconds: look, switch, distance, another adapter', async () => {
    await asleep();
    expect([stage(), current()]).toEqual([en.link.status.searching, undefined]);
    await idle(1700);
    expect([stage(), current()]).toEqual([en.link.stages.steps.switch, en.link.stages.steps.switch]);
    expect(isAnnounced(/^No answer for 2 s\./), 'it changes with each second').toBe(false);
    expect(help()).toBeNull();
    await idle(8000);
    expect([stage(), current()]).toEqual([en.link.stages.steps.near, en.link.stages.steps.near]);
    await idle(20_000);
    expect([stage(), current()]).toEqual([en.link.stages.steps.other, en.link.stages.steps.other]);
    expect(screen.getByText(/^No answer for 30 s\./)).toBeTruthy();
  });

  it('gets the focus, and a screen reader says its title', async () => {
    await asleep();
    const title = screen.getByRole('heading', { level: 1, name: en.link.status.searching });
    expect([document.activeElement, title.closest('[role=status]')]).toEqual([title, expect.anything()]);
    await press('Stop');
    expect(document.activeElement, 'the button is gone, so the focus goes to the page').toBe(screen.getByRole('main'));
  });

  it('leaves one way to stop while the timer is read', async () => {
    const { timer } = await opened({ info: FTDI, plug: { granted: true } });
    const ways: (string | null)[][] = [];
    timer.core.onAnswer = ({ name }) => {
      if (name !== 'GETTIMERS') return;
      const buttons = screen.queryAllByRole('button', { name: /^(Stop|Disconnect)$/ });
      ways.push(buttons.map(({ textContent }) => textContent));
    };
    await press('Connect');
    expect(ways).toEqual([['Stop']]);
    expect(button('Disconnect')).toBeTruthy();
  });

  it('takes no extra room when a program is on the screen', async () => {
    const { timer } = await connected();
    await press('Disconnect');
    timer.core.sleep();
    fireEvent.click(button('Connect'));
    await idle(12_000);
    expect(stage()).toMatch(/^Program:/);
    expect(screen.getAllByText(near).length).toBeGreaterThan(0);
    expect(field('DT time').value).toBe('3:00');
    await press('Stop');
    expect(screen.queryByText(near)).toBeNull();
  });

  it('is shown in full from 10 s on, stays open during the wait, and goes when the timer answers', async () => {
    const bench = await asleep();
    await idle(10_000);
    const shown = help();
    if (!shown) throw new Error('there is no help');
    expect(within(shown).getAllByRole('listitem', { hidden: true })).toHaveLength(4);
    expect(shown.textContent).toContain(en.help.steps.battery);
    shown.open = true;
    await idle();
    expect(bench.session.link.state.value.status).toBe('waiting');
    expect(help()).toBe(shown);
    expect(shown.open).toBe(true);
    bench.timer.core.press();
    await idle();
    expect(field('DT time').value).toBe('3:00');
    expect(help()).toBeNull();
  });

  it('is shown for a timer that no longer answers', async () => {
    const { timer, session } = await connected();
    timer.core.sleep();
    await press('Read again');
    expect([session.link.state.value.status, help() !== null]).toEqual(['waiting', true]);
    await idle(1000);
  });
});

describe('the serial settings', () => {
  it('are those of the next port that is opened, until they are put back', async () => {
    const {
      session,
      port,
      models: { views },
    } = await opened();
    await goTo('settings');
    expect(screen.queryByRole('combobox', { name: en.ports.parity }), 'for Expert only').toBeNull();
    views.setExpert(true);
    await idle(0);
    expect(['Rate', 'Parity', 'Stop bits', 'DTR', 'RTS'].map((name) => choice(name).value)).toEqual([
      'find',
      'none',
      '1',
      '',
      '',
    ]);
    expect(screen.queryByRole('button', { name: en.ports.reset })).toBeNull();
    await choose('Rate', '19200');
    await choose('Parity', 'even');
    await choose('Stop bits', '2');
    await choose('DTR', 'false');
    await choose('RTS', 'true');
    expect(session.link.settings.value).toMatchObject({
      baudRate: 19_200,
      parity: 'even',
      stopBits: 2,
      dtr: false,
      rts: true,
    });
    await goTo('program');
    await press('Connect');
    expect(port.device.opened).toMatchObject({ baudRate: 19_200, parity: 'even', stopBits: 2 });
    expect(port.device.signals).toMatchObject({ dataTerminalReady: false, requestToSend: true });
    await press('Disconnect');
    await goTo('settings');
    // By the list of those that are known, too.
    await choose('Parity', 'odd');
    await press(/^Connect: /);
    expect(port.device.opened).toMatchObject({ baudRate: 19_200, parity: 'odd', stopBits: 2 });
    // What comes of it is shown there.
    expect(views.shown.value).toBe('program');
    await press('Disconnect');
    await goTo('settings');
    await press(en.ports.reset);
    expect([choice('Rate').value, choice('Parity').value, session.link.settings.value]).toEqual(['find', 'none', null]);
  });
});

describe('the write dialog', () => {
  it('shows what was read and what the timer holds now, if that has changed', async () => {
    const { timer } = await connected();
    await type('DT time', '4:00');
    await press('Write…');
    expect(within(screen.getByRole('dialog')).getAllByRole('table')).toHaveLength(1);
    await press(en.cancel);
    timer.core.content.times[10] = 18_500;
    await press('Write…');
    const [conflicts, difference] = within(screen.getByRole('dialog')).getAllByRole('table');
    if (!conflicts || !difference) throw new Error('a table is missing');
    expect(
      within(conflicts)
        .getAllByRole('columnheader')
        .slice(1)
        .map(({ textContent }) => textContent),
    ).toEqual([en.write.wasRead, en.write.from]);
    expect(rows(conflicts)).toEqual([['DT', '3:00 min', '3:05 min']]);
    expect(rows(difference)).toEqual([['DT', '3:05 min', '4:00 min']]);
  });
});

describe('an interrupted write', () => {
  it('says in the dialog that a lost port comes back', async () => {
    const { timer, adapter } = await connected();
    await type('DT time', '4:00');
    await press('Write…');
    await tickSafety();
    timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && adapter.unplug();
    await press('Write 1 change');
    const { textContent } = screen.getByRole('alert');
    expect(textContent).toContain(en.link.lost.advice);
    expect(textContent).not.toContain('press Connect');
  });
});
