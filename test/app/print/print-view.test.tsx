import { act, fireEvent, screen, within } from '@testing-library/preact';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { formatTime } from '../../../src/app/editing/units.js';
import { MODEL, SETTING } from '../../program/library-examples.js';
import { type AppBench, idle } from '../bench/bench.js';
import { connected, goTo, opened, press, type } from '../screen.js';

afterEach(() => localStorage.clear());

/** A library with a model of two settings, and one setting that belongs to none. */
async function withLibrary(): Promise<AppBench> {
  const bench = await opened();
  const { library } = bench.session;
  await library.keepModel(MODEL);
  await library.keepSetting(SETTING);
  await library.keepSetting({ ...SETTING, id: 'wind', name: 'wind', note: '' });
  await library.keepSetting({ ...SETTING, id: 'found', name: 'found', model: null });
  return bench;
}

const pages = () => [...document.querySelectorAll<HTMLElement>('.print-preview > .print-page')];
const sheets = () => [...document.querySelectorAll<HTMLElement>('.print-preview article')];
const rowsOf = (sheet: HTMLElement) =>
  within(within(sheet).getByRole('table', { name: 'Time and servo positions of each function' }))
    .getAllByRole('row')
    .map((row) => [...row.children].map(({ textContent }) => textContent).join(' '));
const choose = (name: RegExp) => act(() => void fireEvent.click(screen.getByRole('checkbox', { name })));

describe('the print view', () => {
  it('shows the program on the screen with every row, and whether it is in the timer', async () => {
    await connected();
    await type('DT time', '2:30');
    await goTo('print');
    const [sheet] = sheets();
    expect(document.querySelector<HTMLDetailsElement>('.print-picker')?.open).toBe(false);
    expect(sheets()).toHaveLength(1);
    const rows = rowsOf(sheet as HTMLElement);
    expect(rows).toHaveLength(13);
    expect(rows.at(-1)).toMatch(/^DT 2:30was 3:00/);
    expect(sheet?.querySelector('.leaf-origin')?.textContent).toMatch(
      /^1\schange\. Marked fields differ from what was last read, \d+\sNov/,
    );
    expect(sheet?.querySelector('.leaf-figures')?.textContent, 'the large figure says what the timer holds').toMatch(
      /2:30 min.*was 3:00/,
    );
    expect(sheet?.textContent, 'there is a line to write the name of the model on').toMatch(/^Model/);
  });

  it('leads back to where the first of what it prints is at home', async () => {
    const app = await connected();
    const back = (name: string) => screen.getByRole('main').querySelector(`.back-head a[href="#${name}"]`)?.textContent;
    /** The view that is marked in the rail: this one has no link there. */
    const marked = () =>
      [...document.querySelectorAll('.view-links [aria-current="true"]')].map(({ textContent }) => textContent);
    await goTo('print');
    expect([back('program'), marked()]).toEqual(['Program', ['Program']]);
    screen.getByText('On this print: the program on the screen');
    await goTo('program');
    app.models.printOrder.choose(['memory 1']);
    await goTo('print');
    expect([back('memories'), marked()]).toEqual(['Memories', ['Memories']]);
    await goTo('program');
    app.models.printOrder.choose(['some-setting']);
    await goTo('print');
    expect([back('library'), marked()]).toEqual(['Library', ['Library']]);
  });

  it('is opened by Ctrl+P where a sheet can be printed; elsewhere, and over a dialog, the browser prints', async () => {
    const { views } = await connected();
    const hit = (): boolean => {
      const key = new KeyboardEvent('keydown', { key: 'p', ctrlKey: true, bubbles: true, cancelable: true });
      act(() => void document.body.dispatchEvent(key));
      return key.defaultPrevented;
    };
    await press('What the values are');
    expect([hit(), views.shown.value]).toEqual([false, 'program']);
    await press('Close');
    expect([hit(), views.shown.value]).toEqual([true, 'print']);
    expect(sheets()).toHaveLength(1);
    expect([hit(), views.shown.value]).toEqual([false, 'print']);
    await goTo('help');
    expect([hit(), views.shown.value]).toEqual([false, 'help']);
  });

  it('begins with the choice of settings where there is nothing to print', async () => {
    await opened();
    await goTo('print');
    const isOpen = () => document.querySelector<HTMLDetailsElement>('.print-picker')?.open;
    expect([isOpen(), screen.getByText(/Nothing is chosen/).textContent]).toEqual([true, expect.any(String)]);
  });

  it('says that the library is empty, or that the search finds nothing in it', async () => {
    const hint = () => document.querySelector('.print-picker > .hint')?.textContent;
    const bench = await opened();
    await goTo('print');
    await idle();
    expect(hint()).toMatch(/no\ssettings to print yet/);
    await act(async () => void (await bench.session.library.keepSetting(SETTING)));
    expect(hint()).toBeUndefined();
    act(() => void fireEvent.input(screen.getByRole('searchbox'), { target: { value: 'storm' } }));
    expect(hint()).toMatch(/no\ssuch setting/);
  });

  it('prints settings of several models, as many as are chosen', async () => {
    const bench = await withLibrary();
    bench.printOrder.choose(['calm-morning']);
    await goTo('print');
    await idle();
    expect(sheets().map((sheet) => within(sheet).getByRole('heading', { level: 2 }).textContent)).toEqual([
      'Lancer 07',
    ]);
    expect(sheets()[0]?.textContent).toMatch(/Read from the timer \d+\sNov\s2026/);
    choose(/^No\smodel\s· found$/);
    choose(/^Lancer\s07\s· wind$/);
    expect(sheets().map((sheet) => sheet.querySelector('.leaf-name')?.textContent)).toEqual([
      'calm morning',
      'found',
      'wind',
    ]);
    await press('Remove all');
    expect(screen.getByText(/Nothing is chosen/)).toBeTruthy();
    expect(screen.getByRole<HTMLButtonElement>('button', { name: /^Print/ }).disabled).toBe(true);
    expect(document.querySelector('.back-head a')?.textContent, 'the way back stays').toBe('Library');
  });

  it('prints two on a page, leaves out unwanted parts, and remembers both choices', async () => {
    const bench = await withLibrary();
    bench.printOrder.choose(['calm-morning', 'wind', 'found']);
    await goTo('print');
    await idle();
    expect(pages()).toHaveLength(3);
    act(() => void fireEvent.click(screen.getByRole('radio', { name: 'A4, two to a page' })));
    expect(pages().map((page) => page.querySelectorAll('article').length)).toEqual([2, 1]);
    expect(screen.getByRole('button', { name: 'Print 2 pages…' })).toBeTruthy();
    const said = () => sheets()[0]?.textContent ?? '';
    expect(said()).toMatch(/Turns left after 12 s\..*Flights/);
    expect(
      screen.getAllByRole('img', { name: /S1 Tailplane, S2 flaps/ }),
      'the timeline on each sheet of a model names its servos',
    ).toHaveLength(2);
    for (const part of [/^Notes/, /^Timeline/, /^Lines to write on/]) choose(part);
    expect(said()).not.toMatch(/Turns left|Flights/);
    expect(screen.queryByRole('img', { name: /S1 Tailplane/ })).toBeNull();
    choose(/^QR code/);
    expect(screen.getAllByRole('img', { name: 'QR code of this setting' })).toHaveLength(3);
    choose(/^QR code/);
    await goTo('library');
    await goTo('print');
    expect(pages()).toHaveLength(2);
    expect(said()).not.toMatch(/Flights/);
  });

  it('prints the memories that were read, as the timer held them, from Memories', async () => {
    const { session, memories, printOrder } = await connected();
    await goTo('memories');
    const button = () => screen.getByRole<HTMLButtonElement>('button', { name: 'Print…' });
    void memories.readOnce(2);
    await idle();
    await goTo('program');
    await type('DT time', '2:30');
    await goTo('memories');
    act(() => button().click());
    await idle();
    const values = (sheet: Element) => [
      sheet.textContent?.match(/Memory ?(M\d)/)?.[1],
      sheet.textContent?.match(/As last read|1\schange/)?.[0].replace(/\s/g, ' '),
      rowsOf(sheet as HTMLElement)
        .at(-1)
        ?.split(' ')[1],
    ];
    const dtOf = (memory: number): string => {
      const known = session.knowledge.of(memory);
      return known.state === 'read' ? formatTime(known.program.times.at(-1) ?? 0) : '';
    };
    expect(sheets().map(values)).toEqual([
      ['M1', 'As last read', dtOf(0)],
      ['M3', 'As last read', dtOf(2)],
    ]);
    expect(dtOf(0)).not.toBe('2:30');
    choose(/^The program on the screen/);
    choose(/^M1, as last read/);
    expect(sheets().map(values)).toEqual([
      ['M3', 'As last read', dtOf(2)],
      ['M1', '1 change', '2:30was'],
    ]);
    expect(screen.queryByRole('checkbox', { name: /^M2/ }), 'nobody has read M2').toBeNull();
    act(() => printOrder.choose(['memory 1']));
    expect(screen.getByText(/Nothing is chosen/)).toBeTruthy();
    expect(screen.queryByText(/not in the library/)).toBeNull();
  });

  it('says what is missing, and that the print window did not open', async () => {
    const bench = await withLibrary();
    bench.printOrder.choose(['calm-morning', 'gone']);
    vi.stubGlobal('print', () => {
      throw new Error('not here');
    });
    await goTo('print');
    await idle();
    expect(screen.getByText(/One of these settings is not in the library/)).toBeTruthy();
    await press('Print 1 page…');
    expect(screen.getByRole('alert').textContent).toMatch(/did not open its print window/);
    vi.unstubAllGlobals();
  });

  it('prints at most a hundred sheets, and says how many are left', async () => {
    const bench = await opened();
    const keys = Array.from({ length: 102 }, (_, at) => `setting-${at}`);
    for (const id of keys) await bench.session.library.keepSetting({ ...SETTING, id, model: null });
    bench.printOrder.choose(keys);
    await goTo('print');
    await idle();
    expect(sheets()).toHaveLength(100);
    expect(screen.getByText(/^2 settings are not on this print/)).toBeTruthy();
  });

  it('prints a setting as another tab has changed it', async () => {
    const bench = await withLibrary();
    bench.printOrder.choose(['wind']);
    await goTo('print');
    await idle();
    await act(async () => void (await bench.session.library.keepSetting({ ...SETTING, id: 'wind', name: 'storm' })));
    expect(sheets()[0]?.querySelector('.leaf-name')?.textContent).toBe('storm');
  });
});
