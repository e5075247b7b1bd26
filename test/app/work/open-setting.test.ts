import { describe, expect, it } from 'vitest';
import { newProgram, USUAL_LAYOUT } from '../../../src/app/editing/new-program.js';
import { emptyModel } from '../../../src/app/records/library.js';
import type { SettingRecord } from '../../../src/app/storage/index.js';
import type { Setting, SettingVersion, TimerProgram } from '../../../src/program/index.js';
import { type AppBench, appBench, connectedBench, idle, MemoryStore, reloaded, run } from '../bench/bench.js';

const DT = { kind: 'time', slot: 10 } as const;
const S2 = { kind: 'position', servo: 1, slot: 3 } as const;
const USUAL = newProgram({ timerClass: 'Q', ...USUAL_LAYOUT, from: 'usual' });

function settingOf(id: string, program: TimerProgram = USUAL): Setting {
  return { id, model: 'lancer', name: id, note: '', tags: [], at: 5, program, from: 'typed', archived: false };
}

/** A library with a model “Lancer” and these settings. */
function stored(...settings: Setting[]): MemoryStore {
  const store = new MemoryStore();
  store.models.records.set('lancer', {
    key: 'lancer',
    changedAt: 1,
    verified: [],
    model: emptyModel('lancer', 'Lancer', 'Q'),
  });
  for (const setting of settings) keepIn(store, setting);
  return store;
}

function keepIn(store: MemoryStore, setting: Setting): void {
  store.settings.records.set(setting.id, { key: setting.id, changedAt: 1, setting });
}

async function opened(setting: Setting, ...more: Setting[]): Promise<AppBench> {
  const bench = await appBench({ store: stored(setting, ...more) });
  expect(await run(bench.session.opened.show(setting))).toBe(true);
  return bench;
}

function type(bench: AppBench, field: typeof DT | typeof S2, text: string): void {
  bench.editor.type(field, text);
  bench.editor.leave(field);
}

const dtOf = ({ store }: AppBench, id: string): number | undefined =>
  (store.settings.records.get(id) as SettingRecord | undefined)?.setting.program.times[10];
const names = ({ session: { origin } }: AppBench) => [
  origin.model.value?.name ?? null,
  origin.setting.value?.name ?? null,
];

describe('a setting that is opened without a timer', () => {
  it('is on the screen with its model, has nothing unsaved, and says nothing about a timer', async () => {
    const bench = await opened(settingOf('calm', { ...USUAL, memory: 0 }));
    const { session, editor } = bench;
    expect([names(bench), editor.working.value?.memory, editor.changes.value]).toEqual([['Lancer', 'calm'], null, []]);
    expect([session.opened.unsaved.value, session.standing.value]).toEqual([
      { changes: 0, unreadable: 0 },
      { sure: 'once', at: null },
    ]);
  });

  it('is saved with what was typed, and undo still works after that', async () => {
    const bench = await opened(settingOf('calm'));
    type(bench, DT, '2:00');
    expect([bench.session.opened.unsaved.value?.changes, dtOf(bench, 'calm')]).toEqual([1, 18000]);
    await run(bench.session.opened.save());
    expect([bench.session.opened.unsaved.value?.changes, dtOf(bench, 'calm')]).toEqual([0, 12000]);
    bench.editor.undo();
    expect(bench.session.opened.unsaved.value).toEqual({ changes: 1, unreadable: 0 });
  });

  it('keeps what is not saved through a reload, with what can be undone', async () => {
    const bench = await opened(settingOf('calm'));
    type(bench, DT, '2:00');
    await idle();
    const after = await reloaded(bench);
    await idle();
    expect([names(after), after.session.opened.unsaved.value?.changes]).toEqual([['Lancer', 'calm'], 1]);
    after.editor.undo();
    expect(after.editor.textOf(DT)).toBe('3:00');
  });

  it('comes back after a reload, also when nothing was typed, and leaves nothing when it is closed', async () => {
    const bench = await opened(settingOf('calm'));
    await idle();
    const after = await reloaded(bench);
    await idle();
    expect(names(after)).toEqual(['Lancer', 'calm']);
    after.session.onScreen.closeProgram();
    await idle();
    expect([...after.store.drafts.records.values()]).toEqual([]);
  });

  it('has its unsaved changes again when another one was open in between', async () => {
    const calm = settingOf('calm');
    const wind = settingOf('wind');
    const bench = await opened(calm, wind);
    type(bench, DT, '2:00');
    bench.editor.type(S2, 'x');
    await idle();
    await run(bench.session.opened.show(wind));
    expect([names(bench)[1], bench.editor.textOf(DT)]).toEqual(['wind', '3:00']);
    await idle();
    await run(bench.session.opened.show(calm));
    expect([names(bench)[1], bench.editor.textOf(DT), bench.editor.textOf(S2)]).toEqual(['calm', '2:00', 'x']);
    expect(bench.session.opened.savable.value, 'a field has no readable value, so it cannot be saved').toBe(false);
    expect([await run(bench.session.opened.save()), dtOf(bench, 'calm')]).toEqual([false, 18000]);
  });

  it('is saved as a new one, which is open from then on', async () => {
    const bench = await opened(settingOf('calm'));
    type(bench, DT, '2:00');
    await run(bench.session.opened.saveAs({ model: 'lancer', name: 'wind' }));
    expect([names(bench), dtOf(bench, 'calm')]).toEqual([['Lancer', 'wind'], 18000]);
    const [made] = bench.session.library.settings.list.value;
    expect(made?.setting).toMatchObject({ name: 'wind', model: 'lancer', from: 'typed' });
    expect(made?.setting.program.times[10]).toBe(12000);
  });

  it('is no longer one when it is deleted, and is one again after undo', async () => {
    const bench = await opened(settingOf('calm'));
    bench.session.library.settings.remove('calm');
    expect([bench.session.origin.setting.value, bench.editor.working.value !== null]).toEqual([null, true]);
    bench.session.library.undoRemove();
    expect(names(bench)).toEqual(['Lancer', 'calm']);
  });

  it('is in the library also when the browser keeps nothing, and says that it is not kept', async () => {
    const bench = await opened(settingOf('calm'));
    type(bench, DT, '2:00');
    bench.store.broken = true;
    expect(await run(bench.session.opened.save())).toBe(false);
    const { library, opened: open } = bench.session;
    expect([open.unsaved.value?.changes, library.kept.value]).toEqual([0, false]);
    expect(library.settings.get('calm')?.setting.program.times[10]).toBe(12000);
    bench.store.broken = false;
    await run(library.keepAgain());
    expect([library.kept.value, dtOf(bench, 'calm')]).toEqual([true, 12000]);
  });
});

/** The DT of the setting, and of its versions, in seconds. */
const dtsOf = ({ session }: AppBench, id: string): readonly number[] => {
  const record = session.library.settings.get(id);
  const programs = [record?.setting, ...(record?.versions ?? [])].map((each) => each?.program.times[10] ?? 0);
  return programs.map((time) => time / 100);
};

async function savedWith(bench: AppBench, ...dts: readonly string[]): Promise<void> {
  for (const dt of dts) {
    type(bench, DT, dt);
    await run(bench.session.opened.save());
  }
}

/** Goes back to one of the versions, by its place in the list. */
async function backTo(bench: AppBench, id: string, at: number): Promise<void> {
  const record = bench.session.library.settings.get(id) as SettingRecord;
  await run(bench.session.opened.goBack(record.setting, record.versions?.[at] as SettingVersion));
}

describe('the versions of a setting', () => {
  it('are what each save replaced, with its source and the moment; the screen may take the save back', async () => {
    const bench = await opened(settingOf('calm'));
    const before = Date.now();
    await savedWith(bench, '2:00', '1:30');
    expect(dtsOf(bench, 'calm')).toEqual([90, 120, 180]);
    const { changedAt, versions = [] } = bench.store.settings.records.get('calm') as SettingRecord;
    expect(versions.map(({ at, from }) => [at === 5, from])).toEqual([
      [false, 'typed'],
      [true, 'typed'],
    ]);
    expect(versions[0]?.until).toBe(changedAt);
    expect(versions[1]?.until).toBeGreaterThanOrEqual(before);
    bench.session.opened.undoSave();
    expect(dtsOf(bench, 'calm')).toEqual([120, 180]);
  });

  it('are not kept by a save that changes no value, such as that of a name', async () => {
    const bench = await opened(settingOf('calm'));
    const { library } = bench.session;
    await run(bench.session.opened.save());
    await run(library.keepSetting({ ...settingOf('calm'), name: 'calmer' }));
    expect(library.settings.get('calm')).toMatchObject({ setting: { name: 'calmer' } });
    expect(library.settings.get('calm')?.versions).toBeUndefined();
  });

  it('are twenty at most: the oldest goes first', async () => {
    const bench = await opened(settingOf('calm'));
    await savedWith(bench, ...Array.from({ length: 21 }, (_, at) => String(60 + at)));
    expect(dtsOf(bench, 'calm')).toEqual(Array.from({ length: 21 }, (_, at) => 80 - at));
  });

  it('come back by a save, which keeps what it replaces; the screen follows, also when that is taken back', async () => {
    const bench = await opened(settingOf('calm'));
    await savedWith(bench, '2:00');
    await backTo(bench, 'calm', 0);
    expect([dtsOf(bench, 'calm'), bench.editor.textOf(DT)]).toEqual([[180, 120, 180], '3:00']);
    expect(bench.session.library.settings.get('calm')?.setting.at, 'the date of its values').toBe(5);
    bench.session.opened.undoSave();
    expect([dtsOf(bench, 'calm'), bench.editor.textOf(DT)]).toEqual([[120, 180], '2:00']);
    expect(bench.session.opened.unsaved.value?.changes).toBe(0);
  });

  it('leave on the screen what is not saved, and what belongs to something else', async () => {
    const bench = await opened(settingOf('calm'), settingOf('wind'));
    await savedWith(bench, '2:00');
    type(bench, S2, '70');
    await backTo(bench, 'calm', 0);
    expect([dtsOf(bench, 'calm')[0], bench.editor.textOf(DT), bench.editor.textOf(S2)]).toEqual([180, '2:00', '70']);
    expect(bench.session.opened.unsaved.value?.changes).toBe(2);
    await run(bench.session.opened.show(settingOf('wind')));
    await backTo(bench, 'calm', 0);
    expect([dtsOf(bench, 'calm')[0], names(bench)[1], bench.editor.textOf(DT)]).toEqual([120, 'wind', '3:00']);
  });

  it('do not move servos that follow', async () => {
    const bench = await connectedBench({ store: stored(settingOf('calm')) });
    await run(bench.session.opened.show(settingOf('calm')));
    await savedWith(bench, '2:00');
    bench.session.safety.confirm();
    await run(bench.bench.moveTo(4));
    await run(bench.follow.start());
    await backTo(bench, 'calm', 0);
    expect([dtsOf(bench, 'calm')[0], bench.editor.textOf(DT)]).toEqual([180, '2:00']);
  });

  it('come back with a setting whose deletion is undone', async () => {
    const bench = await opened(settingOf('calm'));
    await savedWith(bench, '2:00');
    bench.session.library.settings.remove('calm');
    bench.session.library.undoRemove();
    expect(dtsOf(bench, 'calm')).toEqual([120, 180]);
  });
});

describe('a setting with a timer', () => {
  it('is loaded over what the timer holds as one step, which undo takes back with its name', async () => {
    const store = stored(settingOf('calm'));
    const bench = await connectedBench({ store });
    const held = bench.editor.working.value;
    expect(await run(bench.session.opened.show(settingOf('calm')))).toBe(true);
    expect([names(bench), bench.editor.textOf(S2), bench.editor.undoStep.value?.code]).toEqual([
      ['Lancer', 'calm'],
      '65',
      'open',
    ]);
    expect(bench.session.opened.unsaved.value?.changes).toBe(0);
    bench.editor.undo();
    expect([bench.editor.working.value, bench.session.origin.setting.value]).toEqual([held, null]);
    bench.editor.redo();
    expect(names(bench)).toEqual(['Lancer', 'calm']);
  });

  it('that was open before the connection is loaded over the timer and stays open', async () => {
    const bench = await opened(settingOf('calm'));
    type(bench, S2, '70');
    await run(bench.session.timer.connect());
    expect([names(bench), bench.editor.textOf(S2), bench.session.opened.unsaved.value?.changes]).toEqual([
      ['Lancer', 'calm'],
      '70',
      1,
    ]);
    bench.editor.undo();
    expect(bench.session.origin.setting.value).toBeNull();
  });

  it.each([
    ['not-fitting', newProgram({ timerClass: 'B', ...USUAL_LAYOUT, from: 'usual' })],
    ['not-fitting', newProgram({ timerClass: 'Q', functions: 10, servos: 2, from: 'usual' })],
  ] as const)('is refused with the reason %s', async (reason, program) => {
    const bench = await connectedBench();
    const { value } = bench.editor.working;
    expect(bench.session.opened.obstacle(program)).toBe(reason);
    expect(await run(bench.session.opened.show(settingOf('other', program)))).toBe(false);
    expect(bench.editor.working.value).toBe(value);
    await run(bench.session.timer.disconnect());
    expect(await run(bench.session.opened.show(settingOf('other', program)))).toBe(true);
  });

  it('is refused while the servos follow, because they would move', async () => {
    const bench = await connectedBench();
    bench.session.safety.confirm();
    await run(bench.bench.moveTo(4));
    await run(bench.follow.start());
    expect(await run(bench.session.opened.show(settingOf('calm')))).toBe(false);
    expect(bench.session.opened.obstacle(USUAL)).toBe('following');
  });

  it('stays open after it was saved from the timer, with its source, until another timer comes', async () => {
    const bench = await connectedBench({ store: stored() });
    await run(bench.session.opened.saveAs({ model: 'lancer', name: 'as read' }));
    const [record] = bench.session.library.settings.list.value;
    expect([names(bench)[1], record?.setting.from, record?.setting.program]).toEqual([
      'as read',
      'timer',
      bench.editor.baseline.value,
    ]);
    const memory = bench.timer.core.memories[0];
    if (memory) memory.times[10] = 7700;
    await run(bench.session.reader.read());
    expect(bench.session.origin.setting.value, 'it may be another timer, so the setting is closed').toBeNull();
  });

  it('stays open during a write', async () => {
    const bench = await connectedBench({ store: stored(settingOf('calm')) });
    await run(bench.session.opened.show(settingOf('calm')));
    bench.editor.wrote(bench.editor.working.value as TimerProgram);
    expect([names(bench)[1], bench.editor.changes.value]).toEqual(['calm', []]);
  });
});
