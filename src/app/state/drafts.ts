import { differences, sameLayout, type TimerProgram } from '../../program/index.js';
import type { Draft, Keeper } from '../storage/index.js';
import type { EditorContent } from './editor.js';
import { programKey, workKey } from './keys.js';
import type { TabNumber } from './tab-number.js';

/**
 * What a pilot works on, with what can be undone, by kind of timer, memory and tab: through a reload or a crash where the browser keeps
 * anything, else for as long as the page is open. What was left in a tab that is closed falls to the next one that needs it.
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

  /** The one that was worked on last and was not written: in this tab, else in one that is closed. */
  async latest(): Promise<Draft | undefined> {
    await this.#tab.takeBefore();
    const edited = (await this.#all()).filter(isEdited);
    for (const draft of edited) if (await this.#tab.take(draft.tab)) return this.#adopt(draft);
    await this.#tab.takeAny();
    for (const draft of edited) if (await this.#tab.isFree(draft.tab)) return this.#adopt(draft);
    return undefined;
  }

  /**
   * What is kept of the work on a program like this.
   * @param inherit another tab has left its timer to this one: its edits come along.
   */
  async of(program: TimerProgram, simulated: boolean, inherit = false): Promise<Draft | undefined> {
    const key = workKey(program, simulated, this.#tab.value);
    await this.#saving;
    const own = this.#open.get(key) ?? (await this.#shelf.load(key).catch(() => undefined));
    if (own) return this.#adopt(own);
    const kind = programKey(program, simulated);
    for (const draft of await this.#all()) {
      if (programKey(draft.working, draft.simulated) !== kind) continue;
      if (inherit || (await this.#tab.isFree(draft.tab))) return this.#adopt(draft);
    }
    return undefined;
  }

  /** Takes a draft over into this tab; an open one that had it keeps it too. */
  #adopt(draft: Draft): Draft {
    const tab = this.#tab.value;
    const key = workKey(draft.working, draft.simulated, tab);
    const own = { ...draft, key, tab };
    this.#open.set(key, own);
    if (draft.tab !== tab) {
      this.#then(async () => {
        await this.#shelf.save(own);
        if (await this.#tab.isFree(draft.tab)) await this.#shelf.remove(draft.key);
      });
    }
    return own;
  }

  /** All that are kept, the latest first. */
  async #all(): Promise<Draft[]> {
    const all = await this.#shelf.all().catch((): Draft[] => {
      this.#onFailure();
      return [];
    });
    return all.sort((a, b) => b.savedAt - a.savedAt);
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
