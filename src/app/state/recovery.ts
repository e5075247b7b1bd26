import { signal } from '@preact/signals';
import { type PartOfWrite, partWritten, type TimerProgram } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Keeper, Unfinished, UnfinishedWalk, UnfinishedWrite } from '../storage/index.js';
import type { Backups } from './backups.js';
import { kindKey, programKey } from './keys.js';

/** What an earlier job left behind on a timer of this kind, by a fresh read. */
export type Offer =
  /** A write into this memory, and how far it came. */
  | {
      readonly kind: 'write';
      readonly record: UnfinishedWrite;
      readonly part: PartOfWrite;
      readonly read: TimerProgram;
    }
  /** A write into another memory: what became of it can be seen when that is current. */
  | { readonly kind: 'elsewhere'; readonly record: UnfinishedWrite; readonly memory: number }
  /** A walk through the memories that did not come back to where it began. */
  | { readonly kind: 'memories'; readonly record: UnfinishedWalk; readonly current: number | null };

/**
 * Remembers each job that changes a timer from before its first byte until its end was seen. Nothing identifies a timer, so whoever
 * meets one of the same kind is told what a fresh read explains, and decides.
 */
export class Recovery {
  readonly offer = signal<Offer | null>(null, { name: 'offer' });
  readonly #keeper: Keeper<Unfinished>;
  readonly #backups: Backups;
  /** What was begun since the page was opened, also where the browser keeps nothing. */
  readonly #begun = new Map<string, Unfinished>();
  /** The pilot said that the timer at hand is another one. */
  readonly #otherTimer = new Set<string>();

  constructor(keeper: Keeper<Unfinished>, backups: Backups) {
    this.#keeper = keeper;
    this.#backups = backups;
  }

  /**
   * Keeps the goal of a write and a backup of what the timer holds. To be waited for before the first byte goes out.
   * @returns false when the browser keeps nothing: then only this page remembers.
   */
  async begin(before: TimerProgram, goal: TimerProgram, simulated: boolean): Promise<boolean> {
    const key = programKey(before, simulated);
    const record: UnfinishedWrite = { kind: 'write', key, startedAt: Date.now(), before, goal };
    this.#begun.set(key, record);
    this.offer.value = null;
    try {
      await Promise.all([this.#backups.add(before, 'write', simulated), this.#keeper.save(record)]);
      return true;
    } catch {
      return false;
    }
  }

  /** Notes which memory is current before a walk through them begins; as {@link begin}. */
  async leave(identity: Identity, home: number, simulated: boolean): Promise<boolean> {
    const key = kindKey(identity, simulated);
    const record: UnfinishedWalk = { kind: 'memories', key, startedAt: Date.now(), identity, home };
    this.#begun.set(key, record);
    return await this.#keeper.save(record).then(
      () => true,
      () => false,
    );
  }

  /** The end of a write was seen: what the timer holds is known. */
  async ended(program: TimerProgram, simulated: boolean): Promise<void> {
    await this.#forget(programKey(program, simulated));
  }

  /** The memory that was current before the walk is current again. */
  async cameHome(identity: Identity, simulated: boolean): Promise<void> {
    await this.#forget(kindKey(identity, simulated));
  }

  /** A timer was read: is there something that an earlier job left behind? A write that turns out to be complete is forgotten. */
  async look(read: TimerProgram, simulated: boolean): Promise<'completed' | null> {
    const kind = kindKey(read.identity, simulated);
    const key = programKey(read, simulated);
    const known = (await this.#all()).filter((record) => record.key === kind || record.key.startsWith(`${kind}/`));
    const walk = known.find((record) => record.kind === 'memories');
    if (walk && walk.home === read.memory) await this.#forget(walk.key);
    const write = known.filter((record) => record.kind === 'write').find((record) => record.key === key);
    const part = write && partWritten(write.before, write.goal, read);
    const completed = write && part?.extent === 'all';
    if (completed) await this.#forget(key);
    const elsewhere = known.find((record) => record.kind === 'write' && record.key !== key) as
      | UnfinishedWrite
      | undefined;
    if (walk && walk.home !== read.memory) {
      this.offer.value = { kind: 'memories', record: walk, current: read.memory };
    } else if (write && part && !completed && !this.#otherTimer.has(key)) {
      this.offer.value = { kind: 'write', record: write, part, read };
    } else if (elsewhere && elsewhere.goal.memory !== null && !this.#otherTimer.has(elsewhere.key)) {
      this.offer.value = { kind: 'elsewhere', record: elsewhere, memory: elsewhere.goal.memory };
    } else {
      this.offer.value = null;
    }
    return completed ? 'completed' : null;
  }

  /** This is another timer than the one of the interrupted job: said no more while it is connected, and kept for the right one. */
  setAside(): void {
    const { value } = this.offer;
    if (value) this.#otherTimer.add(value.record.key);
    this.offer.value = null;
  }

  /** A timer was connected: it may be any. */
  meet(): void {
    this.#otherTimer.clear();
    this.offer.value = null;
  }

  /** What was left behind is dealt with, or shall stay as it is. The backup stays. */
  async settle(): Promise<void> {
    const { value } = this.offer;
    this.offer.value = null;
    if (value) await this.#forget(value.record.key);
  }

  /** A new simulated timer knows nothing of the one before. */
  async forgetSimulated(): Promise<void> {
    const all = await this.#all();
    await Promise.all(all.filter(({ key }) => key.startsWith('simulated/')).map(({ key }) => this.#forget(key)));
  }

  async #all(): Promise<Unfinished[]> {
    const kept = await this.#keeper.all().catch(() => []);
    const begun = [...this.#begun.values()];
    return [...begun, ...kept.filter(({ key }) => !this.#begun.has(key))];
  }

  async #forget(key: string): Promise<void> {
    this.#begun.delete(key);
    // Where nothing is kept there is nothing to remove.
    await this.#keeper.remove(key).catch(() => {});
  }
}
