import { MemoryStore } from '../bench/bench.js';
import { type Counts, manyRecords } from './many.js';

/** A storage with a library in it. */
export function stored(counts: Counts): MemoryStore {
  const store = new MemoryStore();
  const records = manyRecords(counts);
  for (const each of records.models) store.models.records.set(each.key, each);
  for (const each of records.settings) store.settings.records.set(each.key, each);
  for (const each of records.flights) store.flights.records.set(each.key, each);
  return store;
}
