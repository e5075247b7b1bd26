// Models, settings and flights as pilots may keep them, with all that their values may be.

import fc from 'fast-check';
import { identity, upTo } from './messages.js';

/**
 * @typedef {import('../../src/program/index.js').Flight} Flight
 * @typedef {import('../../src/program/index.js').Library} Library
 * @typedef {import('../../src/program/index.js').Model} Model
 * @typedef {import('../../src/program/index.js').Setting} Setting
 * @typedef {import('../../src/program/index.js').SharedSetting} SharedSetting
 * @typedef {import('../../src/program/index.js').TimerProgram} TimerProgram
 */

/** @template T @param {fc.Arbitrary<T>} of @param {number} count */
const many = (of, count) => fc.array(of, { minLength: count, maxLength: count });

/** @template T @param {fc.Arbitrary<T>} of */
const orNull = (of) => fc.oneof({ weight: 3, arbitrary: of }, fc.constant(null));

/** Any program that a timer can hold. @type {fc.Arbitrary<TimerProgram>} */
export const program = identity.chain((of) =>
  fc.record({
    identity: fc.constant(of),
    memory: orNull(upTo(of.memories - 1)),
    times: many(upTo(0xffff), of.functions + 1),
    positions: many(many(upTo(255), of.functions + 1), of.servos),
    idleThrottle: orNull(upTo(255)),
  }),
);

/**
 * What a person writes, what a joker writes, and what no keyboard can.
 * @param {number} maxLength @param {number} min
 */
export const words = (maxLength, min = 0) =>
  fc.oneof(
    { weight: 4, arbitrary: fc.string({ minLength: min, maxLength }) },
    { weight: 2, arbitrary: fc.string({ unit: 'binary', minLength: min, maxLength }) },
    // Each half of a pair of UTF-16 is two “characters” of its own until the other half follows.
    {
      weight: 1,
      arbitrary: fc
        .array(fc.integer({ min: 0, max: 0xffff }), { minLength: min, maxLength })
        .map((codes) => String.fromCharCode(...codes)),
    },
    {
      weight: 1,
      arbitrary: fc
        .constantFrom('__proto__', 'constructor', '\u2028"\\\u0000', '🛩️ ½ Flügel', '\ufeff', '{"a":1}', '…')
        .map((text) => text.slice(0, maxLength)),
    },
  );

const id = fc.oneof(
  { weight: 4, arbitrary: fc.stringMatching(/^[A-Za-z0-9_-]{1,64}$/) },
  fc.constantFrom('__proto__', 'constructor', 'a', '-', '0'),
);

const date = fc.oneof(
  { weight: 4, arbitrary: fc.integer({ min: 0, max: 4_000_000_000_000 }) },
  fc.constantFrom(0, 1, 253_402_300_799_999, 253_402_300_800_000, 8.64e15),
);

/** @param {number} min @param {number} max */
const measured = (min, max) =>
  orNull(fc.oneof(fc.integer({ min, max }), fc.double({ min, max, noNaN: true })).map((value) => value + 0));

const step = upTo(130);

/** @type {fc.Arbitrary<Model>} */
export const model = fc.record({
  id,
  name: words(60, 1),
  timerClass: orNull(fc.constantFrom('B', 'Q', 'E', '"', '\\', '~')),
  note: words(200),
  servos: fc.array(
    fc
      .record({
        duty: fc.constantFrom('rudder', 'tailplane', 'wing', 'release', 'other', 'none'),
        name: words(16),
        low: step,
        high: step,
        reversed: fc.boolean(),
      })
      .map((use) => ({ ...use, low: Math.min(use.low, use.high), high: Math.max(use.low, use.high) })),
    { maxLength: 4 },
  ),
  memoryNames: fc.array(words(60), { maxLength: 5 }),
  archived: fc.boolean(),
});

const tags = fc.array(words(30, 1), { maxLength: 4 });
const source = fc.constantFrom('typed', 'timer', 'simulated', 'backup', 'file', 'link');

/** @type {fc.Arbitrary<Setting>} */
export const setting = fc.record({
  id,
  model: orNull(id),
  name: words(60, 1),
  note: words(300),
  tags,
  at: date,
  program,
  from: source,
  archived: fc.boolean(),
});

/** @type {fc.Arbitrary<Flight>} */
export const flight = fc.record({
  id,
  at: date,
  place: words(100),
  model: orNull(id),
  modelName: words(60),
  setting: orNull(id),
  settingName: words(60),
  program,
  wind: measured(0, 50),
  temperature: measured(-50, 60),
  round: words(30),
  result: measured(0, 36_000),
  note: words(200),
});

/** @template {{ id: string }} T @param {fc.Arbitrary<T>} of */
const several = (of) => fc.uniqueArray(of, { maxLength: 2, selector: (each) => each.id });

/** @type {fc.Arbitrary<Library>} */
export const library = fc.record({ models: several(model), settings: several(setting), flights: several(flight) });

/** A link carries whole characters alone. @param {string} text */
const whole = (text) => Buffer.from(text).toString();

/** What a link carries. @type {fc.Arbitrary<SharedSetting>} */
export const shared = fc.record({
  name: words(60, 1).map(whole),
  note: words(300).map(whole),
  tags: tags.map((each) => each.map(whole)),
  at: date,
  program,
  modelName: words(60).map(whole),
});
