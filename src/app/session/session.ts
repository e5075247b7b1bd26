import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { type AssumedQuirks, type Progress, TimerError } from '../../client/index.js';
import { differences, sameLayout, type TimerProgram } from '../../program/index.js';
import type { CaptureEntry } from '../../protocol/index.js';
import {
  type LinkState,
  portKey,
  type SerialPortLike,
  type Surroundings,
  type TimerConnection,
} from '../../serial/index.js';
import type { TabNumber } from '../browser/tab-number.js';
import { replaceAll } from '../editing/edit.js';
import { Editor } from '../editing/editor.js';
import type { Backup, Draft, Storage } from '../storage/index.js';
import { Backups } from './backups.js';
import { Drafts } from './drafts.js';
import { InterruptedJobs } from './interrupted-jobs.js';
import { Knowledge } from './knowledge.js';
import { LineLog } from './line-log.js';
import { type Assumed, Link } from './link.js';
import { NextFlight } from './next-flight.js';
import type { NoteCode, Notice } from './notice.js';
import { kindKey, programKey, workKey } from './record-keys.js';
import { Safety } from './safety.js';
import { ServoMoves } from './servo-moves.js';
import { SetAside } from './set-aside.js';
import { type Standing, standingOf } from './standing.js';
import { UnfinishedRecords } from './unfinished.js';

/** A job on the wire that takes longer than a blink. */
export interface Job {
  readonly kind: 'read' | 'select' | 'look' | 'write' | 'memories' | 'bench';
  /** The memory that is being made current, or looked at; null when the job is another. */
  readonly memory: number | null;
  readonly progress: Progress | null;
  readonly stop: AbortController;
}

/** What a job is handed: the way to stop it, the ear for how far it has come, and what makes sure that it may go on. */
export interface JobOptions {
  readonly signal: AbortSignal;
  readonly onProgress: (progress: Progress) => void;
  /**
   * To be called after whatever was waited for, before the next byte: the world may have changed meanwhile.
   * @throws TimerError `closed` when the connection is no longer the one on which the job began; `aborted` when the pilot has asked to
   * stop, or has taken back that it is safe.
   */
  readonly stillOn: () => void;
}

/** How a job ended. */
export type JobEnd =
  | { readonly good: true }
  | {
      readonly good: false;
      /** What ended it; null when it did not begin, since another one holds the wire or there is none. */
      readonly error: unknown;
      /** The connection is gone, or is another: that says so itself, once. */
      readonly lost: boolean;
    };

export interface SessionOptions {
  readonly surroundings: Surroundings;
  readonly storage: Storage;
  readonly tab: TabNumber;
  readonly plugSimulated: (timerClass: 'Q' | 'B') => SerialPortLike;
  readonly plugRecording: (entries: readonly CaptureEntry[]) => SerialPortLike;
}

/** Milliseconds between two looks at what is kept, when something came back during the first. */
const LOOK_AGAIN = 1000;

/** One pilot, one wire, one program on the screen. */
export class Session {
  readonly editor = new Editor();
  readonly log: LineLog = new LineLog(() => this.connection?.peek()?.client.quirksAssumed ?? {});
  readonly backups: Backups;
  readonly aside: SetAside;
  /** What is known of what the timer holds: from this, and from nothing else, comes every word about it. */
  readonly knowledge: Knowledge;
  /** How far the program that was read last can be called what the timer holds. */
  readonly standing: ReadonlySignal<Standing>;
  readonly recovery: InterruptedJobs;
  readonly link: Link;
  readonly servoMoves: ServoMoves;
  readonly job = signal<Job | null>(null, { name: 'job' });
  readonly notice = signal<Notice | null>(null, { name: 'notice' });
  readonly safety = new Safety();
  /** It is open how this timer writes its times: the pilot has to choose before they are written. */
  readonly byteOrderOpen = signal(false, { name: 'byteOrderOpen' });
  /** None was read since the timer came, or since another one was asked for: the memory on the screen need not be the current one. */
  readonly memoryOpen = signal(false, { name: 'memoryOpen' });
  /** Which memory flies next, and whether it is the one of the time of connect. */
  readonly nextFlight = new NextFlight(this.memoryOpen);
  /** Whether the program on the screen is of the simulated timer. */
  readonly simulated = signal(false, { name: 'simulated' });
  readonly connection: ReadonlySignal<TimerConnection | null>;
  /** A job, or the way to a timer, holds the wire. */
  readonly busy: ReadonlySignal<boolean>;
  /** No other way to a timer can begin: something is under way, or waited for until the pilot stops it. */
  readonly engaged: ReadonlySignal<boolean>;
  readonly #options: SessionOptions;
  readonly #drafts: Drafts;
  #arriving: Promise<unknown> = Promise.resolve();
  #bringing: Promise<void> | null = null;
  #lookAgain = false;
  /** A way to a timer was asked for and has not begun yet. */
  readonly #setOut = signal(false, { name: 'setOut' });
  /** The timer was away, or silent, and has come back. */
  #returning = false;
  /** The timer was another tab's. */
  #inherits = false;

  constructor(options: SessionOptions) {
    this.#options = options;
    this.#drafts = new Drafts(options.storage.drafts, options.tab);
    this.backups = new Backups(options.storage.backups);
    this.aside = new SetAside(options.storage.aside);
    this.link = new Link({
      surroundings: options.surroundings,
      ports: options.storage.ports,
      onLine: this.log.add,
      onState: (state, before) => this.#follow(state, before),
    });
    this.connection = this.link.connection;
    const atHand = computed(() => {
      const connected = this.connection.value?.identity;
      if (connected) return { identity: connected, simulated: this.link.simulated.value };
      const shown = this.editor.identity.value;
      return shown && { identity: shown, simulated: this.simulated.value };
    });
    const unfinished = new UnfinishedRecords(options.storage.unfinished, options.tab);
    this.knowledge = new Knowledge(unfinished, atHand, () => options.tab.value);
    this.standing = standingOf(this.editor, this.knowledge, this.connection);
    this.recovery = new InterruptedJobs(unfinished, this.knowledge, this.backups);
    this.servoMoves = new ServoMoves(this.connection, this.safety);
    this.busy = computed(() => this.job.value !== null || this.link.busy.value || this.#setOut.value);
    this.engaged = computed(() => this.busy.value || this.link.waiting.value);
  }

  /** Keeps from now on what is typed, and brings back what a reload or a crash interrupted. Nothing on the screen waits for it. */
  async start(): Promise<void> {
    effect(() => {
      const content = this.editor.snapshot();
      const readAt = this.standing.value.at;
      if (content) this.#drafts.keep({ ...content, readAt }, this.simulated.value);
    });
    await this.bringBack();
  }

  /** Keeps at once what was typed: the page is left, or may be. */
  keepNow(): void {
    this.#drafts.flush();
  }

  /** Whether all that was typed would be there after a reload. */
  get editsKept(): ReadonlySignal<boolean> {
    return this.#drafts.kept;
  }

  /** Takes in what is kept, as far as it is not known yet, and where the pilot has not begun something else meanwhile. */
  bringBack(): Promise<void> {
    // One look at a time; what comes back meanwhile is looked for once more.
    this.#lookAgain = this.#bringing !== null;
    this.#bringing ??= this.#bringBack().finally(() => {
      this.#bringing = null;
      // Not at once: a shelf that answers one call and fails another would keep the page busy for ever.
      if (this.#lookAgain) setTimeout(() => void this.bringBack(), LOOK_AGAIN);
    });
    return this.#bringing;
  }

  async #bringBack(): Promise<void> {
    // What other tabs have under way is told by the number of this one, which comes with the edits.
    const known = this.#bringBackEdits().then(() => this.knowledge.refresh());
    await Promise.all([known, this.backups.load(), this.link.start()]);
    this.#drafts.keepAgain();
    await this.aside.load();
  }

  async #bringBackEdits(): Promise<void> {
    const wanted = (): boolean => this.editor.working.value === null && !this.engaged.value;
    const draft = await this.#drafts.latest(wanted);
    if (draft) this.#showDraft(draft);
    else if (wanted()) void this.#bringBackLate(wanted);
  }

  async #bringBackLate(wanted: () => boolean): Promise<void> {
    const draft = await this.#drafts.leftBehind(wanted);
    if (!draft) return;
    this.#showDraft(draft);
    await this.knowledge.refresh();
  }

  #showDraft(draft: Draft): void {
    // At one stroke: it must not be kept as the work on a real timer in between.
    batch(() => {
      if (!this.editor.restore(draft)) return;
      this.simulated.value = draft.simulated;
      if (typeof draft.readAt === 'number') this.knowledge.remember(draft.baseline, draft.readAt);
      this.notice.value ??= { kind: 'note', code: 'edits-restored' };
    });
  }

  /**
   * Connects to the port that was used last, or is the only one that is known, else to the one that the pilot chooses. A timer that is
   * connected and has not been read is read.
   * @param choose asks for a port in any case.
   * @returns when the timer was read, or when it has to be waited for.
   */
  async connect(choose = false): Promise<void> {
    if (!this.#options.surroundings.serial || this.engaged.value) return;
    if (this.connection.value && !choose) return void (await this.read());
    await this.#goTo(async () => {
      await this.link.refresh();
      const [first, ...more] = choose ? [] : this.link.ports.value;
      const sure = first && (more.length === 0 || this.link.recordOf(first.key));
      return sure ? () => this.link.connect(first.port) : () => this.link.choose();
    });
  }

  /** Connects to the timer that another tab has let go of, and goes on with its edits. */
  async takeOver(): Promise<void> {
    this.#inherits = true;
    await this.connect();
  }

  /** Connects to one of the ports that are known. */
  async connectTo(port: SerialPortLike): Promise<void> {
    await this.#goTo(async () => () => this.link.connect(port));
  }

  async trySimulated(timerClass: 'Q' | 'B'): Promise<void> {
    await this.#goTo(async () => {
      await this.recovery.forgetSimulated();
      return () => this.link.connectSimulated(this.#options.plugSimulated(timerClass));
    });
  }

  /** Connects to a timer that answers as another one did while its line was recorded. */
  async tryRecording(entries: readonly CaptureEntry[]): Promise<void> {
    await this.#goTo(async () => () => this.link.connectSimulated(this.#options.plugRecording(entries)));
  }

  /** Lets the pilot choose another port while a timer at this one is waited for; what is waited for stays until one is chosen. */
  async chooseAnother(): Promise<void> {
    if (this.busy.value) return;
    await this.link.choose();
    await this.#arriving;
  }

  /** Stops what is under way, lets the last request end and closes the port. What was typed stays on the screen. */
  async disconnect(): Promise<void> {
    this.job.value?.stop.abort();
    const wasOn = this.connection.value !== null;
    const closing = this.link.stop();
    batch(() => {
      this.notice.value = null;
      this.recovery.meet();
      if (wasOn && !this.editor.dirty.value) this.editor.clear();
    });
    await closing;
    await this.link.refresh();
  }

  /**
   * Reads the current memory again. Edits stay.
   * @returns whether it was read.
   */
  async read(): Promise<boolean> {
    return await this.run('read', null, async ({ client }, options) =>
      this.#show(await client.readProgram(options), options),
    );
  }

  /**
   * Makes another memory current and reads it. Edits of the one that is left are kept for when it is read again. When it is stopped or
   * fails on the way, the memory that is current by then is read.
   */
  async selectMemory(memory: number): Promise<boolean> {
    const good = await this.run('select', memory, async ({ client }, options) => {
      this.memoryOpen.value = true;
      this.nextFlight.leave(memory);
      await client.selectMemory(memory, options);
      await this.#show(await client.readProgram(options), options);
    });
    if (!good && this.memoryOpen.value && this.connection.value) {
      const { value } = this.notice;
      await this.read();
      this.notice.value ??= value;
    }
    return good;
  }

  /** The pilot has said how this timer is: it is read again that way. */
  async assume(quirks: AssumedQuirks): Promise<void> {
    if (this.busy.value) return;
    await this.link.assume(quirks);
    await this.read();
  }

  /** Takes nothing for true any more of such a timer at such a port; the one at hand is read again without. */
  async forgetAssumed(assumed: Pick<Assumed, 'portKey' | 'kind'>): Promise<void> {
    if (this.busy.value) return;
    const connection = this.connection.value;
    const wasAssumed = connection?.client.quirksAssumed;
    await this.link.forgetAssumed(assumed);
    if (connection && connection === this.connection.value && connection.client.quirksAssumed !== wasAssumed) {
      await this.read();
    }
  }

  /**
   * Runs one job on the wire and says what went wrong with it. A timer that no longer answers is waited for.
   * @returns whether it came to its end.
   */
  async run(
    kind: Job['kind'],
    memory: number | null,
    work: (connection: TimerConnection, options: JobOptions) => Promise<void>,
  ): Promise<boolean> {
    const end = await this.perform(kind, memory, work);
    // That another memory was left current is said in any case.
    const isLeft = !end.good && end.error instanceof TimerError && end.error.code === 'memory-left';
    if (!end.good && end.error !== null && (isLeft || !end.lost)) this.report(end.error);
    return end.good;
  }

  /** Runs one job on the wire, bound to the connection on which it begins, and hands back how it ended; whoever calls it says so. */
  async perform(
    kind: Job['kind'],
    memory: number | null,
    work: (connection: TimerConnection, options: JobOptions) => Promise<void>,
  ): Promise<JobEnd> {
    const connection = this.connection.value;
    if (!connection || this.busy.value) return { good: false, error: null, lost: connection === null };
    const stop = new AbortController();
    const wasSafe = this.safety.confirmed.value;
    const { strays } = connection.client;
    const begin = (progress: Progress | null): void => {
      this.job.value = { kind, memory, progress, stop };
    };
    const stillOn = (): void => {
      if (this.connection.value !== connection) throw new TimerError('closed', 'the connection is another by now');
      if (stop.signal.aborted) throw new TimerError('aborted', 'stopped on request');
      if (wasSafe && !this.safety.confirmed.value) throw new TimerError('aborted', 'it is no longer safe');
    };
    this.notice.value = null;
    begin(null);
    try {
      await work(connection, { signal: stop.signal, onProgress: begin, stillOn });
      if (connection.client.strays > strays) this.notice.value ??= { kind: 'note', code: 'strays' };
      return { good: true };
    } catch (error) {
      const lost = this.connection.value !== connection;
      // The head must not go on naming a timer that is no longer there: whoever answers is asked what it is, and read.
      if (!lost && error instanceof TimerError && error.code === 'other-timer') this.link.recheck();
      return { good: false, error, lost };
    } finally {
      this.knowledge.jobOver();
      this.job.value = null;
      void this.link.learn();
    }
  }

  /** Says that something went wrong, in the pilot's words; waits for a timer that does not answer. */
  report(error: unknown): void {
    if (!(error instanceof TimerError)) this.say('unexpected');
    else if (isRefusedSelection(error)) this.say('select-unanswered');
    else if (error.code === 'no-answer') this.link.wait();
    else if (error.code !== 'aborted' && error.code !== 'closed') {
      this.notice.value = { kind: 'timer', code: error.code };
    }
  }

  say(code: NoteCode): void {
    this.notice.value = { kind: 'note', code };
  }

  /** The pilot has seen what was said. */
  dismissNotice(): void {
    this.notice.value = null;
  }

  /** Under what the work on a program of the timer on the screen is kept. */
  workKey(program: TimerProgram): string {
    return workKey(program, this.simulated.value, this.#options.tab.value);
  }

  /** What was kept becomes what the pilot wants; nothing is written. */
  showBackup({ program }: Backup): void {
    const { working } = this.editor;
    if (!working.value || !sameLayout(working.value.identity, program.identity)) return;
    const idleThrottle = program.idleThrottle ?? working.value.idleThrottle;
    const wanted = { ...working.value, times: program.times, positions: program.positions, idleThrottle };
    this.editor.apply(replaceAll({ code: 'restore', params: {} }, wanted));
  }

  /** Goes to a timer: finds out how, goes, and settles when it was read or has to be waited for. One way at a time, also while it is waited for. */
  async #goTo(find: () => Promise<() => Promise<void>>): Promise<void> {
    if (this.engaged.value) return;
    this.notice.value = null;
    this.#setOut.value = true;
    let going: Promise<void>;
    try {
      going = (await find())();
    } finally {
      this.#setOut.value = false;
    }
    await going;
    await this.#arriving;
  }

  #follow(state: LinkState, before: LinkState): void {
    if (state.status === 'away' || (before.status === 'on' && ['waiting', 'searching'].includes(state.status))) {
      this.#returning = true;
    }
    if (state.status === 'on') {
      this.nextFlight.met(state.connection.identity, this.link.simulated.value);
      this.#arriving = this.#arrive();
      return;
    }
    // A write tells what became of it by how the connection failed.
    if (this.job.value?.kind !== 'write') this.job.value?.stop.abort();
    this.knowledge.connectionOver();
    // What is offered rests on what a timer holds that is no longer there.
    if (before.status === 'on') this.recovery.meet();
    if (state.status !== 'off') return;
    this.#returning = false;
    this.nextFlight.forget();
    if (!state.error) return;
    const port = 'info' in before ? before.info : 'port' in before ? before.port.getInfo() : null;
    this.notice.value = {
      kind: 'connection',
      code: state.error.code,
      port,
      portKey: port && portKey(port),
      bytes: state.error.bytes,
    };
    void this.link.refresh();
  }

  /** A timer has said what it is: reads what it holds. */
  async #arrive(): Promise<void> {
    batch(() => {
      this.safety.withdraw();
      this.byteOrderOpen.value = false;
      this.memoryOpen.value = true;
      this.knowledge.meet();
      this.recovery.meet();
    });
    await Promise.all([this.link.remember(), this.read()]);
  }

  /** Shows what was read, with the edits that belong to it. */
  async #show(read: TimerProgram, { stillOn }: JobOptions): Promise<void> {
    const at = Date.now();
    const simulated = this.link.simulated.value;
    const { editor } = this;
    const before = editor.working.value;
    const held = editor.baseline.value;
    const same = before !== null && programKey(before, this.simulated.value) === programKey(read, simulated);
    const otherKind =
      before !== null && kindKey(before.identity, this.simulated.value) !== kindKey(read.identity, simulated);
    const setAside = before !== null && !same && editor.dirty.value;
    // Together: a storage that does not answer is waited for once.
    const [draft] = await Promise.all([
      same ? undefined : this.#drafts.of(read, simulated, this.#inherits),
      this.knowledge.refresh(),
    ]);
    this.#inherits = false;
    stillOn();
    const returning = this.#returning;
    this.#returning = false;
    batch(() => {
      const completed = this.knowledge.read(read, at);
      this.recovery.look(read, simulated);
      // What an interrupted write explains is told by the offer to finish it, and by nothing else.
      const explained = this.recovery.offer.value?.kind === 'write';
      if (!same) editor.clear();
      if (draft) editor.restore(draft);
      const moved = editor.rebase(read);
      this.memoryOpen.value = false;
      this.nextFlight.found(read.memory);
      this.byteOrderOpen.value = this.connection.value?.client.byteOrderOpen ?? false;
      this.simulated.value = simulated;
      if (completed) this.say('write-completed');
      else if (moved && !explained) this.say('edits-moved');
      else if (draft && editor.dirty.value && !explained) this.say('edits-kept');
      else if (returning && otherKind) this.say('other-kind');
      else if (setAside) this.say('edits-set-aside');
      else if (returning && same && held && !explained) {
        this.say(differences(held, read).length === 0 ? 'back-same' : 'back-changed');
      }
    });
  }
}

/** A timer that answers all else and not SETMEMORY: waiting for it would not help. */
function isRefusedSelection({ code, details }: TimerError): boolean {
  return code === 'no-answer' && details.request === 'SETMEMORY' && details.answersOthers === true;
}
