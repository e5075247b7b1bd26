import { describe, expect, it } from 'vitest';
import type { Draft, SettingRecord } from '../../../src/app/storage/index.js';
import { fieldKey } from '../../../src/program/index.js';
import { type AppBench, goOn, idle, reloaded, review, run } from '../bench/bench.js';
import {
  BACKUP,
  CALM,
  DT,
  LANCER_HELD,
  lancerBench,
  lancerConnected,
  MAGPIE_HELD,
  S2,
  savedAs,
  type,
  WIND,
} from '../two-models.js';

const whose = ({ session: { origin } }: AppBench) => [
  origin.model.value?.name ?? null,
  origin.setting.value?.name ?? null,
  origin.timer.value?.name ?? null,
];
/** The timer holds what no model is known to hold. */
function unknown({ timer }: AppBench): void {
  const positions = LANCER_HELD.positions.map((row) => row.map((position, slot) => (position + 11 * slot) % 100));
  timer.core.memories[0] = { times: LANCER_HELD.times.map((time) => time + 300), positions };
}

const valuesOf = (bench: AppBench) => bench.editor.working.value?.positions;

describe('the values on the screen', () => {
  it('are of the setting that was loaded over the timer of another model, until all of them are the timer’s', async () => {
    const bench = await lancerConnected();
    expect(whose(bench)).toEqual(['Lancer', null, 'Lancer']);
    await run(bench.session.opened.show(WIND));
    expect(whose(bench)).toEqual(['Magpie', 'wind', 'Lancer']);
    bench.editor.revertAll();
    expect(whose(bench)).toEqual(['Lancer', null, 'Lancer']);
    type(bench, DT, '2:00');
    expect(whose(bench), 'typing after that makes them nobody else’s').toEqual(['Lancer', null, 'Lancer']);
    bench.editor.undo();
    bench.editor.undo();
    expect(whose(bench), 'undo brings the setting back with its values').toEqual(['Magpie', 'wind', 'Lancer']);
  });

  it('are the timer’s again, too, when the last one is put back or typed back by itself', async () => {
    for (const isTyped of [false, true]) {
      const bench = await lancerConnected();
      await run(bench.session.opened.show(WIND));
      for (const { field, from } of bench.editor.changes.value) {
        if (isTyped && field.kind === 'position') type(bench, field, String(from));
        else bench.editor.revert(field);
      }
      expect([bench.editor.changes.value, whose(bench)]).toEqual([[], ['Lancer', null, 'Lancer']]);
    }
  });

  it('stay with their setting while a digit on the way is that of the timer', async () => {
    const bench = await lancerConnected();
    const program = { ...LANCER_HELD, positions: LANCER_HELD.positions.map((row) => [...row]) };
    (program.positions[1] as number[])[4] = 7;
    await run(bench.session.library.keepSetting({ ...CALM, program }).then(() => {}));
    await run(bench.session.opened.show({ ...CALM, program }));
    const held = String(LANCER_HELD.positions[1]?.[4]);
    bench.editor.type(S2, held);
    bench.editor.type(S2, `${held}0`);
    bench.editor.leave(S2);
    expect(bench.editor.changed.value.has(fieldKey(S2))).toBe(true);
    expect(whose(bench)).toEqual(['Lancer', 'calm', 'Lancer']);
  });

  it('are of the setting that the timer held them as, when a change of it is typed back', async () => {
    const bench = await lancerConnected();
    await run(bench.session.opened.show(CALM));
    await run(bench.session.opened.saveAs({ model: 'Lancer', name: 'as read' }));
    type(bench, DT, '2:00');
    bench.editor.revertAll();
    expect(whose(bench)).toEqual(['Lancer', 'as read', 'Lancer']);
  });

  it('are of the model of a backup, and of no setting, whichever timer is connected', async () => {
    const bench = await lancerConnected();
    await run(bench.session.opened.show(CALM));
    bench.session.onScreen.showBackup(BACKUP);
    expect(whose(bench)).toEqual(['Magpie', null, 'Lancer']);
    const { model: _, ...unknown } = BACKUP;
    bench.editor.revertAll();
    bench.session.onScreen.showBackup(unknown);
    expect(whose(bench), 'nobody knows whose backup that is').toEqual([null, null, 'Lancer']);
  });

  it('stay those of the timer from which they were read, after Disconnect and a reload', async () => {
    const bench = await lancerConnected();
    type(bench, S2, '77');
    await run(bench.session.timer.disconnect());
    expect(whose(bench)).toEqual(['Lancer', null, 'Lancer']);
    await idle();
    const again = await reloaded(bench);
    await run(again.session.library.load());
    expect([whose(again), again.session.origin.program.value?.memory]).toEqual([['Lancer', null, 'Lancer'], 0]);
  });

  it('that were kept have no name of a timer that was connected meanwhile', async () => {
    const bench = await lancerConnected();
    type(bench, S2, '77');
    await idle();
    await run(bench.session.timer.disconnect());
    const { model, ...draft } = [...bench.store.drafts.records.values()][0] as Draft;
    expect(model).toBe('Lancer');
    bench.session.onScreen.bringBack(draft);
    expect(whose(bench)).toEqual([null, null, null]);
  });

  it('are of no memory of the timer over which they lie, but of that of their own', async () => {
    const bench = await lancerConnected();
    const memory = () => bench.session.origin.program.value?.memory;
    expect(memory()).toBe(0);
    await run(bench.session.opened.show(WIND));
    expect(memory()).toBe(1);
    bench.session.onScreen.showBackup(BACKUP);
    expect(memory()).toBeNull();
  });

  it('are not saved over their setting when another timer has come under them with other values', async () => {
    const bench = await lancerConnected();
    await run(bench.session.opened.show(CALM));
    await run(bench.session.opened.saveAs({ model: 'Lancer', name: 'mine' }));
    type(bench, DT, '2:00');
    bench.timer.core.memories.splice(
      0,
      1,
      structuredClone({ times: [...MAGPIE_HELD.times], positions: MAGPIE_HELD.positions.map((row) => [...row]) }),
    );
    await run(bench.session.reader.read().then(() => {}));
    // Only DT is still the Lancer’s: saved over “mine”, the Magpie’s values would be under the Lancer.
    await run(bench.saveSetting.save());
    expect(bench.saveSetting.asking.value, 'it asks for another name').toBe(true);
    expect(bench.session.origin.crossing.value).toMatchObject({ from: { name: 'Lancer' }, to: [{ name: 'Magpie' }] });
  });
});

describe('a save', () => {
  it('goes to the setting whose values they are, and never to another after Undo all', async () => {
    const bench = await lancerConnected();
    await run(bench.session.opened.show(WIND));
    bench.editor.revertAll();
    await run(bench.saveSetting.save());
    expect(bench.saveSetting.asking.value, 'it asks for a name').toBe(true);
    expect(savedAs(bench, 'wind')).toEqual(WIND);
  });

  it('keeps the memory of the setting’s own timer', async () => {
    const bench = await lancerConnected();
    await run(bench.session.opened.show(WIND));
    type(bench, DT, '2:00');
    await run(bench.saveSetting.save());
    expect(savedAs(bench, 'wind')).toMatchObject({ model: 'Magpie', from: 'typed', program: { memory: 1 } });
    expect(savedAs(bench, 'wind')?.program.times[10]).toBe(12_000);
  });

  it('can be undone: what it replaced is there again, and what was typed is a change again', async () => {
    const bench = await lancerConnected();
    await run(bench.session.opened.show(WIND));
    type(bench, DT, '2:00');
    const typed = valuesOf(bench);
    await run(bench.saveSetting.save());
    expect(bench.session.opened.undoable.value?.name).toBe('wind');
    bench.session.opened.undoSave();
    await idle(0);
    expect(savedAs(bench, 'wind')).toEqual(WIND);
    expect(bench.store.settings.records.get('wind')?.setting).toEqual(WIND);
    expect([bench.session.opened.undoable.value, bench.session.opened.unsaved.value?.changes]).toEqual([null, 1]);
    expect(valuesOf(bench)).toEqual(typed);
  });

  it('as a new setting can be undone, and the values are whose they were', async () => {
    const bench = await lancerConnected();
    type(bench, DT, '2:00');
    await run(bench.saveSetting.saveAs({ model: 'Lancer', name: 'new', note: '' }));
    expect(whose(bench)).toEqual(['Lancer', 'new', 'Lancer']);
    bench.session.opened.undoSave();
    expect(whose(bench)).toEqual(['Lancer', null, 'Lancer']);
    expect(bench.session.library.settings.list.value.map(({ key }) => key)).toEqual(['calm', 'wind']);
  });

  it('is no longer undone once it has changed again, or something else is on the screen', async () => {
    const bench = await lancerConnected();
    await run(bench.session.opened.show(WIND));
    type(bench, DT, '2:00');
    await run(bench.saveSetting.save());
    await run(bench.session.opened.show(CALM));
    expect(bench.session.opened.undoable.value).toBeNull();
    bench.session.opened.undoSave();
    expect(savedAs(bench, 'wind')?.program.times[10]).toBe(12_000);
  });

  it('of what a timer holds says whose timer it is: nobody is asked again', async () => {
    const bench = await lancerBench();
    unknown(bench);
    await run(bench.session.timer.connect());
    expect(bench.session.recognition.tells.value).toBe(true);
    await run(bench.saveSetting.saveAs({ model: 'Lancer', name: 'new', note: '' }));
    expect([bench.session.recognition.tells.value, whose(bench)[2]]).toEqual([false, 'Lancer']);
    await idle();
    await run(bench.session.timer.disconnect());
    await run(bench.session.timer.connect());
    expect([bench.session.recognition.found.value?.kind, whose(bench)[2]]).toEqual(['same', 'Lancer']);
  });

  it('of what a timer holds as a model that is new says so, too', async () => {
    const bench = await lancerBench();
    unknown(bench);
    await run(bench.session.timer.connect());
    await run(bench.saveSetting.saveAs({ model: { name: 'Third' }, name: 'new', note: '' }));
    expect([bench.session.recognition.tells.value, whose(bench)]).toEqual([false, ['Third', 'new', 'Third']]);
  });

  it('of other values says nothing about the timer', async () => {
    const bench = await lancerBench();
    unknown(bench);
    await run(bench.session.timer.connect());
    await run(bench.session.opened.show(WIND));
    await run(bench.saveSetting.saveAs({ model: 'Magpie', name: 'new', note: '' }));
    expect([bench.session.recognition.tells.value, whose(bench)[2]]).toEqual([true, null]);
  });
});

describe('where a saved program comes from', () => {
  const saved = async (bench: AppBench, name = 'new'): Promise<{ from: string; at: number }> => {
    await run(bench.session.opened.saveAs({ model: null, name }));
    const {
      setting: { from, at },
    } = bench.session.library.settings.list.value.find(({ setting }) => setting.name === name) as SettingRecord;
    return { from, at };
  };

  it('is the timer at the time of the reading, however late it is saved', async () => {
    const bench = await lancerConnected();
    const { at } = bench.session.standing.value;
    await run(bench.session.timer.disconnect());
    expect(await saved(bench)).toEqual({ from: 'timer', at });
  });

  it('is typing, once a value is typed', async () => {
    const bench = await lancerConnected();
    type(bench, DT, '2:00');
    expect((await saved(bench)).from).toBe('typed');
  });

  it('stays what it was for a setting that is saved as another one', async () => {
    const bench = await lancerBench();
    await run(bench.session.opened.show({ ...WIND, from: 'link' }));
    await run(bench.session.library.keepSetting({ ...WIND, from: 'link' }).then(() => {}));
    expect(await saved(bench)).toEqual({ from: 'link', at: WIND.at });
  });

  it('is the last reading before a write that was interrupted, and typing for what it was to write', async () => {
    const bench = await lancerConnected();
    const { at } = bench.session.standing.value;
    type(bench, DT, '2:00');
    await review(bench);
    const readAt = bench.session.standing.value.at;
    bench.session.safety.confirm();
    bench.timer.core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS') bench.timer.core.sleep();
    };
    await goOn(bench);
    expect(bench.session.standing.value).toEqual({ sure: 'not', at: readAt });
    expect(readAt).toBeGreaterThanOrEqual(at ?? Infinity);
    expect((await saved(bench)).from).toBe('typed');
    bench.editor.revertAll();
    expect(await saved(bench, 'before')).toEqual({ from: 'timer', at: readAt });
  });
});
