import { differences, sameLayout, type TimerProgram } from '../../program/index.js';
import type { Draft, Keeper } from '../storage/index.js';
import type { EditorContent } from './editor.js';
import { workKey } from './keys.js';
import type { TabNumber } from './tab-number.js';

/**
 * What a pilot works on, with what can be undone, by kind of timer and memory: through a reload or a crash where the browser keeps
 * anything, else for as long as the page is open.
 */
export class Drafts {
  readonly #shelf: Keeper<Draft>;
  readonly #tab: TabNumber;
  readonly #onFailure: () => void;
  readonly #open = new Map<string, Draft>();
  #saving: Promise<unknown> = Promise.resolve();

  /** @param onFailure the browser does not keep anything. */
  constructor(shelf: Keeper<Draft>, tab: TabNumber, onFailure: () => void) {
    this.#shelf = shelf;
    this.#tab = tab;
    this.#onFailure = onFailure;
  }

  /** The one that was worked on last and was not written; of those of simulated timers, this tab's own, or one that no open tab has. */
  async latest(): Promise<Draft | undefined> {
    await this.#tab.takeBefore();
    const all = await this.#shelf.all().catch((): Draft[] => {
      this.#onFailure();
      return [];
    });
    for (const draft of all.filter(isEdited).sort((a, b) => b.savedAt - a.savedAt)) {
      if (draft.simulated && !(await this.#tab.take(draft.tab))) continue;
      this.#open.set(draft.key, draft);
      return draft;
    }
    return undefined;
  }

  /** What is kept of the work on a program like this. */
  async of(program: TimerProgram, simulated: boolean): Promise<Draft | undefined> {
    const key = workKey(program, simulated, this.#tab.value);
    await this.#saving;
    const draft = this.#open.get(key) ?? (await this.#shelf.load(key).catch(() => undefined));
    if (draft) this.#open.set(key, draft);
    return draft;
  }

  /** Keeps what is on the screen while there is anything to bring back, or to undo, and forgets it when there is not. */
  keep(content: EditorContent, simulated: boolean): void {
    const tab = this.#tab.value;
    const key = workKey(content.working, simulated, tab);
    const draft: Draft = { key, ...content, savedAt: Date.now(), simulated, tab };
    if (isEdited(draft) || draft.history?.past.length || draft.history?.future.length) {
      this.#open.set(key, draft);
      // One that has been followed by another before its turn has come is not saved.
      this.#then(async () => void (this.#open.get(key) === draft && (await this.#shelf.save(draft))));
    } else if (this.#open.delete(key)) this.#then(() => this.#shelf.remove(key));
  }

  #then(work: () => Promise<unknown>): void {
    this.#saving = this.#saving.then(work).catch(this.#onFailure);
  }
}

function isEdited({ baseline, working, texts }: Draft): boolean {
  if (!sameLayout(baseline.identity, working.identity)) return false;
  return Object.keys(texts).length > 0 || differences(baseline, working).length > 0;
}
