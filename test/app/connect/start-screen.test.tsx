import { cleanup, fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it, vi } from 'vitest';
import { platformOf } from '../../../src/app/browser/platform.js';
import { NARROW } from '../../../src/app/ui/shapes.js';
import { en } from '../../tools/en.js';
import { idle, reloaded, run } from '../bench/bench.js';
import { connected, drawn, field, goTo, opened, press, table, type } from '../screen.js';

const ANDROID = platformOf({ userAgent: 'Mozilla/5.0 (Linux; Android 17; K) Chrome/149.0.0.0 Mobile Safari/537.36' });
const FIREFOX = platformOf({ userAgent: 'Mozilla/5.0 (X11; Linux x86_64; rv:153.0) Gecko/20100101 Firefox/153.0' });

function card(name: string) {
  return within(screen.getByRole('region', { name }));
}

/** Makes a program by the dialog. */
async function make(choose: () => void = () => {}): Promise<void> {
  await press(en.newProgram.title);
  choose();
  await press(en.newProgram.make);
}

describe('a new program', () => {
  it('is made for a class and a layout, edited, and never shown as being in a timer', async () => {
    await opened();
    await make(() => {
      fireEvent.click(screen.getByRole('radio', { name: 'F1B' }));
      fireEvent.change(screen.getByRole('combobox', { name: en.newProgram.functions }), {
        target: { value: '12' },
      });
      fireEvent.change(screen.getByRole('combobox', { name: 'Servos' }), { target: { value: '2' } });
    });
    expect(table().getByRole('rowheader', { name: /^Function 11/ })).toBeTruthy();
    expect(table().queryByRole('columnheader', { name: /^S3/ })).toBeNull();
    await type('Function 3, S2', '70');
    expect(screen.getByText(en.knowledge.made)).toBeTruthy();
    expect(document.body.textContent).not.toMatch(/last read|as in the timer|was 65/i);
  });

  it('from nothing holds zeros', async () => {
    const { editor } = await opened();
    await make(() => fireEvent.click(screen.getByRole('radio', { name: /^All times/ })));
    expect(new Set(editor.working.value?.times)).toEqual(new Set([0]));
  });

  it('is written by way of Connect: the difference is shown first', async () => {
    const { timer } = await opened({ plug: { granted: true } });
    await make();
    await type('DT time', '4:00');
    await press(en.program.connectAndWrite);
    fireEvent.click(screen.getByRole('checkbox', { name: /^The propeller is off/ }));
    await idle(0);
    await press(/^Write \d+ changes$/);
    expect([timer.core.content.times[10], timer.core.content.positions[2]?.[9]]).toEqual([24000, 65]);
    expect(screen.getByText('Verified.')).toBeTruthy();
  });

  it('says on a phone, in the room that there is, that Connect comes first', async () => {
    vi.spyOn(globalThis, 'matchMedia').mockImplementation((query) => ({ matches: query === NARROW }) as MediaQueryList);
    await opened({ plug: { granted: true } });
    await make();
    await type('DT time', '4:00');
    expect(screen.getByRole('button', { name: en.program.connectAndWrite }).textContent).toBe('Connect…');
  });

  it('waits for a timer that sleeps, and writes nothing unasked when it wakes', async () => {
    const { timer, write } = await opened({ plug: { granted: true } });
    timer.core.sleep();
    await make();
    await press(en.program.connectAndWrite);
    timer.core.press();
    await idle();
    expect([timer.core.content.times[1], write.current.value]).toEqual([1050, null]);
    expect(field('Function 1 time').value).toBe('0.30');
  });
});

describe('a view that asks for a timer', () => {
  it.each([
    ['bench', 'Start'],
    ['memories', 'M1'],
  ] as const)('%s: Connect stands beside the sentence, and the view stays open', async (view, shown) => {
    await opened();
    await goTo(view);
    expect(screen.getByText(/^Connect a timer to /)).toBeTruthy();
    await press('Connect');
    expect(screen.queryByText(/^Connect a timer to /)).toBeNull();
    expect(within(screen.getByRole('main')).getAllByText(shown).length).toBeGreaterThan(0);
    expect(document.documentElement.getAttribute('data-view')).toBe(view);
  });
});

describe('what this device keeps', () => {
  it('is listed by name and time, opened, and deleted after a question', async () => {
    const bench = await opened();
    await make();
    await type('DT time', '4:00');
    await press(en.header.closeProgram);
    expect(card(en.start.models.title).getByText('DT 4:00 min')).toBeTruthy();
    await press(/^Open F1Q, new \d\d:\d\d DT 4:00 min$/);
    expect(field('DT time').value).toBe('4:00');
    await press(en.header.closeProgram);
    await press(/^Delete: F1Q/);
    await press(en.cancel);
    await press(/^Delete: F1Q/);
    await press('Delete');
    expect([screen.queryByText(en.start.programs.title), bench.store.drafts.records.size]).toEqual([null, 0]);
  });

  it('includes changes that are in no timer', async () => {
    const bench = await connected();
    await type('Function 2, S1', '7');
    await run(bench.session.timer.disconnect());
    await press(en.header.closeProgram);
    await press(/^Open F1Q, M1, changes \d/);
    expect(field('Function 2, S1').value).toBe('7');
  });

  it('includes backups, the last with its time, and draws that one', async () => {
    const bench = await connected();
    expect(bench.session.backups.list.value).toEqual([]);
    await type('DT time', '4:00');
    await press('Write…');
    fireEvent.click(screen.getByRole('checkbox', { name: /^The propeller is off/ }));
    await idle(0);
    await press(/^Write 1 change$/);
    cleanup();
    await drawn(await reloaded(bench));
    const backups = screen.getByRole('link', {
      name: /^1 backup, kept before a write\. The last: \d\d:\d\d, F1Q\s· M1\.$/,
    });
    expect(backups.getAttribute('href')).toBe('#memories');
    const picture = within(screen.getByRole('figure'));
    expect(picture.getByText('F1Q, M1')).toBeTruthy();
    expect(picture.getByText('DT 3:00 min'), 'the picture shows the backup: the DT before the write').toBeTruthy();
  });

  it('is nothing at first, and then the picture says that it is an example', async () => {
    await opened();
    expect(within(screen.getByRole('figure')).getByText(en.start.picture.example)).toBeTruthy();
    expect([screen.queryByText(en.start.programs.title), screen.queryByRole('link', { name: /backup/ })]).toEqual([
      null,
      null,
    ]);
  });
});

describe('the page on this device', () => {
  it('is installed by a click, where the browser offers that', async () => {
    const { models } = await opened();
    const window = new EventTarget();
    models.installation.follow(window);
    expect(screen.queryByRole('button', { name: 'Install' })).toBeNull();
    let asked = 0;
    const offer = Object.assign(new Event('beforeinstallprompt', { cancelable: true }), {
      prompt: async () => void asked++,
    });
    window.dispatchEvent(offer);
    await idle(0);
    expect(offer.defaultPrevented, 'the browser does not ask before the click').toBe(true);
    await press('Install');
    expect([asked, screen.queryByRole('button', { name: 'Install' })]).toEqual([1, null]);
    window.dispatchEvent(offer);
    expect(models.installation.install.value).not.toBeNull();
    window.dispatchEvent(new Event('appinstalled'));
    expect(models.installation.install.value, 'the browser has installed it by its own menu').toBeNull();
  });
});

describe('Firefox', () => {
  it('gets the note that it asks for the port again at each load, and no other browser does', async () => {
    await opened();
    expect(screen.queryByText(/Firefox/)).toBeNull();
    cleanup();
    await opened({ platform: FIREFOX });
    expect(screen.getByText(en.start.firefox)).toBeTruthy();
  });

  it('says what a phone can connect to, and only there', async () => {
    await opened();
    expect(screen.queryByText(en.start.android)).toBeNull();
    cleanup();
    await opened({ platform: ANDROID });
    expect(screen.getByText(en.start.android)).toBeTruthy();
  });
});
