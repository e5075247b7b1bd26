import { signal } from '@preact/signals';
import { describe, expect, it, vi } from 'vitest';
import type { EntryCounts } from '../../../src/app/library/files/import-plan.js';
import { LibraryFiles } from '../../../src/app/library/files/library-files.js';
import { addressOf, NO_MODEL, placeOf } from '../../../src/app/library/place.js';
import { asTags } from '../../../src/app/library/tags.js';
import { Library } from '../../../src/app/records/library.js';
import { addressAt } from '../../../src/app/shell/views.js';
import type { ModelRecord } from '../../../src/app/storage/index.js';
import { formatLibraryFile, LIMITS, type Model } from '../../../src/program/index.js';
import { LAST_DATE } from '../../../src/program/require.js';
import { appBench, idle, MemoryStore, run } from '../bench/bench.js';
import { importNewer, manyRecords } from './many.js';
import { stored } from './stored.js';

async function opened(counts: EntryCounts = { models: 3, settings: 6, flights: 0 }) {
  const bench = await appBench({ store: stored(counts) });
  await run(bench.session.library.load());
  return bench;
}

const keys = (records: readonly { readonly key: string }[]): string[] => records.map(({ key }) => key);

describe('the search', () => {
  it('finds every word in name, note, tags or model, whatever its case and marks', async () => {
    const { browse, session } = await opened({ models: 8, settings: 64, flights: 0 });
    const { list } = session.library.settings;
    const named = (text: string): number => {
      browse.search(text);
      return browse.found.value?.length ?? -1;
    };
    expect([named(''), named('  '), named('no such word')]).toEqual([-1, -1, 0]);
    expect(named('FLY-OFF')).toBe(
      list.value.filter(({ setting }) => JSON.stringify(setting).includes('fly-off')).length,
    );
    expect(named('muller'), '“muller” finds the model “Müller”').toBe(
      list.value.filter(({ setting }) => setting.model === 'model-7').length,
    );
    expect(named('series Tailplane')).toBeLessThan(named('series'));
  });

  it('follows what is renamed, deleted and brought back', async () => {
    const { browse, session } = await opened();
    browse.search('pelican');
    expect(keys(browse.found.value ?? [])).toEqual(['setting-4', 'setting-1']);
    const pelican = session.library.models.get('model-1');
    if (!pelican) throw new Error('it is gone');
    void session.library.keepModel({ ...pelican.model, name: 'Osprey' });
    expect(browse.found.value).toEqual([]);
    browse.search('osprey');
    session.library.settings.remove('setting-1');
    expect(keys(browse.found.value ?? [])).toEqual(['setting-4']);
    session.library.undoRemove();
    expect(keys(browse.found.value ?? [])).toEqual(['setting-4', 'setting-1']);
  });
});

it('models stand by name, settings by date, whatever order was kept before', async () => {
  const store = new MemoryStore();
  const { models, settings } = manyRecords({ models: 3, settings: 3, flights: 0 });
  for (const [at, name] of ['Vega 12', 'Élan', 'Vega 2'].entries()) {
    const record = models[at] as ModelRecord;
    store.models.records.set(record.key, { ...record, model: { ...record.model, name }, order: at } as ModelRecord);
  }
  for (const [at, record] of settings.entries()) {
    const setting = { ...record.setting, at: [5, 9, 7][at] as number };
    store.settings.records.set(record.key, { ...record, setting });
  }
  const library = new Library(store);
  await library.load();
  expect(library.models.list.value.map(({ model }) => model.name)).toEqual(['Élan', 'Vega 2', 'Vega 12']);
  expect(library.settings.list.value.map(({ setting }) => setting.at)).toEqual([9, 7, 5]);
});

it('a model that is deleted takes its settings with it, and undo brings all back', async () => {
  const { session, store, browse } = await opened();
  session.library.removeModel('model-1');
  expect([keys(session.library.models.list.value), session.library.settings.list.value.length]).toEqual([
    ['model-0', 'model-2'],
    4,
  ]);
  await idle(9000);
  session.library.settings.remove('setting-0');
  await idle(9000);
  session.library.undoRemove();
  await idle();
  expect([store.models.records.size, store.settings.records.size]).toEqual([3, 6]);
  session.library.removeModel('model-1');
  const steps = vi.spyOn(store, 'change');
  await idle();
  expect([store.models.records.size, store.settings.records.size, steps.mock.calls.length]).toEqual([2, 4, 1]);
  expect(browse.byModel.value.get(null)).toBeUndefined();
});

it('the programs of an archived model are not among those that were changed last, unless the archive is shown', async () => {
  const { browse, session } = await opened();
  const { model } = session.library.models.get('model-1') as ModelRecord;
  await run(session.library.keepModel({ ...model, archived: true }));
  const latest = keys(browse.latest.value);
  browse.showArchive(true);
  expect([latest, browse.latest.value.length]).toEqual([['setting-5', 'setting-3', 'setting-2', 'setting-0'], 6]);
});

it.each([LAST_DATE, Date.now() + 1e9])(
  'what came with a change at %i and is changed here is the newer one',
  async (at) => {
    await appBench();
    const store = stored({ models: 1, settings: 0, flights: 0 });
    const library = new Library(store);
    await library.load();
    const model = library.models.list.value[0]?.model as Model;
    await run(library.models.save({ key: model.id, model, changedAt: at, verified: [] }));
    const text = formatLibraryFile(
      { models: [model], settings: [], flights: [] },
      { writtenAt: at, writtenBy: '', facts: new Map([[model, { changedAt: at }]]) },
    );
    await run(library.keepModel({ ...model, note: 'typed here' }));
    const files = new LibraryFiles({ library, kept: signal(true) });
    await run(importNewer(files, text));
    const next = new Library(store);
    await run(next.load());
    expect(next.models.list.value.map((record) => record.model.note)).toEqual(['typed here']);
  },
);

it('a model that was just deleted, and comes back from a file, stays', async () => {
  await appBench();
  const store = stored({ models: 1, settings: 1, flights: 0 });
  const library = new Library(store);
  await library.load();
  const { models, settings } = library;
  const held = {
    models: models.list.value.map(({ model }) => model),
    settings: settings.list.value.map(({ setting }) => setting),
    flights: [],
  };
  const text = formatLibraryFile(held, { writtenAt: 1, writtenBy: '' });
  library.removeModel('model-0');
  const files = new LibraryFiles({ library, kept: signal(true) });
  await run(importNewer(files, text));
  await idle(20_000);
  expect([keys(models.list.value), keys(settings.list.value)]).toEqual([['model-0'], ['setting-0']]);
  expect([store.models.records.size, store.settings.records.size]).toEqual([1, 1]);
});

it('what is saved and deleted while the list is being read is not lost', async () => {
  await appBench();
  const store = stored({ models: 1, settings: 2, flights: 0 });
  const library = new Library(store);
  const before = [...store.settings.records.values()];
  let give = (): void => {};
  store.settings.all = () => new Promise((resolve) => (give = () => resolve(before)));
  const reading = library.load();
  const [record] = before;
  if (!record) throw new Error('it is gone');
  await run(library.keepSetting({ ...record.setting, name: 'saved meanwhile' }));
  await run(library.change({ settings: { gone: ['setting-1'] } }));
  give();
  await run(reading);
  expect(library.settings.list.value.map(({ setting }) => setting.name)).toEqual(['saved meanwhile']);
});

it('a storage that did not answer at first is asked again when it does', async () => {
  await appBench();
  const store = stored({ models: 2, settings: 3, flights: 0 });
  store.broken = true;
  const library = new Library(store);
  await run(library.load());
  expect([library.models.loaded.value, library.settings.list.value]).toEqual([true, []]);
  store.broken = false;
  await run(library.keepAgain());
  expect([library.models.list.value.length, library.settings.list.value.length]).toEqual([2, 3]);
});

it('what could not be deleted does not come back with the next page', async () => {
  await appBench();
  const store = stored({ models: 1, settings: 2, flights: 0 });
  const library = new Library(store);
  await run(library.load());
  const again = library.settings.get('setting-1')?.setting;
  if (!again) throw new Error('it is gone');
  store.broken = true;
  await run(library.settings.delete('setting-0', 'setting-1'));
  await run(library.keepSetting(again));
  store.broken = false;
  await run(library.keepAgain());
  expect([...store.settings.records.keys()]).toEqual(['setting-1']);
});

it('every view of the library has its address', () => {
  for (const { model, setting } of ['a', null].flatMap((model) => [null, 'b'].map((setting) => ({ model, setting })))) {
    const address = addressAt(addressOf(model, setting));
    expect(address?.view).toBe('library');
    expect(placeOf(address?.path ?? '')).toEqual({ model: model ?? NO_MODEL, setting });
  }
  expect(addressAt('#library')).toEqual({ view: 'library', path: '' });
  for (const word of ['none', 'flights', 'compare', 'a']) {
    const path = addressAt(addressOf(word, word))?.path ?? '';
    expect(placeOf(path), 'an id from a file may be a word that addresses use').toEqual({ model: word, setting: word });
    expect(['none', 'flights', 'compare']).not.toContain(addressAt(addressOf(word))?.path);
    const model = word === 'none' ? NO_MODEL : word;
    expect(placeOf(`${word}/x`).model, 'an address of the old form still works').toBe(model);
  }
  expect(['#library/<b>', `#library/${'x'.repeat(400)}`, '#nothing/a'].filter((each) => addressAt(each))).toEqual([]);
});

it('accepts tags as they are typed, each once, and no more than can be kept', () => {
  expect(asTags(' calm , fly-off,, calm,')).toEqual(['calm', 'fly-off']);
  expect(asTags(Array.from({ length: 50 }, (_, at) => `tag ${at}`).join(','))).toHaveLength(LIMITS.tags);
  expect(asTags('x'.repeat(99))[0]).toHaveLength(LIMITS.tag);
});
