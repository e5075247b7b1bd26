import { act } from '@testing-library/preact';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { parseInterval, parseTime, readTime } from '../../../src/app/editing/units.js';
import { csvColumns, flightsCsv, marksOf } from '../../../src/app/flights/flights-csv.js';
import { measureText, readMeasure } from '../../../src/app/flights/measures.js';
import { scoreOf } from '../../../src/app/flights/score.js';
import { scoreText } from '../../../src/app/flights/score-text.js';
import { LANGUAGES } from '../../../src/app/messages/first.js';
import { dtText, figureText, messages, presetText, spokenTime } from '../../../src/app/messages/index.js';
import { language, speak } from '../../../src/app/messages/language.js';
import { moreMessages } from '../../../src/app/messages/more.js';
import { programOf as programNamed } from '../../../src/app/messages/names.js';
import { emptyModel } from '../../../src/app/records/library.js';
import { appBench, run } from '../bench/bench.js';
import { readCsv } from '../flights/csv-reader.js';
import { PLAIN } from '../flights/flights.js';

/** In hundredths of a second: without and with decimals, at and over a minute. */
const TIMES = [0, 7, 50, 960, 1250, 5999, 6000, 17_850, 18_000, 65_535];
const { identity } = PLAIN.program;

describe.each(LANGUAGES)('in %s', (spoken) => {
  beforeEach(() => act(() => speak(spoken)));
  afterEach(() => act(() => speak('en')));

  it('a comma and a point are read alike, and asked about alike', () => {
    for (const form of ['12,5', '12.5', ' 12,50 ', '12.50']) {
      expect([form, parseTime(form), parseInterval(form)]).toEqual([form, { value: 1250 }, { value: 1250 }]);
    }
    for (const form of ['2,58', '2.58'])
      expect([form, readTime(form, { isDt: true })]).toMatchObject([form, { either: [17_800, 258] }]);
    for (const form of ['3,5', '3.5', `${measureText(3.5)} ${moreMessages.value.flights.form.windUnit}`])
      expect([form, readMeasure('wind', form)]).toEqual([form, { value: 3.5 }]);
    for (const form of ['-2,5', '-2.5', `${measureText(-2.5)} ${moreMessages.value.flights.form.temperatureUnit}`])
      expect([form, readMeasure('temperature', form)]).toEqual([form, { value: -2.5 }]);
  });

  it('what the page writes is read back, with its units', () => {
    const decimal = new Intl.NumberFormat(spoken).format(0.5).charAt(1);
    expect(figureText(identity, { kind: 'time', slot: 1 }, 1250)).toContain(`12${decimal}5`);
    for (const time of TIMES) {
      const texts = [spokenTime(time), presetText(time), dtText(time)];
      for (let slot = 0; slot <= identity.functions; slot++)
        texts.push(figureText(identity, { kind: 'time', slot }, time));
      for (const text of texts) expect([text, parseTime(text)]).toEqual([text, { value: time }]);
    }
  });

  it('flights go into a table and a score card with the marks of that language', () => {
    const flight = { ...PLAIN, round: '2.5', wind: 3.5, result: 170.5 };
    const { separator, decimal } = marksOf();
    expect(decimal).toBe(spoken === 'en' ? '.' : ',');
    const [heads = [], cells = []] = readCsv(flightsCsv([flight], marksOf()).slice(1), separator);
    const { csv, score } = moreMessages.value.flights;
    expect(heads).toEqual(csvColumns().map((column) => csv.columns[column]));
    expect(new Set(heads).size, 'no two columns have one name').toBe(heads.length);
    expect(cells[csvColumns().indexOf('wind')]).toBe(`3${decimal}5`);
    const [total, ...others] = scoreText(scoreOf([flight]))
      .split('\n')
      .reverse();
    expect(total).toBe(`${score.total}\t\t\t170${decimal}5`);
    expect(others[0], 'a name is no number').toBe(`2.5\t170${decimal}5\t\t170${decimal}5`);
  });

  it('a name from right to left keeps its order', () => {
    const name = 'שחף 07 B';
    expect(messages.value.about({ name })).toContain(`\u2068${name}\u2069`);
    expect(programNamed(name, name).split(`\u2068${name}\u2069`).length).toBe(3);
  });
});

it('names of models stand as the language of the page sorts them, also when it changes', async () => {
  const { session } = await appBench();
  await run(session.library.load());
  for (const name of ['Luk', 'Łoś', 'Macek', 'Lz', 'Čáp', 'Cz', 'Chrt', 'Ibis', 'Model 10', 'Model 9'])
    await session.library.keepModel(emptyModel(name, name, null));
  const named = () => session.library.models.list.value.map(({ model }) => model.name);
  const inLanguage = async (code: string) => {
    await act(() => speak(code));
    expect(language.value).toBe(code);
    return named().join(' ');
  };
  try {
    expect(await inLanguage('en')).toBe('Čáp Chrt Cz Ibis Łoś Luk Lz Macek Model 9 Model 10');
    // Č is a letter of its own, after C, and Ch stands after H.
    expect(await inLanguage('cs')).toBe('Cz Čáp Chrt Ibis Łoś Luk Lz Macek Model 9 Model 10');
    expect(await inLanguage('pl')).toBe('Čáp Chrt Cz Ibis Luk Lz Łoś Macek Model 9 Model 10');
  } finally {
    await act(() => speak('en'));
  }
});
