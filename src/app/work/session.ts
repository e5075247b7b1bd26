import { computed, effect, type ReadonlySignal } from '@preact/signals';
import type { TimerConnection } from '../../serial/index.js';
import { Editor } from '../editing/editor.js';
import { Backups } from '../records/backups.js';
import { Library } from '../records/library.js';
import { Recognition } from '../records/recognition.js';
import { SetAside } from '../records/set-aside.js';
import type { Storage } from '../storage/index.js';
import { JobRunner } from '../timer/job-runner.js';
import { Knowledge } from '../timer/knowledge.js';
import { LineLog } from '../timer/line-log.js';
import { Link } from '../timer/link.js';
import { NextFlight } from '../timer/next-flight.js';
import { ABOUT_CHANGES, Notices } from '../timer/notices.js';
import { kindKey, programKey } from '../timer/record-keys.js';
import { Safety } from '../timer/safety.js';
import { ServoMoves } from '../timer/servo-moves.js';
import { type Standing, Standings } from '../timer/standing.js';
import { Trials } from '../timer/trials.js';
import { UnfinishedRecords } from '../timer/unfinished.js';
import { Drafts } from './drafts.js';
import { InterruptedJobs } from './interrupted-jobs.js';
import { KeptWork } from './kept-work.js';
import { OnScreen } from './on-screen.js';
import { OpenSetting } from './open-setting.js';
import { Origin } from './origin.js';
import { Reader } from './reader.js';
import { ServoUses } from './servo-uses.js';
import { ShortDt } from './short-dt.js';
import { TimerAccess, type TimerSources } from './timer-access.js';
import { type OpenJob, unfinishedWork } from './unfinished-work.js';

export interface SessionOptions extends TimerSources {
  readonly storage: Storage;
}

/** One pilot, one wire, one program on the screen: builds all models for that in one place. */
export class Session {
  readonly editor = new Editor();
  /** The program on the screen: where it comes from, and what replaces it. */
  readonly onScreen: OnScreen;
  readonly log: LineLog = new LineLog(() => this.connection?.peek()?.client.quirksAssumed ?? {});
  readonly backups: Backups;
  readonly aside: SetAside;
  readonly keptWork: KeptWork;
  /** The pilot's work on this device: programs that were made here, and changes that are in no timer. */
  readonly keptPrograms: Drafts;
  /** The pilot's models, their settings and the flights. */
  readonly library: Library;
  /** The setting that the program on the screen belongs to, and how it is saved. */
  readonly opened: OpenSetting;
  /** What is known about the content of timers: every statement about a timer comes from here. */
  readonly knowledge: Knowledge;
  /** The model of the connected timer, as its content shows or the pilot says. */
  readonly recognition: Recognition;
  /** Whose the values are: every name of a model comes from here. */
  readonly origin: Origin;
  /** What may be said of the content of timers. */
  readonly standings: Standings;
  /** The same of the program on the screen. */
  readonly standing: ReadonlySignal<Standing>;
  readonly recovery: InterruptedJobs;
  /** Positions that were tried and neither kept nor put back. */
  readonly trials: Trials;
  /** Everything that was begun with a timer and has no end yet, the worst first. */
  readonly unfinished: ReadonlySignal<readonly OpenJob[]>;
  readonly link: Link;
  /** Connecting and disconnecting. */
  readonly timer: TimerAccess;
  readonly reader: Reader;
  readonly runner: JobRunner;
  readonly notices: Notices;
  readonly safety = new Safety();
  readonly servoMoves: ServoMoves;
  /** What the servos of the model move, as the pilot says. */
  readonly servoUses: ServoUses;
  /** Which memory flies next, and whether it is the one of connecting. */
  readonly nextFlight = new NextFlight();
  /** Whether a short DT flies next, and which one can be put back. */
  readonly shortDt: ShortDt;
  /** Whether it is open how this timer writes its times. The pilot has to choose before times are written. */
  readonly byteOrderOpen: ReadonlySignal<boolean>;
  /** Whether the program on the screen comes from the simulated timer. */
  readonly simulated: ReadonlySignal<boolean>;
  readonly connection: ReadonlySignal<TimerConnection | null>;
  /** Whether no other connection can begin: something is in progress, or is waited for until the pilot stops it. */
  readonly engaged: ReadonlySignal<boolean>;

  constructor(options: SessionOptions) {
    const { surroundings, storage } = options;
    this.backups = new Backups(storage.backups, () => this.recognition.model.peek()?.id ?? null);
    this.aside = new SetAside(storage.aside);
    this.library = new Library(storage);
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
    const unfinished = new UnfinishedRecords(storage.unfinished);
    this.knowledge = new Knowledge(unfinished, atHand);
    this.recognition = new Recognition(this);
    this.standings = new Standings({
      knowledge: this.knowledge,
      editor: this.editor,
      connection: this.connection,
      model: this.recognition.model,
      simulated: this.link.simulated,
    });
    this.standing = this.standings.screen;
    this.recovery = new InterruptedJobs(unfinished, this.knowledge, this.backups);
    this.servoMoves = new ServoMoves(this.connection, this.safety);
    this.notices = new Notices(() => this.link.wait());
    this.runner = new JobRunner(this);
    this.engaged = computed(() => this.runner.busy.value || this.link.waiting.value);
    const drafts = new Drafts(storage.drafts);
    this.onScreen = new OnScreen(this, drafts);
    this.reader = new Reader(this, drafts);
    this.simulated = this.onScreen.simulated;
    this.trials = new Trials(this.editor.baseline, (program) => programKey(program, this.simulated.value));
    this.unfinished = unfinishedWork(this);
    this.byteOrderOpen = this.reader.byteOrderOpen;
    this.shortDt = new ShortDt(this);
    this.timer = new TimerAccess(this, options);
    this.keptWork = new KeptWork(this, drafts);
    this.keptPrograms = drafts;
    this.opened = new OpenSetting(this, drafts);
    this.origin = new Origin({
      editor: this.editor,
      models: this.library.models,
      opened: this.opened.shown,
      recognition: this.recognition,
      connection: this.connection,
    });
    effect(() => {
      const said = this.notices.current.value;
      if (said && ABOUT_CHANGES.has(said.code) && !this.editor.dirty.value) this.notices.dismiss();
    });
    effect(() => {
      if (this.recognition.timer.value > 0) this.backups.anotherTimer();
    });
    effect(() => {
      const found = this.recognition.found.value;
      if (found?.kind === 'said') this.backups.assign(found.model.id);
    });
    this.servoUses = new ServoUses(
      computed(() => {
        const shown = this.editor.identity.value;
        return shown && { kind: kindKey(shown, this.simulated.value), servos: shown.servos };
      }),
      computed(() => {
        const model = this.origin.named.value;
        return model && { servos: model.servos, say: (servos) => void this.library.sayServos(model.id, servos) };
      }),
    );
  }
}
