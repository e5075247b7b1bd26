import { effect, type ReadonlySignal } from '@preact/signals';
import { isMoving } from '../editing/history.js';
import type { Drafts } from './drafts.js';
import type { Session } from './session.js';

/** How long to wait before looking again, when something came back during the first look. Milliseconds. */
const LOOK_AGAIN = 1000;

/** While a handle moves, each frame has a new value. How long a value may wait until it is kept, in milliseconds. */
const MOVING_WAIT = 500;

/** Keeps the pilot's work while it is typed, and brings back what a reload or a crash has interrupted. */
export class KeptWork {
  /** Whether all that was typed would be there after a reload. */
  readonly kept: ReadonlySignal<boolean>;
  readonly #session: Session;
  readonly #drafts: Drafts;
  /** Keeps the content of the screen, when that waits for the release of a handle. */
  #late: (() => void) | null = null;
  #lateTimer: ReturnType<typeof setTimeout> | undefined;
  #looking: Promise<void> | null = null;
  #lookAgain = false;
  /** Whether a program has been on the screen. One that the pilot has closed does not come back by itself. */
  #hasShown = false;

  constructor(session: Session, drafts: Drafts) {
    this.#session = session;
    this.#drafts = drafts;
    this.kept = drafts.kept;
  }

  /** From now on keeps what is typed, and brings back what was interrupted. Nothing on the screen waits for it. */
  async start(): Promise<void> {
    const { editor, standing, onScreen, origin, library, aside } = this.#session;
    // The library is read last, and flights only when they are wanted.
    for (const { loaded } of [library.models, library.settings, library.flights]) {
      effect(() => {
        if (loaded.value) void aside.load();
      });
    }
    effect(() => {
      const content = editor.snapshot();
      if (content) this.#hasShown = true;
      const readAt = standing.value.at;
      const model = origin.key.value;
      const ofModel = model === null ? {} : { model };
      const isSimulated = onScreen.simulated.value;
      if (content) this.#late = () => this.#drafts.keep({ ...content, readAt, ...ofModel }, isSimulated);
      if (!content?.history || !isMoving(content.history)) this.#keepLate();
      else this.#lateTimer ??= setTimeout(() => this.#keepLate(), MOVING_WAIT);
    });
    await this.bringBack();
  }

  /** The pilot leaves the page, or may leave it: keeps at once what was typed. */
  keepNow(): void {
    this.#keepLate();
    this.#drafts.flush();
  }

  #keepLate(): void {
    clearTimeout(this.#lateTimer);
    this.#lateTimer = undefined;
    this.#late?.();
    this.#late = null;
  }

  /** Reads what is kept, unless it is known already, and unless the pilot has begun something else. */
  bringBack(): Promise<void> {
    // One look at a time. What comes back during a look needs another one.
    this.#lookAgain = this.#looking !== null;
    this.#looking ??= this.#bringBack().finally(() => {
      this.#looking = null;
      // Not at once: a shelf that answers one call and fails the next would keep the page busy for ever.
      if (this.#lookAgain) setTimeout(() => void this.bringBack(), LOOK_AGAIN);
    });
    return this.#looking;
  }

  async #bringBack(): Promise<void> {
    const { knowledge, backups, link, aside, library } = this.#session;
    await Promise.all([this.#bringBackEdits(), knowledge.refresh(), backups.load(), link.start()]);
    this.#drafts.keepAgain();
    // It may be long, and nothing waits for it.
    void library.load();
    await aside.load();
  }

  async #bringBackEdits(): Promise<void> {
    const { engaged } = this.#session;
    const wanted = (): boolean => !this.#hasShown && !engaged.value;
    const draft = await this.#drafts.latest(wanted);
    if (draft) this.#session.onScreen.bringBack(draft);
  }
}
