import { signal } from '@preact/signals';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import type { TabChannel } from '../../../src/app/browser/other-tabs.js';
import { Browse } from '../../../src/app/library/browse.js';
import { LibraryFiles } from '../../../src/app/library/files/library-files.js';
import { addressOf, NO_MODEL, placeOf } from '../../../src/app/library/place.js';
import { asTags } from '../../../src/app/library/tags.js';
import { Library } from '../../../src/app/session/library.js';
import { addressAt } from '../../../src/app/shell/views.js';
import type { FlightRecord, ModelRecord } from '../../../src/app/storage/index.js';
import { type Flight, formatLibraryFile, LIMITS, type Model, type Setting } from '../../../src/program/index.js';
import { LAST_DATE } from '../../../src/program/require.js';
import { appBench, idle, MemoryStore, run } from '../bench/bench.js';
import { type Counts, manyRecords } from './many.js';

/** A storage with a library in it. */
function stored(counts: Counts): MemoryStore {
  const store = new MemoryStore();
  const records = manyRecords(counts);
  for (const each of records.models) store.models.records.set(each.key, each);
  for (const each of records.settings) store.settings.records.set(each.key, each);
  for (const each of records.flights) store.flights.records.set(each.key, each);
  return store;
}

async function opened(counts: Counts = { models: 3, settings: 6, flights: 0 }) {
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
    expect(keys(browse.found.value ?? [])).toEqual(['setting-1', 'setting-4']);
    const pelican = session.library.models.get('model-1');
    if (!pelican) throw new Error('it is gone');
    void session.library.keepModel({ ...pelican.model, name: 'Osprey' });
    expect(browse.found.value).toEqual([]);
    browse.search('osprey');
    session.library.settings.remove('setting-1');
    expect(keys(browse.found.value ?? [])).toEqual(['setting-4']);
    session.library.undoRemove();
    expect(keys(browse.found.value ?? [])).toEqual(['setting-1', 'setting-4']);
  });
});

describe('the order', () => {
  it('is kept, also when only some are sorted, and when two had the same place', async () => {
    const { session, store } = await opened();
    const { library } = session;
    await run(library.arrange(library.settings, ['setting-4', 'setting-1']));
    const order = ['setting-0', 'setting-4', 'setting-2', 'setting-3', 'setting-1', 'setting-5'];
    expect(keys(library.settings.list.value)).toEqual(order);
    const next = new Library(store);
    await run(next.load());
    expect(keys(next.settings.list.value)).toEqual(order);
    for (const record of library.models.list.value) await run(library.keepModel(record.model, { order: 7 }));
    await run(library.arrange(library.models, ['model-2', 'model-0', 'model-1']));
    expect(keys(library.models.list.value)).toEqual(['model-2', 'model-0', 'model-1']);
  });
});

describe('a model that is deleted', () => {
  it('takes its settings with it, and undo brings all back', async () => {
    const { session, store, browse } = await opened();
    session.library.removeModel('model-1');
    expect([keys(session.library.models.list.value), session.library.settings.list.value.length]).toEqual([
      ['model-0', 'model-2'],
      4,
    ]);
    await idle(9000);
    session.library.undoRemove();
    await idle();
    expect([store.models.records.size, store.settings.records.size]).toEqual([3, 6]);
    session.library.removeModel('model-1');
    await idle();
    expect([store.models.records.size, store.settings.records.size]).toEqual([2, 4]);
    expect(browse.byModel.value.get(null)).toBeUndefined();
  });

  it('leaves a setting that another tab has moved to it without a model, but visible', async () => {
    const { session, store, browse } = await opened();
    store.models.records.delete('model-1');
    await run(session.library.refresh());
    expect(keys(browse.byModel.value.get(null) ?? [])).toEqual(['setting-1', 'setting-4']);
  });
});

/** Two tabs of one browser. */
function twoTabs(store: MemoryStore): [Library, Library] {
  const listeners: ((event: { data: unknown }) => void)[][] = [[], []];
  const channel = (own: number): TabChannel =>
    ({
      addEventListener: (_: string, listener: (event: { data: unknown }) => void) => listeners[own]?.push(listener),
      postMessage: (data: unknown) => {
        for (const listener of listeners[1 - own] ?? []) listener({ data });
      },
    }) as unknown as TabChannel;
  return [new Library(store, channel(0)), new Library(store, channel(1))];
}

describe('two tabs', () => {
  const COUNTS = { models: 1, settings: 2, flights: 0 };

  it('see what the other has kept and deleted', async () => {
    await appBench();
    const [one, other] = twoTabs(stored(COUNTS));
    await Promise.all([one.load(), other.load()]);
    const record = one.settings.list.value[0];
    if (!record) throw new Error('it is gone');
    await run(one.keepSetting({ ...record.setting, name: 'new name' }));
    await idle();
    expect(other.settings.get(record.key)?.setting.name).toBe('new name');
    one.settings.remove(record.key);
    await idle();
    expect(keys(other.settings.list.value)).toEqual(['setting-1']);
  });

  it('do not delete what the other tab has changed meanwhile', async () => {
    await appBench();
    const store = stored(COUNTS);
    const [one, other] = twoTabs(store);
    await Promise.all([one.load(), other.load()]);
    one.settings.remove('setting-0');
    const record = other.settings.get('setting-0');
    if (!record) throw new Error('it is gone');
    await run(other.keepSetting({ ...record.setting, note: 'typed in the other tab' }));
    await idle();
    expect([one.settings.get('setting-0')?.setting.note, store.settings.records.size]).toEqual([
      'typed in the other tab',
      2,
    ]);
  });

  it.each([
    ['has said so', twoTabs],
    ['could not say so', (store: MemoryStore): [Library, Library] => [new Library(store), new Library(store)]],
  ])('do not delete what the other has brought back by undoing an import, where that one %s', async (_, tabs) => {
    await appBench();
    const store = stored(COUNTS);
    const [one, other] = tabs(store);
    await Promise.all([one.load(), one.flights.load(), other.load()]);
    const record = one.settings.get('setting-0');
    if (!record) throw new Error('it is gone');
    const newer = { ...record.setting, note: 'from the file' };
    const facts = new Map([[newer, { changedAt: record.changedAt + 1000 }]]);
    const text = formatLibraryFile(
      { models: [], settings: [newer], flights: [] },
      { writtenAt: 1, writtenBy: 'a test', facts },
    );
    const files = new LibraryFiles({ library: one, storage: signal(null) });
    await run(files.open([new File([text], 'a.sidus')]));
    await run(files.take());
    await run(other.refresh());
    expect(other.settings.get('setting-0')?.setting.note).toBe('from the file');
    other.settings.remove('setting-0');
    await run(files.undo());
    await idle(12_000);
    const note = record.setting.note;
    expect([store.settings.records.get('setting-0'), other.settings.get('setting-0')]).toMatchObject([
      { setting: { note } },
      { setting: { note } },
    ]);
  });

  it('have in both what one brings back after the other has deleted it for good', async () => {
    await appBench();
    const store = stored(COUNTS);
    const [one, other] = twoTabs(store);
    await Promise.all([one.load(), other.load()]);
    one.removeModel('model-0');
    await idle(4000);
    other.removeModel('model-0');
    await idle(7000);
    expect([store.models.records.size, store.settings.records.size]).toEqual([0, 0]);
    other.undoRemove();
    await idle();
    expect([store.models.records.size, store.settings.records.size]).toEqual([1, 2]);
    expect([keys(one.models.list.value), other.kept.value]).toEqual([['model-0'], true]);
  });

  it('do not delete what the other has changed since its clock was put back', async () => {
    await appBench();
    const store = stored(COUNTS);
    const [one, other] = [new Library(store), new Library(store)];
    await Promise.all([one.load(), other.load()]);
    const record = other.settings.get('setting-0');
    if (!record) throw new Error('it is gone');
    await run(one.keepSetting(record.setting));
    await other.refresh();
    vi.spyOn(Date, 'now').mockReturnValue(1000);
    onTestFinished(() => void vi.restoreAllMocks());
    one.settings.remove('setting-0');
    await run(other.keepSetting({ ...record.setting, note: 'typed later, by an earlier clock' }));
    await idle();
    expect(store.settings.records.get('setting-0')?.setting.note).toBe('typed later, by an earlier clock');
  });

  it('do not lose what is saved while the list is being read', async () => {
    await appBench();
    const store = stored(COUNTS);
    const [one] = twoTabs(store);
    await one.load();
    const before = [...store.settings.records.values()];
    let give = (): void => {};
    store.settings.all = () => new Promise((resolve) => (give = () => resolve(before)));
    const reading = one.refresh();
    const [record] = before;
    if (!record) throw new Error('it is gone');
    await run(one.keepSetting({ ...record.setting, name: 'saved meanwhile' }));
    one.settings.remove('setting-1');
    one.settings.flush();
    give();
    await run(reading);
    expect(one.settings.list.value.map(({ setting }) => setting.name)).toEqual(['saved meanwhile']);
  });
});

it.each([LAST_DATE, Date.now() + 1e9])(
  'what came with a change at %i and is changed here is the newer one',
  async (at) => {
    await appBench();
    const store = stored({ models: 1, settings: 0, flights: 0 });
    const library = new Library(store);
    await library.load();
    const model = library.models.list.value[0]?.model as Model;
    await run(library.models.save({ key: model.id, model, order: 1, changedAt: at, verified: [] }));
    const text = formatLibraryFile(
      { models: [model], settings: [], flights: [] },
      { writtenAt: at, writtenBy: '', facts: new Map([[model, { changedAt: at }]]) },
    );
    await run(library.keepModel({ ...model, note: 'typed here' }));
    const files = new LibraryFiles({ library, storage: signal(null) });
    await run(files.open([new File([text], 'a')]));
    await run(files.take());
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
  const files = new LibraryFiles({ library, storage: signal(null) });
  await run(files.open([new File([text], 'a')]));
  await run(files.take());
  expect([keys(models.list.value), keys(settings.list.value)]).toEqual([['model-0'], ['setting-0']]);
  await idle(20_000);
  expect([keys(models.list.value), keys(settings.list.value)]).toEqual([['model-0'], ['setting-0']]);
  expect([store.models.records.size, store.settings.records.size]).toEqual([1, 1]);
});

describe('what is deleted in one tab, while another one', () => {
  /** Both tabs have read a model with a setting; they hear of each other, or not. */
  async function twoModels(hear: boolean): Promise<readonly [Library, Library, MemoryStore]> {
    await appBench();
    const store = stored({ models: 1, settings: 1, flights: 0 });
    const tabs = hear ? twoTabs(store) : ([new Library(store), new Library(store)] as const);
    await Promise.all(tabs.flatMap((tab) => [tab.load(), tab.flights.load()]));
    return [...tabs, store];
  }
  const modelIn = (tab: Library) => tab.models.list.value[0]?.model as Model;
  const notesIn = (store: MemoryStore) => [...store.models.records.values()].map(({ model }) => model.note);

  it.each([true, false])(
    'changes it, is after an undo as the other tab has left it; they hear of each other: %s',
    async (hear) => {
      const [one, other, store] = await twoModels(hear);
      one.removeModel('model-0');
      await run(other.keepModel({ ...modelIn(other), note: 'from the other' }));
      await idle(5000);
      one.undoRemove();
      await idle();
      expect(notesIn(store)).toEqual(['from the other']);
      await run(one.keepModel({ ...modelIn(one), memoryNames: ['fly-off'] }));
      expect(store.models.records.get('model-0')?.model).toMatchObject({
        note: 'from the other',
        memoryNames: ['fly-off'],
      });
      expect([one.clash.value, store.settings.records.size]).toEqual([null, 1]);
    },
  );

  it.each([
    [true, 1000],
    [false, 1000],
    [true, 20_000],
    [false, 20_000],
  ])(
    'imports it from a file, is there as the file has it; they hear of each other: %s, %i ms later',
    async (hear, ms) => {
      const [one, other, store] = await twoModels(hear);
      const { note: before } = modelIn(other);
      const model = { ...modelIn(other), note: 'from the file' };
      const files = new LibraryFiles({ library: other, storage: signal(null) });
      const made = { writtenAt: Date.now(), writtenBy: 'a test' };
      await run(files.open([new File([formatLibraryFile({ models: [model], settings: [], flights: [] }, made)], 'a')]));
      one.removeModel('model-0');
      await idle(ms);
      await run(files.take());
      await idle();
      expect(notesIn(store)).toEqual(['from the file']);
      for (const tab of [one, other]) {
        await run(tab.refresh());
        expect(tab.models.list.value.map((record) => record.model.note)).toEqual(['from the file']);
      }
      await run(files.undo());
      await idle();
      // A tab that has not heard of the deletion knows the model as it was.
      expect(notesIn(store)).toEqual(hear && ms > 10_000 ? [] : [before]);
    },
  );
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

it('every view of the library has its address', () => {
  for (const [model, setting] of [
    ['a', null],
    ['a', 'b'],
    [null, 'b'],
    [null, null],
  ] as const) {
    const address = addressAt(addressOf(model, setting));
    expect(address?.view).toBe('library');
    expect(placeOf(address?.path ?? '')).toEqual({ model: model ?? NO_MODEL, setting });
  }
  expect(addressAt('#library')).toEqual({ view: 'library', path: '' });
  for (const word of ['none', 'flights', 'compare', 'a']) {
    const path = addressAt(addressOf(word, word))?.path ?? '';
    expect(placeOf(path), 'an id from a file may be a word that addresses use').toEqual({ model: word, setting: word });
    expect(['none', 'flights', 'compare']).not.toContain(addressAt(addressOf(word))?.path);
    expect(placeOf(`${word}/x`).model, 'an address of the old form still works').toBe(
      word === 'none' ? NO_MODEL : word,
    );
  }
  expect([addressAt('#library/<b>'), addressAt(`#library/${'x'.repeat(400)}`), addressAt('#nothing/a')]).toEqual([
    null,
    null,
    null,
  ]);
});

describe('two tabs that save one thing within moments, before they hear of each other', () => {
  /** Both have read what is kept; neither is told what the other does. */
  async function twoTabs(): Promise<readonly [Library, Library, MemoryStore]> {
    const store = stored({ models: 1, settings: 1, flights: 1 });
    const tabs = [new Library(store), new Library(store)] as const;
    await Promise.all(tabs.flatMap((tab) => [tab.load(), tab.flights.load()]));
    return [...tabs, store];
  }
  const settingIn = (tab: Library) => tab.settings.list.value[0]?.setting as Setting;
  const keptSetting = (store: MemoryStore) => [...store.settings.records.values()][0]?.setting;

  it('keep the changes of both when these concern different fields', async () => {
    const [one, other, store] = await twoTabs();
    const { note } = settingIn(one);
    const program = { ...settingIn(one).program, idleThrottle: 77 };
    await Promise.all([
      one.keepSetting({ ...settingIn(one), name: 'by the one', program, at: 5, from: 'timer' }),
      other.keepSetting({ ...settingIn(other), tags: ['by the other'] }),
      one.arrange(one.models, []),
    ]);
    const both = { name: 'by the one', tags: ['by the other'], note, program, at: 5, from: 'timer' };
    expect(keptSetting(store)).toMatchObject(both);
    expect(settingIn(other)).toMatchObject(both);
    expect([one.clash.value, other.clash.value, other.kept.value]).toEqual([null, null, true]);
  });

  it.each(['mine', 'theirs'] as const)('ask where they do not agree, and keep what is chosen: %s', async (choice) => {
    const [one, other, store] = await twoTabs();
    const all = await Promise.all([
      one.keepSetting({ ...settingIn(one), note: 'of the one', tags: [] }),
      other.keepSetting({ ...settingIn(other), note: 'of the other', name: 'another' }),
    ]);
    expect(all).toHaveLength(2);
    expect(keptSetting(store)?.note, 'nothing is overwritten before the pilot has chosen').toBe('of the one');
    expect(other.clash.value).toMatchObject({ kind: 'settings', disagreed: ['note'] });
    expect([settingIn(other).note, one.clash.value]).toEqual(['of the one', null]);
    await other.settings.settle(choice);
    expect(other.clash.value).toBeNull();
    expect(keptSetting(store)).toMatchObject(
      choice === 'mine' ? { note: 'of the other', name: 'another', tags: [] } : { note: 'of the one', tags: [] },
    );
    expect(settingIn(other)).toEqual(keptSetting(store));
  });

  it('keep both where the page is left before the pilot has chosen', async () => {
    const [one, other, store] = await twoTabs();
    const long = 'x'.repeat(LIMITS.name);
    await one.keepSetting({ ...settingIn(one), note: 'of the one' });
    await other.keepSetting({ ...settingIn(other), note: 'of the other', name: long });
    await one.keepModel({ ...(one.models.list.value[0] as ModelRecord).model, note: 'of the one' });
    await other.keepModel({ ...(other.models.list.value[0] as ModelRecord).model, note: 'of the other' });
    await one.keepFlight({ ...(one.flights.list.value[0] as FlightRecord).flight, note: 'of the one' });
    await other.keepFlight({ ...(other.flights.list.value[0] as FlightRecord).flight, note: 'of the other' });
    // Put away, come back to, and left.
    other.keepClashes();
    other.flush();
    const next = new Library(store);
    await Promise.all([next.load(), next.flights.load()]);
    const notes = ['of the one', 'of the other'];
    expect(next.settings.list.value.map(({ setting }) => setting.note).sort()).toEqual(notes);
    expect(next.models.list.value.map(({ model }) => model.note).sort()).toEqual(notes);
    expect(next.flights.list.value.map(({ flight }) => flight.note).sort()).toEqual(notes);
    const names = next.settings.list.value.map(({ setting }) => setting.name);
    expect(names).toContain(`${long.slice(4)} (2)`);
    for (const { key, setting } of next.settings.list.value) expect(setting.id).toBe(key);
  });

  it.each(['mine', 'theirs'] as const)(
    'have one version again when the pilot comes back and chooses: %s',
    async (choice) => {
      const [one, other, store] = await twoTabs();
      await one.keepSetting({ ...settingIn(one), note: 'of the one' });
      await other.keepSetting({ ...settingIn(other), note: 'of the other' });
      other.keepClashes();
      await other.refresh();
      expect(other.settings.list.value).toHaveLength(2);
      await other.settings.settle(choice);
      expect([...store.settings.records.values()].map(({ setting }) => setting.note)).toEqual([
        choice === 'mine' ? 'of the other' : 'of the one',
      ]);
      expect(other.settings.list.value).toHaveLength(1);
    },
  );

  it('lose nothing of several changes that follow each other', async () => {
    const [one, other, store] = await twoTabs();
    const theirs = one.keepSetting({ ...settingIn(one), note: 'of the one' });
    const first = other.keepSetting({ ...settingIn(other), name: 'first' });
    const then = other.keepSetting({ ...settingIn(other), tags: ['then'] });
    await Promise.all([theirs, first, then]);
    expect(keptSetting(store)).toMatchObject({ note: 'of the one', name: 'first', tags: ['then'] });
    await other.keepSetting({ ...settingIn(other), note: 'later' });
    expect([keptSetting(store)?.note, other.clash.value]).toEqual(['later', null]);
  });

  it('also merge a model and a flight; what one deletes and the other changes is kept', async () => {
    const [one, other, store] = await twoTabs();
    const modelOf = (tab: Library) => tab.models.list.value[0]?.model as Model;
    const flightOf = (tab: Library) => tab.flights.list.value[0]?.flight as Flight;
    await one.keepModel({ ...modelOf(one), note: 'one' });
    await other.keepModel({ ...modelOf(other), note: 'other' });
    await one.keepFlight({ ...flightOf(one), wind: 1 });
    await other.keepFlight({ ...flightOf(other), result: 99 });
    expect(other.clash.value).toMatchObject({ kind: 'models', disagreed: ['note'] });
    expect([...store.flights.records.values()][0]?.flight).toMatchObject({ wind: 1, result: 99 });
    one.settings.remove(settingIn(one).id);
    one.flush();
    await other.keepSetting({ ...settingIn(other), note: 'still wanted' });
    expect(keptSetting(store)?.note).toBe('still wanted');
  });

  it('do not delete what the other has changed since then, also without a message from it', async () => {
    vi.useFakeTimers();
    onTestFinished(() => void vi.useRealTimers());
    const [one, other, store] = await twoTabs();
    const { id } = settingIn(one);
    one.settings.remove(id);
    await other.keepSetting({ ...settingIn(other), note: 'still wanted' });
    await vi.advanceTimersByTimeAsync(11_000);
    expect(keptSetting(store)?.note).toBe('still wanted');
    expect([settingIn(one).note, one.settings.removed.value]).toEqual(['still wanted', []]);
    one.settings.remove(id);
    await vi.advanceTimersByTimeAsync(11_000);
    expect(keptSetting(store)).toBeUndefined();
  });

  it('also merge when one of them was not stored at first', async () => {
    const [one, other, store] = await twoTabs();
    store.broken = true;
    await other.keepSetting({ ...settingIn(other), note: 'while it was full' });
    store.broken = false;
    await one.keepSetting({ ...settingIn(one), note: 'of the one' });
    await other.refresh();
    await other.keepAgain();
    expect(keptSetting(store)?.note).toBe('of the one');
    expect(other.clash.value).toMatchObject({
      disagreed: ['note'],
      record: { setting: { note: 'while it was full' } },
    });
  });
});

it('accepts tags as they are typed, each once, and no more than can be kept', () => {
  expect(asTags(' calm , fly-off,, calm,')).toEqual(['calm', 'fly-off']);
  expect(asTags(Array.from({ length: 50 }, (_, at) => `tag ${at}`).join(','))).toHaveLength(LIMITS.tags);
  expect(asTags('x'.repeat(99))[0]).toHaveLength(LIMITS.tag);
});

it('draws the rows of a long list in parts', () => {
  const store = new MemoryStore();
  const browse = new Browse(new Library(store));
  const first = browse.room.value;
  browse.showMore();
  expect(browse.room.value).toBeGreaterThan(first);
  browse.search('calm');
  expect(browse.room.value).toBe(first);
});
