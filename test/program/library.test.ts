import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  requireFlight,
  requireLibrary,
  requireModel,
  requireProgram,
  requireSetting,
} from '../../src/program/index.js';
import { CodecError } from '../../src/protocol/index.js';
import { FLIGHT, MODEL, SETTING } from './library-examples.js';

const codeOf = (work: () => unknown): string => {
  try {
    work();
  } catch (error) {
    return error instanceof CodecError ? `${error.code} ${error.field}` : String(error);
  }
  return 'taken';
};

const KINDS = [
  ['model', MODEL, requireModel],
  ['setting', SETTING, requireSetting],
  ['flight', FLIGHT, requireFlight],
] as const;

describe.each(KINDS)('a %s', (kind, example, require) => {
  test('is accepted as it is, without fields that do not belong to it', () => {
    expect(require(structuredClone(example))).toEqual(example);
    expect(require({ ...example, more: 1 })).toEqual(example);
  });

  test.each(Object.keys(example))('refuses another type for %s', (name) => {
    for (const wrong of [Symbol('x'), () => 0, { x: 1 }, [[]], Number.NaN]) {
      expect(codeOf(() => require({ ...example, [name]: wrong }))).toMatch(
        new RegExp(`^(?!taken).* ${kind}\\.${name}`),
      );
    }
  });

  test('is never taken for another kind, and what is accepted is what was checked', () => {
    fc.assert(
      fc.property(fc.anything({ withNullPrototype: true, maxDepth: 3 }), (value) => {
        expect(codeOf(() => require(value))).toMatch(/^[a-z-]+ /);
      }),
    );
  });
});

describe.each([
  [requireModel, MODEL, { name: '' }, 'out-of-range model.name'],
  [requireModel, MODEL, { name: 'x'.repeat(61) }, 'out-of-range model.name'],
  [requireModel, MODEL, { id: 'a b' }, 'wrong-type model.id'],
  [requireModel, MODEL, { id: '__proto__/x' }, 'wrong-type model.id'],
  [requireModel, MODEL, { timerClass: 'QQ' }, 'wrong-type model.timerClass'],
  [requireModel, MODEL, { servos: [{ ...MODEL.servos[0], duty: 'flap' }] }, 'unknown-word model.servos[0].duty'],
  [requireModel, MODEL, { servos: [{ ...MODEL.servos[0], low: 131 }] }, 'out-of-range model.servos[0].low'],
  [requireModel, MODEL, { servos: [{ ...MODEL.servos[0], low: 96 }] }, 'out-of-range model.servos[0].low'],
  [requireModel, MODEL, { servos: [{ ...MODEL.servos[0], high: 19 }] }, 'out-of-range model.servos[0].low'],
  [requireModel, MODEL, { servos: [{ ...MODEL.servos[0], high: 131 }] }, 'out-of-range model.servos[0].high'],
  [requireModel, MODEL, { servos: [{ ...MODEL.servos[0], low: 1.5 }] }, 'not-an-integer model.servos[0].low'],
  [requireModel, MODEL, { servos: [{ ...MODEL.servos[0], reversed: 1 }] }, 'wrong-type model.servos[0].reversed'],
  [requireModel, MODEL, { servos: [{ ...MODEL.servos[0], name: 1 }] }, 'wrong-type model.servos[0].name'],
  [requireModel, MODEL, { memoryNames: Array(256).fill('') }, 'wrong-count model.memoryNames'],
  [requireSetting, SETTING, { tags: Array(21).fill('x') }, 'wrong-count setting.tags'],
  [requireSetting, SETTING, { tags: [''] }, 'out-of-range setting.tags[0]'],
  [requireSetting, SETTING, { at: -1 }, 'out-of-range setting.at'],
  [requireSetting, SETTING, { at: 8.65e15 }, 'out-of-range setting.at'],
  [requireSetting, SETTING, { from: 'hearsay' }, 'unknown-word setting.from'],
  [requireFlight, FLIGHT, { wind: 51 }, 'out-of-range flight.wind'],
  [requireFlight, FLIGHT, { temperature: -51 }, 'out-of-range flight.temperature'],
  [requireFlight, FLIGHT, { result: '180' }, 'wrong-type flight.result'],
  [requireFlight, FLIGHT, { maximum: 0.5 }, 'out-of-range flight.maximum'],
  [requireFlight, FLIGHT, { maximum: 36_001 }, 'out-of-range flight.maximum'],
  [requireFlight, FLIGHT, { maximum: '180' }, 'wrong-type flight.maximum'],
  [requireFlight, FLIGHT, { counts: 1 }, 'wrong-type flight.counts'],
  [requireFlight, FLIGHT, { utcOffset: 841 }, 'out-of-range flight.utcOffset'],
  [requireFlight, FLIGHT, { utcOffset: -841 }, 'out-of-range flight.utcOffset'],
  [requireFlight, FLIGHT, { utcOffset: 60.5 }, 'not-an-integer flight.utcOffset'],
  [requireFlight, FLIGHT, { utcOffset: '+01:00' }, 'not-an-integer flight.utcOffset'],
] as const)('%o', (require, example, change, refused) => {
  test(`with ${JSON.stringify(change).slice(0, 60)} is refused: ${refused}`, () => {
    expect(codeOf(() => (require as (value: unknown) => unknown)({ ...example, ...change }))).toBe(refused);
  });
});

test('an empty field may be missing', () => {
  const { timerClass, ...model } = MODEL;
  expect(requireModel(model)).toEqual({ ...MODEL, timerClass: null });
  const { wind, temperature, result, ...flight } = FLIGHT;
  expect(requireFlight(flight)).toEqual({ ...FLIGHT, wind: null, temperature: null, result: null });
  for (const nothing of [null, undefined]) {
    expect(requireSetting({ ...SETTING, model: nothing })).toEqual({ ...SETTING, model: null });
    const alone = requireFlight({ ...FLIGHT, model: nothing, setting: nothing });
    expect(alone).toEqual({ ...FLIGHT, model: null, setting: null });
    expect(Object.keys(requireFlight({ ...FLIGHT, maximum: nothing, counts: nothing }))).toEqual(Object.keys(FLIGHT));
    const program = { ...SETTING.program, memory: nothing, idleThrottle: nothing };
    expect(requireProgram(program)).toEqual({ ...SETTING.program, memory: null, idleThrottle: null });
  }
});

test.each([
  [5, 'wrong-type library'],
  [{ models: 5, settings: [], flights: [] }, 'wrong-type models'],
  [{ models: [], settings: 5, flights: [] }, 'wrong-type settings'],
  [{ models: [], settings: [], flights: 5 }, 'wrong-type flights'],
  [{ models: [], settings: [], flights: [{ ...FLIGHT, id: '' }] }, 'wrong-type flights[0].id'],
])('a library that is %j is refused: %s', (library, refused) => {
  expect(codeOf(() => requireLibrary(library))).toBe(refused);
});

const { program } = SETTING;
test.each([
  [{ memory: 4 }, 'out-of-range program.memory'],
  [{ times: program.times.slice(1) }, 'wrong-count program.times'],
  [{ times: program.times.map(() => 65_536) }, 'out-of-range program.times[0]'],
  [{ times: program.times.map(() => -1) }, 'out-of-range program.times[0]'],
  [{ times: program.times.map(() => 0.5) }, 'not-an-integer program.times[0]'],
  [{ positions: program.positions.slice(1) }, 'wrong-count program.positions'],
  [{ positions: 5 }, 'wrong-type program.positions'],
  [{ positions: program.positions.map((row) => row.map(() => 256)) }, 'out-of-range program.positions[0][0]'],
  [{ idleThrottle: 256 }, 'out-of-range program.idleThrottle'],
  [{ identity: { ...program.identity, functions: 0 } }, 'bad-identity program.identity.functions'],
  [{ identity: { ...program.identity, firmware: '5/6' } }, 'bad-identity program.identity.firmware'],
  [{ identity: { ...program.identity, firmware: 536 } }, 'wrong-type program.identity.firmware'],
  // What has no words for itself, and breaks whatever wants to show it.
  [{ identity: { ...program.identity, servos: Object.create(null) } }, 'wrong-type program.identity.servos'],
  [{ identity: { ...program.identity, servos: 255 } }, 'bad-identity program.identity.servos'],
])('a program with %j is refused: %s', (change, refused) => {
  expect(codeOf(() => requireProgram({ ...program, ...change }))).toBe(refused);
});
