import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { outdated } from '../../../src/app/records/backup-thinning.js';
import { Backups } from '../../../src/app/records/backups.js';
import type { Backup } from '../../../src/app/storage/index.js';
import { MemoryStore } from '../bench/bench.js';
import { programOf } from '../programs.js';

const DAY = 86_400_000;
const NOW = new Date(2026, 10, 22, 15, 0).getTime();
const PROGRAM = programOf('Q', [1000, 30, 1200, 18_000]);

interface Made {
  readonly at: number;
  readonly model?: string;
  readonly memory?: number;
  readonly simulated?: boolean;
  readonly reason?: Backup['reason'];
}

function backup({ at, model, memory = 0, simulated = false, reason = 'write' }: Made): Backup {
  const key = `${new Date(at).toISOString()}/${memory}/${model ?? ''}/${simulated}`;
  const program = { ...PROGRAM, memory };
  return { key, savedAt: at, reason, program, simulated, ...(model === undefined ? {} : { model }) };
}

function left(backups: readonly Backup[], now = NOW): Backup[] {
  const gone = new Set(outdated(backups, now));
  return backups.filter((each) => !gone.has(each));
}

/** Five writes on each of so many days. */
function daily(days: number): Backup[] {
  return Array.from({ length: days }, (_, day) =>
    [0, 1, 2, 3, 4].map((hour) => backup({ at: NOW - day * DAY - hour * 3_600_000, model: 'Lancer' })),
  ).flat();
}

const day = ({ savedAt }: Backup): string => new Date(savedAt).toDateString();
const month = ({ savedAt }: Backup): string =>
  day({ savedAt } as Backup)
    .replace(/ \d+ /, ' ')
    .slice(4);

describe('backups before writes, over three years', () => {
  const all = daily(1096);
  const kept = left(all);

  it('are all kept from the last two days', () => {
    for (const at of [NOW, NOW - DAY]) {
      expect(kept.filter((each) => day(each) === new Date(at).toDateString())).toHaveLength(5);
    }
  });

  it('are kept for 30 days before that, the first of each day', () => {
    const days = kept.filter(({ savedAt }) => savedAt < NOW - 1.5 * DAY && savedAt >= NOW - 31.5 * DAY);
    expect(days).toHaveLength(30);
    for (const each of days) {
      const same = all.filter((other) => day(other) === day(each));
      expect(each.savedAt).toBe(Math.min(...same.map(({ savedAt }) => savedAt)));
    }
  });

  it('are kept before that, the first of each month', () => {
    const months = kept.filter(({ savedAt }) => savedAt < NOW - 32 * DAY);
    expect(new Set(months.map(month)).size).toBe(months.length);
    expect(months.length).toBeGreaterThanOrEqual(35);
    expect(kept.length).toBeLessThan(5 + 5 + 30 + 38);
  });

  it('are kept for each memory of each model', () => {
    const at = NOW - 200 * DAY;
    const made = [
      { at, model: 'Lancer', memory: 0 },
      { at: at + 1, model: 'Lancer', memory: 1 },
      { at: at + 2, model: 'Magpie', memory: 0 },
      { at: at + 3, memory: 0 },
      { at: at + 4, model: 'Lancer', memory: 0 },
    ].map(backup);
    const later = [backup({ at: NOW - DAY }), backup({ at: NOW })];
    expect(left([...made, ...later])).toEqual([...made.slice(0, 4), ...later]);
  });

  it('are all kept when the pilot has asked for them', () => {
    const asked = [1, 2, 3].map((hour) => backup({ at: NOW - 400 * DAY + hour, reason: 'memories' }));
    expect(left(asked)).toEqual(asked);
  });

  it('do not mix with those of simulated timers, which are kept for at most a month', () => {
    const real = backup({ at: NOW - 3 * DAY });
    const simulated = backup({ at: NOW - 3 * DAY - 1, simulated: true });
    expect(left([real, simulated])).toEqual([real, simulated]);
    expect(left([backup({ at: NOW - 40 * DAY, simulated: true })])).toEqual([]);
  });

  it('are kept when the clock of the device has gone back', () => {
    const later = [1, 2, 3].map((hours) => backup({ at: NOW + 5 * DAY + hours }));
    expect(left(later)).toEqual(later);
  });

  it('are kept when the clock of the device is years ahead for once', () => {
    const today = [1, 2, 3].map((hours) => backup({ at: NOW - hours * 3_600_000 }));
    expect(left(today, NOW + 4000 * DAY)).toEqual(today);
    expect(left(left(all, NOW + 4000 * DAY)), 'with the right clock again, the same backups are kept').toEqual(kept);
  });

  it.each([
    ['ahead', NOW + 4000 * DAY],
    ['behind', NOW - 4000 * DAY],
  ])('are kept as after one more day when one is made while the clock is years %s', (_, wrong) => {
    const next = left([...all, backup({ at: NOW + DAY })]).slice(0, -1);
    const made = { ...backup({ at: wrong }), key: `${new Date(NOW + 1).toISOString()}/0` };
    expect(next.slice(-6)).toEqual(kept.slice(-6));
    expect(left([...kept, made], wrong), 'while it is wrong').toEqual([...next, made]);
    expect(left([...next, made]), 'once it is right').toEqual([...next, made]);
  });

  it('are kept when the clock is years behind on each day of flying', () => {
    const made = [40, 30, 20, 10, 0].flatMap((days) => [
      backup({ at: NOW - days * DAY }),
      { ...backup({ at: NOW - 4000 * DAY }), key: `${new Date(NOW - days * DAY + 1).toISOString()}/0` },
    ]);
    expect(left(made)).toEqual(made);
  });

  it('are at most 3000: the oldest are deleted', () => {
    const asked = Array.from({ length: 3010 }, (_, at) => backup({ at: NOW - at * 1000, reason: 'memories' }));
    expect(left(asked)).toEqual(asked.slice(0, 3000));
  });
});

describe('thinning', () => {
  const backups = fc
    .array(
      fc.record({
        at: fc.integer({ min: NOW - 1500 * DAY, max: NOW }),
        model: fc.constantFrom('Lancer', 'Magpie'),
        memory: fc.nat(1),
        reason: fc.constantFrom('write', 'write', 'write', 'memories' as const),
        simulated: fc.boolean(),
      }),
      { maxLength: 300 },
    )
    .map((made) => made.map((each) => backup(each as Made)));

  it('gives the same result each day as once', () => {
    fc.assert(
      fc.property(backups, fc.uniqueArray(fc.integer({ min: 0, max: 400 }), { maxLength: 20 }), (made, days) => {
        let rest: readonly Backup[] = made;
        for (const each of days.sort((a, b) => a - b)) rest = left(rest, NOW + each * DAY);
        const last = NOW + Math.max(0, ...days) * DAY;
        expect(left(rest, last)).toEqual(left(made, last));
      }),
    );
  });

  it('keeps something of each memory of each model in each month', () => {
    fc.assert(
      fc.property(backups, (made) => {
        const group = (each: Backup): string => `${each.model} ${each.program.memory} ${month(each)}`;
        const real = made.filter(({ simulated }) => !simulated);
        expect(new Set(left(real).map(group))).toEqual(new Set(real.map(group)));
      }),
    );
  });
});

describe('the list of backups', () => {
  it('has the last one first, also after the clock was years ahead', async () => {
    const store = new MemoryStore();
    const ahead = NOW + 4000 * DAY;
    await new Backups(store.backups).add(PROGRAM, 'write', false, ahead);
    for (const at of [NOW, NOW + 1]) {
      const list = new Backups(store.backups);
      await list.load();
      await list.add(PROGRAM, 'write', false, at);
    }
    const list = new Backups(store.backups);
    await list.load();
    expect(list.list.value.map(({ savedAt }) => savedAt)).toEqual([NOW + 1, NOW, ahead]);
  });

  it('keeps those of two tabs after the clock was years ahead', async () => {
    const store = new MemoryStore();
    await new Backups(store.backups).add(PROGRAM, 'write', false, NOW + 4000 * DAY);
    const tabs = [new Backups(store.backups), new Backups(store.backups)];
    await Promise.all(tabs.map((tab) => tab.load()));
    await Promise.all(tabs.map((tab, each) => tab.add(PROGRAM, 'write', false, NOW + each)));
    expect(store.backups.records.size).toBe(3);
  });

  it('gives the model to backups of this timer alone, whatever their time', async () => {
    const store = new MemoryStore();
    await new Backups(store.backups).add(PROGRAM, 'write', false, Date.now() + DAY);
    const list = new Backups(store.backups);
    await list.load();
    list.anotherTimer();
    await list.add(PROGRAM, 'write', false, Date.now() - DAY);
    list.assign('Lancer');
    expect(list.list.value.map(({ model }) => model)).toEqual(['Lancer', undefined]);
  });

  it('is thinned when it is read, and in the storage', async () => {
    const store = new MemoryStore();
    for (const each of daily(60).map((old) => ({ ...old, savedAt: Date.now() - (NOW - old.savedAt) }))) {
      store.backups.records.set(each.key, each);
    }
    const list = new Backups(store.backups);
    await list.load();
    expect(list.list.value.length).toBeLessThan(50);
    expect(store.backups.records.size).toBe(list.list.value.length);
  });

  it('says which model they belong to, also those made before the model was known', async () => {
    const store = new MemoryStore();
    let model: string | null = null;
    const list = new Backups(store.backups, () => model);
    await list.add(PROGRAM, 'write', false, 1000);
    list.anotherTimer();
    await list.add(PROGRAM, 'write', false);
    model = 'Lancer';
    list.assign('Lancer');
    await list.add(PROGRAM, 'write', false);
    expect(list.list.value.map((each) => each.model)).toEqual(['Lancer', 'Lancer', undefined]);
    expect([...store.backups.records.values()].filter((each) => each.model === 'Lancer')).toHaveLength(2);
  });
});
