import { act, fireEvent, screen } from '@testing-library/preact';
import { describe, expect, it, vi } from 'vitest';
import type { Flight } from '../../../src/program/index.js';
import { en } from '../../tools/en.js';
import { type AppBench, idle } from '../bench/bench.js';
import { button, opened, press } from '../screen.js';
import { PLAIN } from './flights.js';

const { score: words, form } = en.flights;
const dayOne = new Date(2026, 10, 21, 9).getTime();
const flightsIn = ({ session }: AppBench): readonly Flight[] =>
  session.library.flights.list.value.map(({ flight }) => flight).reverse();
const maxima = (app: AppBench) => flightsIn(app).map(({ maximum = null }) => maximum);
const rows = () =>
  [...document.querySelectorAll('.score-card tbody tr')].map((row) =>
    [...row.children].map(
      (cell) => cell.querySelector('input')?.value || cell.textContent.replaceAll('\u00a0', ' ').trim(),
    ),
  );
const total = () => rows().find(([name]) => name === words.total)?.[1];
const field = (name: string) => screen.getByRole<HTMLInputElement>('textbox', { name });

function enter(name: string, text: string): void {
  act(() => void fireEvent.input(field(name), { target: { value: text } }));
  act(() => void fireEvent.blur(field(name)));
}

/** A contest day with a second flight in round 2, and another day. */
async function contest(): Promise<AppBench> {
  const app = await opened();
  const given: Partial<Flight>[] = [
    { round: '1', result: 251 },
    { round: '2', result: 150 },
    { round: '2', result: 175.5 },
    { round: '3' },
    { round: 'fly-off', result: 320 },
    { result: 20 },
  ];
  for (const [at, flight] of given.entries()) {
    const noted = { place: 'Wiese', modelName: 'Lancer', ...flight };
    await app.session.library.keepFlight({ ...PLAIN, id: `f${at}`, at: dayOne + at * 3_600_000, ...noted });
  }
  await app.session.library.keepFlight({ ...PLAIN, id: 'z', place: 'Gyula' });
  app.models.views.show('library', 'flights');
  await idle();
  return app;
}

describe('the score card', () => {
  it('shows one day alone, with what counts and what does not, and closes again', async () => {
    await contest();
    expect(document.querySelectorAll('.flight-day').length).toBe(2);
    await press(words.open);
    expect(document.querySelectorAll('.flight-day').length).toBe(1);
    expect(rows()).toEqual([
      ['1', '251', '', '251'],
      ['2 10:00', '150', '', `${words.notCounted}${words.count}`],
      ['2 11:00', '175.5', '', '175.5'],
      ['3', '', '', en.flights.row.noResult],
      [words.total, '7:06.5 min 426.5'],
      ['Fly-off', '320', '', '320'],
      [words.noRound, '20', '', words.notCounted],
    ]);
    expect(screen.getByText(words.none)).toBeTruthy();
    await press(words.open);
    expect([document.querySelectorAll('.flight-day').length, rows()]).toEqual([2, []]);
  });

  it('stands only where a round was noted', async () => {
    await contest();
    expect(screen.getAllByRole('button', { name: words.open }).length).toBe(1);
  });

  it('takes a maximum for the day and another one for a round, as a result is typed', async () => {
    const app = await contest();
    await press(words.open);
    enter(words.maximum, "3'00");
    await idle(0);
    expect(maxima(app)).toEqual([180, 180, 180, 180, null, null, null]);
    expect([field(words.maximum).value, total()]).toEqual(['180', '5:55.5 min 355.5']);
    expect(screen.queryByText(words.none)).toBeNull();
    enter(words.maximumOf({ round: 'Round 1' }), '4 min');
    enter(words.maximumOf({ round: 'Fly-off' }), '300');
    await idle(0);
    expect(maxima(app)).toEqual([240, 180, 180, 180, 300, null, null]);
    expect([field(words.maximum).value, total()]).toEqual(['180', '6:55.5 min 415.5']);
    enter(words.maximum, '2:00');
    await idle(0);
    expect(maxima(app), 'a round with another maximum keeps it').toEqual([240, 120, 120, 120, 300, null, null]);
    enter(words.maximumOf({ round: 'Round 1' }), '');
    await idle(0);
    expect(field(words.maximumOf({ round: 'Round 1' })).placeholder, 'it has that of the day again').toBe('120');
    expect(Object.keys(flightsIn(app)[0] ?? {})).not.toContain('maximum');
  });

  it('asks what 2.58 means, says why a text is none, and takes what stands in it when the page is hidden', async () => {
    const app = await contest();
    await press(words.open);
    const name = words.maximumOf({ round: 'Round 3' });
    enter(name, '2.58');
    expect(maxima(app)[3]).toBeNull();
    await press('2 min 58 s');
    expect(maxima(app)[3]).toBe(178);
    enter(name, 'much');
    expect([screen.getByRole('alert').textContent, field(name).value]).toEqual([form.unreadable['not-a-time'], 'much']);
    enter(name, '0');
    expect(screen.getByRole('alert').textContent).toBe(form.range({ min: 1, max: 36_000, unit: 's' }));
    act(() => void fireEvent.input(field(name), { target: { value: '200' } }));
    expect(maxima(app)[3], 'the field has not been left').toBe(178);
    act(() => void dispatchEvent(new Event('pagehide')));
    expect(maxima(app)[3]).toBe(200);
    act(() => void fireEvent.input(field(name), { target: { value: '210' } }));
    act(() => void fireEvent.keyDown(field(name), { key: 'Enter' }));
    expect(maxima(app)[3]).toBe(210);
  });

  it('counts another flight of a round when the pilot says so, and keeps the focus', async () => {
    const app = await contest();
    await press(words.open);
    button(words.count).focus();
    await press(words.count);
    expect(total()).toBe('6:41 min 401');
    expect(flightsIn(app).map(({ counts }) => counts)).toEqual([undefined, true, ...Array(5).fill(undefined)]);
    expect(document.activeElement).not.toBe(document.body);
    await press(words.count);
    expect(flightsIn(app).map(({ counts }) => counts)).toEqual([
      undefined,
      undefined,
      true,
      ...Array(4).fill(undefined),
    ]);
    expect(total()).toBe('7:06.5 min 426.5');
  });

  it('is of one model where its flights are shown, never of one program alone, and survives its last round', async () => {
    const app = await contest();
    act(() => app.models.flights.showOnly({ of: { kind: 'setting', id: 's', name: 'calm' } }));
    await app.session.library.keepFlight({ ...PLAIN, id: 's', at: dayOne, place: 'Wiese', round: '5', setting: 's' });
    await idle(0);
    await press(words.open);
    expect(rows().length).toBe(8);
    await press(words.open);
    act(() => app.models.flights.showOnly({ of: { kind: 'model', id: 'm', name: 'Vega' } }));
    await app.session.library.keepFlight({ ...PLAIN, id: 'm', at: dayOne, place: 'Mostar', round: '5', model: 'm' });
    await idle(0);
    await press(words.open);
    expect(rows().map(([round]) => round)).toEqual(['5', words.total]);
    await app.session.library.keepFlight({ ...PLAIN, id: 'm', at: dayOne, place: 'Mostar', model: 'm' });
    await idle(0);
    await press(words.copy);
    await press(words.open);
    expect(rows()).toEqual([]);
  });

  it('is copied as text', async () => {
    await contest();
    await press(words.open);
    const copied: string[] = [];
    const clipboard = { writeText: async (text: string) => void copied.push(text) };
    vi.stubGlobal('navigator', { languages: ['en-GB'], clipboard });
    await press(words.copy);
    vi.unstubAllGlobals();
    expect(copied[0]?.split('\n').slice(0, 4)).toEqual(['Sat, 21 Nov 2026', 'Wiese', 'Lancer', '']);
  });
});
