import { screen, within } from '@testing-library/preact';
import { expect, it, onTestFinished } from 'vitest';
import { idle } from '../bench/bench.js';
import { connected, lookAt, press } from '../screen.js';

const figures = () => document.querySelector('.strip-figures') as HTMLButtonElement;
const isOpen = () => figures().getAttribute('aria-expanded') === 'true';
const panel = () => within(document.querySelector('.strip-panel') as HTMLElement);

async function openFigures(): Promise<void> {
  figures().click();
  await idle();
  expect(isOpen()).toBe(true);
}

/** Until the end of the test, this is a phone. */
function onPhone(): void {
  const real = window.matchMedia;
  onTestFinished(() => {
    window.matchMedia = real;
  });
  window.matchMedia = ((query: string) => ({
    ...real.call(window, query),
    matches: query.includes('max-width'),
  })) as typeof real;
}

it('no figure of the memory that flies next is below the name of another one', async () => {
  await connected();
  await openFigures();
  expect(panel().getByRole('textbox', { name: 'DT' })).toBeTruthy();
  await lookAt('M3');
  expect(isOpen()).toBe(true);
  expect(panel().queryAllByRole('textbox')).toEqual([]);
  expect(panel().getByText('For looking only. You edit and write M1, which flies next.')).toBeTruthy();
  await lookAt('M1, flies next');
  expect(panel().getByRole('textbox', { name: 'DT' })).toBeTruthy();
});

it('a phone has no presets for the memory that flies next below the name of another one, either', async () => {
  onPhone();
  await connected();
  await openFigures();
  expect(panel().getByRole('button', { name: 'DT 3 min' })).toBeTruthy();
  await lookAt('M3');
  await openFigures();
  expect(panel().queryByRole('button', { name: 'DT 3 min' })).toBeNull();
  expect(panel().queryAllByRole('textbox')).toEqual([]);
  expect(panel().getByRole('button', { name: 'Disconnect' })).toBeTruthy();
});

it('on a phone the large figures give way to what was asked for', async () => {
  onPhone();
  const app = await connected();
  await openFigures();
  await lookAt('M3');
  expect(isOpen(), 'M3 is shown').toBe(false);
  await openFigures();
  await press('Look at M3');
  expect(screen.getByRole('heading', { name: /^M3, read / })).toBeTruthy();
  expect(isOpen(), 'M3 was read').toBe(false);
  await openFigures();
  await press('Make M3 fly next');
  expect([app.timer.core.memory, isOpen()]).toEqual([2, false]);
  await openFigures();
  screen.getByRole('button', { name: 'Disconnect' }).focus();
  await press('Disconnect');
  within(screen.getByRole('dialog')).getByRole('button', { name: 'Disconnect' }).click();
  await idle();
  expect([app.session.link.state.value.status, isOpen()]).toEqual(['off', false]);
});

it('Connect stands where Disconnect stood, so that a second click closes no program', async () => {
  await connected();
  await press('Disconnect');
  const names = [...document.querySelectorAll('.strip .top-actions button')].map(({ textContent }) => textContent);
  expect(names[0]).toBe('Close program');
  expect(names.at(-1)).toBe('Connect');
});
