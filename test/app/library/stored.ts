import type { EntryCounts } from '../../../src/app/library/files/import-plan.js';
import { MemoryStore } from '../bench/bench.js';
import { manyRecords } from './many.js';

/** A storage with a library in it. */
export function stored(counts: EntryCounts): MemoryStore {
  const store = new MemoryStore();
  const records = manyRecords(counts);
  for (const each of records.models) store.models.records.set(each.key, each);
  for (const each of records.settings) store.settings.records.set(each.key, each);
  for (const each of records.flights) store.flights.records.set(each.key, each);
  return store;
}
