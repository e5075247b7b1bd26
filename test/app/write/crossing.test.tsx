import { fireEvent, screen } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import type { ModelRecord } from '../../../src/app/storage/index.js';
import type { Model } from '../../../src/program/index.js';
import { type AppBench, goOn, idle, reloaded, review, run } from '../bench/bench.js';
import { drawn } from '../screen.js';
import {
  BACKUP,
  exchange,
  LANCER_HELD,
  lancerConnected as lancer,
  lancerBench,
  modelOf,
  S2,
  twoModels,
  WIND,
} from '../two-models.js';

function shown({ write }: AppBench) {
  const step = write.current.value;
  if (step?.step !== 'review') throw new Error(`the dialog shows no difference, its step is ${step?.step}`);
  const { crossing, model } = step;
  return { moved: step.moved, from: crossing?.from.name, to: crossing?.to.map(({ name }) => name), model: model?.name };
}

function sets({ timer }: AppBench): number {
  return timer.core.answered.filter(({ name }) => name.startsWith('SET')).length;
}

describe('a write into the timer of the model that the values are of', () => {
  it('needs no tick, and says whose timer it is', async () => {
    const bench = await lancer();
    bench.editor.type(S2, '77');
    await review(bench);
    expect(shown(bench)).toEqual({ moved: null, from: undefined, to: undefined, model: 'Lancer' });
    bench.session.safety.confirm();
    expect(bench.write.ready.value).toBe(true);
  });

  it('needs no tick when the pilot has said which model this timer belongs to', async () => {
    const bench = await lancer();
    bench.editor.type(S2, '77');
    const magpie = bench.session.recognition.choices.value.find(({ name }) => name === 'Magpie');
    bench.session.recognition.say(magpie as Model);
    await review(bench);
    expect(shown(bench)).toMatchObject({ from: undefined, model: 'Magpie' });
  });
});

describe('a write into the timer of another model', () => {
  it('needs a tick with both names when a backup is of another model', async () => {
    const bench = await drawn(await lancer());
    bench.session.onScreen.showBackup(BACKUP);
    bench.session.safety.confirm();
    await review(bench);
    await idle(0);
    expect(shown(bench)).toMatchObject({ from: 'Magpie', to: ['Lancer'], model: 'Lancer' });
    expect(screen.getByText('These are values of Magpie, but this timer looks like that of Lancer.')).toBeTruthy();
    expect(bench.write.ready.value).toBe(false);
    await goOn(bench);
    expect(sets(bench)).toBe(0);
    fireEvent.click(screen.getByRole('checkbox', { name: 'Write values of Magpie into the timer of Lancer.' }));
    expect(bench.write.ready.value).toBe(true);
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
    // It is still the timer of the Lancer.
    expect(bench.session.origin.timer.value?.name).toBe('Lancer');
  });

  it('needs a tick when a backup of another model was undone and redone, also after a reading', async () => {
    const bench = await lancer();
    bench.editor.type(S2, '77');
    bench.session.onScreen.showBackup(BACKUP);
    bench.editor.undo();
    await review(bench);
    expect(shown(bench).from, 'the edits made before the backup belong to the connected timer').toBeUndefined();
    bench.write.dismiss();
    bench.editor.redo();
    await review(bench);
    expect(shown(bench)).toMatchObject({ from: 'Magpie', to: ['Lancer'] });
    bench.write.dismiss();
    bench.editor.undo();
    bench.editor.undo();
    await run(bench.session.reader.read().then(() => {}));
    bench.editor.redo();
    bench.editor.redo();
    await review(bench);
    expect(shown(bench)).toMatchObject({ from: 'Magpie', to: ['Lancer'] });
  });

  it('needs a tick when a backup of another model was loaded before the timer came', async () => {
    const bench = await lancerBench();
    bench.session.onScreen.showBackup(BACKUP);
    await run(bench.session.timer.connect());
    await review(bench);
    expect(shown(bench)).toMatchObject({ from: 'Magpie', to: ['Lancer'] });
  });

  it('needs a tick when a setting of another model was opened over it', async () => {
    const bench = await lancer();
    await run(bench.session.opened.show(WIND));
    await review(bench);
    expect(shown(bench)).toMatchObject({ from: 'Magpie', to: ['Lancer'] });
    bench.write.dismiss();
    bench.editor.undo();
    bench.editor.type(S2, '77');
    await review(bench);
    expect(shown(bench).from).toBeUndefined();
  });

  it('needs a tick when the timer was exchanged during the changes and the connection did not notice', async () => {
    const bench = await lancer();
    bench.editor.type(S2, '77');
    exchange(bench);
    await review(bench);
    expect(shown(bench)).toMatchObject({ from: 'Lancer', to: ['Magpie'], model: 'Magpie' });
  });

  it('needs a tick when the timer is exchanged while the dialog is open', async () => {
    const bench = await lancer();
    bench.editor.type(S2, '77');
    await review(bench);
    bench.session.safety.confirm();
    exchange(bench);
    await goOn(bench);
    expect(sets(bench)).toBe(0);
    expect(shown(bench)).toMatchObject({ moved: 'timer', from: 'Lancer', to: ['Magpie'], model: 'Magpie' });
    expect(bench.write.ready.value).toBe(false);
  });

  it('needs a tick when another timer comes at the next connection', async () => {
    const bench = await lancer();
    bench.editor.type(S2, '77');
    await run(bench.session.timer.disconnect());
    exchange(bench);
    await run(bench.session.timer.connect());
    await review(bench);
    expect(shown(bench)).toMatchObject({ from: 'Lancer', to: ['Magpie'] });
  });

  it('needs a tick after a reload, too, because the changes are kept with their model', async () => {
    const bench = await lancer();
    bench.editor.type(S2, '77');
    await idle();
    const again = await reloaded(bench);
    exchange(again);
    await run(again.session.timer.connect());
    await review(again);
    expect(shown(again)).toMatchObject({ from: 'Lancer', to: ['Magpie'] });
  });

  it('is shown again without the tick when a name has changed meanwhile', async () => {
    const bench = await lancer();
    bench.session.onScreen.showBackup(BACKUP);
    bench.session.safety.confirm();
    await review(bench);
    bench.write.tick('model', true);
    const { library } = bench.session;
    const { model } = library.models.get('Magpie') as ModelRecord;
    await run(library.keepModel({ ...model, name: 'Magpie 2' }));
    await goOn(bench);
    expect(sets(bench)).toBe(0);
    expect(shown(bench)).toMatchObject({ moved: 'model', from: 'Magpie 2', to: ['Lancer'] });
    expect([bench.write.ticked.value.has('model'), bench.write.ready.value]).toEqual([false, false]);
  });

  it('names all candidates, and needs no tick when the model is one of them', async () => {
    const store = twoModels();
    store.models.records.set('Twin', modelOf('Twin', LANCER_HELD));
    const bench = await lancer(store);
    bench.session.onScreen.showBackup(BACKUP);
    await review(bench);
    expect(shown(bench)).toMatchObject({ from: 'Magpie', to: ['Lancer', 'Twin'], model: undefined });
    bench.write.dismiss();
    bench.editor.undo();
    bench.session.onScreen.showBackup({ ...BACKUP, model: 'Twin' });
    await review(bench);
    expect(shown(bench).from).toBeUndefined();
  });

  it('needs no tick with the name of a deleted model', async () => {
    const bench = await lancer();
    bench.session.onScreen.showBackup(BACKUP);
    await run(bench.session.library.change({ models: { gone: ['Magpie'] } }));
    await review(bench);
    expect(shown(bench).from).toBeUndefined();
  });

  it('needs a tick when several backups of another model are restored', async () => {
    const bench = await lancer();
    const backups = [{ ...BACKUP, reason: 'memories' as const }];
    await review(bench, { kind: 'restore', backups });
    bench.session.safety.confirm();
    expect(bench.write.current.value).toMatchObject({
      crossing: { from: { name: 'Magpie' }, to: [{ name: 'Lancer' }] },
    });
    expect(bench.write.ready.value).toBe(false);
    await goOn(bench);
    expect(sets(bench)).toBe(0);
    bench.write.tick('model', true);
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
  });
});
