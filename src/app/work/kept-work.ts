import { effect, type ReadonlySignal } from '@preact/signals';
import type { Editor } from '../editing/editor.js';
import { isMoving } from '../editing/history.js';
import type { Library } from '../records/library.js';
import type { SetAside } from '../records/set-aside.js';
import type { Standings } from '../timer/standing.js';
import type { Drafts } from './drafts.js';
import type { OnScreen } from './on-screen.js';
import type { Origin } from './origin.js';

interface KeptWorkParts {
  readonly editor: Editor;
  readonly onScreen: OnScreen;
  readonly origin: Origin;
  readonly standings: Standings;
  readonly engaged: ReadonlySignal<boolean>;
  readonly drafts: Drafts;
  readonly library: Library;
  readonly aside: SetAside;
  /** Reads everything else that is kept, and is known before the library. */
  readonly readRest: () => Promise<unknown>;
}

/** How long to wait before looking again, when something came back during the first look. Milliseconds. */
const LOOK_AGAIN = 1000;

/** While a handle moves, each frame has a new value. How long a value may wait until it is kept, in milliseconds. */
const MOVING_WAIT = 500;

/** Keeps the pilot's work while it is typed, and brings back what a reload or a crash has interrupted. */
export class KeptWork {
  readonly #parts: KeptWorkParts;
  /** Keeps the content of the screen, when that waits for the release of a handle. */
  #late: (() => void) | null = null;
  #lateTimer: ReturnType<typeof setTimeout> | undefined;
  #looking: Promise<void> | null = null;
  #lookAgain = false;
  /** Whether a program has been on the screen. One that the pilot has closed does not come back by itself. */
  #hasShown = false;

  constructor(parts: KeptWorkParts) {
    this.#parts = parts;
  }

  /** From now on keeps what is typed, and brings back what was interrupted. Nothing on the screen waits for it. */
  async start(): Promise<void> {
    const { editor, standings, onScreen, origin, library, aside, drafts } = this.#parts;
    // The library is read last, and flights only when they are wanted.
    for (const { loaded } of [library.models, library.settings, library.flights]) {
      effect(() => {
        if (loaded.value) void aside.load();
      });
    }
    effect(() => {
      const content = editor.snapshot();
      if (content) this.#hasShown = true;
      const readAt = standings.screen.value.at;
      const model = origin.key.value;
      const ofModel = model === null ? {} : { model };
      const isSimulated = onScreen.simulated.value;
      const apart = onScreen.apart.value ? { apart: true } : {};
      if (content) this.#late = () => drafts.keep({ ...content, readAt, ...ofModel, ...apart }, isSimulated);
      if (!content?.history || !isMoving(content.history)) this.#keepLate();
      else this.#lateTimer ??= setTimeout(() => this.#keepLate(), MOVING_WAIT);
    });
    await this.bringBack();
  }

  /** The pilot leaves the page, or may leave it: keeps at once what was typed. */
  keepNow(): void {
    this.#keepLate();
    this.#parts.drafts.flush();
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
    const { readRest, aside, library, drafts } = this.#parts;
    await Promise.all([this.#bringBackEdits(), readRest()]);
    void drafts.keepAgain();
    // It may be long, and nothing waits for it.
    void library.load();
    await aside.load();
  }

  async #bringBackEdits(): Promise<void> {
    const { engaged, drafts, onScreen } = this.#parts;
    const wanted = (): boolean => !this.#hasShown && !engaged.value;
    const draft = await drafts.latest(wanted);
    if (draft) onScreen.bringBack(draft);
  }
}
