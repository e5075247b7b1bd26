import { batch, computed, effect, type ReadonlySignal } from '@preact/signals';
import type { AssumedQuirks } from '../../client/index.js';
import { type Model, type Setting, sameLayout, type TimerProgram } from '../../program/index.js';
import type { CaptureEntry } from '../../protocol/index.js';
import {
  type LinkState,
  portKey,
  type SerialPortLike,
  type Surroundings,
  type TimerConnection,
} from '../../serial/index.js';
import type { TabChannel } from '../browser/other-tabs.js';
import type { TabNumber } from '../browser/tab-number.js';
import { replaceAll } from '../editing/edit.js';
import { Editor } from '../editing/editor.js';
import type { Backup, Draft, Storage } from '../storage/index.js';
import { Backups } from './backups.js';
import { Drafts } from './drafts.js';
import { InterruptedJobs } from './interrupted-jobs.js';
import { JobRunner } from './job-runner.js';
import { KeptPrograms } from './kept-programs.js';
import { KeptWork } from './kept-work.js';
import { Knowledge } from './knowledge.js';
import { Library } from './library.js';
import { LineLog } from './line-log.js';
import { type Assumed, Link } from './link.js';
import { NextFlight } from './next-flight.js';
import { Notices } from './notices.js';
import { OpenSetting } from './open-setting.js';
import { Origin } from './origin.js';
import { Reader } from './reader.js';
import { Recognition } from './recognition.js';
import { kindKey, workKey } from './record-keys.js';
import { Safety } from './safety.js';
import { ServoMoves } from './servo-moves.js';
import { ServoUses } from './servo-uses.js';
import { SetAside } from './set-aside.js';
import { ShortDt } from './short-dt.js';
import { type Standing, standingOf } from './standing.js';
import { UnfinishedRecords } from './unfinished.js';

/** The classes of which there is a simulated timer. */
export const SIMULATED_CLASSES = ['Q', 'B', 'E'] as const;
export type SimulatedClass = (typeof SIMULATED_CLASSES)[number];

export interface SessionOptions {
  readonly surroundings: Surroundings;
  readonly storage: Storage;
  readonly tab: TabNumber;
  /** Between the tabs of this page, of the library; null where there is none. */
  readonly libraryChannel?: TabChannel | null;
  readonly plugSimulated: (timerClass: SimulatedClass) => SerialPortLike | Promise<SerialPortLike>;
  readonly plugRecording: (entries: readonly CaptureEntry[]) => SerialPortLike | Promise<SerialPortLike>;
}

/**
 * One pilot, one wire, one program on the screen: builds what belongs to that, and goes to a timer and away from it.
 */
export class Session {
  readonly editor = new Editor();
  readonly log: LineLog = new LineLog(() => this.connection?.peek()?.client.quirksAssumed ?? {});
  readonly backups: Backups;
  readonly aside: SetAside;
  readonly keptWork: KeptWork;
  readonly keptPrograms: KeptPrograms;
  /** The pilot's models, their settings and the flights. */
  readonly library: Library;
  /** The setting that the program on the screen belongs to, and how it is saved. */
  readonly opened: OpenSetting;
  /** What is known of what the timer holds: from this, and from nothing else, comes every word about it. */
  readonly knowledge: Knowledge;
  /** Whose timer is connected, by what it holds or by the pilot's word. */
  readonly recognition: Recognition;
  /**
   * The model of the timer that is connected; without one, of the setting that is open. Null where that is not known.
   */
  readonly modelAtHand: ReadonlySignal<Model | null>;
  /** For which model the changes on the screen were made. */
  readonly origin: Origin;
  /** How far the program that was read last can be called what the timer holds. */
  readonly standing: ReadonlySignal<Standing>;
  readonly recovery: InterruptedJobs;
  readonly link: Link;
  readonly runner: JobRunner;
  readonly notices: Notices;
  readonly safety = new Safety();
  readonly servoMoves: ServoMoves;
  /** What the servos of the model move, by the pilot's word. */
  readonly servoUses: ServoUses;
  /** Which memory flies next, and whether it is the one of the time of connect. */
  readonly nextFlight = new NextFlight();
  /** Whether a DT for trimming flies next, and what it can be put back to. */
  readonly shortDt: ShortDt;
  /** It is open how this timer writes its times: the pilot has to choose before they are written. */
  readonly byteOrderOpen: ReadonlySignal<boolean>;
  /** Whether the program on the screen is of the simulated timer. */
  readonly simulated: ReadonlySignal<boolean>;
  readonly connection: ReadonlySignal<TimerConnection | null>;
  /** No other way to a timer can begin: something is under way, or waited for until the pilot stops it. */
  readonly engaged: ReadonlySignal<boolean>;
  readonly #options: SessionOptions;
  readonly #reader: Reader;

  constructor(options: SessionOptions) {
    const { surroundings, storage, tab } = options;
    this.#options = options;
    this.backups = new Backups(storage.backups, () => this.recognition.model.peek()?.id ?? null);
    this.aside = new SetAside(storage.aside);
    this.library = new Library(storage, options.libraryChannel);
    this.link = new Link({
      surroundings,
      ports: storage.ports,
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
    const unfinished = new UnfinishedRecords(storage.unfinished, tab);
    this.knowledge = new Knowledge(unfinished, atHand, () => tab.value);
    this.recognition = new Recognition({
      library: this.library,
      knowledge: this.knowledge,
      connection: this.connection,
      simulated: this.link.simulated,
    });
    this.modelAtHand = computed(() =>
      this.connection.value ? this.recognition.model.value : (this.opened.shown.value?.model ?? null),
    );
    this.standing = standingOf(this.editor, this.knowledge, this.connection);
    this.recovery = new InterruptedJobs(unfinished, this.knowledge, this.backups);
    this.servoMoves = new ServoMoves(this.connection, this.safety);
    this.notices = new Notices(() => this.link.wait());
    this.runner = new JobRunner(this);
    const drafts = new Drafts(storage.drafts, tab);
    const { editor, link, runner, notices, safety, knowledge, recovery, nextFlight } = this;
    const onDraft = ({ model }: Draft): void => this.origin.take(model);
    const reader = new Reader({
      editor,
      drafts,
      link,
      runner,
      notices,
      safety,
      knowledge,
      recovery,
      nextFlight,
      onDraft,
    });
    this.#reader = reader;
    this.simulated = reader.simulated;
    this.byteOrderOpen = reader.byteOrderOpen;
    this.shortDt = new ShortDt({
      editor,
      standing: this.standing,
      nextFlight,
      byteOrderOpen: reader.byteOrderOpen,
      simulated: reader.simulated,
      model: () => this.modelAtHand.value?.id ?? null,
    });
    this.keptWork = new KeptWork(this, drafts, (draft) => reader.showDraft(draft));
    this.keptPrograms = new KeptPrograms(drafts);
    this.engaged = computed(() => runner.busy.value || link.waiting.value);
    this.opened = new OpenSetting(this, {
      show: (program, of) => reader.showMade(program, of),
      showDraft: (draft) => reader.showDraft(drafts.take(draft)),
      kept: (id) => drafts.ofSetting(id),
    });
    this.origin = new Origin(this);
    effect(() => {
      const found = this.recognition.found.value;
      if (found?.kind !== 'said') return;
      this.backups.assign(found.model.id, this.recognition.since, this.link.simulated.peek());
    });
    this.servoUses = new ServoUses(
      computed(() => {
        const shown = editor.identity.value;
        return shown && { kind: kindKey(shown, reader.simulated.value), servos: shown.servos };
      }),
      computed(() => {
        const model = this.modelAtHand.value;
        return model ? { servos: model.servos, say: (servos) => void this.#keepServos(model.id, servos) } : null;
      }),
    );
  }

  /**
   * Connects to the port that was used last, or is the only one that is known, else to the one that the pilot chooses.
   * A timer that is connected and has not been read is read.
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
    this.#reader.inherit();
    await this.connect();
  }

  /** Connects to one of the ports that are known. */
  async connectTo(port: SerialPortLike): Promise<void> {
    await this.#goTo(async () => () => this.link.connect(port));
  }

  async trySimulated(timerClass: SimulatedClass): Promise<void> {
    await this.#goTo(async () => {
      await this.recovery.forgetSimulated();
      const port = await this.#options.plugSimulated(timerClass);
      return () => this.link.connectSimulated(port);
    });
  }

  /** Connects to a timer like the one that the program on the screen came from: a simulated one is made anew. */
  async comeBack(): Promise<void> {
    const timerClass = this.simulated.value ? this.editor.identity.value?.timerClass : undefined;
    const simulated = SIMULATED_CLASSES.find((each) => each === timerClass);
    await (simulated ? this.trySimulated(simulated) : this.connect());
  }

  /** Connects to a timer that answers as another one did while its line was recorded. */
  async tryRecording(entries: readonly CaptureEntry[]): Promise<void> {
    await this.#goTo(async () => {
      const port = await this.#options.plugRecording(entries);
      return () => this.link.connectSimulated(port);
    });
  }

  /**
   * Lets the pilot choose another port while a timer at this one is waited for; what is waited for stays until one is
   * chosen.
   */
  async chooseAnother(): Promise<void> {
    if (!['searching', 'waiting'].includes(this.link.state.value.status)) return;
    await this.link.choose();
    await this.#reader.settled();
  }

  /**
   * Stops what is under way, lets the last request end and closes the port. The program stays on the screen, as it was
   * read last, with what was typed.
   */
  async disconnect(): Promise<void> {
    void this.runner.stop();
    const closing = this.link.stop();
    batch(() => {
      this.notices.dismiss();
      this.recovery.anotherTimer();
    });
    await closing;
    await this.link.refresh();
  }

  /**
   * Reads the current memory again. Edits stay.
   * @returns whether it was read.
   */
  async read(): Promise<boolean> {
    return await this.#reader.read();
  }

  /** Reads where a job has left it open which memory is current. What stopped that job is still said. */
  async readIfOpen(): Promise<void> {
    await this.#reader.readIfOpen();
  }

  /**
   * Makes another memory current and reads it. Edits of the one that is left are kept for when it is read again. When
   * it is stopped or fails on the way, the memory that is current by then is read.
   * @returns whether that memory was read.
   */
  async selectMemory(memory: number): Promise<boolean> {
    return await this.#reader.selectMemory(memory);
  }

  /** The pilot has said how this timer is: it is read again that way. */
  async assume(quirks: AssumedQuirks): Promise<void> {
    if (this.runner.busy.value) return;
    await this.link.assume(quirks);
    await this.read();
  }

  /** Takes nothing for true any more of such a timer at such a port; the one at hand is read again without. */
  async forgetAssumed(assumed: Pick<Assumed, 'portKey' | 'kind'>): Promise<void> {
    if (this.runner.busy.value) return;
    const connection = this.connection.value;
    const wasAssumed = connection?.client.quirksAssumed;
    await this.link.forgetAssumed(assumed);
    if (connection && connection === this.connection.value && connection.client.quirksAssumed !== wasAssumed) {
      await this.read();
    }
  }

  /** The setting of the library that the program on the screen belongs to, and its model; null: to none. */
  get openSetting(): OpenSetting['shown'] {
    return this.opened.shown;
  }

  /**
   * A setting comes to the screen: without a timer to be edited; over what the connected timer holds as one step.
   * @returns whether it is shown; see {@link OpenSetting.obstacle}.
   */
  async showSetting(setting: Setting): Promise<boolean> {
    return await this.opened.show(setting);
  }

  async #keepServos(id: string, servos: Model['servos']): Promise<void> {
    const model = this.library.models.get(id)?.model;
    if (model) await this.library.keepModel({ ...model, servos });
  }

  /** Under what the work on a program of the timer on the screen is kept. */
  workKey(program: TimerProgram): string {
    return workKey(program, this.simulated.value, this.#options.tab.value);
  }

  /** A new program comes to the screen, to be edited without a timer. */
  make(program: TimerProgram): void {
    if (this.engaged.value || this.connection.value) return;
    this.notices.dismiss();
    this.#reader.showMade(program);
  }

  /** Clears the screen for something else, while no timer is connected. What the pilot wants is kept. */
  putAway(): void {
    if (this.engaged.value || this.connection.value) return;
    this.notices.dismiss();
    this.#reader.putAway();
  }

  /** Shows what was kept of earlier work, as the program of no timer. */
  showKept(draft: Draft): void {
    if (this.engaged.value || this.connection.value) return;
    this.notices.dismiss();
    this.#reader.putAway();
    this.#reader.showDraft(this.keptPrograms.take(draft));
  }

  /** Whether a backup can come to the screen: over what is there, or, while no timer is connected, in its place. */
  canLoad(program: TimerProgram): boolean {
    const working = this.editor.working.value;
    if (working && isOfOneShape(working, program)) return true;
    return this.connection.value === null && !this.engaged.value;
  }

  /** What was kept becomes what the pilot wants; nothing is written. */
  showBackup({ program, model }: Backup): void {
    const { working } = this.editor;
    if (!this.canLoad(program)) return;
    if (!working.value || !isOfOneShape(working.value, program)) {
      this.make({ ...program, memory: null });
      return;
    }
    const idleThrottle = program.idleThrottle ?? working.value.idleThrottle;
    const wanted = { ...working.value, times: program.times, positions: program.positions, idleThrottle };
    this.editor.apply(replaceAll({ code: 'restore', params: {} }, wanted));
    this.origin.take(model);
  }

  /**
   * Goes to a timer, and settles when it was read or has to be waited for. One way at a time, also while it is waited
   * for.
   */
  async #goTo(find: () => Promise<() => Promise<void>>): Promise<void> {
    if (this.engaged.value) return;
    this.notices.dismiss();
    await this.link.begin(find);
    await this.#reader.settled();
  }

  #follow(state: LinkState, before: LinkState): void {
    if (state.status === 'away' || (before.status === 'on' && ['waiting', 'searching'].includes(state.status))) {
      this.#reader.timerAway();
    }
    if (state.status === 'on') {
      this.#reader.timerCame(state.connection);
      this.recognition.timerCame();
      return;
    }
    this.runner.connectionOver();
    this.knowledge.connectionOver();
    // What is offered rests on what a timer holds that is no longer there.
    if (before.status === 'on') this.recovery.anotherTimer();
    if (state.status !== 'off') return;
    this.#reader.timerGone();
    this.nextFlight.forget();
    if (!state.error) return;
    const { code, bytes } = state.error;
    const port = 'info' in before ? before.info : 'port' in before ? before.port.getInfo() : null;
    this.notices.show({ kind: 'connection', code, port, portKey: port && portKey(port), bytes });
    void this.link.refresh();
  }
}

function isOfOneShape(a: TimerProgram, b: TimerProgram): boolean {
  return a.identity.timerClass === b.identity.timerClass && sameLayout(a.identity, b.identity);
}
