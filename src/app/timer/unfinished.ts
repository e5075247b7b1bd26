import { computed, type ReadonlySignal } from '@preact/signals';
import { Collection } from '../storage/collection.js';
import type { Keeper, Unfinished, UnfinishedRoundTrip, UnfinishedWrite } from '../storage/index.js';

/** The records of jobs that change a timer, from before their first byte until somebody has seen their end. */
export class UnfinishedRecords extends Collection<Unfinished> {
  readonly writes: ReadonlySignal<readonly UnfinishedWrite[]> = computed(() =>
    this.list.value.filter((record) => record.kind === 'write'),
  );
  readonly roundTrips: ReadonlySignal<readonly UnfinishedRoundTrip[]> = computed(() =>
    this.list.value.filter((record) => record.kind === 'memories'),
  );

  constructor(keeper: Keeper<Unfinished>) {
    super({ keeper });
  }
}
