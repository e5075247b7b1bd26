import { computed } from '@preact/signals';
import { Bench } from './bench/bench.js';
import { Follow } from './bench/follow.js';
import type { Lack } from './browser/doors.js';
import type { Platform } from './browser/platform.js';
import { ComparedPair } from './compare/choice.js';
import { Installation } from './connect/installation.js';
import { FlightLog } from './flights/flight-log.js';
import { Checklist } from './help/checklist.js';
import { Browse } from './library/browse.js';
import { SaveSetting } from './library/save-setting.js';
import { Sharing } from './library/share/sharing.js';
import { FrameForm } from './line/frame-form.js';
import { LineView } from './line/line-view.js';
import { Leaving } from './memories/leaving.js';
import { Memories } from './memories/memories.js';
import { PrintOrder } from './print/print-order.js';
import { ProgramPicture } from './program/program-picture.js';
import { Keeping } from './records/keeping.js';
import { Preferences } from './records/preferences.js';
import { Erase, type Erasers } from './settings/erase.js';
import { Theme } from './settings/theme.js';
import { UpdateOffer } from './shell/update-offer.js';
import { Views } from './shell/views.js';
import { limited } from './storage/index.js';
import { createSession, type SessionOptions } from './work/session.js';
import { WriteJob } from './write/write-job.js';

/** The models that the views read and call. */
export type AppModels = Readonly<ReturnType<typeof createModels>>;

export interface ModelOptions extends SessionOptions {
  readonly platform: Platform;
  /** How to delete what the browser keeps outside of the storage. Default: there is nothing. */
  readonly erasers?: Erasers | undefined;
  /** Loads the page again. */
  readonly reload?: (() => void) | undefined;
  /** Default: a new one. */
  readonly theme?: Theme;
  /** What was missing when the page opened. Default: nothing. */
  readonly lacks?: readonly Lack[];
}

const NOTHING_KEPT: Erasers = { settings: async () => {}, ports: async () => {}, offline: async () => {} };

/** Builds all models, before anything is brought back or connected. */
export function createModels({
  platform,
  lacks,
  erasers = NOTHING_KEPT,
  reload = () => {},
  theme = new Theme(),
  ...options
}: ModelOptions) {
  const keeping = new Keeping(lacks);
  const storage = limited(options.storage, keeping);
  const session = createSession({ ...options, storage });
  keeping.onReturn(() => {
    void session.keptWork.bringBack();
    for (const each of [session.records, session.backups]) void each.keepAgain();
    void session.link.remember();
    void session.library.keepAgain();
  });
  const write = new WriteJob(session);
  const memories = new Memories(session);
  const bench = new Bench(session);
  const follow = new Follow(session, bench);
  session.opened.notWhile(follow.on);
  return {
    session,
    views: new Views(),
    keeping,
    aside: session.aside,
    erase: new Erase(session, storage, erasers, reload),
    write,
    memories,
    leaving: new Leaving(session, memories, write, () => follow.stop()),
    bench,
    follow,
    /** The view of the line, and the frame by hand. They outlast their view, as what follows does. */
    line: { view: new LineView(session.log), form: new FrameForm(session) },
    /** How the pilot looks at the program. */
    programPicture: new ProgramPicture(),
    /** What to print. */
    printOrder: new PrintOrder(),
    /** How the pilot looks at the library. */
    browse: new Browse(session.library),
    saveSetting: new SaveSetting(session),
    /** The two programs that are compared. */
    comparedPair: new ComparedPair(),
    theme,
    /** The log of flights, and how the pilot looks at it. */
    flights: new FlightLog(session, write),
    /** Settings that go to another device, or come from one, by link or QR code. */
    sharing: new Sharing(),
    preferences: new Preferences(session.editor),
    update: new UpdateOffer(session),
    installation: new Installation(),
    checklist: new Checklist(computed(() => session.editor.identity.value?.timerClass ?? null)),
    /** The pilot's system and browser. They only choose sentences. */
    platform,
  };
}
