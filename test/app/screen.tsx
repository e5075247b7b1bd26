import { act, cleanup, fireEvent, render, screen, within } from '@testing-library/preact';
import { onTestFinished } from 'vitest';
import { App } from '../../src/app/app.js';
import type { View } from '../../src/app/shell/views.js';
import { en } from '../tools/en.js';
import { type AppBench, appBench, type BenchOptions, idle, reloaded } from './bench/bench.js';

let page: AppBench;

/** The whole screen, as the page starts. */
export async function opened(options: BenchOptions = {}): Promise<AppBench> {
  return drawn(await appBench(options));
}

/** Draws the whole screen of a page. */
export async function drawn(bench: AppBench): Promise<AppBench> {
  render(<App models={bench.models} />);
  page = bench;
  await idle(0);
  return bench;
}

/** The whole screen after Connect. */
export async function connected(options: BenchOptions = {}): Promise<AppBench> {
  const bench = await opened(options);
  await press('Connect');
  table();
  return bench;
}

/** The page is loaded again: see `reloaded`. */
export async function loadedAgain(bench: AppBench): Promise<AppBench> {
  cleanup();
  const after = await drawn(await reloaded(bench));
  await idle();
  return after;
}

/** Goes to a view, as a click on its link does. */
export async function goTo(view: View): Promise<void> {
  page.models.views.show(view);
  await idle(0);
}

/** Until the end of the test, the window is one for which these queries match. */
export function inWindow(matches: (query: string) => boolean): void {
  const real = window.matchMedia;
  onTestFinished(() => {
    window.matchMedia = real;
  });
  window.matchMedia = ((query: string) => ({ ...real.call(window, query), matches: matches(query) })) as typeof real;
}

export async function press(name: string | RegExp): Promise<void> {
  if (/^(Copy M\d to|Read and keep all)/.test(String(name))) await goTo('memories');
  fireEvent.click(button(name));
  await idle();
}

/** In the dialog of a write: ticks that it is safe, unless that was said before, and starts it. */
export async function startWrite(): Promise<void> {
  const safety = screen.getByRole<HTMLInputElement>('checkbox', { name: /^The propeller is off/ });
  if (!safety.checked) fireEvent.click(safety);
  await press(/^(Write \d+ changes?|Read back.*)$/);
}

/** Looks at a memory, by its name for screen readers: “M1, flies next” for the current one. */
export async function lookAt(name: string | RegExp): Promise<void> {
  fireEvent.click(screen.getByRole('radio', { name }));
  await idle(0);
}

/** Makes a memory fly next. */
export async function fly(name: string): Promise<void> {
  await lookAt(name);
  // The memory cards have such a button, too.
  const look = within(document.querySelector<HTMLElement>('.memory-look') as HTMLElement);
  fireEvent.click(look.getByRole('button', { name: `Make ${name} fly next` }));
  await idle();
}

/** The reading of M3 is cut: the timer falls asleep on the way, and is back with M3 as the memory that flies next. */
export async function strandAtM3({ timer: { core } }: AppBench): Promise<void> {
  await lookAt('M3');
  core.onAnswer = ({ name }) => name === 'GETSERVOPOS' && core.memory === 2 && core.sleep();
  await press('Edit M3');
  core.onAnswer = undefined;
  core.press();
  await idle();
}

/** A field of the program. */
export function field(name: string): HTMLInputElement {
  return screen.getByRole<HTMLInputElement>('textbox', { name });
}

/** Presses a key where the focus is. */
export async function key(key: string, held: KeyboardEventInit = {}): Promise<void> {
  fireEvent.keyDown(document.activeElement ?? document.body, { key, ...held });
  await idle();
}

export async function type(name: string, text: string): Promise<void> {
  const input = field(name);
  input.focus();
  fireEvent.input(input, { target: { value: text } });
  input.blur();
  await idle();
  await late();
}

/** Waits for what is drawn one frame after the field. */
export async function late(): Promise<void> {
  for (let frame = 0; frame < 3; frame++) {
    await act(() => new Promise<void>((resolve) => requestAnimationFrame(() => resolve())));
  }
}

export function button(name: string | RegExp): HTMLButtonElement {
  // Its label counts the changes.
  return screen.getByRole<HTMLButtonElement>('button', { name: name === 'Write…' ? /^Write( \d+ changes?)?…$/ : name });
}

/** The table of the program; the log of the line is another one. */
export function table() {
  return within(screen.getByRole('table', { name: en.program.tableCaption }));
}
