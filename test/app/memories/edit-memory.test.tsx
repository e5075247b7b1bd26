import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { en } from '../../tools/en.js';
import { type AppBench, type BenchOptions, idle, run, selected, sets } from '../bench/bench.js';
import { connected, field, goTo, loadedAgain, lookAt, press, startWrite, type } from '../screen.js';

/** M3 is opened in the table while M1 flies next: there DT is 4:00, in M1 it is 3:00. */
async function editing(options: BenchOptions = {}): Promise<AppBench> {
  const app = await connected(options);
  await lookAt('M3');
  await press('Edit M3');
  return app;
}

const top = () => document.querySelector('.top')?.textContent?.replaceAll('\u00a0', ' ') ?? '';
const said = () => document.querySelector('.changes strong')?.textContent?.replaceAll('\u00a0', ' ');
const dialog = () => within(screen.getByRole('dialog'));
const dtOf = ({ timer }: AppBench) => timer.core.memories.slice(0, 3).map(({ times }) => times[10]);
/** A frame by hand that stores nothing, which waits for a yes. */
function ask({ line: { form }, session }: AppBench) {
  session.safety.confirm();
  form.type('4e');
  form.ask();
  return form;
}

/** Which memory is on the screen, and which one flies next by what the page says. */
const where = ({ session }: AppBench) => [session.onScreen.memory.value, session.nextFlight.memory.value];

describe('another memory than the one that flies next, in the table', () => {
  it('is said in words above every view, and is as it was read in the timer', async () => {
    const app = await editing();
    expect([app.timer.core.memory, selected(app), where(app)]).toEqual([0, [2, 0], [2, 0]]);
    for (const view of ['program', 'memories', 'bench', 'library'] as const) {
      await goTo(view);
      expect(top(), view).toContain('This is M3. M1 flies next.');
    }
    expect(said()).toMatch(/^As in the timer, read \d\d:\d\d$/);
    await press('Disconnect');
    expect(top()).not.toContain('flies next');
    expect(said()).toMatch(/^As last read/);
  });

  it('is written, verified, and M1 flies next at the end; M1 is as it was', async () => {
    const app = await editing();
    const [m1] = structuredClone(app.timer.core.memories);
    await type('DT time', '2:00');
    await press('Write 1 change…');
    expect(dialog().getByText(/^M3 will hold .* At the end M1 flies next again\.$/)).toBeTruthy();
    await startWrite();
    expect(screen.getByRole('dialog').textContent.replaceAll('\u00a0', ' ')).toMatch(
      /Verified\..*M3 verified \d\d:\d\d · DT 2:00 min .* 1 change/,
    );
    expect(dialog().getByRole('status').textContent).toBe('M1 flies next.');
    expect([...app.editor.confirmed.value]).toEqual(['time:10']);
    expect([app.timer.core.memories[0], app.timer.core.memory, dtOf(app)]).toEqual([m1, 0, [18_000, 21_000, 12_000]]);
    expect(app.session.backups.list.value.map(({ program }) => program.memory)).toEqual([2]);
    expect(app.store.unfinished.records.size).toBe(0);
    await press('Close');
    expect([where(app), app.editor.changes.value.length, said()]).toEqual([
      [2, 0],
      0,
      expect.stringMatching(/^As in the timer, verified/),
    ]);
  });

  it('keeps the changes of each memory, with their steps, over every way from one to the other', async () => {
    const app = await connected();
    await type('DT time', '5:00');
    await lookAt('M3');
    await press('Edit M3');
    expect([field('DT time').value, app.editor.undoStep.value]).toEqual(['4:00', null]);
    expect(app.session.notices.current.value).toEqual({ kind: 'note', code: 'kept' });
    await type('DT time', '2:00');
    app.timer.core.answered.length = 0;
    await lookAt('M1, flies next');
    await idle();
    expect([field('DT time').value, app.editor.changes.value.length, where(app)]).toEqual(['5:00', 1, [0, 0]]);
    expect(app.timer.core.answered, 'it was read').toEqual([]);
    app.editor.undo();
    await lookAt('M3');
    await press('Edit M3');
    expect(field('DT time').value).toBe('2:00');
    app.editor.undo();
    await idle();
    expect(field('DT time').value).toBe('4:00');
    await press('Show M1');
    expect([field('DT time').value, app.editor.redoStep.value]).toEqual(['3:00', expect.anything()]);
  });

  it('is read again by Read, which goes back, and shows what has changed below the changes', async () => {
    const app = await editing();
    await type('DT time', '2:00');
    app.timer.core.memories[2]?.times.splice(10, 1, 30_000);
    await press(en.program.read);
    expect([selected(app), where(app), app.session.notices.current.value]).toEqual([
      [2, 0, 2, 0],
      [2, 0],
      { kind: 'note', code: 'moved' },
    ]);
    const asked = app.timer.core.answered.map(({ name }) => name);
    const back = asked.slice(asked.lastIndexOf('SETMEMORY'));
    expect(back, 'after going back, the timer is asked which memory is current').toContain('GETMEMORY');
    expect(back, 'M1 is not read for it').not.toContain('GETTIMERS');
    app.timer.core.memories[2]?.positions[2]?.splice(5, 1, 44);
    await press('Write 1 change…');
    expect(dialog().getByText(en.notes.moved.title)).toBeTruthy();
    await startWrite();
    expect(app.timer.core.memories[2]?.positions[2]?.[5], 'what else has changed there stays').toBe(44);
    expect([dtOf(app)[2], app.editor.conflicts.value.size]).toEqual([12_000, 0]);
  });

  it('goes into M1 when the pilot chooses that, by its own request', async () => {
    const app = await editing();
    await press('Write…');
    fireEvent.click(dialog().getByRole('radio', { name: 'M1' }));
    await idle();
    expect(dialog().getByText(/^M1 will hold the times and positions on the screen/)).toBeTruthy();
    await startWrite();
    expect([dtOf(app), app.timer.core.memory, where(app)]).toEqual([[24_000, 21_000, 24_000], 0, [2, 0]]);
    await press('Close');
    await press('Show M1');
    expect([field('DT time').value, said()]).toEqual(['4:00', expect.stringMatching(/^As in the timer, read/)]);
  });

  it('has no idle throttle to edit, which may belong to all memories', async () => {
    const app = await editing();
    expect(screen.queryByRole('textbox', { name: 'Idle throttle' })).toBeNull();
    await goTo('bench');
    expect(document.querySelector('.bench')?.textContent).not.toContain(en.program.idleThrottle);
    await run(app.session.reader.showNext());
    await goTo('program');
    expect(field('Idle throttle').value).toBe('30');
  });

  it('flies next when the pilot makes it: then nothing is apart', async () => {
    const app = await editing();
    await type('DT time', '2:00');
    await goTo('memories');
    await press('Make M3 fly next');
    expect([app.timer.core.memory, where(app), app.session.onScreen.apart.value]).toEqual([2, [2, 2], false]);
    await goTo('program');
    expect([field('DT time').value, top().includes('This is')]).toEqual(['2:00', false]);
    await press('Write 1 change…');
    expect(dialog().getByText(en.write.lead({ memory: 'M3' }))).toBeTruthy();
  });
});

describe('what is said of the next flight, while M3 is in the table', () => {
  it('is of M1: a flight, a short DT, the checklist', async () => {
    const app = await connected();
    app.timer.core.memories[2]?.times.splice(10, 1, 2000);
    await lookAt('M3');
    await press('Edit M3');
    const { session, flights } = app;
    expect(app.editor.baseline.value?.times[10]).toBe(2000);
    expect(session.shortDt.held.value).toBeNull();
    expect(flights.held.value?.memory).toBe(0);
    const key = flights.flying();
    expect(session.library.flights.get(key)?.flight.program).toMatchObject({ memory: 0, times: { 10: 18_000 } });
    await goTo('help');
    expect(document.querySelector('.known-now')?.textContent?.replaceAll('\u00a0', ' ')).toMatch(
      /^M1 flies next, DT 3:00 min, read \d\d:\d\d\./,
    );
    await goTo('program');
    await type('DT time', '1:00');
    await goTo('help');
    expect(document.querySelector('.known-now')?.textContent, 'changes of M3').not.toContain('change');
    await goTo('program');
    expect(screen.queryByRole('button', { name: /^Flying this/ })).toBeNull();
    await press('Write 1 change…');
    await startWrite();
    expect([app.write.verified.value, flights.flyable.value?.memory]).toEqual([null, 0]);
    await press('Close');
    await press('Disconnect');
    expect([session.link.state.value.status, flights.flyable.value]).toEqual(['off', null]);
    await goTo('help');
    expect(document.querySelector('.known-now')?.textContent).toBe(en.checklist.known.nothing);
  });

  it('is a short DT of M1, which is put back there', async () => {
    const app = await connected();
    app.timer.core.memories[0]?.times.splice(10, 1, 2000);
    await press(en.program.read);
    await lookAt('M3');
    await press('Edit M3');
    await type('DT time', '6:00');
    await press('Disconnect');
    expect(dialog().getByText(/DT of M1 is 20 s/)).toBeTruthy();
    fireEvent.click(dialog().getByRole('button', { name: /3:00/ }));
    await idle();
    await startWrite();
    expect(dtOf(app)).toEqual([18_000, 21_000, 24_000]);
    expect(where(app)).toEqual([0, 0]);
  });

  it('moves nothing: no servo, no motor, and no position is stored', async () => {
    const app = await editing();
    await goTo('bench');
    expect(screen.getByText(en.bench.elsewhere({ memory: 'M1' }))).toBeTruthy();
    app.session.safety.confirm();
    app.timer.core.answered.length = 0;
    await run(Promise.all([app.bench.moveTo(2), app.bench.unlock(), app.bench.jump(), app.follow.start()]));
    expect([app.timer.core.answered, app.follow.on.value, app.bench.ready.value]).toEqual([[], false, false]);
    await run(app.session.reader.showNext());
    expect(app.bench.ready.value).toBe(true);
  });

  it('ends servos that follow M1', async () => {
    const app = await connected();
    app.session.safety.confirm();
    await run(app.follow.start());
    expect(app.follow.on.value).toBe(true);
    await run(app.memories.edit(2));
    await idle();
    expect([app.follow.on.value, where(app)]).toEqual([false, [2, 0]]);
    app.editor.type({ kind: 'position', servo: 0, slot: 2 }, '7');
    await idle();
    expect(sets(app)).not.toContain('SETSERVO');
  });
});

describe('while M3 is in the table', () => {
  it('the timer that comes back leaves it there, as last read, and says what flies next', async () => {
    const app = await editing({ plug: { granted: true } });
    await type('DT time', '2:00');
    app.adapter.unplug();
    await idle();
    app.adapter.replug();
    await idle();
    expect([app.session.link.state.value.status, where(app)]).toEqual(['on', [2, 0]]);
    expect([field('DT time').value, app.session.standing.value.sure, selected(app)]).toEqual(['2:00', 'once', [2, 0]]);
    expect(top()).toContain('This is M3. M1 flies next.');
    await press(en.program.read);
    expect([field('DT time').value, app.session.standing.value.sure]).toEqual(['2:00', 'now']);
  });

  it('a reload keeps its changes as those of M3, and says nothing of the next flight', async () => {
    const app = await editing();
    await type('DT time', '2:00');
    await idle();
    const after = await loadedAgain(app);
    expect([field('DT time').value, after.session.onScreen.apart.value]).toEqual(['2:00', true]);
    await goTo('help');
    expect(document.querySelector('.known-now')?.textContent).toBe(en.checklist.known.nothing);
    await goTo('program');
    await run(after.session.timer.connect());
    expect([where(after), field('DT time').value]).toEqual([[0, 0], '3:00']);
    await lookAt('M3');
    await press('Edit M3');
    expect([where(after), field('DT time').value]).toEqual([[2, 0], '2:00']);
  });

  it('“Connect and write” after a reload reads M3 and writes there', async () => {
    const app = await editing();
    await type('DT time', '2:00');
    await idle();
    const after = await loadedAgain(app);
    await press(en.program.connectAndWrite);
    expect(dialog().getByText(/^M3 will hold/)).toBeTruthy();
    await startWrite();
    expect([dtOf(after), after.timer.core.memory]).toEqual([[18_000, 21_000, 12_000], 0]);
  });

  it('a timer of another kind that comes then gets nothing of it', async () => {
    const app = await editing();
    await type('DT time', '2:00');
    await idle();
    const after = await loadedAgain(app);
    Object.assign(after.timer.core.identity, { firmware: '537' });
    await press(en.program.connectAndWrite);
    expect([screen.queryByRole('dialog'), selected(after)]).toEqual([null, []]);
  });

  it('another memory that became current meanwhile is said, and M3 stays', async () => {
    const app = await editing();
    app.timer.core.memory = 1;
    await press(en.program.read);
    expect([where(app), app.timer.core.memory]).toEqual([[2, 1], 1]);
    expect(document.querySelector('.unfinished')?.textContent).toContain('M2 flies next.');
    await press('Back to M1');
    expect([where(app), app.timer.core.memory]).toEqual([[0, 0], 0]);
  });

  it('a frame by hand makes it old, and every other memory but M1, which is read', async () => {
    const app = await editing();
    await run(app.memories.readOnce(1));
    await run(ask(app).confirm());
    const { standings, standing } = app.session;
    expect([standing.value.sure, standings.next.value?.sure, where(app)]).toEqual(['once', 'now', [2, 0]]);
    expect(standings.of(1).sure).toBe('once');
    await run(app.memories.edit(2));
    expect(standing.value.sure).toBe('now');
  });

  it('a reading that fails after a frame by hand leaves M1 old', async () => {
    const app = await editing();
    const form = ask(app);
    app.timer.core.onAnswer = ({ name }) => name === 'GETTIMERS' && app.timer.core.sleep();
    await run(form.confirm());
    expect([app.session.standings.next.value, app.session.standings.of(0).sure]).toEqual([null, 'once']);
    expect([app.flights.held.value, app.session.shortDt.held.value]).toEqual([null, null]);
  });

  it('positions that were tried in M1 are decided there', async () => {
    const app = await connected();
    const before = app.editor.baseline.value;
    if (!before) throw new Error('nothing was read');
    app.timer.core.memories[0]?.positions[1]?.splice(4, 1, 77);
    await press(en.program.read);
    app.session.trials.set({ before, touched: new Set(['position:1:4']) });
    await lookAt('M3');
    await press('Edit M3');
    expect(document.querySelector('.unfinished')?.textContent).toContain('Positions were tried in M1');
    await press('Edit M1');
    expect([where(app), document.querySelector('.unfinished')?.textContent]).toEqual([
      [0, 0],
      expect.stringContaining('Tried: Function 4, S2'),
    ]);
  });

  it('positions that were tried in M3 are decided when M3 flies next: they are put back there', async () => {
    const app = await editing();
    const before = app.editor.baseline.value;
    if (!before) throw new Error('nothing was read');
    app.timer.core.memories[2]?.positions[1]?.splice(4, 1, 77);
    await press(en.program.read);
    app.session.trials.set({ before, touched: new Set(['position:1:4']) });
    await idle(0);
    expect(screen.queryByRole('button', { name: en.bench.putBack })).toBeNull();
    await run(app.write.open({ kind: 'edits', only: [{ kind: 'position', servo: 1, slot: 4 }] }));
    expect(app.write.current.value, 'nothing of M3 is written into M1').toBeNull();
    await press('Make M3 fly next');
    expect(screen.getByRole('button', { name: en.bench.putBack })).toBeTruthy();
  });

  it('what a pilot says of how the timer writes its times brings what flies next', async () => {
    const app = await editing();
    await run(app.session.timer.assume({}));
    expect([where(app), app.session.onScreen.apart.value]).toEqual([[0, 0], false]);
  });
});

describe('a job on M3 that is cut', () => {
  it('while it is written: M3 is uncertain, is opened by the band, and the write is finished there', async () => {
    const app = await editing({ plug: { granted: true } });
    await type('DT time', '2:00');
    await type('Function 4, S2', '33');
    await press('Write 2 changes…');
    app.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && app.adapter.unplug();
    await startWrite();
    app.timer.core.onAnswer = undefined;
    app.write.dismiss();
    app.adapter.replug();
    await idle();
    // It came back with M3, which is said; nothing selects a memory unasked.
    expect([app.timer.core.memory, where(app)]).toEqual([2, [2, 2]]);
    await press(/^(Make M1 fly next|Back to M1)$/);
    expect(where(app)).toEqual([0, 0]);
    await press('Edit M3');
    expect(where(app)).toEqual([2, 0]);
    await press(en.recovery.finish);
    await startWrite();
    expect([dtOf(app), app.timer.core.memories[2]?.positions[1]?.[4], app.timer.core.memory]).toEqual([
      [18_000, 21_000, 12_000],
      33,
      0,
    ]);
    expect(app.store.unfinished.records.size).toBe(0);
  });

  it('on the way back: M3 flies next, and says so', async () => {
    const app = await editing();
    await type('DT time', '2:00');
    await press('Write 1 change…');
    let isWritten = false;
    app.timer.core.onAnswer = ({ name }) => {
      isWritten ||= name === 'SETTIMERS';
      if (isWritten && name === 'GETSERVOPOS') app.timer.core.sleep();
    };
    await startWrite();
    app.timer.core.onAnswer = undefined;
    app.timer.core.press();
    await idle();
    expect([app.timer.core.memory, where(app)]).toEqual([2, [2, 2]]);
    expect(dialog().getByText(/^M3 flies next\./)).toBeTruthy();
    await press('Close');
    expect(document.querySelector('.unfinished')?.textContent).toContain('M3 flies next');
    expect(top()).not.toContain('This is M3.');
  });

  it('a write into M1 that was cut before is finished in M1, whatever is on the screen', async () => {
    const app = await connected({ plug: { granted: true } });
    await type('DT time', '5:00');
    await press('Write 1 change…');
    app.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && app.adapter.unplug();
    await startWrite();
    app.timer.core.onAnswer = undefined;
    app.write.dismiss();
    app.timer.core.memories[0]?.times.splice(10, 1, 18_000);
    app.adapter.replug();
    await idle();
    await lookAt('M3');
    await press('Edit M3');
    await run(app.session.reader.read());
    expect(where(app)).toEqual([2, 0]);
    await press(en.recovery.finish);
    expect(where(app)).toEqual([0, 0]);
    await startWrite();
    expect(dtOf(app)).toEqual([30_000, 21_000, 24_000]);
  });
});
