import { batch, computed, effect, type ReadonlySignal, signal, untracked } from '@preact/signals';
import { fieldKey, type ProgramField, type TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { withValues } from '../editing/edit.js';
import type { JobContext, JobKind } from '../session/job-runner.js';
import type { Session } from '../session/session.js';
import { withinLimit } from '../storage/limit.js';
import type { Bench } from './bench.js';
import { FollowedEdits, type Position } from './followed-edits.js';
import { Trials } from './trials.js';

/**
 * Why the servos no longer follow, when it was not the pilot who ended it: the page went out of sight, another job took
 * the wire, another memory is current or asked for, it is no longer said to be safe, the connection ended, or a command
 * came to no good end.
 */
export type EndReason = 'hidden' | 'job' | 'memory' | 'unsafe' | 'lost' | 'failed';

/** How following ended. */
export interface Ended {
  readonly reason: EndReason;
  /** What was taken for what the timer held by then. */
  readonly held: TimerProgram | null;
}

/**
 * Jobs that do not end it: of its own kind, and a frame by hand, which says itself whether it may move the servos. They
 * read nothing.
 */
const BESIDE: ReadonlySet<JobKind> = new Set(['bench', 'frame']);

/**
 * Servos that follow the fields. A position that changes is stored at once and its servo moved, for the function where
 * the servos stand; for any other function it waits until the pilot sends them there, or for a write. It all belongs to
 * one connection.
 */
export class Follow {
  /** Whether the servos follow. */
  readonly on: ReadonlySignal<boolean>;
  /** Whether they go to each function that is edited. Off whenever following begins. */
  readonly going: ReadonlySignal<boolean>;
  /** The timer is read and backed up before they follow. */
  readonly starting: ReadonlySignal<boolean>;
  /** The backup could not be kept: it is asked whether they shall follow anyway. */
  readonly unkept: ReadonlySignal<boolean>;
  /** How it ended, until it begins again or the pilot has read it; null too when he has ended it. */
  readonly ended: ReadonlySignal<Ended | null>;
  /** Whether the timer was read since it ended. */
  readonly endRead: ReadonlySignal<boolean>;
  /** The functions of which positions have changed while the servos stand elsewhere. */
  readonly awaited: ReadonlySignal<ReadonlySet<number>>;
  /** Whether positions wait for a write that were edited before it began. */
  readonly hasEarlier: ReadonlySignal<boolean>;
  /** What was tried, until the pilot keeps it or it is put back. */
  readonly trials: Trials;
  readonly #on = signal(false, { name: 'following' });
  readonly #going = signal(false, { name: 'going' });
  /** The connection on which it is about to begin. */
  readonly #start = signal<{ readonly connection: TimerConnection } | null>(null, { name: 'start' });
  /** What the timer holds, of which no backup was kept. */
  readonly #unkept = signal<TimerProgram | null>(null, { name: 'unkept' });
  readonly #ended = signal<Ended | null>(null, { name: 'ended' });
  readonly #session: Session;
  readonly #bench: Bench;
  /** What is followed, and on which connection. */
  #followed: string | null = null;
  #bound: TimerConnection | null = null;
  /** The function to which the pilot has sent the servos. */
  readonly #wanted = signal<number | null>(null, { name: 'wanted' });
  readonly #edits: FollowedEdits;
  /** Whether the browser has kept what was stored, each before its first byte. */
  #isKept = true;

  constructor(session: Session, bench: Bench) {
    const { editor } = session;
    this.#session = session;
    this.#bench = bench;
    this.#edits = new FollowedEdits(editor);
    this.trials = new Trials(editor.baseline, (program) => session.onScreen.workKey(program));
    this.on = this.#on;
    this.going = this.#going;
    this.ended = this.#ended;
    this.starting = computed(() => this.#start.value !== null);
    this.unkept = computed(() => this.#unkept.value !== null);
    this.endRead = computed(() => editor.fresh.value && editor.baseline.value !== this.#ended.value?.held);
    this.awaited = computed(() => {
      const slots = this.#on.value ? this.#edits.pending().map(({ field }) => field.slot) : [];
      return new Set(slots.filter((slot) => slot !== bench.stand.at.value));
    });
    this.hasEarlier = this.#edits.hasEarlier;
    session.connection.subscribe(() => void this.#end('lost'));
    session.safety.confirmed.subscribe((safe) => void (safe || this.#end('unsafe')));
    session.servoMoves.count.subscribe(() => void this.#end('job'));
    effect(() => this.#follow());
    effect(() => {
      // A reading says that a write has put it back, or that nothing was stored at all.
      const isOver = !this.#on.value && editor.fresh.value && this.trials.tried.value.length === 0;
      if (isOver && this.trials.current.value) untracked(() => this.trials.set(null));
    });
  }

  /**
   * Reads afresh, keeps a backup, and from then on stores each position that changes. Edits from before are not stored.
   */
  async start(): Promise<void> {
    const { editor, backups, simulated, connection } = this.#session;
    const { value: bound } = connection;
    if (!bound || !this.#bench.ready.value || this.starting.value || this.#on.value) return;
    if (this.trials.tried.value.length > 0) return;
    const start = { connection: bound };
    batch(() => {
      this.#start.value = start;
      this.#unkept.value = null;
      this.#ended.value = null;
    });
    // In the meantime the tab may have been hidden, the timer lost, or it was called off.
    const isOff = (): boolean => this.#start.peek() !== start || connection.peek() !== bound;
    try {
      if (!(await this.#session.reader.read()) || isOff()) return;
      const before = editor.baseline.value;
      if (!before) return;
      const kept = await withinLimit(() => backups.add(before, 'write', simulated.value)).then(
        () => true,
        () => false,
      );
      if (isOff()) return;
      if (kept) this.#begin(before);
      else this.#unkept.value = before;
    } finally {
      if (this.#start.peek() === start) this.#start.value = null;
    }
  }

  /** The pilot lets the servos follow although no backup could be kept. */
  startUnkept(): void {
    const before = this.#unkept.value;
    this.#unkept.value = null;
    if (before) this.#begin(before);
  }

  /** The pilot does not want that. */
  cancelUnkept(): void {
    this.#unkept.value = null;
  }

  /** Whether the servos go to each function that is edited from now on. Only while they follow. */
  setGoing(on: boolean): void {
    this.#edits.forgetLastSlot();
    this.#going.value = on && this.#on.value;
  }

  /**
   * Moves the servos to a function of which positions wait, as soon as the command under way has ended. Only while they
   * follow.
   */
  bring(slot: number): void {
    if (this.#on.value) this.#wanted.value = slot;
  }

  /** The first position of a function that waits for the servos. */
  waitingAt(slot: number): ProgramField | null {
    return this.#edits.pending().find(({ field }) => field.slot === slot)?.field ?? null;
  }

  /**
   * Lets the command under way come to its end and reads what the timer holds now.
   * @param reason null: the pilot wants it so, and need not be told.
   */
  async stop(reason: EndReason | null = null): Promise<void> {
    await this.#end(reason);
  }

  /** The pilot has read how it ended. */
  dismissEnd(): void {
    this.#ended.value = null;
  }

  /** What was tried stays in the timer, and on the screen. */
  keep(): void {
    const { editor } = this.#session;
    const tried = new Set(this.trials.tried.value.map(({ field }) => fieldKey(field)));
    const putBack = editor.changes.value.map(({ field }) => field).filter((field) => tried.has(fieldKey(field)));
    batch(() => {
      this.trials.set(null);
      if (putBack.length > 0) editor.revertFields({ code: 'keep-tried', params: {} }, putBack);
    });
  }

  #begin(before: TimerProgram): void {
    const { editor, connection } = this.#session;
    // What is kept is what the timer holds now.
    if (!this.#bench.ready.value || !editor.fresh.value || editor.baseline.value !== before) return;
    batch(() => {
      this.#edits.begin();
      this.#bound = connection.value;
      this.#isKept = true;
      this.#followed = this.#session.onScreen.workKey(before);
      this.#wanted.value = null;
      this.trials.set({ before, touched: new Set() });
      this.#on.value = true;
    });
  }

  async #end(reason: EndReason | null): Promise<void> {
    const { connection, editor, runner } = this.#session;
    batch(() => {
      this.#start.value = null;
      this.#unkept.value = null;
    });
    if (!this.#on.peek()) return;
    const held = editor.baseline.peek();
    this.#edits.end();
    batch(() => {
      this.#on.value = false;
      this.#going.value = false;
      this.#wanted.value = null;
      this.#ended.value = reason && { reason, held };
    });
    // Another job reads by itself.
    const other = runner.job.peek();
    if (other && !BESIDE.has(other.kind)) return;
    const bound = this.#bound;
    if (runner.busy.peek()) await runner.ended();
    if (bound && connection.peek() === bound) await this.#session.reader.read();
  }

  /** Finds out what to do next, whenever something has changed or a command has come to its end. */
  #follow(): void {
    if (!this.#on.value) return;
    const reason = this.#reasonToEnd();
    if (reason) {
      untracked(() => void this.#end(reason));
      return;
    }
    this.#edits.note();
    const next = this.#next();
    if (next !== null && this.#bench.ready.value) untracked(() => void this.#go(next));
  }

  #reasonToEnd(): EndReason | null {
    const { editor, connection, runner, nextFlight, safety } = this.#session;
    const job = runner.job.value;
    const working = editor.working.value;
    if (!connection.value || connection.value !== this.#bound) return 'lost';
    if (!safety.confirmed.value) return 'unsafe';
    // While another memory is being selected it is open where a position would be stored.
    if (job?.kind === 'select') return 'memory';
    if (job && !BESIDE.has(job.kind)) return 'job';
    const isSame = working && this.trials.current.value && this.#session.onScreen.workKey(working) === this.#followed;
    return nextFlight.open.value || !isSame ? 'memory' : null;
  }

  /** The function at which there is something to do; null when there is nothing. */
  #next(): number | null {
    const due = this.#edits.due();
    const isDue = (slot: number | null): boolean => due.some(({ field }) => field.slot === slot);
    const at = this.#bench.stand.at.value;
    if (this.#wanted.value !== null) return this.#wanted.value;
    if (this.#going.value && isDue(this.#edits.lastSlot)) return this.#edits.lastSlot;
    return isDue(at) ? at : null;
  }

  /**
   * Moves the servos to a function, unless they stand there; stores what is due there; and moves them to what is stored
   * now.
   */
  async #go(slot: number): Promise<void> {
    const { stand } = this.#bench;
    await this.#session.runner.run('bench', async (connection, options) => {
      // Whatever has ended it in the meantime: the next command does not go out. Whether it was stopped the client asks
      // itself.
      const isOff = (): boolean => !this.#on.peek() || this.#bound !== connection;
      const move = () => this.#bench.carryOut({ kind: 'move', slot }, connection, options);
      this.#wanted.value = null;
      try {
        if (slot !== stand.at.peek()) await move();
        const due = this.#edits.due().filter(({ field }) => field.slot === slot);
        let stored = 0;
        for (const { field } of due) {
          if (isOff()) break;
          await this.#store(field, connection, options);
          stored++;
        }
        if (stored === 0) return;
        // It is open whether storing alone has moved them (rows 15 and 17 of the protocol page).
        if (isOff()) stand.lose();
        else await move();
      } catch (error) {
        stand.lose();
        void this.#end(this.#session.connection.peek() === connection ? 'failed' : 'lost');
        throw error;
      }
    });
  }

  /** Stores the position that a field has by now, where the servos stand. */
  async #store(field: Position, connection: TimerConnection, options: JobContext): Promise<void> {
    const { editor, knowledge } = this.#session;
    const pending = this.#edits.pending().find((other) => fieldKey(other.field) === fieldKey(field));
    const trial = this.trials.current.peek();
    const before = editor.baseline.peek();
    if (!pending || !trial || !before) return;
    // Kept before the first byte: it may be stored although no answer comes.
    this.trials.set({ ...trial, touched: new Set([...trial.touched, fieldKey(field)]) });
    const keeping = knowledge.begin(before, withValues(before, [pending]));
    // Where nothing is kept the servos must not wait for it each time.
    if (this.#isKept) this.#isKept = await keeping;
    options.stillOn();
    if (!this.#on.peek()) return;
    editor.sent();
    await connection.client.setPosition(field, pending.value, options);
    if (editor.baseline.peek() !== before) return;
    batch(() => {
      knowledge.acknowledged(before.memory);
      editor.acknowledge(field, pending.value);
      this.#bench.stand.moved(connection, field.slot);
    });
  }
}
