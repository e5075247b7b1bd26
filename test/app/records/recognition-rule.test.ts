import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { newProgram } from '../../../src/app/editing/new-program.js';
import { type ModelHeld, recognise } from '../../../src/app/records/recognition-rule.js';
import {
  differences,
  fieldsOf,
  type ProgramField,
  type TimerProgram,
  valueAt,
  withValue,
} from '../../../src/program/index.js';
import { MODEL } from '../../program/library-examples.js';

const DT: ProgramField = { kind: 'time', slot: 10 };
const STOP: ProgramField = { kind: 'time', slot: 0 };
const IDENTITY = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };
const TEMPLATES = (['usual', 'nothing'] as const).map((from) =>
  newProgram({ timerClass: 'Q', functions: 10, servos: 3, from }),
);
/** What somebody has trimmed: all but DT, motor stop and idle throttle. */
const TRIMS = fieldsOf(IDENTITY).filter(
  (field) => field.kind === 'position' || (field.kind === 'time' && field.slot > 0 && field.slot < 10),
);

/** Numbers that come again: a model is made of its number. */
function* numbers(seed: number): Generator<number, never> {
  for (let state = seed * 2654435761 + 1; ; ) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    yield state / 2 ** 32;
  }
}

/** What a pilot may have trimmed: rising times, positions that wander. */
function trimmed(seed: number, memory: number | null = 0): TimerProgram {
  const random = numbers(seed);
  const next = (from: number, to: number): number => from + Math.floor(random.next().value * (to - from + 1));
  const times = [next(30, 200) * 5];
  for (let slot = 1, time = 0; slot < 10; slot++) {
    time += next(2, 60) * 5;
    times.push(time);
  }
  times.push(next(2, 6) * 6000);
  const positions = Array.from({ length: 3 }, () => {
    const middle = next(40, 90);
    return Array.from({ length: 11 }, () => middle + next(-20, 20));
  });
  return { identity: IDENTITY, memory, times, positions, idleThrottle: null };
}

/** The same with other values in some of these fields. */
function differing(program: TimerProgram, fields: readonly ProgramField[], by = 1): TimerProgram {
  return fields.reduce((edited, field) => withValue(edited, field, (valueAt(program, field) ?? 0) + by), program);
}

function held(key: string, ...programs: readonly TimerProgram[]): ModelHeld {
  return { model: { ...MODEL, id: key }, verified: programs.map((program, at) => ({ program, at: 1000 + at })) };
}

/** Four memories of one model: each is the first one with other days' values, and a trim or two. */
function season(seed: number): TimerProgram[] {
  const calm = trimmed(seed);
  return [0, 1, 2, 3].map((memory) => ({
    ...differing(calm, memory === 0 ? [] : [DT, STOP, ...TRIMS.slice(memory, memory + 2)], memory * 7),
    memory,
  }));
}

const KNOWN = Array.from({ length: 300 }, (_, seed) => held(`model-${seed}`, ...season(seed)));

/** Who was named, and how. */
function found(read: readonly TimerProgram[], models: readonly ModelHeld[]) {
  const result = recognise(read, models, TEMPLATES);
  return 'model' in result
    ? { kind: result.kind, keys: [result.model.id], differs: result.of.differs }
    : { kind: result.kind, keys: result.candidates.map(({ model }) => model.id) };
}

describe('among 300 models', () => {
  it('names the right one by any memory', () => {
    for (const [seed, { model }] of KNOWN.entries()) {
      for (const program of season(seed))
        expect(found([program], KNOWN)).toEqual({ kind: 'same', keys: [model.id], differs: 0 });
    }
  });

  it('names the right one with some values changed, and counts them', () => {
    const changes = fc.uniqueArray(fc.constantFrom(...fieldsOf(IDENTITY).slice(0, -1)), {
      minLength: 1,
      maxLength: 4,
      selector: (field) => JSON.stringify(field),
    });
    fc.assert(
      fc.property(fc.nat(299), fc.nat(3), changes, (seed, memory, fields) => {
        const read = differing(season(seed)[memory] as TimerProgram, fields);
        expect(found([read], KNOWN)).toEqual({ kind: 'like', keys: [`model-${seed}`], differs: fields.length });
      }),
    );
  });

  it('names no model for a timer that it has never seen', () => {
    for (let seed = 300; seed < 600; seed++) {
      expect(found(season(seed), KNOWN)).toEqual({ kind: 'unknown', keys: [] });
    }
  });
});

describe('many similar models', () => {
  /** Models of one pilot: copies of a few, with a few values changed, some in nothing at all. */
  const family = fc.array(
    fc.record({
      base: fc.nat(2),
      fields: fc.array(fc.constantFrom(DT, STOP, ...TRIMS), { maxLength: 8 }),
      by: fc.integer({ min: 1, max: 3 }),
      memories: fc.subarray([0, 1, 2, 3], { minLength: 1 }),
    }),
    { minLength: 2, maxLength: 200 },
  );
  const programsOf = ({
    base,
    fields,
    by,
    memories,
  }: {
    base: number;
    fields: ProgramField[];
    by: number;
    memories: number[];
  }) => memories.map((memory) => differing(season(base)[memory] as TimerProgram, fields, by));
  const crowds = family.map((sisters) => ({
    sisters: sisters.map(programsOf),
    models: sisters.map((sister, at) => held(`sister-${at}`, ...programsOf(sister))),
  }));

  it('never names another model alone for a timer that holds what its model holds', () => {
    fc.assert(
      fc.property(crowds, fc.nat(), ({ sisters, models }, pick) => {
        const at = pick % sisters.length;
        const result = found(sisters[at] as TimerProgram[], models);
        expect(result.keys).toContain(`sister-${at}`);
      }),
    );
  });

  it('says the same in whatever order models and memories come', () => {
    fc.assert(
      fc.property(crowds, fc.nat(), ({ sisters, models }, pick) => {
        const read = sisters[pick % sisters.length] as TimerProgram[];
        const { kind, keys } = found(read, models);
        const back = found([...read].reverse(), [...models].reverse());
        expect([back.kind, [...back.keys].sort()]).toEqual([kind, [...keys].sort()]);
      }),
    );
  });

  it('names only one when it holds nearly all that was read and no other is about as near', () => {
    const reads = fc.tuple(crowds, fc.nat(), fc.array(fc.constantFrom(DT, STOP, ...TRIMS), { maxLength: 6 }));
    fc.assert(
      fc.property(reads, ([{ sisters, models }, pick, fields]) => {
        const read = (sisters[pick % sisters.length] as TimerProgram[]).map((program) => differing(program, fields, 5));
        const result = recognise(read, models, TEMPLATES);
        if (!('model' in result)) return;
        const named = models.find(({ model }) => model === result.model);
        for (const program of read) {
          const own = named?.verified.find((each) => each.program.memory === program.memory);
          if (own) expect(differences(own.program, program).length).toBeLessThanOrEqual(4);
        }
        expect(result.kind).toBe(result.of.differs === 0 ? 'same' : 'like');
        const twins = models.filter(({ verified }) => JSON.stringify(verified) === JSON.stringify(named?.verified));
        expect(twins).toHaveLength(1);
      }),
    );
  });
});

describe('a reading that does not decide', () => {
  const A = trimmed(1);
  const B = trimmed(2);
  const own = { ...trimmed(3), memory: 1 };

  it('is a program that two models hold, and both are named', () => {
    expect(found([A], [held('one', A), held('two', A), held('three', B)])).toEqual({
      kind: 'several',
      keys: ['two', 'one'].sort(),
    });
  });

  it('is a program that differs from that of another model only in DT and motor stop', () => {
    const models = [held('one', A), held('two', differing(A, [DT, STOP]))];
    expect(found([A], models)).toEqual({ kind: 'several', keys: ['one', 'two'] });
    expect(found([differing(A, [DT], 3)], models).kind).toBe('several');
  });

  it('is a program that is about as near to another model: up to twice as many values differ', () => {
    const one = held('one', differing(A, TRIMS.slice(0, 1)));
    const models = (count: number): ModelHeld[] => [one, held('two', differing(A, TRIMS.slice(10, 10 + count)))];
    expect(found([A], models(2))).toEqual({ kind: 'several', keys: ['one', 'two'] });
    expect(found([A], models(3))).toEqual({ kind: 'like', keys: ['one'], differs: 1 });
  });

  it('becomes clear with another memory that was read', () => {
    const models = [held('one', A, own), held('two', A, differing(own, TRIMS.slice(0, 20)))];
    expect(found([A, own], models)).toEqual({ kind: 'same', keys: ['one'], differs: 0 });
    expect(found([A, own], [held('one', A, own), held('two', A)])).toEqual({ kind: 'same', keys: ['one'], differs: 0 });
  });

  it.each([
    ['all 0', newProgram({ timerClass: 'Q', functions: 10, servos: 3, from: 'nothing' })],
    ['the template of the class', newProgram({ timerClass: 'Q', functions: 10, servos: 3, from: 'usual' })],
    ['servos in equal steps', { ...A, positions: A.positions.map((row) => row.map((_, slot) => 15 + 10 * slot)) }],
    ['servos that stand still', { ...A, positions: A.positions.map((row) => row.map(() => 65)) }],
  ])('is a memory that any timer may hold: %s', (_, program) => {
    const read = { ...program, identity: IDENTITY, memory: 0 };
    expect(found([read], [held('one', read), held('two', B)])).toEqual({ kind: 'unknown', keys: ['one'] });
    expect(found([read, own], [held('one', read, own)])).toEqual({ kind: 'same', keys: ['one'], differs: 0 });
  });

  it('is a template with a few values changed that are not those of the model', () => {
    const template = { ...(TEMPLATES[0] as TimerProgram), identity: IDENTITY, memory: 0 };
    const models = [held('one', differing(template, TRIMS.slice(14, 16)))];
    expect(found([differing(template, TRIMS.slice(20, 22))], models)).toEqual({ kind: 'unknown', keys: ['one'] });
    expect(found([differing(template, TRIMS.slice(14, 16))], models).kind).toBe('same');
  });

  it('is two memories that name two models', () => {
    expect(found([A, own], [held('one', A), held('two', own)])).toEqual({ kind: 'several', keys: ['one', 'two'] });
  });
});

describe('a model is out of the question', () => {
  const A = trimmed(1);
  const own = { ...trimmed(3), memory: 1 };

  it.each<[what: string, other: Partial<TimerProgram>]>([
    ['class', { identity: { ...IDENTITY, timerClass: 'B' } }],
    ['firmware', { identity: { ...IDENTITY, firmware: '540' } }],
    ['number of memories', { identity: { ...IDENTITY, memories: 5 } }],
    ['layout', { identity: { ...IDENTITY, servos: 2 }, positions: A.positions.slice(0, 2) }],
    ['memory', { memory: 2 }],
  ])('where what is known of it is of another %s', (_, other) => {
    expect(found([A], [held('one', { ...A, ...other })])).toEqual({ kind: 'unknown', keys: [] });
  });

  it('where more than four of 44 values differ', () => {
    expect(found([differing(A, TRIMS.slice(0, 4))], [held('one', A)])).toEqual({
      kind: 'like',
      keys: ['one'],
      differs: 4,
    });
    expect(found([differing(A, TRIMS.slice(0, 5))], [held('one', A)])).toEqual({ kind: 'unknown', keys: [] });
  });

  it('where one memory differs in more, however well the others fit, and it is offered last', () => {
    const models = [held('one', A, own), held('two', differing(A, TRIMS.slice(0, 1)))];
    const strange = differing(own, TRIMS.slice(0, 9));
    expect(found([A, strange], models)).toEqual({ kind: 'like', keys: ['two'], differs: 1 });
    expect(found([A, strange], models.slice(0, 1))).toEqual({ kind: 'unknown', keys: ['one'] });
  });
});

describe('a timer that does not say which memory is current', () => {
  it('is compared with readings without a current memory', () => {
    const A = trimmed(1, null);
    expect(found([A], [held('one', A), held('two', trimmed(1, 0))])).toEqual({
      kind: 'same',
      keys: ['one'],
      differs: 0,
    });
  });
});

it('an idle throttle that was not read does not count', () => {
  const A = { ...trimmed(1), idleThrottle: 12 };
  expect(found([{ ...A, idleThrottle: null }], [held('one', A)]).kind).toBe('same');
  expect(found([{ ...A, idleThrottle: 13 }], [held('one', A)])).toEqual({ kind: 'like', keys: ['one'], differs: 1 });
});
