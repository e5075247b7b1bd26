import { describe, expect, it } from 'vitest';
import { emptyModel } from '../../../src/app/records/library.js';
import type { Flight, ProgramField } from '../../../src/program/index.js';
import { type AppBench, asked, connectedBench, goOn, idle, reloaded, review, run } from '../bench/bench.js';
import { CALM, LANCER_HELD, lancerBench, lancerConnected, MAGPIE_HELD } from '../two-models.js';
import { PLAIN } from './flights.js';

const DT: ProgramField = { kind: 'time', slot: 10 };
const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };
const LANCER = emptyModel('lancer', 'Lancer 07', 'Q');

const logged = ({ session }: AppBench): readonly Flight[] =>
  session.library.flights.list.value.map(({ flight }) => flight);
const latest = (app: AppBench): Flight => logged(app)[0] as Flight;
const kept = ({ store }: AppBench) => [...store.flights.records.values()].map(({ flight }) => flight);

/** Types a DT, and writes what differs. */
async function write(app: AppBench, dt: string): Promise<void> {
  app.editor.type(DT, dt);
  await review(app);
  app.session.safety.confirm();
  await goOn(app);
  app.write.dismiss();
}

describe('one tap', () => {
  it('logs what the timer was verified to hold, and never what was only typed', async () => {
    const app = await connectedBench();
    await write(app, '4:00');
    const { times, positions } = structuredClone(app.timer.core.content);
    app.editor.type(DT, '20 s');
    app.editor.type(S1, '7');
    app.flights.flying();
    await idle();
    expect(latest(app).program).toMatchObject({ memory: 0, times, positions });
    expect(times[10]).toBe(24_000);
    expect(latest(app).utcOffset).toBe(0 - new Date().getTimezoneOffset());
    const nothing = { wind: null, temperature: null, round: '', result: null, note: '' };
    expect(latest(app)).toMatchObject({ ...nothing, place: '', model: null, modelName: '' });
    expect(kept(app)).toEqual(logged(app));
    await write(app, '3:00');
    expect(latest(app).program.times[10], 'a later write does not change a logged flight').toBe(24_000);
    const again = await reloaded(app);
    await again.session.library.flights.load();
    expect(logged(again)).toEqual(logged(app));
  });

  it('logs nothing where it is not known what flies next', async () => {
    const app = await connectedBench();
    expect(app.flights.held.value, 'after a reading it is known what flies').not.toBeNull();
    app.timer.core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS') app.timer.core.sleep();
    };
    await write(app, '4:00');
    expect(app.flights.held.value, 'after a write that was cut off it is not known what flies').toBeNull();
    app.flights.flying();
    await run(app.session.timer.disconnect());
    app.flights.flying();
    expect([app.flights.held.value, logged(app)]).toEqual([null, []]);
  });

  it('knows the current model and the last place', async () => {
    const app = await connectedBench();
    await app.session.library.load();
    await app.session.library.keepModel(LANCER);
    app.session.recognition.say(LANCER);
    app.flights.flying();
    await idle();
    expect([latest(app).model, latest(app).modelName]).toEqual(['lancer', 'Lancer 07']);
    await app.flights.change(latest(app).id, { place: 'Gyula' });
    await app.session.library.keepFlight({ ...PLAIN, id: 'old', at: 0 });
    await app.flights.change('old', { place: 'Mostar' });
    await app.session.library.keepModel({ ...LANCER, name: 'Lancer 07b' });
    app.flights.flying();
    await idle();
    const names = logged(app).map(({ place, modelName }) => `${place} ${modelName}`);
    expect(
      names.sort(),
      'each flight keeps its name of that day; an old flight that is corrected moves no place',
    ).toEqual(['Gyula Lancer 07', 'Gyula Lancer 07b', 'Mostar ']);
  });

  it('is of a setting only where the timer holds each value of it, whatever is typed', async () => {
    const app = await connectedBench();
    await app.session.library.load();
    await app.session.library.keepModel(LANCER);
    await app.session.opened.saveAs({ model: 'lancer', name: 'calm' });
    const [calm] = app.session.library.settings.list.value;
    const flown = (): unknown[] => {
      app.flights.flying();
      const { setting, settingName, model } = app.session.library.flights.get(app.flights.logged.value)?.flight ?? {};
      return [model, setting, settingName];
    };
    expect(flown()).toEqual(['lancer', calm?.key, 'calm']);
    app.editor.type(DT, '20 s');
    app.editor.leave(DT);
    expect(flown(), 'what is typed is not in the timer').toEqual(['lancer', calm?.key, 'calm']);
    await write(app, '25 s');
    expect(flown(), 'what flies is no longer what is saved').toEqual(['lancer', null, 'calm, changed']);
    await run(app.session.opened.save());
    expect(flown(), 'now it is').toEqual(['lancer', calm?.key, 'calm']);
  });

  it('knows a setting again by its values', async () => {
    const app = await lancerConnected();
    expect(app.session.origin.setting.value, 'nobody has opened it').toBeNull();
    app.flights.flying();
    expect(latest(app)).toMatchObject({ model: 'Lancer', setting: 'calm', settingName: 'calm' });
    // Two settings of the same values: nobody knows which of them it is.
    await run(app.session.library.keepSetting({ ...CALM, id: 'twin', name: 'twin' }).then(() => {}));
    app.flights.flying();
    const names = logged(app).map(({ settingName }) => settingName);
    expect(names.sort()).toEqual(['', 'calm']);
  });

  it('logs what a write has verified as long as its result is shown, also when the timer is gone by then', async () => {
    const app = await connectedBench();
    await app.session.library.load();
    await app.session.library.keepModel(LANCER);
    app.session.recognition.say(LANCER);
    app.editor.type(DT, '4:00');
    await review(app);
    app.session.safety.confirm();
    await goOn(app);
    await run(app.session.timer.disconnect());
    expect([app.flights.held.value, app.flights.flyable.value?.times[10]]).toEqual([null, 24_000]);
    app.flights.flying();
    await idle();
    expect(latest(app)).toMatchObject({ modelName: 'Lancer 07' });
    expect(latest(app).program.times[10]).toBe(24_000);
    app.write.dismiss();
    expect([app.flights.flyable.value, app.flights.flying()]).toEqual([null, null]);
  });

  it('is undone, and what was deleted comes back', async () => {
    const app = await connectedBench();
    app.flights.remove(app.flights.flying() ?? '');
    expect([logged(app), app.flights.logged.value]).toEqual([[], null]);
    await idle();
    expect(kept(app)).toEqual([]);
    app.flights.flying();
    await idle(0);
    const flight = latest(app);
    app.flights.fillIn(flight.id);
    app.flights.remove(flight.id);
    expect([logged(app), app.flights.filling.value]).toEqual([[], null]);
    app.session.library.flights.undoRemove();
    await idle();
    expect([logged(app), kept(app)]).toEqual([[flight], [flight]]);
  });

  it('does not call a flight before the write logged under the result of the write', async () => {
    const app = await connectedBench();
    await write(app, '4:00');
    app.flights.flyAgain(PLAIN);
    expect(app.flights.logged.value).not.toBeNull();
    app.editor.type(DT, '3:30');
    await review(app);
    await goOn(app);
    expect([app.write.current.value?.step, app.flights.logged.value]).toEqual(['done', null]);
  });

  it('once more needs no timer', async () => {
    const app = await connectedBench();
    app.flights.flying();
    await idle(0);
    await app.flights.change(latest(app).id, { place: 'Gyula', result: 170, note: 'good air', round: '1' });
    await run(app.session.timer.disconnect());
    const first = latest(app);
    app.flights.flyAgain(first);
    await idle();
    const again = logged(app).find(({ id }) => id !== first.id);
    expect(again).toMatchObject({ program: first.program, place: 'Gyula', result: null, note: '', round: '' });
  });
});

describe('what was flown comes back to the screen', () => {
  const dt = ({ editor }: AppBench) => editor.working.value?.times[10];
  const shown = async (app: AppBench, flight: Partial<Flight>): Promise<boolean> =>
    run(app.flights.showFlown({ ...PLAIN, ...flight }));
  const longer = { ...LANCER_HELD, times: LANCER_HELD.times.map((time, slot) => (slot === 10 ? 21_000 : time)) };

  it('over what the timer holds, as the copy that the flight keeps: one step to undo', async () => {
    const app = await lancerConnected();
    app.editor.type(DT, '4:00');
    app.editor.leave(DT);
    expect(await shown(app, { model: 'Lancer', setting: 'calm', program: longer })).toBe(true);
    expect([dt(app), app.session.origin.setting.value, app.session.origin.model.value?.name]).toEqual([
      21_000,
      null,
      'Lancer',
    ]);
    app.editor.undo();
    expect(dt(app)).toBe(24_000);
    expect(app.timer.core.content.times[10], 'nothing is written').toBe(LANCER_HELD.times[10]);
  });

  it('as the saved program where that still is exactly this; its unsaved changes are one step back', async () => {
    const app = await lancerBench();
    const flown = { model: 'Lancer', setting: 'calm', program: { ...LANCER_HELD, memory: 2 } };
    expect(await shown(app, flown)).toBe(true);
    expect([app.session.origin.setting.value?.id, app.editor.undoStep.value]).toEqual(['calm', null]);
    app.editor.type(DT, '4:00');
    app.editor.leave(DT);
    expect(await shown(app, flown)).toBe(true);
    expect([app.session.opened.unsaved.value?.changes, dt(app)]).toEqual([0, LANCER_HELD.times[10]]);
    app.editor.undo();
    expect(dt(app)).toBe(24_000);
  });

  it('not over the values of another kind of timer', async () => {
    const app = await lancerConnected();
    expect(await shown(app, {})).toBe(false);
    expect(await shown(app, { program: MAGPIE_HELD })).toBe(true);
  });
});

describe('a round with a short DT', () => {
  it('is put back by a write, and flown with what that has verified', async () => {
    const app = await connectedBench();
    await write(app, '20 s');
    app.flights.flying();
    await idle(0);
    const { id } = latest(app);
    expect(app.flights.canPutBack(latest(app))).toBe(true);
    app.flights.fillIn(id);
    void app.flights.putBack(id);
    await asked(app);
    expect([app.flights.filling.value, app.timer.core.content.times[10]], 'the page asks before it writes').toEqual([
      null,
      2000,
    ]);
    await goOn(app);
    await idle(0);
    expect(app.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
    expect([latest(app).program.times[10], app.timer.core.content.times[10]]).toEqual([18_000, 18_000]);
    app.write.dismiss();
    await write(app, '25 s');
    expect(latest(app).program.times[10], 'a later write of something else does not change the flight').toBe(18_000);
  });

  it('is not put back when it has a result, when the timer holds another DT, or when the write is cancelled', async () => {
    const app = await connectedBench();
    await write(app, '20 s');
    app.flights.flying();
    await idle(0);
    const flight = latest(app);
    expect(app.flights.canPutBack({ ...flight, result: 20 })).toBe(false);
    void app.flights.putBack(flight.id);
    await asked(app);
    app.write.dismiss();
    await write(app, '25 s');
    expect(latest(app).program.times[10]).toBe(2000);
    expect(app.flights.canPutBack(latest(app)), 'the DT of the flight is not the one that the timer holds').toBe(false);
  });
});
