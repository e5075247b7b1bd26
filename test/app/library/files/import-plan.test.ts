import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  countOf,
  type Group,
  groupsOf,
  type Records,
  recordsOf,
  takenOf,
  undoOf,
  type Way,
} from '../../../../src/app/library/files/import-plan.js';
import { partOf, textOf } from '../../../../src/app/library/files/library-text.js';
import { withPlainNames } from '../../../../src/app/records/plain-names.js';
import { type LibraryFile, parseLibraryFile, type SettingVersion } from '../../../../src/program/index.js';
import { library } from '../../../fuzz/kept.js';
import { FLIGHT, MODEL, SETTING, VERSION } from '../../../program/library-examples.js';

const HELD: Records = {
  models: [{ key: MODEL.id, model: MODEL, changedAt: 1000, verified: [{ program: SETTING.program, at: 10 }] }],
  settings: [{ key: SETTING.id, setting: SETTING, changedAt: 1000 }],
  flights: [{ key: FLIGHT.id, flight: FLIGHT, changedAt: 1000 }],
};
const NOTHING: Records = { models: [], settings: [], flights: [] };

function fileOf(records: Records, isAll = true): LibraryFile {
  const made = textOf(records, isAll, '1.2.3', 5000);
  if (typeof made === 'string') throw new Error(made);
  return parseLibraryFile(made.text);
}

/** The same with some fields of the setting changed, at another time. */
const changed = (name: string, changedAt: number): Records => ({
  ...HELD,
  settings: [{ key: SETTING.id, setting: { ...SETTING, name }, changedAt }],
});

const standings = (groups: readonly Group[]) =>
  groups.map(
    ({ name, entries }) => `${name}: ${entries.map(({ kind, standing }) => `${kind} ${standing}`).join(', ')}`,
  );

let made = 0;
const newId = () => `made-${++made}`;
const imported = (file: LibraryFile, held: Records, way: Way) => recordsOf(groupsOf(file, held), way, held, newId);

describe('what a file would bring', () => {
  it('is new, or the same, model by model', () => {
    expect(standings(groupsOf(fileOf(HELD), NOTHING))).toEqual(['Lancer 07: models new, settings new, flights new']);
    expect(standings(groupsOf(fileOf(HELD), HELD))).toEqual(['Lancer 07: models same, settings same, flights same']);
    const fields = { ...HELD.models[0]?.model } as Record<string, unknown>;
    const turned = Object.fromEntries(Object.entries(fields).reverse()) as unknown as typeof MODEL;
    const again = { ...HELD, models: HELD.models.map((record) => ({ ...record, model: turned })) };
    expect(standings(groupsOf(fileOf(HELD), again))[0]).toContain('models same');
  });

  it('differs, and the one of the file is newer or not', () => {
    for (const [at, standing] of [
      [1001, 'file-newer'],
      [1000, 'not-newer'],
      [999, 'not-newer'],
    ] as const) {
      expect(standings(groupsOf(fileOf(changed('windy', at)), HELD))[0]).toContain(`settings ${standing}`);
    }
  });

  it('has a name when anything knows one', () => {
    const setting = { ...HELD, models: [], flights: [] };
    const nobody = { ...SETTING, id: 's2', model: 'nobody' };
    const loose = { ...SETTING, id: 's3', model: null };
    const more = [nobody, loose].map((each) => ({ key: each.id, setting: each, changedAt: 1 }));
    const file = fileOf({ ...setting, settings: [...setting.settings, ...more] });
    expect(groupsOf(file, HELD).map(({ id, name }) => [id, name])).toEqual([
      ['lancer-07', 'Lancer 07'],
      ['nobody', ''],
      [null, ''],
    ]);
    expect(groupsOf(fileOf({ ...NOTHING, flights: HELD.flights }), NOTHING)[0]?.name).toBe('Lancer 07');
  });
});

describe('the versions of a setting', () => {
  const dt = (seconds: number) => ({ ...SETTING.program, times: SETTING.program.times.with(4, seconds * 100) });
  const at = (until: number, seconds: number): SettingVersion => ({ ...VERSION, until, program: dt(seconds) });
  const held = (seconds: number, changedAt: number, ...versions: SettingVersion[]): Records => ({
    ...NOTHING,
    settings: [{ key: SETTING.id, setting: { ...SETTING, program: dt(seconds) }, changedAt, versions }],
  });
  const dts = ({ settings }: Records) => settings[0]?.versions?.map(({ program }) => (program.times[4] ?? 0) / 100);

  it('go into every file, and come to a device that has nothing', () => {
    const records = held(60, 1000, at(1000, 70), at(900, 80));
    for (const isAll of [true, false]) expect(imported(fileOf(records, isAll), NOTHING, 'newer')).toEqual(records);
  });

  it.each([
    ['of a device that had it before', held(70, 900), [70, 80]],
    ['of a device that went its own way', held(50, 900, at(900, 70), at(800, 40)), [50, 70, 70, 80, 40]],
    ['of a device that has another name for it', held(60, 900, at(700, 30)), [70, 80, 30]],
  ])('are joined with those %s, with what the import replaces', (_, here, expected) => {
    const before = { ...here, settings: here.settings.map((each) => ({ ...each })) };
    const file = fileOf(held(60, 1001, at(1000, 70), at(850, 80)));
    for (const each of file.library.settings) Object.assign(each, { note: 'new' });
    const put = imported(file, before, 'newer');
    expect(dts(put)).toEqual(expected);
    expect(undoOf(put.settings, before.settings, put.settings)).toEqual({ put: before.settings, gone: [] });
    expect(dts(imported(file, before, 'both')), 'a copy has those of the file alone').toEqual([70, 80]);
  });

  it('stay with an import from a page that knows none, which replaces what is here', () => {
    const file = fileOf({ ...NOTHING, settings: [{ key: SETTING.id, setting: SETTING, changedAt: 1001 }] });
    expect(dts(imported(file, held(60, 1000, at(1000, 70)), 'newer'))).toEqual([60, 70]);
  });
});

describe('an import', () => {
  it('brings everything back to a device that has nothing, with what is known of its timers', () => {
    const two = { ...HELD.models[0], key: 'b', model: { ...MODEL, id: 'b' } } as Records['models'][number];
    const records = imported(fileOf({ ...HELD, models: [two, ...HELD.models] }), NOTHING, 'newer');
    expect(records.models.map(({ key, changedAt, verified }) => [key, changedAt, verified.length])).toEqual([
      ['b', 1000, 1],
      ['lancer-07', 1000, 1],
    ]);
    expect(records.settings).toEqual(HELD.settings);
    expect(records.flights).toEqual(HELD.flights);
  });

  it.each([
    ['newer', 1001, ['calm-morning windy']],
    ['newer', 1000, []],
    ['newer', 999, []],
    ['both', 1001, ['made calm (2)']],
    ['both', 1000, ['made calm (2)']],
    ['both', 999, ['made calm (2)']],
  ] as const)('with “%s” at %i takes %j', (way, at, taken) => {
    const file = fileOf(changed(way === 'both' ? 'calm' : 'windy', at));
    const records = imported(file, HELD, way);
    expect(records.settings.map(({ key, setting }) => [key.replace(/-\d+$/, ''), setting.name].join(' '))).toEqual(
      taken,
    );
    expect([...records.models, ...records.flights]).toEqual([]);
    for (const { key, setting } of records.settings) expect(setting.id).toBe(key);
  });

  it('finds a name that is free, however long the old one is', () => {
    const long = '🛩️'.repeat(30);
    const held = { ...HELD, settings: HELD.settings.map((each) => ({ ...each, setting: { ...SETTING, name: long } })) };
    const file = fileOf({
      ...held,
      settings: held.settings.map((each) => ({ ...each, setting: { ...each.setting, note: 'x' } })),
    });
    const first = imported(file, held, 'both').settings[0];
    expect([...(first?.setting.name ?? '')]).toHaveLength(60);
    expect(first?.setting.name.endsWith(' (2)')).toBe(true);
    const again = imported(file, { ...held, settings: [...held.settings, ...(first ? [first] : [])] }, 'both');
    expect(again.settings[0]?.setting.name.endsWith(' (3)')).toBe(true);
  });

  it('gives each copy a name of its own, and looks only at the settings beside it', () => {
    const twice = (name: string) => ['a', 'b'].map((id) => ({ ...SETTING, id, name }));
    const elsewhere = { ...SETTING, id: 'c', model: null, name: 'calm morning (2)' };
    const recordsFor = (settings: readonly (typeof SETTING)[]) =>
      settings.map((setting) => ({ key: setting.id, setting, changedAt: 1000 }));
    const held = { ...HELD, settings: recordsFor([...twice('calm morning'), elsewhere]) };
    const theirs = { ...held, settings: recordsFor(twice('calm morning').map((each) => ({ ...each, note: 'x' }))) };
    const names = imported(fileOf(theirs), held, 'both').settings.map(({ setting }) => setting.name);
    expect(names).toEqual(['calm morning (2)', 'calm morning (3)']);
  });

  it('keeps both of a model under two names', () => {
    const theirs = { ...HELD, models: HELD.models.map((record) => ({ ...record, model: { ...MODEL, note: 'x' } })) };
    const [copy] = imported(fileOf(theirs), HELD, 'both').models;
    expect(copy).toMatchObject({ model: { name: 'Lancer 07 (2)', note: 'x' } });
    expect(copy?.key).toBe(copy?.model.id);
    expect(copy?.key).not.toBe(MODEL.id);
  });

  it('gives the second model all programs of the file, and leaves the flights with the first', () => {
    const windy = { ...SETTING, id: 'windy', name: 'windy' };
    const theirs: Records = {
      models: HELD.models.map((record) => ({ ...record, model: { ...MODEL, note: 'x' } })),
      settings: [
        ...changed('calm', 2000).settings,
        { key: 'windy', setting: windy, changedAt: 2000 },
        { key: 'fresh', setting: { ...SETTING, id: 'fresh', name: 'fresh' }, changedAt: 2000 },
      ],
      flights: [...HELD.flights, { key: 'f2', flight: { ...FLIGHT, id: 'f2' }, changedAt: 2000 }],
    };
    const held = { ...HELD, settings: [...HELD.settings, { key: 'windy', setting: windy, changedAt: 2000 }] };
    const { models, settings, flights } = imported(fileOf(theirs), held, 'both');
    const [copy] = models;
    expect(settings.map(({ setting }) => [setting.model, setting.name])).toEqual(
      ['calm', 'windy', 'fresh'].map((name) => [copy?.key, name]),
    );
    expect(new Set([...settings.map(({ key }) => key), SETTING.id, 'windy']).size).toBe(5);
    expect(flights.map(({ key, flight }) => [key, flight.model])).toEqual([['f2', MODEL.id]]);
    const [group] = groupsOf(fileOf(theirs), held);
    expect(countOf(group ? takenOf(group, 'both') : [])).toEqual({ models: 1, settings: 3, flights: 1 });
  });

  it('makes no second model and no second program of one that is only in the archive', () => {
    const theirs: Records = {
      models: HELD.models.map((record) => ({ ...record, model: { ...MODEL, archived: true }, changedAt: 2000 })),
      settings: HELD.settings.map((record) => ({
        ...record,
        setting: { ...SETTING, archived: true },
        changedAt: 2000,
      })),
      flights: HELD.flights,
    };
    expect(imported(fileOf(theirs), HELD, 'both')).toEqual(NOTHING);
    expect(imported(fileOf(theirs), HELD, 'newer').models[0]?.model.archived).toBe(true);
  });

  it('recognises an entry whose name has signs that reverse the text of the file', () => {
    const turned: Records = {
      models: HELD.models.map((record) => ({
        ...record,
        model: { ...MODEL, name: '\u202eLancer 07', memoryNames: ['\u202a'] },
      })),
      settings: HELD.settings.map((record) => ({ ...record, setting: { ...SETTING, name: 'calm\u2066' } })),
      flights: HELD.flights.map((record) => ({ ...record, flight: { ...FLIGHT, place: '\u202dTurda' } })),
    };
    const groups = groupsOf(fileOf(turned), NOTHING);
    expect(groups.map(({ name }) => name)).toEqual(['Lancer 07']);
    const there = imported(fileOf(turned), NOTHING, 'newer');
    expect(there.models[0]?.model).toMatchObject({ name: 'Lancer 07', memoryNames: [''] });
    for (const held of [there, turned]) {
      expect(standings(groupsOf(fileOf(turned), held))[0]).toMatch(/: models same, settings same, flights same$/);
      for (const way of ['newer', 'both'] as const) expect(imported(fileOf(turned), held, way)).toEqual(NOTHING);
    }
  });

  it('keeps what is known of a timer, the latest of each memory', () => {
    const theirs = { program: { ...SETTING.program, memory: 2 }, at: 5 };
    const newer = { program: SETTING.program, at: 20 };
    const file = fileOf({
      ...HELD,
      models: HELD.models.map((record) => ({
        ...record,
        model: { ...MODEL, note: 'x' },
        changedAt: 2000,
        verified: [newer, theirs],
      })),
    });
    expect(imported(file, HELD, 'newer').models[0]?.verified).toEqual([newer, theirs]);
  });

  it('counts what it takes', () => {
    const [group] = groupsOf(fileOf(HELD), NOTHING);
    expect(countOf(group ? takenOf(group, 'newer') : [])).toEqual({ models: 1, settings: 1, flights: 1 });
  });
});

describe('whatever a library holds', () => {
  const records = fc.tuple(library, fc.array(fc.integer({ min: 0, max: 1e12 }))).map(
    ([{ models, settings, flights }, times]): Records => ({
      models: models.map((model, at) => ({
        key: model.id,
        model,
        changedAt: times[at] ?? 1,
        verified: [],
      })),
      settings: settings.map((setting, at) => ({ key: setting.id, setting, changedAt: times[at] ?? 2 })),
      flights: flights.map((flight, at) => ({ key: flight.id, flight, changedAt: times[at] ?? 3 })),
    }),
  );
  const put = (records: Records, held: Records): Records => {
    const over = <R extends { key: string }>(old: readonly R[], fresh: readonly R[]): R[] => [
      ...new Map([...old, ...fresh].map((record) => [record.key, record])).values(),
    ];
    return {
      models: over(held.models, records.models),
      settings: over(held.settings, records.settings),
      flights: over(held.flights, records.flights),
    };
  };

  it('can be moved to another device, and a second import of the same file changes nothing', () => {
    fc.assert(
      fc.property(records, (all) => {
        fc.pre(all.models.length + all.settings.length + all.flights.length > 0);
        const file = fileOf(all);
        const there = put(imported(file, NOTHING, 'newer'), NOTHING);
        const sorted = (of: readonly { key: string }[]) => [...of].sort((a, b) => (a.key < b.key ? -1 : 1));
        expect(there.models.map(({ model }) => model)).toEqual(all.models.map(({ model }) => withPlainNames(model)));
        const flights = all.flights.map((record) => ({ ...record, flight: withPlainNames(record.flight) }));
        expect(sorted(there.flights)).toEqual(sorted(flights));
        expect(imported(file, there, 'newer')).toEqual(NOTHING);
        expect(imported(file, there, 'both')).toEqual(NOTHING);
      }),
      { numRuns: 40 },
    );
  });

  it('loses nothing by “keep both”, and comes back by undo', () => {
    fc.assert(
      fc.property(records, records, fc.constantFrom<Way>('newer', 'both'), (held, theirs, way) => {
        fc.pre(theirs.models.length + theirs.settings.length + theirs.flights.length > 0);
        const fresh = imported(fileOf(theirs), held, way);
        const now = put(fresh, held);
        if (way === 'both') expect(now.settings.slice(0, held.settings.length)).toEqual(held.settings);
        const { put: back = [], gone = [] } = undoOf(fresh.settings, held.settings, now.settings);
        const left = now.settings.filter(({ key }) => !gone.includes(key));
        expect(put({ ...NOTHING, settings: back }, { ...NOTHING, settings: left }).settings).toEqual(held.settings);
      }),
      { numRuns: 40 },
    );
  });
});

it('undo leaves entries that were changed or deleted since then', () => {
  const [record] = HELD.settings;
  if (!record) throw new Error('no setting');
  const edited = { ...record, setting: { ...record.setting, note: 'since then' } };
  expect(undoOf([record], [], [edited])).toEqual({ put: [], gone: [] });
  expect(undoOf([record], [], [])).toEqual({ put: [], gone: [] });
  expect(undoOf([record], [edited], [record])).toEqual({ put: [edited], gone: [] });
  expect(undoOf([record], [], [record])).toEqual({ put: [], gone: [record.key] });
});

describe('a part of the library', () => {
  const other = { ...SETTING, id: 'other', model: 'b' };
  const all = { ...HELD, settings: [...HELD.settings, { key: 'other', setting: other, changedAt: 1 }] };

  it('is one model with what belongs to it, or one setting with its model', () => {
    expect(partOf(all, { kind: 'all' })).toEqual(all);
    expect(partOf(all, { kind: 'model', id: MODEL.id })).toEqual(HELD);
    expect(partOf(all, { kind: 'setting', id: SETTING.id })).toEqual({ ...HELD, flights: [] });
    expect(partOf(all, { kind: 'setting', id: 'other' }).models).toEqual([]);
    expect(textOf(partOf(all, { kind: 'setting', id: 'gone' }), false, '1', 1)).toBe('nothing');
  });

  it('does not contain what the pilot’s timers hold', () => {
    const known = (isAll: boolean) => [...fileOf(HELD, isAll).facts.values()].filter(({ verified }) => verified).length;
    expect([known(true), known(false)]).toEqual([1, 0]);
  });
});
