import { act, cleanup, fireEvent, screen, within } from '@testing-library/preact';
import { afterEach, describe, expect, it, onTestFinished } from 'vitest';
import { TABS_BELOW } from '../../../src/app/ui/use-query.js';
import { idle, type MemoryStore, reloaded, run } from '../bench/bench.js';
import { button, connected, drawn, goTo, inWindow, opened, press, type } from '../screen.js';

const PAGES = {
  checklist: 'Before the flight',
  trouble: 'When something is wrong',
  words: 'What the values are',
  energy: 'Energy for F1Q',
  steps: 'First steps',
};
type Page = keyof typeof PAGES;

/** Goes to a page of the help, as its link does. */
async function look(models: { views: { show(view: 'help', path: string): void } }, page: string): Promise<void> {
  act(() => models.views.show('help', page));
  await idle(0);
}

afterEach(() => localStorage.clear());

describe('the help', () => {
  it.each(Object.keys(PAGES) as Page[])('has a page of its own for: %s', async (page) => {
    const { models } = await opened();
    await look(models, page);
    expect(screen.getByRole('heading', { level: 2, name: PAGES[page] })).toBeTruthy();
    const current = within(screen.getByRole('navigation', { name: 'Help pages' })).getAllByRole('link');
    expect(current.filter((link) => link.getAttribute('aria-current') === 'page')).toHaveLength(1);
  });

  it('marks the link that leads to it: on a phone that of the settings', async () => {
    const real = window.matchMedia;
    onTestFinished(() => {
      window.matchMedia = real;
    });
    const marked = () =>
      [...document.querySelectorAll('.view-links [aria-current]')].map((link) => [
        link.textContent,
        link.getAttribute('aria-current'),
      ]);
    await opened();
    await goTo('help');
    expect(marked()).toEqual([['Help', 'page']]);
    cleanup();
    window.matchMedia = ((query: string) => ({ ...real.call(window, query), matches: true })) as typeof real;
    await opened();
    await goTo('help');
    expect(marked()).toEqual([['Settings', 'true']]);
  });

  it.each(['', 'nowhere', 'words/more', 'constructor'])('begins with the checklist at “%s”', async (path) => {
    const { models } = await opened();
    await look(models, path);
    expect(screen.getByRole('heading', { level: 2, name: 'Before the flight' })).toBeTruthy();
  });

  it('opens by the key ?, but not in a text field or while a dialog is open', async () => {
    const { views } = await connected();
    const hit = (target: Element): void => {
      act(() => void fireEvent.keyDown(target, { key: '?' }));
    };
    hit(screen.getByRole('textbox', { name: 'DT time' }));
    expect(views.shown.value).toBe('program');
    await press('What the values are');
    hit(document.body);
    expect(views.shown.value).toBe('program');
    await press('Close');
    hit(document.body);
    expect(views.shown.value).toBe('help');
  });

  it('is shown in short over the table that it explains, and leads to the rest', async () => {
    const { views } = await connected();
    await press('What the values are');
    const dialog = within(screen.getByRole('dialog', { name: 'What the values are' }));
    expect(dialog.getByText('0 to 130 steps.')).toBeTruthy();
    expect(dialog.getByText('Motor stop')).toBeTruthy();
    fireEvent.click(dialog.getByRole('button', { name: 'More about each' }));
    await idle(0);
    expect([views.shown.value, views.path.value, screen.queryByRole('dialog')]).toEqual(['help', 'words', null]);
  });

  it('says nothing about a motor on a class without one', async () => {
    await connected({ identity: { timerClass: 'B' } });
    await press('What the values are');
    expect(within(screen.getByRole('dialog')).queryByText('Motor stop')).toBeNull();
  });
});

describe('the first steps', () => {
  it('are three, stand below Connect, and are not shown again when they were seen', async () => {
    const bench = await opened();
    expect(screen.getByText('First steps, 1 of 3')).toBeTruthy();
    const connect = button('Connect');
    const card = screen.getByRole('region', { name: 'Read the timer' });
    expect(connect.compareDocumentPosition(card) & Node.DOCUMENT_POSITION_FOLLOWING).toBeTruthy();
    await press('Next');
    await press('Next');
    expect(screen.getByText('First steps, 3 of 3')).toBeTruthy();
    await press('Back');
    await press('Next');
    await press('Done');
    expect(screen.queryByText(/^First steps, /)).toBeNull();
    cleanup();
    await drawn(await reloaded(bench));
    expect(screen.queryByText(/^First steps, /)).toBeNull();
  });

  it('are skipped by one press, for good', async () => {
    await opened();
    await press('Skip');
    cleanup();
    await opened();
    expect(screen.queryByText(/^First steps, /)).toBeNull();
  });

  it('are not shown to a pilot who has reached a timer or has kept something', async () => {
    const bench = await connected();
    await run(bench.session.timer.disconnect());
    await press('Close program');
    expect(screen.queryByText(/^First steps, /)).toBeNull();
    localStorage.clear();
    cleanup();
    const store: MemoryStore = bench.store;
    await opened({ store });
    expect(screen.getByText('First steps, 1 of 3'), 'nothing is kept yet, so the first steps are shown').toBeTruthy();
    await press('New program…');
    await press('Make the program');
    await press('Close program');
    expect(screen.queryByText(/^First steps, /)).toBeNull();
  });
});

describe('what the checklist says of the timer', () => {
  const known = (): string => document.querySelector('.known-now')?.textContent?.trim() ?? '';

  it('is nothing before one was read', async () => {
    const { models } = await opened();
    await look(models, 'checklist');
    expect(known()).toBe('No timer has been read. Connect to see its memory and DT here.');
  });

  it('is what flies next while the timer is connected, and else what was last read', async () => {
    const { models, session } = await connected();
    await look(models, 'checklist');
    expect(known()).toMatch(/^M1 flies next, DT\u00a03:00\u00a0min, read \d\d:\d\d\.$/);
    await run(session.timer.disconnect());
    await idle(0);
    expect(known()).toMatch(/^M1, DT\u00a03:00\u00a0min, as last read \d\d:\d\d\.$/);
  });

  it('is what the timer holds, and how many changes are not in it yet', async () => {
    const { models } = await connected();
    await type('DT time', '6:00');
    await look(models, 'checklist');
    expect(known()).toMatch(
      /^M1 flies next, DT\u00a03:00\u00a0min, read \d\d:\d\d\. 1 change is not in the timer yet\.$/,
    );
  });

  it('never comes from a program that is in no timer', async () => {
    const bench = await opened();
    await press('New program…');
    await press('Make the program');
    await look(bench.models, 'checklist');
    expect(known()).toBe('No timer has been read. Connect to see its memory and DT here.');
    cleanup();
    const { models, editor } = await drawn(await reloaded(bench));
    await look(models, 'checklist');
    expect(editor.madeAt.value).not.toBeNull();
    expect(known()).toBe('No timer has been read. Connect to see its memory and DT here.');
  });

  it('is that nobody knows, after a write was cut off', async () => {
    const { models, adapter, timer } = await connected();
    await type('DT time', '4:00');
    await press('Write…');
    fireEvent.click(screen.getByRole('checkbox', { name: /^The propeller is off/ }));
    await idle(0);
    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS') adapter.unplug();
      return name === 'SETTIMERS';
    };
    await press(/^Write 1 change$/);
    await look(models, 'checklist');
    expect(known()).toBe('It is not known what M1 holds. Read it before you fly.');
  });
});

describe('the energy', () => {
  const fill = (label: string, value: string): void => {
    act(() => void fireEvent.input(screen.getByLabelText(label), { target: { value } }));
  };

  it('is worked out while the pilot types, from watts or from volts and amperes, with the age of the rule', async () => {
    const { models } = await opened();
    await look(models, 'energy');
    expect(screen.getByText(/told it around 2022\. Rules change: check/)).toBeTruthy();
    const rule = (): string => screen.getByText(/^The rule: /).textContent ?? '';
    expect(rule()).toMatch(/^The rule: 3 J for each gram of the model, at most 1650 J, and at most 40 s\./);
    fill('Weight of the model', '480');
    fill('Power', '165');
    expect([screen.getByText('1440 J'), screen.getByText('8.7 s')]).toHaveLength(2);
    fireEvent.click(screen.getByRole('radio', { name: 'Volts and amperes' }));
    await idle(0);
    expect(screen.queryByText('1440 J')).toBeNull();
    fill('Battery voltage', '11,1');
    fill('Battery current', '15');
    expect(screen.getByText('8.6 s')).toBeTruthy();
    fireEvent.click(screen.getByRole('radio', { name: 'Fly-off' }));
    await idle(0);
    expect(screen.getByText('960 J')).toBeTruthy();
    expect(rule()).toMatch(/^The rule: 2 J for each gram .* at most 20 s\..* less certain even then\.$/);
  });

  it('says which figures are possible, and gives no result for others', async () => {
    const { models } = await opened();
    await look(models, 'energy');
    fill('Power', '165');
    fill('Weight of the model', '9');
    expect(screen.getByRole('alert').textContent).toBe('Type a figure from 10 g to 5000 g.');
    expect(screen.getByText(/^Type the weight and the power/)).toBeTruthy();
  });

  it('is compared with the motor stop on the screen, if the class has one', async () => {
    const { models } = await connected();
    await look(models, 'energy');
    fill('Weight of the model', '480');
    fill('Power', '165');
    expect(screen.getByText(/stops the motor at 10\.0 s: 1650 J\. That is more than is allowed\.$/)).toBeTruthy();
    fill('Power', '140');
    expect(screen.getByText(/stops the motor at 10\.0 s: 1400 J\. That is within the limit\.$/)).toBeTruthy();
    cleanup();
    const glider = await connected({ identity: { timerClass: 'E' } });
    await look(glider.models, 'energy');
    fill('Weight of the model', '480');
    fill('Power', '165');
    expect(screen.queryByText(/stops the motor/)).toBeNull();
  });
});

it('a symptom of the connection has the same steps as the page shows when it happens', async () => {
  const { models } = await opened();
  await look(models, 'trouble');
  const symptom = within(screen.getByText('The timer does not answer').closest('details') as HTMLElement);
  expect(symptom.getByText(/^The timer falls asleep after one or two minutes\./)).toBeTruthy();
});

it('the settings lead to the help where the links to the views have no room for it', async () => {
  await opened();
  await goTo('settings');
  const links = () => screen.getAllByRole('link', { name: /^Help/ }).map(({ textContent }) => textContent);
  expect(links()).toEqual(['Help']);
  cleanup();
  inWindow((query) => query === TABS_BELOW);
  await opened();
  await goTo('settings');
  expect(links()).toEqual(['Help: checklist, trouble, values, energy']);
});
