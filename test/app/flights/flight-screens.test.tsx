import { act, cleanup, fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it, vi } from 'vitest';
import { offsetText } from '../../../src/app/flights/flight-list.js';
import { moreMessages } from '../../../src/app/messages/more.js';
import { emptyModel } from '../../../src/app/records/library.js';
import { en } from '../../tools/en.js';
import { type AppBench, idle, reloaded } from '../bench/bench.js';
import { button, connected, drawn, field, opened, press, type } from '../screen.js';
import { PLAIN, recordOf } from './flights.js';

const form = () => within(screen.getByRole('dialog', { name: 'Flight' }));
const flights = ({ session }: AppBench) => session.library.flights.list.value.map(({ flight }) => flight);
/** What each says, with plain spaces. */
const texts = (selector: string) =>
  [...document.querySelectorAll(selector)].map(({ textContent }) => textContent.replaceAll('\u00a0', ' '));
const rows = () => texts('.flight-row');
const days = () => texts('.flight-day h2');

async function toLog(app: AppBench): Promise<void> {
  app.models.views.show('library', 'flights');
  await idle();
}

function fill(name: string, text: string): void {
  act(() => void fireEvent.input(form().getByRole('textbox', { name }), { target: { value: text } }));
}

/** The page is loaded anew. */
async function drawnAgain(app: AppBench): Promise<AppBench> {
  cleanup();
  return drawn(await reloaded(app));
}

/** A season: two days at two places. */
async function season(): Promise<AppBench> {
  const app = await opened();
  const day = (date: number, hour: number) => new Date(2026, 10, date, hour).getTime();
  const some = [
    { id: 'a', at: day(21, 9), place: 'Wiese', modelName: 'Lancer', model: 'l', result: 180, round: '1' },
    { id: 'b', at: day(21, 10), place: 'Wiese', modelName: 'Lancer', model: 'l', result: 171.5, round: '2', wind: 3.5 },
    { id: 'c', at: day(22, 9), place: 'Gyula', modelName: 'Vega', model: 'v', note: 'strong thermal\nsecond line' },
  ];
  for (const flight of some) await app.session.library.keepFlight({ ...PLAIN, ...flight });
  await toLog(app);
  return app;
}

it('what was typed last into a flight is saved when the page goes, also after a save that takes long', async () => {
  const app = await season();
  act(() => app.models.flights.fillIn('c'));
  await idle(0);
  const sent: string[] = [];
  app.store.change = ({ flights }) => {
    sent.push(...(flights?.put ?? []).map(({ flight }) => flight.note));
    return new Promise(() => {});
  };
  fill('Note', 'strong');
  await idle(0);
  fill('Note', 'strong thermal');
  dispatchEvent(new Event('pagehide'));
  await idle(0);
  dispatchEvent(new Event('pageshow'));
  expect(sent).toEqual(['strong', 'strong thermal']);
});

describe('the log', () => {
  it('shows flights by day and place, newest first, with their totals', async () => {
    await season();
    expect(days()).toEqual(['Sun, 22 Nov 2026 · Gyula 1 flight', 'Sat, 21 Nov 2026 · Wiese 2 flights']);
    expect(rows()).toEqual([
      '09:00Vegastrong thermalno result',
      '10:00LancerRound 2 · 3.5 m/s2:51.5 min',
      '09:00LancerRound 13:00 min',
    ]);
    expect(document.querySelector('.flight-totals')?.textContent).toBe('3 flightsbest 3:00 minaverage 2:55.7 min');
  });

  it('is searched from ten flights on, and shows all again', async () => {
    const app = await season();
    const search = () => screen.queryByRole('searchbox', { name: en.label.search });
    expect(search()).toBeNull();
    const more = Array.from({ length: 7 }, (_, at) =>
      recordOf({ id: `m${at}`, at: new Date(2024, 5, at + 1).getTime() }),
    );
    await app.session.library.flights.save(...more);
    await idle(0);
    act(() => void fireEvent.input(search() as Element, { target: { value: 'gyula' } }));
    expect(rows()).toEqual(['09:00Vegastrong thermalno result']);
    act(() => void fireEvent.input(search() as Element, { target: { value: 'nowhere' } }));
    expect(texts('.flight-totals')).toEqual(['0 flights']);
    await press(moreMessages.value.flights.filter.clear);
    expect(rows().length).toBe(10);
  });

  it('opens a flight, fills it in, deletes it and takes that back', async () => {
    const app = await season();
    act(() => void fireEvent.click(document.querySelector('.flight-row') as Element));
    fill('Result s', '2,58');
    await press('2.58 s');
    expect(flights(app)[0]?.result).toBe(2.58);
    fill('Result s', '2,58');
    await press('2 min 58 s');
    expect(form().getByText('2:58 min, 178 s')).toBeTruthy();
    fill('Result s', '19,5');
    expect(form().getByText('19.5 s')).toBeTruthy();
    fill('Result s', '2:58');
    expect(form().getByText('2:58 min, 178 s')).toBeTruthy();
    await press('5');
    await press('Wind: more');
    await press('Temperature: less');
    fill('Note', 'better');
    await press('Done');
    expect(screen.queryByRole('dialog')).toBeNull();
    expect(flights(app)[0]).toMatchObject({ result: 178, round: '5', wind: 2, temperature: 15, note: 'better' });
    expect(rows()[0]).toBe('09:00VegaRound 5 · 2 m/s · 15 °C · better2:58 min');
    act(() => void fireEvent.click(document.querySelector('.flight-row') as Element));
    await press('Delete');
    expect([rows().length, screen.queryByRole('dialog')]).toEqual([2, null]);
  });

  it('offers the next flight once the last one is filled in', async () => {
    const app = await connected();
    await toLog(app);
    await press('Flying this');
    button('Fill in').focus();
    await press('Fill in');
    await press('2');
    const round = form().getByRole<HTMLInputElement>('textbox', { name: 'Round' });
    expect(round.value).toBe('2');
    await press('2');
    expect(round.value, 'a press on the chosen round takes it back').toBe('');
    fill('Round', '12');
    expect(form().queryAllByRole('button', { pressed: true })).toEqual([]);
    await press('Done');
    expect([screen.queryByText(/^Flight logged/), screen.queryByRole('button', { name: 'Undo' })]).toEqual([
      null,
      null,
    ]);
    expect(document.activeElement).toBe(button('Flying this'));
    expect(flights(app).map(({ round }) => round)).toEqual(['12']);
  });

  it('keeps the clock of its field when its date is corrected, and its date when a text is none', async () => {
    const app = await season();
    const at = Date.UTC(2026, 10, 22, 22, 30);
    const utcOffset = (0 - new Date(at).getTimezoneOffset() + 480) % 840;
    await app.session.library.keepFlight({ ...PLAIN, id: 'd', at, utcOffset });
    act(() => app.models.flights.fillIn('d'));
    await idle(0);
    const date = form().getByLabelText<HTMLInputElement>(en.flights.form.date);
    const enter = async (text: string): Promise<number | undefined> => {
      date.value = text;
      fireEvent.blur(date);
      await idle(0);
      return app.session.library.flights.get('d')?.flight.at;
    };
    const shown = date.value;
    expect([await enter(''), date.value]).toEqual([at, shown]);
    expect(await enter('2026-11-21T09:30')).toBe(Date.UTC(2026, 10, 21, 9, 30) - utcOffset * 60_000);
    expect(rows().some((row) => row.includes(`09:30 ${offsetText({ utcOffset })}`))).toBe(true);
  });

  it('begins a step with what was noted before on that day', async () => {
    const app = await season();
    const at = new Date(2026, 10, 21, 11).getTime();
    await app.session.library.keepFlight({ ...PLAIN, id: 'd', at });
    act(() => app.models.flights.fillIn('d'));
    await idle(0);
    await press('Wind: less');
    await press('Result: more');
    expect(app.session.library.flights.get('d')?.flight).toMatchObject({ wind: 3.5, result: 171.5 });
    await press('Wind: less');
    await press('Result: more');
    expect(app.session.library.flights.get('d')?.flight).toMatchObject({ wind: 3, result: 172 });
  });

  it('proposes the next round of the model and the last wind of the day, until one is noted', async () => {
    const app = await season();
    const at = (hour: number) => new Date(2026, 10, 23, hour).getTime();
    const { library } = app.session;
    await library.keepFlight({ ...PLAIN, id: 'd', at: at(9), model: 'vega', round: '5', wind: 6 });
    await library.keepFlight({ ...PLAIN, id: 'e', at: at(10), model: 'lancer', round: '2' });
    const proposed = async (model: string): Promise<string | undefined> => {
      await library.keepFlight({ ...PLAIN, id: 'f', at: at(11), model });
      act(() => app.models.flights.fillIn('f'));
      await idle(0);
      return form()
        .getByRole('button', { name: /^Note / })
        .textContent?.replaceAll(/\s/g, ' ');
    };
    expect([await proposed('spare'), await proposed('lancer')]).toEqual([
      'Note Round 3 · 6 m/s',
      'Note Round 3 · 6 m/s',
    ]);
    await press(/^Note /);
    expect(library.flights.get('f')?.flight).toMatchObject({ round: '3', wind: 6 });
    expect(form().queryByRole('button', { name: /^Note / })).toBeNull();
    expect(form().queryByText(moreMessages.value.flights.form.noOffset)).not.toBeNull();
  });

  it('leads to the text that cannot be read, and Escape closes the form', async () => {
    const app = await season();
    act(() => void fireEvent.click(document.querySelector('.flight-row') as Element));
    fill('Wind m/s', 'much');
    const alert = form().getByRole('alert');
    const described = texts('dialog [aria-describedby]').length;
    expect([alert.textContent, described]).toEqual([moreMessages.value.flights.form.unreadable['not-a-number'], 1]);
    await press('Done');
    expect(document.activeElement).toBe(form().getByRole('textbox', { name: 'Wind m/s' }));
    fill('Wind m/s', '51');
    expect(form().getByRole('alert').textContent).toBe('0 to 50 m/s.');
    act(() => void screen.getByRole('dialog').dispatchEvent(new Event('cancel', { cancelable: true })));
    expect([screen.queryByRole('dialog'), flights(app)[0]?.wind]).toEqual([null, null]);
    act(() => app.models.flights.fillIn('c'));
    form().getByRole('textbox', { name: 'Wind m/s' }).focus();
    fill('Wind m/s', '3,5 m/s');
    act(() => void screen.getByRole('dialog').dispatchEvent(new Event('cancel', { cancelable: true })));
    expect(flights(app)[0]?.wind, 'what was typed last is not lost').toBe(3.5);
  });

  it('is saved as a table with what is shown', async () => {
    const app = await season();
    const saved: Blob[] = [];
    vi.stubGlobal('URL', Object.assign(URL, { createObjectURL: (blob: Blob) => String(saved.push(blob)) }));
    act(() => app.models.flights.showOnly({ of: { kind: 'model', id: 'v', name: 'Vega' } }));
    expect(screen.getByText(moreMessages.value.flights.filter.of({ name: 'Vega' }))).toBeTruthy();
    await press(moreMessages.value.flights.csv.save);
    const text = await saved[0]?.text();
    expect(saved[0]?.type).toBe('text/csv');
    expect(text?.split('\r\n').length).toBe(3);
    expect(text).toContain('2026-11-22,09:00,,"Gyula","Vega"');
  });

  it('says that it cannot be read, and never that it is empty, when the browser does not give the flights', async () => {
    const app = await opened();
    await app.session.library.keepFlight(PLAIN);
    const all = app.store.flights.all.bind(app.store.flights);
    app.store.flights.all = () => Promise.reject(new Error('no'));
    const page = await drawnAgain(app);
    await toLog(page);
    expect(screen.getByRole('alert').textContent).toContain(moreMessages.value.flights.failed);
    expect(screen.queryByText(moreMessages.value.flights.empty.title)).toBeNull();
    app.store.flights.all = all;
    await press('Try again');
    expect([rows().length, screen.queryByRole('alert')]).toEqual([1, null]);
  });

  it('says what it is for while it is empty', async () => {
    await toLog(await opened());
    expect(screen.getByText(moreMessages.value.flights.empty.title)).toBeTruthy();
    expect(screen.queryByRole('button', { name: 'Flying this' })).toBeNull();
  });
});

it('the button is back for the next flight', async () => {
  const app = await connected();
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  for (let count = 1; count <= 3; count++) {
    act(() => button('Flying this').click());
    expect(screen.queryByRole('button', { name: 'Flying this' })).toBeNull();
    act(() => void vi.advanceTimersByTime(60_000));
  }
  expect(flights(app).length).toBe(3);
});

it('one press beside the program on the screen logs a flight, and what it flew is opened again from the log', async () => {
  const app = await connected();
  await press('Flying this');
  expect(flights(app)[0]?.program.times[10]).toBe(18_000);
  await type('DT time', '20 s');
  expect(screen.queryByRole('button', { name: 'Flying this' }), 'what is typed is not in the timer').toBeNull();
  await toLog(app);
  act(() => void fireEvent.click(document.querySelector('.flight-row') as Element));
  await press(moreMessages.value.flights.form.open);
  expect([app.models.views.shown.value, screen.queryByRole('dialog')]).toEqual(['program', null]);
  expect(field('DT time').value).toBe('3:00');
  expect(app.editor.undoStep.value?.code).toBe('open');
});

describe('after a verified write', () => {
  it('one tap logs the flight; it is undone, or filled in', async () => {
    const app = await connected();
    await type('DT time', '20 s');
    await press('Write…');
    expect(screen.queryByRole('button', { name: 'Flying this' }), 'the button comes only after the write').toBeNull();
    app.session.safety.confirm();
    await idle(0);
    await press(/^Write \d+ changes?$/);
    const written = within(screen.getByRole('dialog', { name: en.write.title }));
    expect(written.getAllByText(/DT 20 s/).length, 'the figures stand once').toBe(1);
    expect(written.getByText(moreMessages.value.flights.flying.purpose)).toBeTruthy();
    button('Flying this').focus();
    await press('Flying this');
    expect(document.activeElement, 'the focus does not leave the dialog').toBe(button('Fill in'));
    const dialog = within(screen.getByRole('dialog', { name: en.write.title }));
    expect(dialog.getByText(/^Flight logged \d\d:\d\d · No model$/)).toBeTruthy();
    expect(flights(app).map(({ program }) => program.times[10])).toEqual([2000]);
    dialog.getByRole('button', { name: 'Undo' }).focus();
    dialog.getByRole('button', { name: 'Undo' }).click();
    await idle(0);
    expect(flights(app)).toEqual([]);
    expect(document.activeElement).toBe(button('Flying this'));
    await press('Flying this');
    await press('Fill in');
    expect(screen.getAllByRole('dialog').length).toBe(1);
    await press('3');
    expect(form().getByRole('alert').textContent).toContain('DT of M1 is 20\u00a0s. Put it back to 3:00\u00a0min?');
    await press('Put DT back to 3:00\u00a0min…');
    await press(/^Write \d+ changes?$/);
    expect(app.timer.core.content.times[10]).toBe(18_000);
    expect(flights(app).map(({ program, round }) => [program.times[10], round])).toEqual([[18_000, '3']]);
  });

  it('offers nothing when the timer did not take every value', async () => {
    const app = await connected();
    await type('DT time', '20 s');
    await press('Write…');
    app.session.safety.confirm();
    await idle(0);
    app.timer.core.onAnswer = ({ name }) => {
      if (name === 'SETTIMERS') app.timer.core.content.times[10] = 1900;
    };
    await press(/^Write \d+ changes?$/);
    expect(within(screen.getByRole('dialog')).queryByRole('button', { name: 'Flying this' })).toBeNull();
  });
});

it('the page of a model shows the totals of its flights, and leads to them', async () => {
  const app = await season();
  await app.session.library.keepModel(emptyModel('l', 'Lancer', 'Q'));
  app.models.views.show('library', 'l');
  await idle();
  expect(texts('.flight-totals')).toEqual(['2 flightsbest 3:00 minaverage 2:55.7 min']);
  await press(moreMessages.value.flights.section.all);
  expect(app.models.views.path.value).toBe('flights');
  expect(rows().length).toBe(2);
  expect(
    days().map((day) => day?.trim()),
    'the totals above count the flights of a single day',
  ).toEqual(['Sat, 21 Nov 2026 · Wiese']);
  expect(button('Show all')).toBeTruthy();
});
