import { batch, computed, effect, type ReadonlySignal, signal, untracked } from '@preact/signals';
import { fieldKey, type ProgramField, type TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { withValues } from '../editing/edit.js';
import type { JobContext, JobKind } from '../timer/job-runner.js';
import type { Trials } from '../timer/trials.js';
import type { Session } from '../work/session.js';
import type { Bench, BenchParts } from './bench.js';
import { FollowedEdits, type Position } from './followed-edits.js';
import { isProof, readBack, type Unlike } from './taken.js';

/**
 * Why the servos no longer follow, when the pilot did not end it. `over`: the page went out of sight, another job has
 * the wire, the pilot no longer says that it is safe, or the connection ended. `memory`: another memory is current, or
 * was asked for. `failed`: a command failed. `strayed`: the reading at the end shows that another memory became
 * current, which may have taken positions. `unlike`: a reading shows that the timer does not do what it acknowledges.
 */
export type EndReason = 'over' | 'memory' | 'failed' | 'strayed' | 'unlike';

/** How following ended. */
interface Ended {
  readonly reason: EndReason;
  /** What the reading after the first position has shown, where the timer did something else. */
  readonly unlike: Unlike | null;
}

/** What the servos follow, from the beginning to the end. */
interface Following {
  readonly connection: TimerConnection;
  /** Which program it is: see `OnScreen.keyOf`. */
  readonly key: string;
  /** Whether a position was sent. */
  hasStored: boolean;
  /** Whether a reading has shown that the timer takes positions as it says. */
  isProven: boolean;
}

/**
 * Jobs that do not end it: those of the bench, and a frame by hand, which decides itself whether it may move the
 * servos. Neither reads anything.
 */
const BESIDE: ReadonlySet<JobKind> = new Set(['bench', 'frame']);

type FollowParts = BenchParts & Pick<Session, 'backups' | 'knowledge' | 'notices' | 'reader' | 'simulated' | 'trials'>;

/**
 * Servos that follow the fields. A changed position is stored at once, and its servo moves, for the function where the
 * servos stand. For any other function it waits until the pilot moves the servos there, or writes. All of this belongs
 * to one connection.
 */
export class Follow {
  /** Whether the servos follow. */
  readonly on = computed(() => this.#following.value !== null);
  /** Whether the servos follow and a position is still on its way. */
  readonly isBehind = computed(() => this.on.value && !this.#bench.ready.value);
  /** Whether the timer is being read and backed up, which comes before following. */
  readonly starting = computed(() => this.#start.value !== null);
  /** The functions with changed positions at which the servos do not stand. */
  readonly awaited: ReadonlySignal<ReadonlySet<number>> = computed(() => {
    const slots = this.on.value ? this.#edits.pending().map(({ field }) => field.slot) : [];
    return new Set(slots.filter((slot) => slot !== this.#bench.stand.at.value));
  });
  /** The positions that were tried and not yet kept or put back. */
  readonly trials: Trials;
  /**
   * How following ended. Null once it begins again, once the pilot has read it, and when the pilot ended it. Only this
   * model writes it.
   */
  readonly ended = signal<Ended | null>(null);
  readonly #following = signal<Following | null>(null, { name: 'following' });
  /** Stands for the start in progress; another one is another object. */
  readonly #start = signal<object | null>(null, { name: 'start' });
  readonly #parts: FollowParts;
  readonly #bench: Bench;
  /** The function to which the pilot has sent the servos. */
  readonly #wanted = signal<number | null>(null, { name: 'wanted' });
  readonly #edits: FollowedEdits;
  /** Ends waiting for the reading that says in which memory the positions are. */
  #unwatch: () => void = () => {};

  constructor(parts: FollowParts, bench: Bench) {
    const { editor } = parts;
    this.#parts = parts;
    this.#bench = bench;
    this.#edits = new FollowedEdits(editor);
    this.trials = parts.trials;
    parts.connection.subscribe(() => void this.stop('over'));
    parts.safety.confirmed.subscribe((safe) => void (safe || this.stop('over')));
    parts.servoMoves.count.subscribe(() => void this.stop('over'));
    effect(() => this.trials.setTrying(this.on.value));
    effect(() => this.#follow());
    effect(() => {
      // A reading shows that a write has put everything back, or that nothing was stored at all.
      const isOver = !this.on.value && editor.fresh.value && this.trials.tried.value.length === 0;
      if (isOver && this.trials.current.value) untracked(() => this.trials.set(null));
    });
  }

  /**
   * Reads the timer afresh and keeps a backup: without one it does not begin. From then on it stores each position that
   * changes, but no earlier edit.
   */
  async start(): Promise<void> {
    const { editor, backups, simulated, connection, notices } = this.#parts;
    const { value: bound } = connection;
    if (!bound || !this.#bench.ready.value || this.starting.value || this.on.value) return;
    if (this.trials.tried.value.length > 0) return;
    const start = {};
    batch(() => {
      this.#start.value = start;
      this.ended.value = null;
    });
    // By now the tab may be hidden, the timer lost, or the start called off.
    const isOff = (): boolean => this.#start.peek() !== start || connection.peek() !== bound;
    try {
      if (!(await this.#parts.reader.read()) || isOff()) return;
      const before = editor.baseline.value;
      if (!before) return;
      const kept = await backups.add(before, 'write', simulated.value);
      if (isOff()) return;
      if (!kept) return notices.say('not-backed-up');
      // The backup must be of what the timer holds now.
      if (!this.#bench.ready.value || !editor.fresh.value || editor.baseline.value !== before) return;
      batch(() => {
        this.#edits.begin();
        this.trials.set({ before, touched: new Set() });
        const key = this.#parts.onScreen.keyOf(before);
        this.#following.value = { connection: bound, key, hasStored: false, isProven: false };
      });
    } finally {
      if (this.#start.peek() === start) this.#start.value = null;
    }
  }

  /**
   * Moves the servos to a function with waiting positions, as soon as the command in progress has ended.
   * Only while they follow.
   */
  bring(slot: number): void {
    if (this.on.value) this.#wanted.value = slot;
  }

  /** The first position of a function that waits for the servos. */
  waitingAt(slot: number): ProgramField | null {
    return this.#edits.pending().find(({ field }) => field.slot === slot)?.field ?? null;
  }

  /** The pilot has read the message. */
  dismissEnd(): void {
    this.ended.value = null;
  }

  /** The positions that were tried stay in the timer and on the screen. */
  keep(): void {
    const { editor } = this.#parts;
    const tried = new Set(this.trials.tried.value.map(({ field }) => fieldKey(field)));
    const putBack = editor.changes.value.map(({ field }) => field).filter((field) => tried.has(fieldKey(field)));
    batch(() => {
      this.trials.set(null);
      if (putBack.length > 0) editor.revertFields({ code: 'keep-tried', params: {} }, putBack);
    });
  }

  /**
   * Ends following: waits for the command in progress, then reads what the timer holds.
   * @param reason null when the pilot ended it and needs no message.
   */
  async stop(reason: EndReason | null = null, unlike: Unlike | null = null): Promise<void> {
    const { connection, editor, runner } = this.#parts;
    this.#start.value = null;
    const following = this.#following.peek();
    if (!following) return;
    const held = editor.baseline.peek();
    this.#edits.end();
    batch(() => {
      this.#following.value = null;
      this.#wanted.value = null;
      this.ended.value = reason && { reason, unlike };
    });
    if (held && following.hasStored && !editor.fresh.peek()) this.#watch(held, following.connection);
    // Any other job reads the timer itself.
    const kind = runner.job.peek()?.kind ?? 'bench';
    if (!BESIDE.has(kind)) return;
    if (runner.busy.peek()) await runner.ended();
    if (connection.peek() === following.connection) await this.#parts.reader.read();
  }

  /**
   * A position goes into the memory that is current, whichever the page believes that to be. The first reading after
   * the last position says which it was: a job that selects another memory reads this one before, or restores it.
   */
  #watch(held: TimerProgram, bound: TimerConnection): void {
    const { connection, editor, nextFlight } = this.#parts;
    this.#unwatch();
    this.#unwatch = effect(() => {
      if (connection.value !== bound) return this.#unwatch();
      const now = editor.baseline.value;
      // A reading on a round trip through other memories does not say which one was current.
      if (!editor.fresh.value || nextFlight.open.value || !now) return;
      this.#unwatch();
      if (now.memory !== held.memory) this.ended.value = { reason: 'strayed', unlike: null };
    });
  }

  /** Decides what to do next, after each change and each finished command. */
  #follow(): void {
    const following = this.#following.value;
    if (!following) return;
    const reason = this.#reasonToEnd(following);
    if (reason) {
      untracked(() => void this.stop(reason));
      return;
    }
    this.#edits.note();
    const due = this.#edits.due();
    const at = this.#bench.stand.at.value;
    const next = this.#wanted.value ?? (due.some(({ field }) => field.slot === at) ? at : null);
    if (next !== null && this.#bench.ready.value) untracked(() => void this.#go(next));
  }

  #reasonToEnd({ connection, key }: Following): EndReason | null {
    const { editor, runner, nextFlight, safety, onScreen } = this.#parts;
    const job = runner.job.value;
    const working = editor.working.value;
    if (this.#parts.connection.value !== connection) return 'over';
    if (!safety.confirmed.value) return 'over';
    // While another memory is being selected, nobody knows in which one a position would be stored.
    if (job?.kind === 'select') return 'memory';
    if (job && !BESIDE.has(job.kind)) return 'over';
    const isSame = working && this.trials.current.value && onScreen.keyOf(working) === key;
    return nextFlight.open.value || !isSame ? 'memory' : null;
  }

  /**
   * Moves the servos to a function, unless they stand there.
   * Stores the positions that are due, and moves the servos to them.
   */
  async #go(slot: number): Promise<void> {
    const { stand } = this.#bench;
    await this.#parts.runner.run('bench', async (connection, options) => {
      // If following has ended in the meantime, the next command is not sent. The client itself checks for a stop.
      const isOff = (): boolean => this.#following.peek()?.connection !== connection;
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
        // Nobody knows whether storing alone has moved the servos (rows 15 and 17 of docs/protocol.md).
        if (isOff()) stand.lose();
        else await move();
      } catch (error) {
        stand.lose();
        void this.stop(this.#parts.connection.peek() === connection ? 'failed' : 'over');
        throw error;
      }
    });
  }

  /** Stores the present position of a field, where the servos stand. */
  async #store(field: Position, connection: TimerConnection, options: JobContext): Promise<void> {
    const { editor, knowledge } = this.#parts;
    const pending = this.#edits.pending().find((other) => fieldKey(other.field) === fieldKey(field));
    const trial = this.trials.current.peek();
    const before = editor.baseline.peek();
    const following = this.#following.peek();
    if (!pending || !trial || !before || !following) return;
    // Kept before the first byte goes out: the position may be stored even without an answer.
    this.trials.set({ ...trial, touched: new Set([...trial.touched, fieldKey(field)]) });
    await knowledge.begin(before, withValues(before, [pending]), true);
    options.stillOn();
    if (this.#following.peek() !== following) return;
    editor.sent();
    following.hasStored = true;
    await connection.client.setPosition(field, pending.value, options);
    // An acknowledgement is no reading. What no reading has confirmed stays a change on the screen.
    const unlike = following.isProven ? null : await readBack(connection, options, before, pending);
    if (editor.baseline.peek() !== before) return;
    if (unlike) {
      const changed = unlike.beside.map((change) => fieldKey(change.field));
      this.trials.set({ ...trial, touched: new Set([...trial.touched, fieldKey(field), ...changed]) });
      const { held } = unlike;
      const reason = held.memory === before.memory ? 'unlike' : 'strayed';
      if (reason === 'unlike') {
        // Nothing of it is open: it was read back.
        void knowledge.ended(before);
        batch(() => {
          knowledge.read(held, Date.now());
          editor.rebase(held);
        });
      }
      // The pilot may have ended it in the meantime, and has to know all the same.
      if (this.#following.peek() === following) void this.stop(reason, unlike);
      else this.ended.value = { reason, unlike };
      return;
    }
    following.isProven ||= isProof(pending);
    batch(() => {
      knowledge.acknowledged(before.memory);
      editor.acknowledge(field, pending.value);
      this.#bench.stand.moved(connection, field.slot);
    });
  }
}
