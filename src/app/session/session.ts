import { computed, effect, type ReadonlySignal } from '@preact/signals';
import type { Model } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { TabChannel } from '../browser/other-tabs.js';
import type { TabNumber } from '../browser/tab-number.js';
import { Editor } from '../editing/editor.js';
import type { Storage } from '../storage/index.js';
import { Backups } from './backups.js';
import { Drafts } from './drafts.js';
import { InterruptedJobs } from './interrupted-jobs.js';
import { JobRunner } from './job-runner.js';
import { KeptPrograms } from './kept-programs.js';
import { KeptWork } from './kept-work.js';
import { Knowledge } from './knowledge.js';
import { Library } from './library.js';
import { LineLog } from './line-log.js';
import { Link } from './link.js';
import { NextFlight } from './next-flight.js';
import { Notices } from './notices.js';
import { OnScreen } from './on-screen.js';
import { OpenSetting } from './open-setting.js';
import { Origin } from './origin.js';
import { Reader } from './reader.js';
import { Recognition } from './recognition.js';
import { kindKey } from './record-keys.js';
import { Safety } from './safety.js';
import { ServoMoves } from './servo-moves.js';
import { ServoUses } from './servo-uses.js';
import { SetAside } from './set-aside.js';
import { ShortDt } from './short-dt.js';
import { type Standing, standingOf } from './standing.js';
import { TimerAccess, type TimerSources } from './timer-access.js';
import { UnfinishedRecords } from './unfinished.js';

/** The classes of which there is a simulated timer. */
export const SIMULATED_CLASSES = ['Q', 'B', 'E'] as const;
export type SimulatedClass = (typeof SIMULATED_CLASSES)[number];

export interface SessionOptions extends TimerSources {
  readonly storage: Storage;
  readonly tab: TabNumber;
  /** Between the tabs of this page, of the library; null where there is none. */
  readonly libraryChannel?: TabChannel | null;
}

/** One pilot, one wire, one program on the screen: all models that belong to that, built in one place. */
export class Session {
  readonly editor = new Editor();
  /** The program on the screen: where it comes from, and what comes in its place. */
  readonly onScreen: OnScreen;
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
  /** The ways to a timer and away from it. */
  readonly timer: TimerAccess;
  readonly reader: Reader;
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

  constructor(options: SessionOptions) {
    const { surroundings, storage, tab } = options;
    this.backups = new Backups(storage.backups, () => this.recognition.model.peek()?.id ?? null);
    this.aside = new SetAside(storage.aside);
    this.library = new Library(storage, options.libraryChannel);
    this.link = new Link({
      surroundings,
      ports: storage.ports,
      onLine: this.log.add,
      onState: (state, before) => this.timer.follow(state, before),
    });
    this.connection = this.link.connection;
    const atHand = computed(() => {
      const connected = this.connection.value?.identity;
      if (connected) return { identity: connected, simulated: this.link.simulated.value };
      const shown = this.editor.identity.value;
      return shown && { identity: shown, simulated: this.onScreen.simulated.value };
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
    this.engaged = computed(() => this.runner.busy.value || this.link.waiting.value);
    const drafts = new Drafts(storage.drafts, tab);
    this.onScreen = new OnScreen(this, drafts);
    this.reader = new Reader(this, drafts);
    this.simulated = this.onScreen.simulated;
    this.byteOrderOpen = this.reader.byteOrderOpen;
    this.shortDt = new ShortDt(this);
    this.timer = new TimerAccess(this, options);
    this.keptWork = new KeptWork(this, drafts);
    this.keptPrograms = new KeptPrograms(drafts);
    this.opened = new OpenSetting(this, drafts);
    this.origin = new Origin(this);
    effect(() => {
      const found = this.recognition.found.value;
      if (found?.kind !== 'said') return;
      this.backups.assign(found.model.id, this.recognition.since, this.link.simulated.peek());
    });
    this.servoUses = new ServoUses(
      computed(() => {
        const shown = this.editor.identity.value;
        return shown && { kind: kindKey(shown, this.simulated.value), servos: shown.servos };
      }),
      computed(() => {
        const model = this.modelAtHand.value;
        return model && { servos: model.servos, say: (servos) => void this.library.sayServos(model.id, servos) };
      }),
    );
  }
}
