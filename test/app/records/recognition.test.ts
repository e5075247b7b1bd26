import { describe, expect, it } from 'vitest';
import type { ModelRecord } from '../../../src/app/storage/index.js';
import type { Model } from '../../../src/program/index.js';
import { type AppBench, goOn, idle, MemoryStore, reloaded, review, run } from '../bench/bench.js';
import { exchange, LANCER_HELD, lancerHeld, lancerStarted, modelOf, THEN } from '../two-models.js';

const record = (name: string, verified: ModelRecord['verified'] = []): ModelRecord => ({
  ...modelOf(name, LANCER_HELD),
  verified,
});
const held = (...memories: number[]) => memories.map((memory) => ({ program: lancerHeld(memory), at: THEN }));

async function benchWith(...models: readonly ModelRecord[]): Promise<AppBench> {
  const store = new MemoryStore();
  for (const model of models) store.models.records.set(model.key, model);
  return lancerStarted(store);
}

function nameOf({ session }: AppBench): string | null {
  return session.recognition.model.value?.name ?? null;
}

const kindOf = ({ session }: AppBench) => session.recognition.found.value?.kind ?? null;

describe('a timer that holds what a model held', () => {
  it('belongs to the model, without a click of the pilot', async () => {
    const bench = await benchWith(record('Magpie'), record('Lancer 07', held(0)));
    expect(nameOf(bench)).toBeNull();
    await run(bench.session.timer.connect());
    expect([kindOf(bench), nameOf(bench)]).toEqual(['same', 'Lancer 07']);
    expect(bench.session.recognition.found.value).toMatchObject({ of: { at: THEN, differs: 0 } });
    await run(bench.session.timer.disconnect());
    expect(nameOf(bench)).toBeNull();
  });

  it('no longer belongs to the model when another memory says something else', async () => {
    const bench = await benchWith(
      record('Lancer 07', [...held(0), { program: { ...lancerHeld(3), memory: 1 }, at: THEN }]),
    );
    await run(bench.session.timer.connect());
    expect(nameOf(bench)).toBe('Lancer 07');
    await run(bench.memories.readOnce(1));
    expect([kindOf(bench), nameOf(bench)]).toEqual(['unknown', null]);
    expect(bench.store.models.records.get('Lancer 07')?.verified[1]?.program.times).toEqual(lancerHeld(3).times);
  });

  it('adds to the model what its other memories hold', async () => {
    const bench = await benchWith(record('Lancer 07', held(0)));
    await run(bench.session.timer.connect());
    await run(bench.memories.readOnce(2));
    const known = bench.store.models.records.get('Lancer 07')?.verified;
    expect(known?.map(({ program }) => program.memory)).toEqual([0, 2]);
    // What was known already keeps its day.
    expect(known?.[0]?.at).toBe(THEN);
  });

  it('still belongs to the model after a write, and is recognised by what was written', async () => {
    const bench = await benchWith(record('Lancer 07', held(0)));
    await run(bench.session.timer.connect());
    bench.editor.type({ kind: 'position', servo: 1, slot: 4 }, '77');
    for (let slot = 1; slot < 10; slot++) bench.editor.type({ kind: 'position', servo: 0, slot }, String(80 + slot));
    await review(bench);
    bench.session.safety.confirm();
    await goOn(bench);
    expect(bench.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
    expect([kindOf(bench), nameOf(bench)]).toEqual(['same', 'Lancer 07']);
    await run(bench.session.timer.disconnect());
    const again = await reloaded(bench);
    await run(again.session.timer.connect());
    expect([kindOf(again), nameOf(again)]).toEqual(['same', 'Lancer 07']);
  });
});

it('a timer is like a model when few values differ, until a verified write names it', async () => {
  const lancer = record('Lancer 07', held(0));
  const bench = await benchWith(lancer);
  (bench.timer.core.memories[0]?.times as number[])[10] = 24_000;
  await run(bench.session.timer.connect());
  expect([kindOf(bench), nameOf(bench)]).toEqual(['like', 'Lancer 07']);
  await idle();
  // Nothing is taught by what is not certain.
  expect(bench.store.models.records.get('Lancer 07')?.verified).toEqual(lancer.verified);
  bench.editor.type({ kind: 'time', slot: 10 }, '5:00');
  await review(bench);
  bench.session.safety.confirm();
  await goOn(bench);
  await idle();
  expect(kindOf(bench)).toBe('said');
  expect(bench.store.models.records.get('Lancer 07')?.verified[0]?.program.times[10]).toBe(30_000);
});

describe('a timer that is not known', () => {
  it('brings the question, and the answer holds until the connection ends', async () => {
    const bench = await benchWith(record('Magpie'), record('Swift'));
    await run(bench.session.timer.connect());
    const { recognition } = bench.session;
    expect([kindOf(bench), nameOf(bench), recognition.tells.value]).toEqual(['unknown', null, true]);
    expect(recognition.choices.value.map(({ name }) => name)).toEqual(['Magpie', 'Swift']);
    recognition.say(recognition.choices.value[1] as Model);
    expect([kindOf(bench), nameOf(bench), recognition.tells.value]).toEqual(['said', 'Swift', false]);
    await idle();
    const again = await reloaded(bench);
    await run(again.session.timer.connect());
    expect([kindOf(again), nameOf(again)]).toEqual(['same', 'Swift']);
  });

  it('cannot belong to a model of another class, or to an archived one', async () => {
    const other = record('Alien');
    const away = record('Old');
    const bench = await benchWith(
      { ...other, model: { ...other.model, timerClass: 'B' } },
      { ...away, model: { ...away.model, archived: true } },
      record('Magpie'),
    );
    await run(bench.session.timer.connect());
    expect(bench.session.recognition.choices.value.map(({ name }) => name)).toEqual(['Magpie']);
  });
});

describe('another timer in the place of the first, and the connection stays', () => {
  it('no longer belongs to the model after the next reading', async () => {
    const bench = await benchWith(record('Lancer 07', held(0)), record('Magpie'));
    await run(bench.session.timer.connect());
    exchange(bench);
    await run(bench.session.reader.read());
    expect([kindOf(bench), nameOf(bench)]).toEqual(['unknown', null]);
    expect(bench.store.models.records.get('Lancer 07')?.verified).toEqual(held(0));
  });

  it('cancels what the pilot has said of the first', async () => {
    const bench = await benchWith(record('Lancer 07'), record('Magpie'));
    await run(bench.session.timer.connect());
    bench.session.recognition.say(bench.session.recognition.choices.value[1] as Model);
    await idle();
    exchange(bench);
    await run(bench.session.reader.read());
    expect([kindOf(bench), nameOf(bench), bench.session.recognition.tells.value]).toEqual(['unknown', null, true]);
    expect(bench.store.models.records.get('Magpie')?.verified[0]?.program.times).toEqual(LANCER_HELD.times);
  });

  it('brings the question when only one value differs: it may be the same timer or a similar one', async () => {
    const bench = await benchWith(record('Lancer 07', held(0)));
    await run(bench.session.timer.connect());
    (bench.timer.core.memories[0]?.times as number[])[10] = 24_000;
    await run(bench.session.reader.read());
    expect([kindOf(bench), nameOf(bench)]).toEqual(['like', 'Lancer 07']);
    expect(bench.store.models.records.get('Lancer 07')?.verified).toEqual(held(0));
  });

  it('is recognised anew after it was away and has come back', async () => {
    const bench = await benchWith(record('Lancer 07', held(0)));
    await run(bench.session.timer.connect());
    bench.adapter.unplug();
    exchange(bench);
    bench.adapter.replug();
    await idle();
    expect([bench.session.connection.value !== null, kindOf(bench), nameOf(bench)]).toEqual([true, 'unknown', null]);
  });
});

describe('a library that changes, or does not come', () => {
  it('forgets a model that was deleted, and uses a new name', async () => {
    const bench = await benchWith(record('Lancer 07', held(0)), record('Magpie'));
    await run(bench.session.timer.connect());
    const { library } = bench.session;
    const { model } = library.models.get('Lancer 07') as ModelRecord;
    await run(library.keepModel({ ...model, name: 'Lancer 7b' }));
    expect(nameOf(bench)).toBe('Lancer 7b');
    await run(library.change({ models: { gone: ['Lancer 07'] } }));
    expect([kindOf(bench), nameOf(bench)]).toEqual(['unknown', null]);
    expect([...bench.store.models.records.keys()]).toEqual(['Magpie']);
  });

  it('forgets the answer of the pilot with the model', async () => {
    const bench = await benchWith(record('Magpie'));
    await run(bench.session.timer.connect());
    bench.session.recognition.say(bench.session.recognition.choices.value[0] as Model);
    await idle();
    await run(bench.session.library.change({ models: { gone: ['Magpie'] } }));
    expect([kindOf(bench), nameOf(bench)]).toEqual(['unknown', null]);
  });

  it('says nothing while the storage hangs, and everything when it answers late', async () => {
    const store = new MemoryStore();
    store.models.records.set('Lancer 07', record('Lancer 07', held(0)));
    let answer = (): void => {};
    const all = store.models.all.bind(store.models);
    store.models.all = () => new Promise((resolve) => (answer = () => void all().then(resolve)));
    const bench = await lancerStarted(store);
    await run(bench.session.timer.connect());
    expect([bench.editor.working.value?.memory, kindOf(bench)]).toEqual([0, null]);
    await idle();
    // The storage has had its time: there are no models.
    expect([kindOf(bench), bench.session.recognition.tells.value]).toEqual(['unknown', false]);
    store.models.all = all;
    answer();
    await idle();
    expect([kindOf(bench), nameOf(bench)]).toEqual(['same', 'Lancer 07']);
  });
});

describe('simulated timers', () => {
  it('and real ones are never compared', async () => {
    const store = new MemoryStore();
    const simulated = held(0).map((each) => ({ ...each, simulated: true }));
    store.models.records.set('Lancer 07', record('Lancer 07', held(0)));
    store.models.records.set('Play', record('Play', simulated));
    const real = await lancerStarted(store);
    await run(real.session.timer.connect());
    expect([nameOf(real), real.session.recognition.choices.value.map(({ name }) => name)]).toEqual([
      'Lancer 07',
      ['Lancer 07'],
    ]);
    await run(real.session.timer.disconnect());
    await run(real.session.timer.trySimulated('Q'));
    expect(real.session.recognition.choices.value.map(({ name }) => name)).toEqual(['Play']);
    await run(real.session.recognition.sayNew('Toy'));
    await idle();
    const toy = [...store.models.records.values()].find(({ model }) => model.name === 'Toy');
    expect(toy?.verified).toMatchObject([{ simulated: true }]);
  });
});
