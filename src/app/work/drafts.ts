import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { differences, sameLayout, type TimerProgram } from '../../program/index.js';
import { changesSince } from '../editing/content.js';
import type { EditorContent } from '../editing/editor.js';
import type { Draft, Keeper } from '../storage/index.js';
import { programKey, workKey } from '../timer/record-keys.js';

/** In place of a key, until the storage has said what it holds. */
const EARLY = '';

/**
 * What a pilot works on, with its undo history, by kind of timer and memory. It survives a reload or a crash where the
 * browser keeps anything; else it lasts as long as the page.
 */
export class Drafts {
  readonly #shelf: Keeper<Draft>;
  readonly #open = new Map<string, Draft>();
  /** The keys for which it is known what the storage held. */
  readonly #seen = new Set<string>();
  readonly #begun: Promise<void>;
  #begin: () => void = () => {};
  /** Work to keep once the storage has been asked for what it holds. */
  #early: (() => void) | null = null;
  #hasBegun = false;
  #saving: Promise<unknown> = Promise.resolve();
  /** The keys of drafts that this page has and the storage does not. */
  readonly #unsaved = signal<ReadonlySet<string>>(new Set(), { name: 'unsaved' });
  /** Whether everything that was typed would survive a reload. */
  readonly kept: ReadonlySignal<boolean> = computed(() => this.#unsaved.value.size === 0);

  readonly #list = signal<readonly Draft[]>([], { name: 'drafts' });
  /** All drafts that can be shown, the latest first, as of the last look. */
  readonly list: ReadonlySignal<readonly Draft[]> = this.#list;

  constructor(shelf: Keeper<Draft>) {
    this.#shelf = shelf;
    this.#begun = new Promise((resolve) => {
      this.#begin = resolve;
    });
  }

  /**
   * The latest unwritten draft.
   * @param wanted asked once it is found, which may take time: whether there is still a place for it.
   */
  async latest(wanted: () => boolean): Promise<Draft | undefined> {
    const found = (await this.#all()).find(isOpen);
    const draft = found && wanted() ? this.take(found) : undefined;
    this.#hasBegun = true;
    this.#begin();
    this.#early?.();
    return draft;
  }

  /** The stored work on a program like this one. */
  async of(program: TimerProgram, simulated: boolean): Promise<Draft | undefined> {
    await this.#begun;
    const key = programKey(program, simulated);
    await this.#saving;
    const own = this.#open.get(key) ?? (await this.#load(key).catch(() => undefined));
    if (own) return this.take(own);
    const other = (await this.#all()).find(
      ({ madeAt, working, simulated: of }) => madeAt === undefined && programKey(working, of) === key,
    );
    return other && this.take(other);
  }

  /** Looks up what is kept. Where the browser keeps nothing there is none. */
  async load(): Promise<void> {
    this.#list.value = await this.#available();
  }

  async #available(): Promise<Draft[]> {
    await this.#begun;
    await this.#saving;
    return (await this.#all()).filter(isEdited);
  }

  /** A program that was made here leaves the screen, and is kept: see {@link Draft.shelved}. */
  shelve(madeAt: number): void {
    const draft = [...this.#open.values()].find((each) => each.madeAt === madeAt);
    if (!draft) return;
    // Something that the library holds need not be kept twice.
    if (!isEdited(draft)) return void this.remove(draft);
    const shelved = { ...draft, shelved: true };
    this.#open.set(draft.key, shelved);
    this.#keep(shelved);
  }

  /** The stored, unsaved changes of a setting. */
  async ofSetting(id: string): Promise<Draft | undefined> {
    return (await this.#available()).find((draft) => draft.madeAt !== undefined && draft.of?.id === id);
  }

  /** Deletes a draft for good. */
  async remove({ key }: Draft): Promise<void> {
    this.#list.value = this.#list.peek().filter((each) => each.key !== key);
    this.#open.delete(key);
    this.#note(key, true);
    this.#then(() => this.#shelf.remove(key));
    await this.#saving;
  }

  /**
   * A stored draft is worked on: it gets the place of its program. Some have another one, because what was there must
   * not be overwritten, or because an earlier version kept the work of each tab apart.
   */
  take(draft: Draft): Draft {
    const key = workKey(draft.working, draft.simulated, draft.madeAt);
    const own = { ...draft, key };
    if (draft.key === key) {
      this.#seen.add(key);
    } else {
      // Other edits may be there.
      this.#seen.delete(key);
      this.#then(async () => {
        await this.#save(own);
        await this.#shelf.remove(draft.key);
      });
    }
    this.#open.set(key, own);
    return own;
  }

  /** All drafts, the latest first; none where the browser does not give them. */
  async #all(): Promise<Draft[]> {
    const all = await this.#shelf.all().catch((): Draft[] => []);
    return all.sort((a, b) => b.savedAt - a.savedAt);
  }

  /** Keeps the content of the screen while it has anything to bring back or to undo; forgets it when it has not. */
  readonly keep = (content: EditorContent & Pick<Draft, 'model' | 'apart'>, simulated: boolean): void => {
    if (!this.#hasBegun) {
      this.#early = () => this.keep(content, simulated);
      this.#note(EARLY, false);
      return;
    }
    this.#early = null;
    this.#note(EARLY, true);
    const key = workKey(content.working, simulated, content.madeAt);
    const draft: Draft = { key, ...content, savedAt: Date.now(), simulated };
    if (isOpen(draft) || draft.history?.past.length || draft.history?.future.length) {
      this.#open.set(key, draft);
      this.#keep(draft);
    } else if (this.#open.delete(key)) {
      this.#note(key, true);
      this.#then(() => this.#shelf.remove(key));
    }
  };

  /**
   * The pilot leaves the page, or may leave it: keeps at once what was waiting, because a timer may never fire again.
   */
  flush(): void {
    for (const key of this.#unsaved.peek()) {
      const draft = this.#open.get(key);
      // Does not overwrite something that was never read.
      if (draft && this.#seen.has(key)) void this.#shelf.save(draft, true).catch(() => {});
    }
  }

  /** Tries again to keep what the browser has not kept. */
  keepAgain(): void {
    for (const key of this.#unsaved.peek()) {
      const draft = this.#open.get(key);
      if (draft) this.#keep(draft);
    }
  }

  #keep(draft: Draft): void {
    this.#note(draft.key, false);
    this.#then(async () => {
      // A newer draft has taken its place before its turn came, so it is not saved.
      if (this.#open.get(draft.key) !== draft) return;
      await this.#save(draft);
      if (this.#open.get(draft.key) === draft) this.#note(draft.key, true);
    });
  }

  #note(key: string, isSaved: boolean): void {
    if (this.#unsaved.peek().has(key) !== isSaved) return;
    const unsaved = new Set(this.#unsaved.peek());
    if (isSaved) unsaved.delete(key);
    else unsaved.add(key);
    this.#unsaved.value = unsaved;
  }

  async #load(key: string): Promise<Draft | undefined> {
    const draft = await this.#shelf.load(key);
    this.#seen.add(key);
    return draft;
  }

  /** When the browser failed to give a draft, it must not be overwritten: it gets another place. */
  async #save(draft: Draft): Promise<void> {
    const unseen = this.#seen.has(draft.key) ? undefined : await this.#load(draft.key);
    if (unseen && isEdited(unseen) && !sameWork(unseen, draft)) {
      await this.#shelf.save({ ...unseen, key: `${unseen.key}/${Math.floor(unseen.savedAt)}` });
    }
    await this.#shelf.save(draft);
  }

  /** One after another. `Keeping` reports what the browser does not keep. */
  #then(work: () => Promise<unknown>): void {
    this.#saving = this.#saving.then(work).catch(() => {});
  }
}

function sameWork(a: Draft, b: Draft): boolean {
  return differences(a.working, b.working).length === 0 && JSON.stringify(a.texts) === JSON.stringify(b.texts);
}

/** Whether it comes back to the screen without being asked for. */
function isOpen(draft: Draft): boolean {
  return (isEdited(draft) || draft.madeAt !== undefined) && !draft.shelved;
}

/** Whether a pilot would miss it. */
function isEdited({ baseline, working, texts, madeAt, of }: Draft): boolean {
  if (madeAt !== undefined) {
    if (!of || !sameLayout(of.saved.identity, working.identity)) return true;
    return Object.keys(texts).length > 0 || changesSince(of.saved, working).length > 0;
  }
  if (!sameLayout(baseline.identity, working.identity)) return false;
  return Object.keys(texts).length > 0 || differences(baseline, working).length > 0;
}
