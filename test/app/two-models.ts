import { emptyModel } from '../../src/app/records/library.js';
import type { Backup, ModelRecord, SettingRecord } from '../../src/app/storage/index.js';
import type { ProgramField, Setting, TimerProgram } from '../../src/program/index.js';
import { exampleMemories } from '../../src/simulator/index.js';
import { type AppBench, appBench, MemoryStore, run } from './bench/bench.js';

export const IDENTITY = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };
export const DT: ProgramField = { kind: 'time', slot: 10 };
export const S2: ProgramField = { kind: 'position', servo: 1, slot: 4 };
export const THEN = 1_795_000_000_000;

const LANCER = exampleMemories('Q').map(({ times, positions }) => ({ times: [...times], positions }));
const MAGPIE = LANCER.map(({ times, positions }) => ({
  times: times.map((time) => time + 5),
  positions: positions.map((row) => row.map((position, slot) => position + 1 + (slot % 3))),
}));

function programOf({ times, positions }: (typeof MAGPIE)[number], memory: number): TimerProgram {
  return { identity: IDENTITY, memory, times, positions: positions.map((row) => [...row]), idleThrottle: 30 };
}

/** What the timer of the Lancer holds in a memory. */
export const lancerHeld = (memory: number): TimerProgram =>
  programOf(LANCER[memory] as (typeof MAGPIE)[number], memory);
/** What the timer of each model last held in M1. */
export const LANCER_HELD = lancerHeld(0);
export const MAGPIE_HELD = programOf(MAGPIE[0] as (typeof MAGPIE)[number], 0);
/** A setting of each model. That of the Magpie is for its M2. */
export const CALM = settingOf('calm', 'Lancer', LANCER_HELD);
export const WIND = settingOf('wind', 'Magpie', programOf(MAGPIE[1] as (typeof MAGPIE)[number], 1));

export const BACKUP: Backup = {
  key: '2026-11-20T10:00:00.000Z/0',
  savedAt: THEN,
  reason: 'write',
  program: MAGPIE_HELD,
  simulated: false,
  model: 'Magpie',
};

function settingOf(id: string, model: string, program: TimerProgram): Setting {
  return { id, model, name: id, note: '', tags: [], at: THEN, program, from: 'typed', archived: false };
}

export function modelOf(name: string, held: TimerProgram): ModelRecord {
  const model = { ...emptyModel(name, name, 'Q'), memoryNames: [`${name} one`, `${name} two`] };
  return { key: name, changedAt: 1, verified: [{ program: held, at: THEN }], model };
}

/** A library with two models of the same kind of timer, and a setting of each. */
export function twoModels(): MemoryStore {
  const store = new MemoryStore();
  store.models.records.set('Lancer', modelOf('Lancer', LANCER_HELD));
  store.models.records.set('Magpie', modelOf('Magpie', MAGPIE_HELD));
  for (const setting of [CALM, WIND])
    store.settings.records.set(setting.id, { key: setting.id, changedAt: 1, setting } satisfies SettingRecord);
  return store;
}

/** The page with both models, before anything is connected. The timer is that of the Lancer. */
export async function lancerBench(store: MemoryStore = twoModels()): Promise<AppBench> {
  const bench = await lancerStarted(store);
  await run(bench.session.library.load());
  return bench;
}

/** The same, before anything is read of the library. */
export async function lancerStarted(store: MemoryStore): Promise<AppBench> {
  const bench = await appBench({ store, identity: IDENTITY });
  bench.timer.core.memories.splice(0, bench.timer.core.memories.length, ...structuredClone(LANCER));
  return bench;
}

/** The timer of the Magpie is under the head in place of the other one, and nobody has noticed yet. */
export function exchange({ timer: { core } }: AppBench): void {
  core.memories.splice(0, core.memories.length, ...structuredClone(MAGPIE));
}

/** The same, with the timer of the Lancer connected and read. */
export async function lancerConnected(store?: MemoryStore): Promise<AppBench> {
  const bench = await lancerBench(store);
  await run(bench.session.timer.connect());
  return bench;
}

export function type({ editor }: AppBench, field: ProgramField, text: string): void {
  editor.type(field, text);
  editor.leave(field);
}

/** What the library keeps under this id. */
export function savedAs({ session }: AppBench, id: string): Setting | undefined {
  return session.library.settings.get(id)?.setting;
}
