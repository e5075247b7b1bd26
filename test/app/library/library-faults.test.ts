import { describe, expect, it, vi } from 'vitest';
import { LibraryFiles } from '../../../src/app/library/files/library-files.js';
import type { Library } from '../../../src/app/records/library.js';
import { formatLibraryFile, type Model, type Setting } from '../../../src/program/index.js';
import { FLIGHT, MODEL, SETTING } from '../../program/library-examples.js';
import { type AppBench, appBench, idle, run } from '../bench/bench.js';
import { FAULTS, type FaultName, FaultyStore } from '../faults.js';
import { importNewer } from './many.js';

const OTHER: Model = { ...MODEL, id: 'other', name: 'Vega' };
const WINDY: Setting = { ...SETTING, id: 'windy', name: 'windy' };
const TEXT = formatLibraryFile(
  { models: [{ ...MODEL, id: 'from-file' }], settings: [], flights: [] },
  { writtenAt: 1, writtenBy: 'a test' },
);

/** What the screen shows. */
const shown = ({ models, settings, flights }: Library) => ({
  models: models.list.value.map(({ model }) => model),
  settings: settings.list.value.map(({ setting }) => setting),
  flights: flights.list.value.map(({ flight }) => flight),
});

/** What would be there after a reload. */
async function afterReload(store: FaultyStore): Promise<ReturnType<typeof shown>> {
  const { session } = await appBench({ store: store.next() });
  await run(Promise.all([session.library.load(), session.library.flights.load()]));
  return shown(session.library);
}

const ACTIONS: Readonly<Record<string, (app: AppBench) => Promise<unknown>>> = {
  'a setting is saved': ({ session }) => session.library.keepSetting({ ...SETTING, note: 'changed' }),
  'a model is changed': ({ session }) => session.library.keepModel({ ...MODEL, note: 'changed' }),
  'a flight is logged': ({ session }) => session.library.keepFlight({ ...FLIGHT, id: 'now' }),
  'a file is imported': async ({ session, keeping }) => {
    const files = new LibraryFiles({ library: session.library, kept: keeping.kept });
    await importNewer(files, TEXT);
  },
};

/** A page with two models and two settings, in a storage that can fail from now on. */
async function filled() {
  const store = new FaultyStore();
  const app = await appBench({ store });
  const { library } = app.session;
  await run(Promise.all([library.load(), library.flights.load()]));
  for (const model of [MODEL, OTHER]) await run(library.keepModel(model));
  for (const setting of [SETTING, WINDY]) await run(library.keepSetting(setting));
  return { store, app };
}

/** How what was not kept is kept after all, once the storage works again. */
const RECOVERIES: Readonly<Record<string, (app: AppBench) => void | Promise<void>>> = {
  'the pilot comes back': ({ keeping }) => keeping.tryAgain(),
  'the pilot does anything at all': async ({ session: { library } }) => {
    await run(library.keepModel({ ...OTHER, note: 'flew well' }));
    await run(library.keepSetting({ ...WINDY, note: 'flew well' }));
    await run(library.keepFlight({ ...FLIGHT, id: 'then' }));
  },
};

describe.each(Object.keys(FAULTS) as FaultName[])('where the storage %s', (fault) => {
  it.each(Object.keys(ACTIONS).flatMap((action) => Object.keys(RECOVERIES).map((recovery) => [action, recovery])))(
    'and %s, that is on the screen, is never taken for kept when it is not, and is kept once %s',
    async (action = '', recovery = '') => {
      const { store, app } = await filled();
      const { library } = app.session;
      const before = shown(library);
      store.before = (door) => (/(save|remove|change)$/.test(door) ? FAULTS[fault]() : undefined);
      void ACTIONS[action]?.(app).catch(() => {});
      await idle(6000);
      const wanted = shown(library);
      expect(wanted, 'the screen shows the change').not.toEqual(before);
      expect([library.kept.value, app.keeping.kept.value]).not.toContain(true);
      expect(app.update.free.value, 'a new version waits, so the change is not lost').toBe(false);
      // What hangs for ever is a matter for a reload; what was typed stays on the screen.
      if (fault === 'hangs') return;
      store.before = () => undefined;
      await RECOVERIES[recovery]?.(app);
      await idle();
      expect([library.kept.value, app.keeping.kept.value]).toEqual([true, true]);
      expect(await afterReload(store)).toEqual(shown(library));
    },
  );

  it('and a deletion is undone, all is there, now and after a reload', async () => {
    const store = new FaultyStore();
    const app = await appBench({ store });
    const { library } = app.session;
    await run(library.load());
    await run(library.keepModel(MODEL));
    await run(library.keepSetting(SETTING));
    const before = shown(library);
    store.before = (door) => (/(save|remove|change)$/.test(door) ? FAULTS[fault]() : undefined);
    library.removeModel(MODEL.id);
    await idle(9000);
    library.undoRemove();
    await idle();
    expect(shown(library)).toEqual(before);
    expect(await afterReload(store)).toEqual(before);
  });
});

it('what belongs together and was not kept is kept in one step once the storage works again', async () => {
  const { store, app } = await filled();
  const { library } = app.session;
  store.before = (door) => (door === 'change' ? FAULTS['is full']() : undefined);
  const model = { ...MODEL, id: 'new' };
  void library.keepModel(model);
  void library.keepSetting({ ...SETTING, id: 'new', model: model.id });
  void library.keepFlight({ ...FLIGHT, id: 'new', model: model.id });
  await idle();
  store.before = () => undefined;
  const steps = vi.spyOn(store, 'change');
  app.keeping.tryAgain();
  await idle();
  expect(library.kept.value).toBe(true);
  const puts = steps.mock.calls.map(([change]) => Object.values(change).map(({ put = [] }) => put.length));
  expect(new Set(puts.map(String)), 'no step has one of them without the others').toEqual(new Set(['1,1,1']));
});

it('where nothing has changed, nothing is asked of the storage: its answer would say that it works again', async () => {
  const { store, app } = await filled();
  const { library } = app.session;
  const change = vi.spyOn(store, 'change');
  library.flush();
  await run(library.keepAgain());
  expect(change).not.toHaveBeenCalled();
});
