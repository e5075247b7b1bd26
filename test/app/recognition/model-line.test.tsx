import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import type { ModelRecord } from '../../../src/app/storage/index.js';
import type { TimerProgram } from '../../../src/program/index.js';
import { en } from '../../tools/en.js';
import { type AppBench, idle, MemoryStore } from '../bench/bench.js';
import { button, drawn, goTo, press } from '../screen.js';
import { LANCER_HELD, lancerStarted, modelOf } from '../two-models.js';

const THEN = new Date(2025, 10, 12, 14, 32).getTime();

function record(name: string, program?: TimerProgram): ModelRecord {
  const { model, ...rest } = modelOf(name, LANCER_HELD);
  const verified = program ? [{ program, at: THEN }] : [];
  return { ...rest, verified, model: { ...model, memoryNames: ['calm'] } };
}

/** After Connect, on a device that keeps these models. */
async function withModels(...models: readonly ModelRecord[]): Promise<AppBench> {
  const store = new MemoryStore();
  for (const model of models) store.models.records.set(model.key, model);
  const bench = await drawn(await lancerStarted(store));
  await press('Connect');
  return bench;
}

const line = (): string | undefined => document.querySelector('.model-line p')?.textContent ?? undefined;
const list = () => within(screen.getByRole('dialog', { name: en.whichModel.recognition.dialog.title }));

describe('the line about the model', () => {
  it('is its name and the day, shown once', async () => {
    await withModels(record('Lancer 07', LANCER_HELD));
    expect(line()).toBe('This is Lancer 07, as seen 12\u00a0Nov\u00a02025.');
    await press('OK');
    expect(line()).toBeUndefined();
    expect(button('Model Lancer 07: say which model it is').textContent).toBe('Lancer 07');
  });

  it('is a question when some values differ, and Yes answers it', async () => {
    const changed = { ...LANCER_HELD, times: LANCER_HELD.times.with(10, 24_000).with(0, 900) };
    const { session } = await withModels(record('Lancer 07', changed));
    expect(line()).toBe('This is like Lancer 07, 2 values differ. Is it Lancer 07?');
    await press('Yes, Lancer 07');
    expect([line(), session.recognition.found.value?.kind]).toEqual([undefined, 'said']);
  });

  it('names all candidates, and a click chooses one', async () => {
    const { session } = await withModels(record('One', LANCER_HELD), record('Two', LANCER_HELD), record('Three'));
    expect(line()).toBe('This may be One or Two. Which model is it?');
    await press('Two');
    expect(session.origin.timer.value?.name).toBe('Two');
  });

  it('is short when hundreds hold the same, also with one name; the list has all of them', async () => {
    const many = Array.from({ length: 300 }, (_, at) => record(`m${at}`, LANCER_HELD));
    await withModels(...many.map((each) => ({ ...each, model: { ...each.model, name: 'Lancer' } })));
    expect(line()).toBe('This may be Lancer, Lancer, Lancer, Lancer, Lancer or 295 more. Which model is it?');
    await press(en.whichModel.recognition.choose);
    expect(list().getAllByRole('button', { name: /^Lancer/ })).toHaveLength(300);
  });

  it('is not shown when no model is kept, and the strip still offers to name one', async () => {
    const { session } = await withModels();
    expect(line()).toBeUndefined();
    await press(en.recognition.which);
    fireEvent.input(list().getByRole('textbox', { name: 'Name' }), { target: { value: '  Lancer 08 ' } });
    fireEvent.submit(
      list().getByRole('button', { name: en.whichModel.recognition.dialog.keep }).closest('form') as HTMLFormElement,
    );
    await idle();
    expect(session.origin.timer.value?.name).toBe('Lancer 08');
    expect(screen.queryByRole('dialog')).toBeNull();
  });

  it('opens a list: the candidates first, then all others', async () => {
    const others = Array.from({ length: 12 }, (_, at) => record(`Model ${at}`));
    const { session } = await withModels(...others, record('Two', LANCER_HELD), record('One', LANCER_HELD));
    await press(en.whichModel.recognition.choose);
    const names = () =>
      list()
        .getAllByRole('listitem')
        .map((item) => item.querySelector('strong')?.textContent);
    expect(names().slice(0, 3)).toEqual(['One', 'Two', 'Model 0']);
    await press('Model 11');
    expect(session.origin.timer.value?.name).toBe('Model 11');
    // Corrected at any time.
    await press('Model Model 11: say which model it is');
    await press(/^Two/);
    expect(session.origin.timer.value?.name).toBe('Two');
  });

  it('does not ask again after “not now”', async () => {
    const { session } = await withModels(record('Three'));
    expect(line()).toBe(en.whichModel.recognition.unknown);
    await press('Choose…');
    fireEvent.click(list().getByRole('button', { name: 'Cancel' }));
    await idle(0);
    await press('Not now');
    await press('Read again');
    expect([line(), session.origin.timer.value]).toEqual([undefined, null]);
  });
});

describe('the names of the memories', () => {
  it('stand beside their numbers', async () => {
    await withModels(record('Lancer 07', LANCER_HELD));
    expect(screen.getByRole('radio', { name: 'M1 “calm”, flies next' })).toBeTruthy();
    await goTo('memories');
    expect(screen.getByRole('textbox', { name: 'Name of M1' })).toHaveProperty('value', 'calm');
  });

  it('are changed at the cards, and kept with the model', async () => {
    const { store } = await withModels(record('Lancer 07', LANCER_HELD));
    await goTo('memories');
    const input = screen.getByRole('textbox', { name: 'Name of M4' });
    fireEvent.input(input, { target: { value: ' fly-off ' } });
    input.focus();
    fireEvent.keyDown(input, { key: 'Enter' });
    await idle();
    expect(store.models.records.get('Lancer 07')?.model.memoryNames).toEqual(['calm', '', '', 'fly-off']);
    expect(screen.getByRole('radio', { name: 'M4 “fly-off”' })).toBeTruthy();
    // What the timer held is still known.
    expect(store.models.records.get('Lancer 07')?.verified).toHaveLength(1);
  });

  it('stay as they are after Escape', async () => {
    const { store } = await withModels(record('Lancer 07', LANCER_HELD));
    await goTo('memories');
    const input = screen.getByRole('textbox', { name: 'Name of M1' });
    fireEvent.input(input, { target: { value: 'windy' } });
    input.focus();
    fireEvent.keyDown(input, { key: 'Escape' });
    await idle();
    expect(store.models.records.get('Lancer 07')?.model.memoryNames).toEqual(['calm']);
    expect(input).toHaveProperty('value', 'calm');
  });

  it('are kept when the page goes while they are typed, and are not ended by a key for the keyboard itself', async () => {
    const { store } = await withModels(record('Lancer 07', LANCER_HELD));
    await goTo('memories');
    const input = screen.getByRole('textbox', { name: 'Name of M4' });
    fireEvent.input(input, { target: { value: '微風' } });
    input.focus();
    fireEvent.keyDown(input, { key: 'Escape', isComposing: true });
    await idle();
    expect(document.activeElement).toBe(input);
    dispatchEvent(new Event('pagehide'));
    dispatchEvent(new Event('pageshow'));
    await idle();
    expect(store.models.records.get('Lancer 07')?.model.memoryNames).toEqual(['calm', '', '', '微風']);
  });

  it('cannot be given when the model is not known', async () => {
    await withModels();
    await goTo('memories');
    expect(screen.queryByRole('button', { name: /Name it/ })).toBeNull();
  });
});
