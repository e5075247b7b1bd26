import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { en } from '../../tools/en.js';
import { type AppBench, appBench, idle, reloaded, run } from '../bench/bench.js';
import { button, connected, goTo, late, loadedAgain, press, strandAtM3, type } from '../screen.js';

const dialog = () => within(screen.getByRole('dialog', { name: en.nextFlight.leaving.title }));
const status = ({ session }: AppBench) => session.link.state.value.status;
const buttons = () =>
  dialog()
    .getAllByRole('button')
    .map(({ textContent }) => textContent);

/** Types a DT and writes it, with the difference shown and the safety ticked. */
async function writeDt(app: AppBench, text: string): Promise<void> {
  await type('DT time', text);
  await press('Write…');
  await finish(app);
  await press('Close');
}

async function finish(app: AppBench): Promise<void> {
  app.session.safety.confirm();
  await idle(0);
  await press(/^Write \d+ changes?$/);
  expect(screen.getByText('Verified.')).toBeTruthy();
}

describe('with a short DT in the timer', () => {
  it('Disconnect asks once, puts it back by a normal write, and then disconnects', async () => {
    const app = await connected();
    await writeDt(app, '2:45');
    await writeDt(app, '20 s');
    const dt = () => app.timer.core.content.times[10];
    await press('Disconnect');
    expect([status(app), dialog().getByRole('status').textContent]).toEqual([
      'on',
      'DT of M1 is 20\u00a0s. Put it back to 2:45\u00a0min?',
    ]);
    expect(buttons()).toEqual(['Cancel', 'Disconnect with DT\u00a020\u00a0s', 'Put DT back to 2:45\u00a0min…']);
    await press('Put DT back to 2:45\u00a0min…');
    expect(dt(), 'nothing is written before the pilot confirms the write').toBe(2000);
    expect(screen.getByRole('dialog', { name: en.write.title }).textContent).toContain('2:45 min');
    await finish(app);
    expect([dt(), status(app)]).toEqual([16_500, 'on']);
    within(screen.getByRole('dialog')).getByRole('button', { name: 'Disconnect' }).click();
    await idle();
    expect([status(app), screen.queryByRole('dialog')]).toEqual(['off', null]);
  });

  it('puts DT back alone: what else was changed goes on waiting', async () => {
    const app = await connected();
    await writeDt(app, '2:45');
    await writeDt(app, '20 s');
    await type('Function 4, S2', '70');
    await press('Disconnect');
    await press('Put DT back to 2:45\u00a0min…');
    app.session.safety.confirm();
    await idle(0);
    await press('Write 1 change');
    const { times, positions } = app.timer.core.content;
    expect([times[10], positions[1]?.[4], app.editor.changes.value.length]).toEqual([16_500, 55, 1]);
  });

  it('is remembered for each memory, through a reload', async () => {
    const first = await connected();
    await writeDt(first, '4:00');
    await writeDt(first, '20 s');
    const app = await loadedAgain(first);
    await run(app.session.timer.connect());
    await press('Disconnect');
    expect(buttons()).toContain('Put DT back to 4:00\u00a0min…');
    app.models.preferences.setShortDt(30_000);
    expect(
      app.session.shortDt.held.value?.back,
      '4:00 min is short by the new limit, so the limit itself is offered',
    ).toBe(30_000);
  });

  it('is put back to the DT of a round of the class when no long one was seen', async () => {
    for (const [timerClass, back] of [
      ['Q', 18_000],
      ['B', 18_000],
      ['E', 30_000],
    ] as const) {
      localStorage.clear();
      const { session, timer, preferences } = await appBench({ identity: { timerClass } });
      for (const memory of timer.core.memories) memory.times[10] = 1500;
      await run(session.timer.connect());
      expect(session.shortDt.held.value).toEqual({ memory: 0, dt: 1500, back, remembered: false });
      preferences.setShortDt(36_000);
      expect(
        session.shortDt.held.value?.back,
        'a round of the class is short by the new limit, so the limit itself is offered',
      ).toBe(36_000);
    }
  });

  it('asks in one dialog about another memory too, and about the first one when it is back', async () => {
    const app = await connected();
    const [first, , third] = app.timer.core.memories;
    await writeDt(app, '20 s');
    if (third) third.times[10] = 1000;
    await strandAtM3(app);
    await press('Disconnect');
    expect(screen.getAllByRole('dialog').length).toBe(1);
    expect(dialog().getByRole('status').textContent).toBe(
      'M3 flies next. When you connected it was M1.DT of M3 is 10\u00a0s. Set it to 3:00\u00a0min?',
    );
    expect(buttons()).toEqual([
      'Cancel',
      'Disconnect with M3, DT\u00a010\u00a0s',
      'Set DT to 3:00\u00a0min…',
      'Back to M1 and disconnect',
    ]);
    screen.getByRole('dialog').dispatchEvent(new Event('cancel', { cancelable: true }));
    await idle();
    expect(status(app), 'Escape does not disconnect').toBe('on');
    await press('Disconnect');
    await press('Back to M1 and disconnect');
    expect([status(app), dialog().getByRole('status').textContent]).toEqual([
      'on',
      'DT of M1 is 20\u00a0s. Put it back to 3:00\u00a0min?',
    ]);
    expect(dialog().queryByRole('alert'), 'going back worked, so there is no warning').toBeNull();
    await press('Disconnect with DT\u00a020\u00a0s');
    expect([status(app), first?.times[10]]).toEqual(['off', 2000]);
  });

  it('says nothing about a DT that is only typed', async () => {
    const app = await connected();
    await type('DT time', '20 s');
    expect(app.session.shortDt.held.value, 'the timer does not hold the typed DT').toBeNull();
    await press('Disconnect');
    expect(status(app)).toBe('off');
  });

  it('says nothing while it is not known how this timer writes its times', async () => {
    const { session, timer } = await appBench({ quirks: { bigEndianTimes: true } });
    for (const memory of timer.core.memories) memory.times[10] = 0x1700;
    await run(session.timer.connect());
    expect([session.reader.byteOrderOpen.value, session.shortDt.held.value]).toEqual([true, null]);
    await run(session.timer.assume({ bigEndianTimes: true }));
    expect([session.reader.byteOrderOpen.value, session.shortDt.held.value?.dt]).toEqual([false, 0x1700]);
  });

  it('cannot be put back while something blocks the write, and says so', async () => {
    const app = await connected();
    await writeDt(app, '20 s');
    await type('Function 2, S1', 'abc');
    await press('Disconnect');
    expect(dialog().getByText(/cannot be written yet/)).toBeTruthy();
    expect(button('Put DT back to 3:00\u00a0min…').disabled).toBe(true);
    await press('Disconnect with DT\u00a020\u00a0s');
    expect(status(app)).toBe('off');
  });

  it('does not delay anybody while bytes are written', async () => {
    const app = await connected();
    await writeDt(app, '20 s');
    await type('DT time', '3:00');
    await press('Write…');
    app.session.safety.confirm();
    await idle(0);
    let asked: unknown = 'not tried';
    app.timer.core.onAnswer = ({ name }) => {
      if (name !== 'SETTIMERS') return;
      void app.models.leaving.disconnect();
      asked = app.models.leaving.question.value;
    };
    await press(/^Write \d+ changes?$/);
    expect([asked, status(app)]).toEqual([null, 'off']);
  });
});

it('the limit of a short DT is the same for the strip and the question, set in the settings and kept', async () => {
  const app = await connected();
  const figure = () => document.querySelector('.strip-figure')?.className;
  await goTo('Settings'.toLowerCase() as 'settings');
  const limit = () => screen.getByRole<HTMLInputElement>('textbox', { name: /^A DT is short below/ });
  const say = async (text: string): Promise<void> => {
    fireEvent.change(limit(), { target: { value: text } });
    await late();
  };
  expect([limit().value, figure()]).toEqual(['1:00 min', 'strip-figure ']);
  await say('3:30');
  expect([limit().value, figure(), app.session.shortDt.held.value?.dt]).toEqual([
    '3:30 min',
    'strip-figure bad',
    18_000,
  ]);
  await say('never');
  expect(screen.getByRole('alert').textContent).toBe(en.edits.presets.refused);
  expect(limit().value, 'the text in the field stays').toBe('never');
  await say('0');
  expect([screen.queryByRole('alert'), figure()]).toEqual([null, 'strip-figure ']);
  const again = await reloaded(app);
  expect(again.models.preferences.shortDt.value).toBe(0);
});
