import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  type Group,
  groupsOf,
  type Records,
  recordsOf,
  undoOf,
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
  const made = textOf(records, isAll, 5000);
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

const imported = (file: LibraryFile, held: Records) => recordsOf(groupsOf(file, held), held);

describe('what a file would bring', () => {
  it('is new, or the same, model by model', () => {
    expect(standings(groupsOf(fileOf(HELD), NOTHING))).toEqual(['Lancer 07: models new, settings new, flights new']);
    expect(standings(groupsOf(fileOf(HELD), HELD))).toEqual(['Lancer 07: models same, settings same, flights same']);
    const fields = { ...HELD.models[0]?.model } as Record<string, unknown>;
    const turned = Object.fromEntries(Object.entries(fields).reverse()) as unknown as typeof MODEL;
    const again = { ...HELD, models: HELD.models.map((record) => ({ ...record, model: turned })) };
    expect(standings(groupsOf(fileOf(HELD), again))[0]).toContain('models same');
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
    for (const isAll of [true, false]) expect(imported(fileOf(records, isAll), NOTHING)).toEqual(records);
  });

  it.each([
    ['of a device that had it before', held(70, 900), [70, 80]],
    ['of a device that went its own way', held(50, 900, at(900, 70), at(800, 40)), [50, 70, 70, 80, 40]],
    ['of a device that has another name for it', held(60, 900, at(700, 30)), [70, 80, 30]],
  ])('are joined with those %s, with what the import replaces', (_, here, expected) => {
    const before = { ...here, settings: here.settings.map((each) => ({ ...each })) };
    const file = fileOf(held(60, 1001, at(1000, 70), at(850, 80)));
    for (const each of file.library.settings) Object.assign(each, { note: 'new' });
    const put = imported(file, before);
    expect(dts(put)).toEqual(expected);
    expect(undoOf(put.settings, before.settings, put.settings)).toEqual({ put: before.settings, gone: [] });
  });

  it('stay with an import from a page that knows none, which replaces what is here', () => {
    const file = fileOf({ ...NOTHING, settings: [{ key: SETTING.id, setting: SETTING, changedAt: 1001 }] });
    expect(dts(imported(file, held(60, 1000, at(1000, 70))))).toEqual([60, 70]);
  });
});

describe('an import', () => {
  it('brings everything back to a device that has nothing, with what is known of its timers', () => {
    const two = { ...HELD.models[0], key: 'b', model: { ...MODEL, id: 'b' } } as Records['models'][number];
    const records = imported(fileOf({ ...HELD, models: [two, ...HELD.models] }), NOTHING);
    expect(records.models.map(({ key, changedAt, verified }) => [key, changedAt, verified.length])).toEqual([
      ['b', 1000, 1],
      ['lancer-07', 1000, 1],
    ]);
    expect(records.settings).toEqual(HELD.settings);
    expect(records.flights).toEqual(HELD.flights);
  });

  it.each([
    [1001, 'file-newer', ['calm-morning windy']],
    [1000, 'not-newer', []],
    [999, 'not-newer', []],
  ])('of a setting that was changed at %i is of one that is %s', (at, standing, taken) => {
    const file = fileOf(changed('windy', at));
    expect(standings(groupsOf(file, HELD))[0]).toContain(`settings ${standing}`);
    const { models, settings, flights } = imported(file, HELD);
    expect(settings.map(({ key, setting }) => `${key} ${setting.name}`)).toEqual(taken);
    expect([...models, ...flights]).toEqual([]);
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
    expect(imported(file, HELD).models[0]?.verified).toEqual([newer, theirs]);
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
        const there = put(imported(file, NOTHING), NOTHING);
        const sorted = (of: readonly { key: string }[]) => [...of].sort((a, b) => (a.key < b.key ? -1 : 1));
        expect(there.models.map(({ model }) => model)).toEqual(all.models.map(({ model }) => withPlainNames(model)));
        const flights = all.flights.map((record) => ({ ...record, flight: withPlainNames(record.flight) }));
        expect(sorted(there.flights)).toEqual(sorted(flights));
        expect(imported(file, there)).toEqual(NOTHING);
      }),
      { numRuns: 40 },
    );
  });

  it('comes back by undo', () => {
    fc.assert(
      fc.property(records, records, (held, theirs) => {
        fc.pre(theirs.models.length + theirs.settings.length + theirs.flights.length > 0);
        const fresh = imported(fileOf(theirs), held);
        const now = put(fresh, held);
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
    expect(textOf(partOf(all, { kind: 'setting', id: 'gone' }), false, 1)).toBe('nothing');
  });

  it('does not contain what the pilot’s timers hold', () => {
    const known = (isAll: boolean) => [...fileOf(HELD, isAll).facts.values()].filter(({ verified }) => verified).length;
    expect([known(true), known(false)]).toEqual([1, 0]);
  });
});
