import { batch, computed, effect, type ReadonlySignal, signal, untracked } from '@preact/signals';
import { TimerError } from '../../client/index.js';
import {
  type Change,
  differences,
  fieldKey,
  type ProgramField,
  sameLayout,
  type TimerProgram,
} from '../../program/index.js';
import { MAX_POSITION } from '../../protocol/index.js';
import type { FieldValue } from '../edit/edits.js';
import { trialsSchema } from '../storage/records.js';
import { loadSetting, saveSetting } from '../storage/settings.js';
import type { Session } from './session.js';

/** What may happen on the bench when the timer is told so. */
export type BenchAction = { readonly kind: 'move'; readonly column: number } | { readonly kind: 'unlock' | 'jump' };

/** What is known of the last thing that was done: that it was acknowledged, or only that it may have been carried out all the same. */
export interface Done {
  readonly action: BenchAction;
  readonly certain: boolean;
}

/** What was tried while the servos followed. */
export interface Trial {
  /** What the timer held before, by a fresh read; it is among the backups. */
  readonly before: TimerProgram;
  /** The keys of the positions that have changed in the editor since. */
  readonly touched: ReadonlySet<string>;
}

type Position = Extract<ProgramField, { kind: 'position' }>;

/** Under which name the trials are kept. */
const TRIALS = 'trials';

/** While digits come no closer than this, in milliseconds, a number counts as typed: 6 is not sent on the way to 65. */
const TYPED = 600;

/** Servos and motor, moved from the page: only what the pilot asks for, one command at a time. */
export class Bench {
  /** The last thing that was done with the timer that is connected. */
  readonly done = signal<Done | null>(null, { name: 'done' });
  /** Whether each position that changes is stored in the timer at once. */
  readonly following: ReadonlySignal<boolean>;
  /** What was tried since the servos began to follow, until the pilot keeps it or it is put back. */
  readonly trial: ReadonlySignal<Trial | null>;
  /** The positions that the timer holds otherwise than before the trial. */
  readonly tried: ReadonlySignal<readonly Change[]>;
  /** Whether anything may be begun: a timer that does nothing else, and a pilot who has said that it is safe. */
  readonly ready: ReadonlySignal<boolean>;
  readonly #following = signal(false, { name: 'following' });
  /** By what was worked on, see `workKey`; through a reload too. */
  readonly #trials = signal<ReadonlyMap<string, Trial>>(keptTrials() ?? new Map(), { name: 'trials' });
  /** What the servos follow. */
  #followed: string | null = null;
  readonly #session: Session;
  readonly #isElsewhere: () => boolean;
  #starting = false;
  #seen: TimerProgram | null = null;
  #typing: ReturnType<typeof setTimeout> | undefined;
  /** Counted up when typed digits have rested long enough. */
  readonly #rested = signal(0);
  readonly #changedAt = new Map<string, number>();

  /** @param isElsewhere whether a write or a job over several memories is at work. */
  constructor(session: Session, isElsewhere: () => boolean) {
    this.#session = session;
    this.#isElsewhere = isElsewhere;
    this.following = this.#following;
    this.trial = computed(() => {
      const held = session.editor.baseline.value;
      const trial = held && this.#trials.value.get(this.#keyOf(held));
      // What was kept may be damaged.
      return trial && sameLayout(trial.before.identity, held.identity) ? trial : null;
    });
    this.ready = computed(
      () => session.connection.value !== null && session.safe.value && !session.busy.value && !isElsewhere(),
    );
    this.tried = computed(() => {
      const trial = this.trial.value;
      const held = session.editor.baseline.value;
      if (!trial || !held) return [];
      return differences(trial.before, held).filter(({ field }) => trial.touched.has(fieldKey(field)));
    });
    session.connection.subscribe(() => {
      this.#starting = false;
      batch(() => {
        this.#following.value = false;
        // What may have happened is said until something else is done: the timer may be back before it was read.
        if (this.done.peek()?.certain) this.done.value = null;
      });
    });
    session.servoMoves.count.subscribe(() => {
      this.done.value = null;
    });
    effect(() => this.#follow());
    effect(() => {
      // A reading says that a write has put it back, or that nothing was stored at all.
      const isOver = !this.#following.value && session.editor.fresh.value && this.tried.value.length === 0;
      if (isOver && this.trial.value) untracked(() => this.#setTrial(null));
    });
  }

  /** Moves the servos to a column, 0 start to NF. @returns whether the timer has acknowledged it. */
  async moveTo(column: number): Promise<boolean> {
    return await this.#act({ kind: 'move', column });
  }

  /** Frees the motor of a class Q timer: a propeller may start. */
  async unlock(): Promise<boolean> {
    return this.#session.editor.working.value?.identity.timerClass === 'Q' && (await this.#act({ kind: 'unlock' }));
  }

  /** Sends the jump, whose effect is not documented. */
  async jump(): Promise<boolean> {
    return await this.#act({ kind: 'jump' });
  }

  /** Reads afresh, keeps a backup, and from then on stores each position that changes. Edits from before are not stored. */
  async follow(): Promise<void> {
    const { editor, backups, simulated } = this.#session;
    if (!this.ready.value || this.#following.value || this.tried.value.length > 0) return;
    this.#starting = true;
    if (!(await this.#session.read())) return;
    const before = editor.baseline.value;
    if (!before) return;
    await backups.add(before, 'write', simulated.value).catch(() => this.#session.say('not-kept'));
    // In the meantime the tab may have been hidden, or something else begun.
    if (!this.#starting || !this.ready.value) return;
    batch(() => {
      this.#seen = editor.working.value;
      this.#followed = this.#keyOf(before);
      this.#setTrial({ before, touched: new Set() });
      this.#following.value = true;
    });
  }

  /** Lets the command under way come to its end and reads what the timer holds now. */
  async stopFollowing(): Promise<void> {
    this.#starting = false;
    if (!this.#following.value) return;
    this.#following.value = false;
    clearTimeout(this.#typing);
    if (this.#session.busy.value) await this.#idle();
    if (this.#session.connection.value) await this.#session.read();
  }

  /** What was tried stays in the timer, and on the screen. */
  keep(): void {
    const { editor } = this.#session;
    const tried = new Set(this.tried.value.map(({ field }) => fieldKey(field)));
    const putBack = editor.changes.value.map(({ field }) => field).filter((field) => tried.has(fieldKey(field)));
    batch(() => {
      this.#setTrial(null);
      if (putBack.length > 0) editor.revertFields(putBack, { code: 'keep-tried', params: {} });
    });
  }

  /** The values that bring back what the timer held before, for the editor and a write. */
  takeBack(): readonly FieldValue[] {
    return this.tried.value.flatMap(({ field, from }) => (from === null ? [] : [{ field, value: from }]));
  }

  async #act(action: BenchAction): Promise<boolean> {
    if (!this.ready.value) return false;
    this.done.value = null;
    return await this.#session.run('bench', null, async ({ client }, options) => {
      try {
        if (action.kind === 'move') await client.moveToFunction(action.column, options);
        else if (action.kind === 'unlock') await client.unlockMotor(options);
        else await client.jump(options);
        this.done.value = { action, certain: true };
      } catch (error) {
        const isSent = error instanceof TimerError && (error.code === 'port-lost' || (error.details.sent ?? 0) > 0);
        if (isSent) this.done.value = { action, certain: false };
        throw error;
      }
    });
  }

  /** Finds the next position to send, whenever something has changed or a command has come to its end. */
  #follow(): void {
    if (!this.#following.value) return;
    const { editor, connection, busy, memoryOpen } = this.#session;
    const trial = this.trial.value;
    const working = editor.working.value;
    void this.#rested.value;
    // While another memory is being selected it is open where a position would be stored.
    if (memoryOpen.value || !trial || !working || !connection.value || this.#keyOf(working) !== this.#followed) {
      this.#following.value = false;
      return;
    }
    this.#note(trial, working);
    if (busy.value || this.#isElsewhere()) return;
    const due = this.#due(editor.changes.value);
    if (due) untracked(() => void this.#send(due));
  }

  /** Notes which positions have changed, and when. */
  #note(trial: Trial, working: TimerProgram): void {
    const before = this.#seen;
    this.#seen = working;
    if (!before || before === working || !sameLayout(before.identity, working.identity)) return;
    const changed = differences(before, working).map(({ field }) => fieldKey(field));
    for (const key of changed) this.#changedAt.set(key, performance.now());
    const touched = new Set([...trial.touched, ...changed]);
    if (touched.size > trial.touched.size) this.#setTrial({ ...trial, touched });
  }

  #due(changes: readonly Change[]): { field: Position; value: number } | null {
    clearTimeout(this.#typing);
    const touched = this.trial.value?.touched;
    let wait = Number.POSITIVE_INFINITY;
    for (const { field, to } of changes) {
      if (field.kind !== 'position' || to === null || to < 0 || to > MAX_POSITION) continue;
      // A value that stands behind a text that is none was not asked for.
      if (!touched?.has(fieldKey(field)) || this.#session.editor.unreadable.value.has(fieldKey(field))) continue;
      const rest = this.#session.editor.isTyped(field) ? this.#restOf(field) : 0;
      if (rest <= 0) return { field, value: to };
      wait = Math.min(wait, rest);
    }
    if (wait < Number.POSITIVE_INFINITY) this.#typing = setTimeout(() => this.#rested.value++, wait);
    return null;
  }

  #restOf(field: Position): number {
    return (this.#changedAt.get(fieldKey(field)) ?? 0) + TYPED - performance.now();
  }

  async #send({ field, value }: { field: Position; value: number }): Promise<void> {
    const { editor } = this.#session;
    const good = await this.#session.run('bench', null, async ({ client }, options) => {
      editor.fresh.value = false;
      await client.setPosition(field.servo, field.column, value, options);
      editor.acknowledge(field, value);
    });
    // What the timer holds now is not known: nothing more is sent, and it is read.
    if (!good) await this.stopFollowing();
  }

  /** Settles when the job under way has ended. */
  #idle(): Promise<void> {
    return new Promise((resolve) => {
      const stop = this.#session.busy.subscribe((busy) => {
        if (busy) return;
        queueMicrotask(() => {
          stop();
          resolve();
        });
      });
    });
  }

  #keyOf(program: TimerProgram): string {
    return this.#session.workKey(program);
  }

  /** Keeps the trial of what the timer holds now, or ends it. */
  #setTrial(trial: Trial | null): void {
    const held = this.#session.editor.baseline.value;
    if (!held) return;
    // Other tabs keep theirs in the same place.
    const trials = new Map(keptTrials() ?? this.#trials.value);
    if (trial) trials.set(this.#keyOf(held), trial);
    else trials.delete(this.#keyOf(held));
    this.#trials.value = trials;
    const kept = [...trials].map(([key, { before, touched }]) => ({ key, before, touched: [...touched] }));
    saveSetting(TRIALS, kept);
  }
}

/** Null where nothing is kept. */
function keptTrials(): ReadonlyMap<string, Trial> | null {
  const kept = loadSetting(TRIALS, trialsSchema);
  return kept && new Map(kept.map(({ key, before, touched }) => [key, { before, touched: new Set(touched) }]));
}
