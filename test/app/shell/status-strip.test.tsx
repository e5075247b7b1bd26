import { act, fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { SHAPES, TIGHT } from '../../../src/app/ui/shapes.js';
import { en } from '../../tools/en.js';
import { idle } from '../bench/bench.js';
import { connected, drawn, goTo, inWindow, lookAt, opened, press, type } from '../screen.js';
import { CALM, lancerBench } from '../two-models.js';

const figures = () => document.querySelector('.strip-more') as HTMLButtonElement;
const isOpen = () => figures().getAttribute('aria-expanded') === 'true';
const panel = () => within(document.querySelector('.strip-panel') as HTMLElement);

async function openFigures(): Promise<void> {
  figures().click();
  await idle();
  expect(isOpen()).toBe(true);
}

const onPhone = (): void => inWindow((query) => query.includes(SHAPES.phone));
const onTablet = (): void => inWindow((query) => query === TIGHT);

it('a phone has no presets for the memory that flies next below the name of another one', async () => {
  onPhone();
  await connected();
  await openFigures();
  expect(panel().getByRole('button', { name: 'DT 3 min' })).toBeTruthy();
  await lookAt('M3');
  await openFigures();
  expect(panel().queryByRole('button', { name: 'DT 3 min' })).toBeNull();
  expect(panel().getByRole('button', { name: 'Disconnect' })).toBeTruthy();
});

it('on a phone the panel gives way to what was asked for', async () => {
  onPhone();
  const app = await connected();
  await openFigures();
  await lookAt('M3');
  expect(isOpen(), 'M3 is shown').toBe(false);
  await openFigures();
  await press('Edit M3');
  expect(screen.getByText(en.nextFlight.onScreen({ memory: 'M3' }))).toBeTruthy();
  expect(isOpen(), 'M3 was read').toBe(false);
  await openFigures();
  await lookAt('M1, flies next');
  await idle();
  expect([isOpen(), app.editor.working.value?.memory], 'M1 is shown').toEqual([false, 0]);
  await openFigures();
  await lookAt('M3');
  await openFigures();
  await press('Make M3 fly next');
  expect([app.timer.core.memory, isOpen()]).toEqual([2, false]);
  await openFigures();
  screen.getByRole('button', { name: 'Disconnect' }).focus();
  await press('Disconnect');
  expect([app.session.link.state.value.status, isOpen()]).toEqual(['off', false]);
});

it('on a tablet, too: that a memory is only looked at is said once', async () => {
  onTablet();
  await connected();
  await openFigures();
  await lookAt('M3');
  expect(isOpen()).toBe(false);
  expect(screen.getAllByText('For looking only. M1 flies next.')).toHaveLength(1);
});

it('the panel stays open while keys walk through the memories', async () => {
  onPhone();
  await connected();
  await openFigures();
  for (const memory of ['M2', 'M3']) {
    // As an arrow key does: it moves the focus with the choice.
    screen.getByRole('radio', { name: memory }).focus();
    await lookAt(memory);
    expect([isOpen(), document.activeElement?.getAttribute('aria-label')]).toEqual([true, memory]);
  }
  fireEvent.keyDown(document.activeElement as Element, { key: 'Escape' });
  await idle();
  expect([isOpen(), document.activeElement]).toEqual([false, figures()]);
});

it.each(['99:99', '5:00x'])('a figure whose cell says %s is not valid, not the value before it', async (text) => {
  await connected();
  const dt = () => document.querySelector('.strip-figure');
  await type('DT time', text);
  expect([dt()?.textContent?.trim(), dt()?.className]).toEqual([`DT ${en.strip.notValid}`, 'strip-figure bad']);
  expect(document.querySelector('.presets [aria-current="true"]'), 'nor is the preset before it').toBeNull();
  await type('DT time', '5:00');
  expect(dt()?.textContent).toBe('DT 5:00 min');
});

it('says what is true also after a tool has put its own text into every element', async () => {
  const app = await connected();
  const strip = document.querySelector('.strip') as HTMLElement;
  const words = () => strip.textContent.replace(/\s+/g, ' ');
  // As a translator does: another element, with another text.
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const found: Text[] = [];
  while (texts.nextNode()) found.push(texts.currentNode as Text);
  for (const text of found) {
    const wrapped = document.createElement('font');
    wrapped.textContent = text.data;
    text.replaceWith(wrapped);
  }
  await type('DT time', '6:00');
  await type(en.program.motorStopTime, '12');
  expect(words()).toContain(en.program.changes({ count: 2 }));
  expect(words()).toContain('DT 6:00 min');
  expect(words()).toContain('motor stop 12.0 s');
  expect(words()).not.toMatch(/As in the timer|3:00|10\.0/);
  act(() => app.adapter.unplug());
  await idle();
  expect(words()).toContain(en.link.status.away);
});

it('Connect stands where Disconnect stood, so that a second click closes no program', async () => {
  await connected();
  await press('Disconnect');
  const names = [...document.querySelectorAll('.strip .top-actions button')].map(({ textContent }) => textContent);
  expect(names[0]).toBe(en.header.closeProgram);
  expect(names.at(-1)).toBe('Connect');
});

it.each([
  ['a desktop', () => {}],
  ['a tablet', onTablet],
  ['a phone', onPhone],
])('on %s a simulated timer is never taken for a real one, also after Disconnect', async (_, onDevice) => {
  onDevice();
  await opened();
  const said = () => within(document.querySelector('.strip-line') as HTMLElement).queryAllByText(en.header.simulated);
  expect(said()).toHaveLength(0);
  await press('Try a simulated F1Q timer');
  expect(said()).toHaveLength(1);
  if (onDevice === onPhone) await openFigures();
  await press(en.header.disconnect);
  expect(said()).toHaveLength(1);
});

describe.each([
  ['a desktop', () => {}],
  ['a phone', onPhone],
])('on %s a figure of the strip leads to its field', (_, onDevice) => {
  const hasFocus = () => document.activeElement?.getAttribute('aria-label');

  it.each([
    ['from the program', async () => {}],
    ['from another view', async () => goTo('settings')],
    [
      'from a memory that is looked at',
      async () => {
        if (onDevice === onPhone) await openFigures();
        await lookAt('M3');
      },
    ],
    ['from the picture', async () => onDevice === onPhone && (await press(en.program.picture))],
  ])('%s', async (_, before) => {
    onDevice();
    const app = await connected();
    await before();
    await press(/^DT 3:00/);
    expect(hasFocus()).toBe('DT time');
    await type('DT time', '2:30');
    expect(app.session.editor.changes.value.map(({ to }) => to)).toEqual([15000]);
    await press(/^motor stop/i);
    expect(hasFocus()).toBe(en.program.motorStopTime);
  });
});

it.each(['program', 'library', 'settings'] as const)(
  'while connected, the head of the view %s names the saved program that is open, and what is not saved',
  async (view) => {
    onPhone();
    const app = await drawn(await lancerBench());
    await press('Connect');
    await act(async () => {
      await app.session.opened.show(CALM);
    });
    await type('DT time', '2:00');
    await goTo(view);
    const { ofModel, ofSetting } = en.knowledge;
    const head = document.querySelector('.top') as HTMLElement;
    expect(
      within(head).getByText(ofSetting({ name: ofModel({ name: 'calm', model: 'Lancer' }), changes: 1 })),
    ).toBeTruthy();
  },
);

it('Connect comes back to a simulated timer, and another adapter can be chosen', async () => {
  const app = await opened();
  await press('Try a simulated F1Q timer');
  await press(en.header.disconnect);
  expect(screen.getByRole('button', { name: en.header.choosePort })).toBeTruthy();
  await press(en.header.connect);
  expect([app.session.link.state.value.status, app.session.link.simulated.value]).toEqual(['on', true]);
});

it('Connect goes to a real timer that is plugged in, also when a simulated one was tried before', async () => {
  const app = await opened({ plug: { granted: true } });
  await press('Try a simulated F1Q timer');
  await press(en.header.disconnect);
  await press(en.header.connect);
  expect([app.session.link.state.value.status, app.session.link.simulated.value]).toEqual(['on', false]);
});
