import { computed, effect } from '@preact/signals';
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
import { Safety } from '../timer/safety.js';
import { ServoMoves } from '../timer/servo-moves.js';
import { Settled } from '../timer/settled.js';
import { Standings } from '../timer/standing.js';
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
import { unfinishedWork } from './unfinished-work.js';

export interface SessionOptions extends TimerSources {
  readonly storage: Storage;
}

/** One pilot, one wire, one program on the screen: the models for that. A model takes those that it needs. */
export type Session = ReturnType<typeof createSession>;

/** Builds them from the ground up. */
export function createSession({ storage, ...sources }: SessionOptions) {
  const editor = new Editor();
  const log: LineLog = new LineLog(() => link.connection.peek()?.client.quirksAssumed ?? {});
  const link = new Link({ surroundings: sources.surroundings, ports: storage.ports, onLine: log.add });
  const { connection } = link;
  const atHand = computed(() => {
    const connected = connection.value?.identity;
    if (connected) return { identity: connected, simulated: link.simulated.value };
    const shown = editor.identity.value;
    return shown && { identity: shown, simulated: onScreen.simulated.value };
  });
  const records = new UnfinishedRecords(storage.unfinished);
  const knowledge = new Knowledge(records, atHand);
  const library = new Library(storage);
  const recognition = new Recognition({ library, knowledge, link });
  const backups = new Backups(storage.backups, () => recognition.model.peek()?.id ?? null);
  const kept = {
    library,
    recognition,
    backups,
    aside: new SetAside(storage.aside),
    drafts: new Drafts(storage.drafts),
  };
  const recovery = new InterruptedJobs(records, knowledge, backups);
  const safety = new Safety();
  const notices = new Notices(() => link.wait());
  const runner = new JobRunner({ link, safety, notices, knowledge, recovery });
  /** Whether no other connection can begin: something is in progress, or is waited for until the pilot stops it. */
  const engaged = computed(() => runner.busy.value || link.waiting.value);
  const nextFlight = new NextFlight();
  const wire = { link, connection, engaged, runner, notices, safety, records, knowledge, recovery, nextFlight };
  const origin = new Origin({ editor, library, recognition, connection });
  const standings = new Standings({ knowledge, editor, link, nextFlight, model: recognition.model });
  const onScreen: OnScreen = new OnScreen({ ...wire, ...kept, editor, origin });
  const shown = { editor, origin, standings, onScreen };
  const reader = new Reader({ ...wire, ...kept, ...shown });
  const readRest = () => Promise.all([records.loadAgain(), backups.load(), link.start()]);
  const trials = new Trials(editor.baseline, (program) => onScreen.keyOf(program));
  effect(() => {
    const said = notices.current.value;
    if (said && ABOUT_CHANGES.has(said.code) && !editor.dirty.value) notices.dismiss();
  });
  effect(() => {
    if (recognition.timer.value > 0) backups.anotherTimer();
  });
  effect(() => {
    const found = recognition.found.value;
    if (found?.kind === 'said') backups.assign(found.model.id);
  });
  return {
    ...wire,
    ...kept,
    ...shown,
    log,
    reader,
    trials,
    timer: new TimerAccess({ ...wire, ...shown, reader, trials }, sources),
    keptWork: new KeptWork({ ...kept, ...shown, engaged, readRest }),
    opened: new OpenSetting({ ...wire, ...kept, ...shown }),
    /** Everything that was begun with a timer and has no end yet, the worst first. */
    unfinished: unfinishedWork({ ...wire, trials }),
    servoMoves: new ServoMoves(connection, safety),
    settled: new Settled(),
    servoUses: new ServoUses({ ...kept, ...shown }),
    shortDt: new ShortDt({ ...shown, reader }),
    /** What may be said of the program on the screen. */
    standing: standings.screen,
    /** Whether the program on the screen comes from the simulated timer. */
    simulated: onScreen.simulated,
  };
}
