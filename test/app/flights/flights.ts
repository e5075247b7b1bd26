import fc from 'fast-check';
import type { FlightRecord } from '../../../src/app/storage/index.js';
import { type Flight, LIMITS, requireFlight } from '../../../src/program/index.js';
import { programOf } from '../programs.js';

/** A flight with nothing noted. */
export const PLAIN: Flight = {
  id: 'plain',
  at: new Date(2026, 10, 22, 14, 5).getTime(),
  place: '',
  model: null,
  modelName: '',
  setting: null,
  settingName: '',
  program: programOf('Q', [1000, 30, 100, 300, 18_000]),
  wind: null,
  temperature: null,
  round: '',
  result: null,
  note: '',
};

export function recordOf(flight: Partial<Flight>): FlightRecord {
  const whole = requireFlight({ ...PLAIN, ...flight });
  return { key: whole.id, flight: whole, changedAt: 0 };
}

const PLACES = ['', 'Wiese', 'Gyula', 'Mostar'];
const nasty = fc.stringMatching(/^[=+\-@'"\t\r\n;, aé]{0,8}$/);
const text = (longest: number) =>
  fc.oneof(nasty, fc.string({ maxLength: longest, unit: 'grapheme' })).map((each) => each.slice(0, longest));

/** Any flight: with texts that bite, of a few places and models. */
export const anyFlight: fc.Arbitrary<Flight> = fc
  .record({
    id: fc.uuid(),
    at: fc.integer({ min: new Date(2026, 0, 1).getTime(), max: new Date(2026, 0, 20).getTime() }),
    place: fc.oneof(fc.constantFrom(...PLACES), text(LIMITS.place)),
    model: fc.constantFrom(null, 'lancer', 'vega'),
    modelName: text(LIMITS.name),
    setting: fc.constantFrom(null, 'calm', 'windy'),
    settingName: text(LIMITS.name),
    wind: fc.option(fc.integer({ min: 0, max: 500 }).map((tenths) => tenths / 10)),
    temperature: fc.option(fc.integer({ min: -500, max: 600 }).map((tenths) => tenths / 10)),
    round: fc.oneof(fc.constantFrom('', '1', '5', 'fly-off'), text(LIMITS.round)),
    result: fc.option(fc.integer({ min: 0, max: 60_000 }).map((hundredths) => hundredths / 100)),
    note: text(100),
  })
  .map((flight) => requireFlight({ ...PLAIN, ...flight }));

export const anyLog: fc.Arbitrary<FlightRecord[]> = fc
  .uniqueArray(anyFlight, { selector: ({ id }) => id, maxLength: 40 })
  .map((flights) => flights.sort((a, b) => b.at - a.at).map(recordOf));
