import { afterEach, expect, it } from 'vitest';
import { Density } from '../../../src/app/settings/density.js';

afterEach(() => localStorage.clear());

it('the height of rows follows the screen or the choice, and is kept', () => {
  const page = document.implementation.createHTMLDocument();
  const tablet = Object.assign(new EventTarget(), { matches: true });
  const turn = (matches: boolean): void => {
    tablet.matches = matches;
    tablet.dispatchEvent(new Event('change'));
  };
  const density = new Density();
  const stop = density.follow(page, tablet as MediaQueryList);
  const shown = () => page.documentElement.getAttribute('data-density');
  expect(shown()).toBe('comfortable');
  turn(false);
  expect(shown()).toBe('dense');
  density.choose('comfortable');
  expect([shown(), new Density().chosen.value]).toEqual(['comfortable', 'comfortable']);
  density.choose('dense');
  turn(true);
  expect(shown()).toBe('dense');
  density.choose('system');
  expect(shown()).toBe('comfortable');
  stop();
  turn(false);
  expect(shown(), 'after stop() the page no longer follows the screen').toBe('comfortable');
});

it('rows are dense when the browser says nothing about the screen', () => {
  const page = document.implementation.createHTMLDocument();
  new Density().follow(page, null);
  expect(page.documentElement.getAttribute('data-density')).toBe('dense');
});
