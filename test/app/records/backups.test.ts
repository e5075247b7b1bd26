import { describe, expect, it } from 'vitest';
import { Backups } from '../../../src/app/records/backups.js';
import type { Backup } from '../../../src/app/storage/index.js';
import { MemoryStore } from '../bench/bench.js';
import { programOf } from '../programs.js';

const DAY = 86_400_000;
const NOW = new Date(2026, 10, 22, 15, 0).getTime();
const PROGRAM = programOf('Q', [1000, 30, 1200, 18_000]);

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

  it('keeps 1,000 before writes, and all that were asked for; the oldest are deleted, also in the storage', async () => {
    const store = new MemoryStore();
    const put = (at: number, given: Partial<Backup>): void => {
      const backup = { key: String(at), savedAt: at, reason: 'write', program: PROGRAM, simulated: false } as const;
      store.backups.records.set(backup.key, { ...backup, ...given });
    };
    put(NOW - 1, { reason: 'memories' });
    for (let at = NOW; at <= NOW + 1000; at++) put(at, {});
    put(NOW + 1001, { simulated: true });
    const list = new Backups(store.backups);
    await list.load();
    const left = () => {
      const written = list.list.value.filter(({ reason, simulated }) => reason === 'write' && !simulated);
      return [list.list.value.length, store.backups.records.size, written.at(-1)?.savedAt];
    };
    expect(left()).toEqual([1002, 1002, NOW + 1]);
    await list.add(PROGRAM, 'write', false, NOW + DAY);
    expect(left()).toEqual([1002, 1002, NOW + 2]);
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
