import { act, cleanup, fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it, onTestFinished } from 'vitest';
import { SHAPES } from '../../../src/app/ui/shapes.js';
import { en } from '../../tools/en.js';
import { idle, reloaded, run } from '../bench/bench.js';
import { connected, drawn, goTo, inWindow, opened, press, type } from '../screen.js';

const PAGES = en.guide.pages;
type Page = keyof typeof PAGES;

/** Goes to a page of the help, as its link does. */
async function look(models: { views: { show(view: 'help', path: string): void } }, page: string): Promise<void> {
  act(() => models.views.show('help', page));
  await idle(0);
}

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
    expect(screen.getByRole('heading', { level: 2, name: PAGES.checklist })).toBeTruthy();
  });

  it('opens by the key ?, but not in a text field or while a dialog is open', async () => {
    const { views, models } = await connected();
    const hit = (target: Element): void => {
      act(() => void fireEvent.keyDown(target, { key: '?' }));
    };
    hit(screen.getByRole('textbox', { name: 'DT time' }));
    expect(views.shown.value).toBe('program');
    act(() => models.erase.open());
    hit(document.body);
    expect(views.shown.value).toBe('program');
    await press(en.cancel);
    hit(document.body);
    expect(views.shown.value).toBe('help');
  });

  it('is where the ? of the table leads', async () => {
    const { models } = await connected();
    expect(screen.getByRole('link', { name: en.edits.table.explain }).getAttribute('href')).toBe('#help/words');
    await look(models, 'words');
    expect(screen.getByText(en.values.position.range)).toBeTruthy();
  });
});

describe('what the checklist says of the timer', () => {
  const known = (): string => document.querySelector('.known-now')?.textContent?.trim() ?? '';

  it('is nothing before one was read', async () => {
    const { models } = await opened();
    await look(models, 'checklist');
    expect(known()).toBe(en.checklist.known.nothing);
  });

  it('is what flies next while the timer is connected, and else what was last read', async () => {
    const { models, session } = await connected();
    await look(models, 'checklist');
    expect(known()).toMatch(/^M1 flies next, DT\u00a03:00\u00a0min, read \d\d:\d\d\.$/);
    await run(session.timer.disconnect());
    await idle(0);
    expect(known()).toMatch(/^As last read \d\d:\d\d: M1, DT\u00a03:00\u00a0min\.$/);
  });

  it('is what the timer holds, and how many changes are not in it yet', async () => {
    const { models } = await connected();
    await type('DT time', '6:00');
    await look(models, 'checklist');
    expect(known()).toMatch(/^M1 flies next, DT\u00a03:00\u00a0min, read \d\d:\d\d\. 1 change not in the timer yet\.$/);
  });

  it('never comes from a program that is in no timer', async () => {
    const bench = await opened();
    await press(en.newProgram.title);
    await press(en.newProgram.make);
    await look(bench.models, 'checklist');
    expect(known()).toBe(en.checklist.known.nothing);
    cleanup();
    const { models, editor } = await drawn(await reloaded(bench));
    await look(models, 'checklist');
    expect(editor.madeAt.value).not.toBeNull();
    expect(known()).toBe(en.checklist.known.nothing);
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

it('a symptom of the connection has the same steps as the page shows when it happens', async () => {
  const { models } = await opened();
  await look(models, 'trouble');
  const symptom = within(screen.getByText(en.troubles.symptoms.noAnswer.title).closest('details') as HTMLElement);
  expect(symptom.getByText(en.help.steps.battery)).toBeTruthy();
});

it('the settings lead to the help where the links to the views have no room for it', async () => {
  await opened();
  await goTo('settings');
  const links = () => screen.getAllByRole('link', { name: /^Help/ }).map(({ textContent }) => textContent);
  expect(links()).toEqual(['Help']);
  cleanup();
  inWindow((query) => query === SHAPES.phone);
  await opened();
  await goTo('settings');
  expect(links()).toEqual(['Help']);
});
