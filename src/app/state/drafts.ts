import { differences, sameLayout } from '../../program/index.js';
import type { Draft, Keeper } from '../storage/index.js';
import type { EditorContent } from './editor.js';
import { programKey } from './keys.js';

/**
 * What a pilot works on, with what can be undone, by kind of timer and memory: through a reload or a crash where the browser keeps
 * anything, else for as long as the page is open.
 */
export class Drafts {
  readonly #shelf: Keeper<Draft>;
  readonly #onFailure: () => void;
  readonly #open = new Map<string, Draft>();
  #saving: Promise<unknown> = Promise.resolve();

  /** @param onFailure the browser does not keep anything. */
  constructor(shelf: Keeper<Draft>, onFailure: () => void) {
    this.#shelf = shelf;
    this.#onFailure = onFailure;
  }

  /** The one that was worked on last and was not written. */
  async latest(): Promise<Draft | undefined> {
    const all = await this.#shelf.all().catch((): Draft[] => {
      this.#onFailure();
      return [];
    });
    const [latest] = all.filter(isEdited).sort((a, b) => b.savedAt - a.savedAt);
    if (latest) this.#open.set(latest.key, latest);
    return latest;
  }

  /** What is kept under a key, see `programKey`. */
  async of(key: string): Promise<Draft | undefined> {
    await this.#saving;
    const draft = this.#open.get(key) ?? (await this.#shelf.load(key).catch(() => undefined));
    if (draft) this.#open.set(key, draft);
    return draft;
  }

  /** Keeps what is on the screen while there is anything to bring back, or to undo, and forgets it when there is not. */
  keep(content: EditorContent, simulated: boolean): void {
    const key = programKey(content.working, simulated);
    const draft: Draft = { key, ...content, savedAt: Date.now(), simulated };
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
