import { act, fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { formatTime } from '../../../src/app/editing/units.js';
import { dateText, messages } from '../../../src/app/messages/index.js';
import { moreMessages } from '../../../src/app/messages/more.js';
import { MODEL, SETTING } from '../../program/library-examples.js';
import { en } from '../../tools/en.js';
import { idle } from '../bench/bench.js';
import { connected, goTo, opened, press, type } from '../screen.js';

/** The view with these programs of a library: two of a model, and one that belongs to none. */
async function printed(...keys: readonly string[]): Promise<void> {
  const { session, printOrder } = await opened();
  const { library } = session;
  await library.keepModel(MODEL);
  await library.keepSetting(SETTING);
  await library.keepSetting({ ...SETTING, id: 'wind', name: 'wind', note: '' });
  await library.keepSetting({ ...SETTING, id: 'found', name: 'found', model: null });
  printOrder.choose(keys);
  await goTo('print');
  await idle();
}

const sheets = () => [...document.querySelectorAll<HTMLElement>('.print-sheets article')];
const rowsOf = (sheet: HTMLElement) =>
  within(within(sheet).getByRole('table', { name: en.program.tableCaption }))
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
    expect(rows.at(-1)).toMatch(/^DT 2:30 min was 3:00/);
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
    screen.getByText(en.print.choose({ chosen: 1 }));
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
    const { views, models } = await connected();
    const hit = (): boolean => {
      const key = new KeyboardEvent('keydown', { key: 'p', ctrlKey: true, bubbles: true, cancelable: true });
      act(() => void document.body.dispatchEvent(key));
      return key.defaultPrevented;
    };
    act(() => models.erase.open());
    expect([hit(), views.shown.value]).toEqual([false, 'program']);
    await press(en.cancel);
    expect([hit(), views.shown.value]).toEqual([true, 'print']);
    expect(sheets()).toHaveLength(1);
    expect([hit(), views.shown.value]).toEqual([false, 'print']);
    await goTo('help');
    expect([hit(), views.shown.value]).toEqual([false, 'help']);
  });

  it('begins with the choice of settings where there is nothing to print', async () => {
    const bench = await opened();
    bench.printOrder.choose(['gone']);
    await goTo('print');
    expect(document.querySelector<HTMLDetailsElement>('.print-picker')?.open).toBe(true);
    expect(screen.getByText(en.print.nothing)).toBeTruthy();
  });

  it('prints settings of several models, as many as are chosen', async () => {
    await printed('calm-morning');
    expect(sheets().map((sheet) => within(sheet).getByRole('heading', { level: 2 }).textContent)).toEqual([
      'Lancer 07',
    ]);
    expect(sheets()[0]?.querySelector('.leaf-origin')?.textContent).toBe(
      en.library.setting.origin({ source: en.library.setting.from.timer, time: dateText(SETTING.at) }),
    );
    choose(/^No\smodel\s· found$/);
    choose(/^Lancer\s07\s· wind$/);
    expect(sheets().map((sheet) => sheet.querySelector('.leaf-name')?.textContent)).toEqual([
      'calm morning',
      'found',
      'wind',
    ]);
    await press('Remove all');
    expect(screen.getByText(en.print.nothing)).toBeTruthy();
    expect(screen.getByRole<HTMLButtonElement>('button', { name: /^Print/ }).disabled).toBe(true);
    expect(document.querySelector('.back-head a')?.textContent, 'the way back stays').toBe('Library');
  });

  it('takes another paper, leaves out unwanted parts, and remembers both choices', async () => {
    await printed('calm-morning', 'wind', 'found');
    const papers = () => [...document.querySelectorAll('.leaf')].map((leaf) => leaf.className.match(/on-\w+/)?.[0]);
    expect(papers()).toEqual(['on-a5', 'on-a5', 'on-a5']);
    act(() => void fireEvent.click(screen.getByRole('radio', { name: 'A4' })));
    expect(papers()).toEqual(['on-a4', 'on-a4', 'on-a4']);
    const said = () => sheets()[0]?.textContent ?? '';
    const timelines = () => screen.queryAllByRole('img', { name: messages.value.timeline.picture });
    expect(said()).toMatch(new RegExp(`Turns left after 12 s\\..*${moreMessages.value.flights.title}`));
    expect(timelines()).toHaveLength(3);
    expect(timelines()[0]?.textContent, 'the timeline names the servos').toMatch(/S1Tailplane.*S2flaps/);
    for (const part of [en.print.notes, messages.value.timeline.title, en.print.parts.lines])
      choose(new RegExp(`^${part}`));
    expect(said()).not.toMatch(new RegExp(`Turns left|${moreMessages.value.flights.title}`));
    expect(timelines()).toEqual([]);
    choose(/^QR code/);
    expect(screen.getAllByRole('img', { name: en.print.parts.code })).toHaveLength(3);
    choose(/^QR code/);
    await goTo('library');
    await goTo('print');
    expect(papers()[0]).toBe('on-a4');
    expect(said()).not.toMatch(new RegExp(moreMessages.value.flights.title));
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
      sheet.textContent?.match(/Memory (M\d)/)?.[1],
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
    choose(new RegExp(`^${en.compare.screen}`));
    choose(/^M1\s· As\slast\sread/);
    expect(sheets().map(values)).toEqual([
      ['M3', 'As last read', dtOf(2)],
      ['M1', '1 change', '2:30'],
    ]);
    expect(screen.queryByRole('checkbox', { name: /^M2/ }), 'nobody has read M2').toBeNull();
    act(() => printOrder.choose(['memory 1']));
    expect(screen.getByText(en.print.nothing)).toBeTruthy();
  });
});
