import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { type PartOfWrite, partWritten, type TimerProgram } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Backups } from '../records/backups.js';
import type { UnfinishedRoundTrip, UnfinishedWrite } from '../storage/index.js';
import { isSimulated, type Knowledge, memoryKey } from '../timer/knowledge.js';
import { kindKey, programKey } from '../timer/record-keys.js';
import type { UnfinishedRecords } from '../timer/unfinished.js';

/** What an earlier job left behind on a timer of this kind, by a fresh read. */
export type Offer =
  /** A write into this memory, and how far it came. */
  | {
      readonly kind: 'write';
      readonly record: UnfinishedWrite;
      readonly part: PartOfWrite;
      readonly read: TimerProgram;
    }
  /** A write into another memory. What became of it shows once that memory is current. */
  | { readonly kind: 'elsewhere'; readonly record: UnfinishedWrite; readonly memory: number }
  /** A memory round trip that did not come back to the original. */
  | { readonly kind: 'memories'; readonly record: UnfinishedRoundTrip; readonly current: number | null };

/** A job that selects other memories and comes back; with `select` it stays. */
export interface RoundTrip {
  readonly job: NonNullable<UnfinishedRoundTrip['job']>;
  /** The memory that is looked at or selected, counted from 0; null for several. */
  readonly memory: number | null;
}

interface Reading {
  readonly read: TimerProgram;
  readonly simulated: boolean;
  /** The current memory, counted from 0; null when the timer does not say. */
  readonly current: number | null;
}

/**
 * What can be done about an interrupted job. Nothing identifies a timer, so with any timer of the same kind the page
 * shows what a fresh read explains, and the pilot decides. What is not known about a timer is no part of the offer:
 * {@link Knowledge} has that.
 */
export class InterruptedJobs {
  /** Derived from the records and the last reading. */
  readonly offer: ReadonlySignal<Offer | null>;
  /** The memory round trips that did not come back, as far as anybody knows. */
  readonly left: ReadonlySignal<readonly UnfinishedRoundTrip[]>;
  /** The key of the one that this page has in progress. */
  readonly #underWay = signal<string | null>(null, { name: 'roundTrip' });
  /** The last reading of the connected timer; null before there is one. */
  readonly #reading = signal<Reading | null>(null, { name: 'reading' });
  /** Round trips about which the pilot wants to hear nothing while this timer is connected. */
  readonly #notNow = signal<ReadonlySet<string>>(new Set(), { name: 'notNow' });
  readonly #records: UnfinishedRecords;
  readonly #knowledge: Knowledge;
  readonly #backups: Backups;

  constructor(records: UnfinishedRecords, knowledge: Knowledge, backups: Backups) {
    this.#records = records;
    this.#knowledge = knowledge;
    this.#backups = backups;
    this.left = computed(() =>
      records.roundTrips.value.filter(({ key }) => key !== this.#underWay.value && !this.#notNow.value.has(key)),
    );
    this.offer = computed(() => {
      const reading = this.#reading.value;
      return reading && this.#offerFor(reading);
    });
  }

  /**
   * Keeps the goal of a write and a backup of what the timer holds. Wait for it before the first byte goes out.
   * @param held what the timer holds. It differs from `before` where the goal is to put back what is about to be tried:
   * then `before` has the value that is tried.
   * @returns false when the browser keeps nothing: then only this page remembers.
   */
  async begin(before: TimerProgram, goal: TimerProgram, simulated: boolean, held = before): Promise<boolean> {
    this.#reading.value = null;
    const backup = this.#backups.add(held, 'write', simulated);
    const kept = await Promise.all([backup, this.#knowledge.begin(before, goal)]);
    return kept.every(Boolean);
  }

  /**
   * Notes which memory is current before a round trip begins. An earlier one that did not come back is remembered until
   * its own original is current again.
   */
  async leave(trip: RoundTrip, identity: Identity, original: number, simulated: boolean): Promise<void> {
    const key = kindKey(identity, simulated);
    this.#underWay.value = key;
    // The record of a timer that the pilot has told apart from this one is kept for the right one.
    const isOfOther = trip.job === 'select' && this.#notNow.peek().has(key);
    if (isOfOther || this.offer.value?.kind === 'memories') return;
    await this.#records.save({
      kind: 'memories',
      key,
      startedAt: Date.now(),
      identity,
      original,
      job: trip.job,
      ...(trip.memory === null ? {} : { memory: trip.memory }),
    });
  }

  /** A job has ended. A round trip that has not come back by now is cut off. */
  jobOver(): void {
    this.#underWay.value = null;
  }

  /** The pilot has made a memory fly next: whatever an earlier round trip left, this is what is meant. */
  async chose(identity: Identity, simulated: boolean): Promise<void> {
    const trip = this.#roundTripOf(identity, simulated);
    if (trip && !this.#notNow.peek().has(trip.key)) await this.#records.delete(trip.key);
  }

  /** The memory from before the round trip is current again. */
  async wasRestored(identity: Identity, simulated: boolean): Promise<void> {
    await this.#records.delete(kindKey(identity, simulated));
  }

  /**
   * The current memory was read, or another one came to the screen: looks for what an earlier job may have left behind.
   * @param current the current memory.
   */
  wasRead(read: TimerProgram, simulated: boolean, current = read.memory): void {
    this.#reading.value = { read, simulated, current };
    const trip = this.#roundTripOf(read.identity, simulated);
    // The pilot meant one of two memories to fly, and now reads which of them does.
    const isSettled = trip?.job === 'select' || trip?.original === current;
    if (trip && isSettled) void this.#records.delete(trip.key);
  }

  /**
   * This is another timer than that of the interrupted job. The record is kept for the right one and not shown while
   * this timer is connected.
   */
  setAside(): void {
    const { value } = this.offer;
    if (!value) return;
    const { key, kind } = value.record;
    if (kind === 'write') this.#knowledge.notThisTimer(key);
    else this.#notNow.value = new Set(this.#notNow.value).add(key);
  }

  /** A timer was connected or disconnected: the next one may be another. */
  anotherTimer(): void {
    this.#notNow.value = new Set();
    this.#reading.value = null;
  }

  /** The pilot has dealt with it, or wants to leave it as it is. The backup stays. */
  async settle(): Promise<void> {
    const { value } = this.offer;
    if (value) await this.#knowledge.forget(value.record.key);
  }

  /** The simulated timers of this page know nothing about those of a page that was closed. */
  async forgetSimulated(): Promise<void> {
    await this.#records.load();
    const old = this.#records.list.value.filter(isSimulated);
    await Promise.all(old.map(({ key }) => this.#knowledge.forget(key)));
  }

  #offerFor({ read, simulated, current }: Reading): Offer | null {
    const trip = this.#roundTripOf(read.identity, simulated);
    if (trip && trip.job !== 'select' && trip.original !== current && !this.#notNow.value.has(trip.key)) {
      return { kind: 'memories', record: trip, current };
    }
    const kind = `${kindKey(read.identity, simulated)}/`;
    const key = programKey(read, simulated);
    const writes = this.#knowledge.writes.value.filter(
      (record) => memoryKey(record).startsWith(kind) && !this.#knowledge.isOfOther(record.key),
    );
    const here = writes.find((record) => memoryKey(record) === key);
    if (here) return { kind: 'write', record: here, part: partWritten(here.before, here.goal, read), read };
    const elsewhere = writes.find((record) => record.goal.memory !== null && !record.tried);
    return elsewhere ? { kind: 'elsewhere', record: elsewhere, memory: elsewhere.goal.memory as number } : null;
  }

  #roundTripOf(identity: Identity, simulated: boolean): UnfinishedRoundTrip | undefined {
    const kind = kindKey(identity, simulated);
    return this.#records.roundTrips.value.find(({ key }) => key === kind);
  }
}
