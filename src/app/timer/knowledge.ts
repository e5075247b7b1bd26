import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { differences, partWritten, sameLayout, type TimerProgram } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { UnfinishedWrite } from '../storage/index.js';
import type { Known } from './known.js';
import { programKey } from './record-keys.js';
import type { UnfinishedRecords } from './unfinished.js';

/** The connected timer, or the one from which the program on the screen came. */
export interface TimerAtHand {
  readonly identity: Identity;
  readonly simulated: boolean;
}

type Reading = Extract<Known, { state: 'read' }>;

/** A fresh reading of a memory of the connected timer. */
export interface FreshReading {
  readonly program: TimerProgram;
  /** Milliseconds since 1970. */
  readonly at: number;
  /** Whether it holds what this page last read from it, or has written since. */
  readonly expected: boolean;
}

/**
 * What is known about the content of timers. Every statement about a timer is derived from this alone.
 *
 * A change begins with {@link begin}, before its first byte. From then on there is a record of it, also in the
 * browser's storage. While the change is in progress nothing is reported. It ends in one of two ways. With {@link read}
 * or {@link ended}: a fresh reading has shown the result. With {@link jobOver} or {@link connectionOver}: it was cut
 * off, and the memory is uncertain, until a fresh reading explains it or the pilot settles it ({@link forget}). A page
 * that crashes in between leaves its record, which means the same.
 */
export class Knowledge {
  /**
   * The records of interrupted writes, of every timer that this browser knows, the latest first: also of those that a
   * reading has explained, as long as they can be finished.
   */
  readonly writes: ReadonlySignal<readonly UnfinishedWrite[]>;
  /** Those among them that no reading has explained. The content of their memories is uncertain. */
  readonly uncertain: ReadonlySignal<readonly UnfinishedWrite[]>;
  readonly #records: UnfinishedRecords;
  readonly #timer: ReadonlySignal<TimerAtHand | null>;
  readonly #readings = signal<ReadonlyMap<string, Reading>>(new Map(), { name: 'readings' });
  /**
   * The changes that this page has in progress, by the key of the record:
   * whether the timer has acknowledged all so far.
   */
  readonly #underWay = signal<ReadonlyMap<string, boolean>>(new Map(), { name: 'underWay' });
  /** The memories into which something unknown may have gone since they were read. */
  readonly #stale = signal<ReadonlySet<string>>(new Set(), { name: 'stale' });
  /** Records of which the pilot has said that they belong to another timer than the connected one. */
  readonly #ofOthers = signal<ReadonlySet<string>>(new Set(), { name: 'ofOthers' });
  #lastStart = 0;
  #onRead: (reading: FreshReading) => void = () => {};

  constructor(records: UnfinishedRecords, timer: ReadonlySignal<TimerAtHand | null>) {
    this.#records = records;
    this.#timer = timer;
    this.writes = computed(() =>
      records.writes.value
        .filter(({ key }) => !this.#underWay.value.has(key))
        .sort((a, b) => b.startedAt - a.startedAt),
    );
    this.uncertain = computed(() => this.writes.value.filter(({ seenAt }) => seenAt === null));
  }

  /**
   * What is known about a memory of the connected timer.
   * @param memory counted from 0; null when the timer does not say which is current.
   */
  of(memory: number | null): Known {
    const key = this.#keyOf(memory);
    const cut = this.uncertain.value.find((record) => memoryKey(record) === key && !this.isOfOther(record.key));
    if (cut) return { state: 'uncertain', ...cut };
    return this.#readings.value.get(key ?? '') ?? { state: 'unread' };
  }

  /** Whether this page has sent something into a memory since it was last read. */
  isSent(memory: number | null): boolean {
    const key = this.#keyOf(memory);
    const isUnderWay = this.#records.writes.value.some(
      (record) => memoryKey(record) === key && this.#underWay.value.has(record.key),
    );
    return isUnderWay || this.#stale.value.has(key ?? '');
  }

  /** Something was sent that may have changed any memory. */
  sent(): void {
    this.#stale.value = new Set(this.#readings.peek().keys());
  }

  /** Calls back after each fresh reading. */
  onRead(callback: (reading: FreshReading) => void): void {
    this.#onRead = callback;
  }

  /**
   * Takes in a fresh reading of a memory of the connected timer. It ends every uncertainty that it explains. A reading
   * that neither the state before a write nor its goal explains ends nothing: the pilot has to say whether this is
   * another timer.
   * @param verified whether it is the read back of a write and equals its goal.
   * @returns `completed` when it shows that an interrupted write has arrived completely; `tried` when it shows what
   * became of a position that was sent while the servos followed.
   */
  read(program: TimerProgram, at = Date.now(), verified = false): 'completed' | 'tried' | null {
    const simulated = this.#timer.peek()?.simulated ?? false;
    const key = programKey(program, simulated);
    let shown: 'completed' | 'tried' | null = null;
    const before = this.#readings.peek().get(key)?.program;
    let expected = verified || !before || isSame(before, program);
    batch(() => {
      this.#readings.value = new Map(this.#readings.value).set(key, { state: 'read', program, at, verified });
      this.#stale.value = new Set([...this.#stale.peek()].filter((each) => each !== key));
      for (const record of this.#recordsOf(key)) {
        if (this.isOfOther(record.key)) continue;
        const { extent } = partWritten(record.before, record.goal, program);
        if (extent === 'foreign') continue;
        expected = true;
        const wasUnderWay = this.#leave(record.key);
        if (extent === 'all' || record.tried) void this.#records.delete(record.key);
        else if (record.seenAt === null) void this.#records.save({ ...record, seenAt: at });
        if (wasUnderWay) continue;
        if (record.tried) shown = 'tried';
        else if (extent === 'all') shown = 'completed';
      }
      this.#onRead({ program, at, expected });
    });
    return shown;
  }

  /**
   * Takes in a reading of an earlier page, as it was stored with the work on it.
   * It explains nothing, because no timer was asked.
   */
  remember(program: TimerProgram, at: number): void {
    const key = programKey(program, this.#timer.peek()?.simulated ?? false);
    if (this.#readings.peek().has(key)) return;
    this.#readings.value = new Map(this.#readings.value).set(key, { state: 'read', program, at, verified: false });
  }

  /**
   * Begins a change of a memory. Wait for it before its first byte goes out. A second change of the same memory
   * replaces the first if nobody has seen the end of that; `before` must then be what the timer holds, as far as it has
   * acknowledged it.
   * @param tried whether the servos follow, so that there is no write which could be finished.
   * @returns false when the browser does not keep the record: then only this page remembers.
   */
  async begin(before: TimerProgram, goal: TimerProgram, tried = false): Promise<boolean> {
    const simulated = this.#timer.peek()?.simulated ?? false;
    const program = programKey(before, simulated);
    const known = this.of(before.memory);
    const readAt = known.state === 'read' ? known.at : null;
    const under = this.#recordsOf(program).find(({ key }) => this.#underWay.peek().has(key));
    this.#lastStart = Math.max(Date.now(), this.#lastStart + 1);
    const startedAt = under?.startedAt ?? this.#lastStart;
    const key = under?.key ?? `${program}@${startedAt}`;
    // A write that a reading has explained can no longer be finished: the memory is about to hold something else.
    const over = this.#recordsOf(program).filter((record) => record.key !== key && record.seenAt !== null);
    batch(() => {
      for (const record of over) void this.#records.delete(record.key);
      this.#underWay.value = new Map(this.#underWay.value).set(key, false);
    });
    return await this.#records.save({
      kind: 'write',
      key,
      startedAt,
      before,
      goal,
      readAt,
      seenAt: null,
      ...(tried ? { tried } : {}),
    });
  }

  /** Values that were meant for another memory may be in this one: what was last read of it no longer counts. */
  doubt(memory: number): void {
    this.#unread(this.#keyOf(memory));
  }

  /**
   * The timer has acknowledged the whole change in this memory. That is no reading: the record stays, and if the
   * connection is lost before a reading, the memory is uncertain.
   */
  acknowledged(memory: number | null): void {
    const keys = this.#underWayIn(memory);
    if (keys.length === 0) return;
    this.#underWay.value = new Map([...this.#underWay.value, ...keys.map((key): [string, boolean] => [key, true])]);
  }

  /** The end of a change was seen, or nothing was sent: the memory holds what its last reading gave. */
  async ended(before: TimerProgram): Promise<void> {
    const keys = this.#underWayIn(before.memory);
    await Promise.all(keys.map((key) => this.forget(key)));
  }

  /** A job has ended. Changes that it began, and whose end nobody has seen, are cut off. */
  jobOver(): void {
    this.#cut((isAcknowledged) => !isAcknowledged);
  }

  /**
   * The connection has ended. Changes that were acknowledged but never read are cut off.
   * A running job comes to its own end.
   */
  connectionOver(): void {
    this.#cut((isAcknowledged) => isAcknowledged);
  }

  /** A timer was connected; it may be any. Nothing is known about it but interrupted writes on timers of its kind. */
  anotherTimer(): void {
    batch(() => {
      this.#readings.value = new Map();
      this.#ofOthers.value = new Set();
    });
  }

  /**
   * The pilot says that the connected timer is not the one of this record, so its readings explain nothing. Until the
   * next connection.
   */
  notThisTimer(key: string): void {
    batch(() => {
      this.#ofOthers.value = new Set(this.#ofOthers.value).add(key);
      const record = this.writes.peek().find((each) => each.key === key);
      if (record && record.seenAt !== null) void this.#records.save({ ...record, seenAt: null });
    });
  }

  /** Whether the pilot has said that the connected timer is not the one of this record. */
  isOfOther(key: string): boolean {
    return this.#ofOthers.value.has(key);
  }

  /**
   * The pilot says that nothing more can be found out about this record:
   * it was read elsewhere or settled, or the timer is gone.
   */
  forget(key: string): Promise<void> {
    return batch(() => {
      this.#leave(key);
      return this.#records.delete(key);
    });
  }

  /** Cuts off changes whose result no reading has shown: their memories are uncertain from now on. */
  #cut(which: (isAcknowledged: boolean) => boolean): void {
    const under = this.#underWay.peek();
    batch(() => {
      for (const record of this.#records.writes.peek()) {
        const isAcknowledged = under.get(record.key);
        if (isAcknowledged === undefined || !which(isAcknowledged)) continue;
        this.#leave(record.key);
        this.#unread(memoryKey(record));
      }
    });
  }

  /** What was last read of this memory no longer counts. */
  #unread(key: string | null): void {
    this.#readings.value = new Map([...this.#readings.peek()].filter(([read]) => read !== key));
  }

  /** The key of a memory of the timer at hand; null without one. */
  #keyOf(memory: number | null): string | null {
    const timer = this.#timer.value;
    return timer && programKey({ identity: timer.identity, memory }, timer.simulated);
  }

  /** @returns whether it was in progress. */
  #leave(key: string): boolean {
    const rest = new Map(this.#underWay.peek());
    const was = rest.delete(key);
    if (was) this.#underWay.value = rest;
    return was;
  }

  #underWayIn(memory: number | null): string[] {
    const under = this.#underWay.peek();
    const records = this.#records.writes.peek();
    return records.filter(({ key, before }) => under.has(key) && before.memory === memory).map(({ key }) => key);
  }

  #recordsOf(program: string): UnfinishedWrite[] {
    return this.#records.writes.peek().filter((record) => memoryKey(record) === program);
  }
}

/** An idle throttle that one of them does not know does not count. */
function isSame(before: TimerProgram, now: TimerProgram): boolean {
  if (!sameLayout(before.identity, now.identity)) return false;
  return differences(before, now).every(({ from, to }) => from === null || to === null);
}

/** Whether a record belongs to the simulated timer. */
export function isSimulated({ key }: { readonly key: string }): boolean {
  return key.startsWith('simulated/');
}

/** The key of the memory into which a write went: see `programKey`. */
export function memoryKey(record: UnfinishedWrite): string {
  return programKey(record.before, isSimulated(record));
}
