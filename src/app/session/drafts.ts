import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { differences, sameLayout, type TimerProgram } from '../../program/index.js';
import type { TabNumber } from '../browser/tab-number.js';
import { changesSince } from '../editing/content.js';
import type { EditorContent } from '../editing/editor.js';
import type { Draft, Keeper } from '../storage/index.js';
import { programKey, workKey } from './record-keys.js';

/** In the place of a key, before it is known under which number this tab keeps its work. */
const EARLY = '';
/** So long a browser has at most to clear a closed tab away, in milliseconds. */
const CLEARING_WAIT = 30_000;

/**
 * What a pilot works on, with what can be undone, by kind of timer, memory and tab: through a reload or a crash where
 * the browser keeps anything, else for as long as the page is open. What was left in a tab that is closed falls to the
 * next one that needs it.
 */
export class Drafts {
  readonly #shelf: Keeper<Draft>;
  readonly #tab: TabNumber;
  readonly #open = new Map<string, Draft>();
  /** Under these keys it is known what was kept before. */
  readonly #seen = new Set<string>();
  readonly #begun: Promise<void>;
  #begin: () => void = () => {};
  /** What was to be kept before it was known under which number. */
  #early: (() => void) | null = null;
  #hasBegun = false;
  #saving: Promise<unknown> = Promise.resolve();
  /** What this page has and the storage has not, by key. */
  readonly #unsaved = signal<ReadonlySet<string>>(new Set(), { name: 'unsaved' });
  /** Whether all that was typed would be there after a reload. */
  readonly kept: ReadonlySignal<boolean> = computed(() => this.#unsaved.value.size === 0);

  constructor(shelf: Keeper<Draft>, tab: TabNumber) {
    this.#shelf = shelf;
    this.#tab = tab;
    this.#begun = new Promise((resolve) => {
      this.#begin = resolve;
    });
  }

  /**
   * The one that was worked on last and was not written: in this tab, else in one that is closed. From its end on this
   * tab has its number.
   * @param wanted asked when it was found, which may take its time: whether it still has a place.
   */
  async latest(wanted: () => boolean): Promise<Draft | undefined> {
    await this.#tab.takeBefore();
    const edited = (await this.#all()).filter(isOpen);
    let found: Draft | undefined;
    for (const draft of edited) if (!found && (await this.#tab.take(draft.tab))) found = draft;
    await this.#tab.takeAny();
    for (const draft of edited) if (!found && (await this.#tab.isFree(draft.tab))) found = draft;
    const draft = found && wanted() ? this.#found(found) : undefined;
    this.#hasBegun = true;
    this.#begin();
    this.#early?.();
    return draft;
  }

  /**
   * Waits a while for one of the tabs that seem to be open and have edits: a tab that has just been closed may have its
   * number until the browser has cleared it away.
   * @param wanted as in {@link latest}, which was asked before.
   */
  async leftBehind(wanted: () => boolean): Promise<Draft | undefined> {
    const stop = new AbortController();
    const giveUp = setTimeout(() => stop.abort(), CLEARING_WAIT);
    const others = new Set((await this.#all()).filter(isEdited).map(({ tab }) => tab));
    others.delete(this.#tab.value);
    const closing = [...others].map(async (tab) => {
      if (!(await this.#tab.whenClosed(tab, stop.signal))) throw new Error('it is open');
    });
    const isAny = await Promise.any(closing).then(
      () => true,
      () => false,
    );
    clearTimeout(giveUp);
    stop.abort();
    // Looked for afresh: the tab may have kept something as it was closed.
    const edited = isAny ? (await this.#all()).filter(isEdited) : [];
    // Work that this tab has begun meanwhile is not buried under it.
    if (this.#open.size > 0 || edited.some(({ tab }) => tab === this.#tab.value)) return undefined;
    for (const draft of edited) {
      if (await this.#tab.isFree(draft.tab)) return wanted() ? this.#found(draft) : undefined;
    }
    return undefined;
  }

  /**
   * What is kept of the work on a program like this.
   * @param inherit another tab has left its timer to this one: its edits come along.
   */
  async of(program: TimerProgram, simulated: boolean, inherit = false): Promise<Draft | undefined> {
    await this.#begun;
    const key = this.keyOf(program, simulated);
    await this.#saving;
    const own = this.#open.get(key) ?? (await this.#load(key).catch(() => undefined));
    if (own) return this.#adopt(own);
    const kind = programKey(program, simulated);
    for (const draft of await this.#all()) {
      if (draft.madeAt !== undefined) continue;
      if (programKey(draft.working, draft.simulated) !== kind) continue;
      if (inherit || (await this.#tab.isFree(draft.tab))) return this.#adopt(draft);
    }
    return undefined;
  }

  /** All that has a place on the screen and is no other tab's, the latest first. */
  async available(): Promise<Draft[]> {
    await this.#begun;
    await this.#saving;
    const free: Draft[] = [];
    for (const draft of await this.#all()) {
      if (!isEdited(draft)) continue;
      if (draft.tab === this.#tab.value || (await this.#tab.isFree(draft.tab))) free.push(draft);
    }
    return free;
  }

  /** Under what the work on such a program is kept in this tab. */
  keyOf(program: TimerProgram, simulated: boolean): string {
    return workKey(program, simulated, this.#tab.value);
  }

  /** What was kept comes to the screen: it is the work of this tab from now on. */
  take(draft: Draft): Draft {
    return this.#found(draft);
  }

  /** A program that was made here leaves the screen, and is kept: see {@link Draft.shelved}. */
  shelve(madeAt: number): void {
    const draft = [...this.#open.values()].find((each) => each.madeAt === madeAt);
    if (!draft) return;
    // What the library holds need not be kept twice.
    if (!isEdited(draft)) return void this.remove(draft);
    const shelved = { ...draft, shelved: true };
    this.#open.set(draft.key, shelved);
    this.#keep(shelved);
  }

  /** What is kept of changes of a setting that were not saved: in this tab, or in one that is closed. */
  async ofSetting(id: string): Promise<Draft | undefined> {
    return (await this.available()).find((draft) => draft.madeAt !== undefined && draft.of?.id === id);
  }

  /** What was kept is deleted for good. */
  async remove({ key }: Draft): Promise<void> {
    this.#open.delete(key);
    this.#note(key, true);
    this.#then(() => this.#shelf.remove(key));
    await this.#saving;
  }

  /** Takes over what was found among all that are kept: nothing else that was edited lies in its new place. */
  #found(draft: Draft): Draft {
    const own = this.#adopt(draft);
    this.#seen.add(own.key);
    return own;
  }

  /** Takes a draft over into this tab; an open one that had it keeps it too. */
  #adopt(draft: Draft): Draft {
    const tab = this.#tab.value;
    const key = workKey(draft.working, draft.simulated, tab, draft.madeAt);
    const own = { ...draft, key, tab };
    if (draft.tab !== tab) {
      this.#then(async () => {
        await this.#save(own);
        if (await this.#tab.isFree(draft.tab)) await this.#shelf.remove(draft.key);
      });
    } else {
      this.#seen.add(key);
    }
    this.#open.set(key, own);
    return own;
  }

  /** All that are kept, the latest first; none where the browser does not give them. */
  async #all(): Promise<Draft[]> {
    const all = await this.#shelf.all().catch((): Draft[] => []);
    return all.sort((a, b) => b.savedAt - a.savedAt);
  }

  /**
   * Keeps what is on the screen while there is anything to bring back, or to undo, and forgets it when there is not.
   */
  readonly keep = (content: EditorContent & Pick<Draft, 'model'>, simulated: boolean): void => {
    if (!this.#hasBegun) {
      this.#early = () => this.keep(content, simulated);
      this.#note(EARLY, false);
      return;
    }
    this.#early = null;
    this.#note(EARLY, true);
    const tab = this.#tab.value;
    const key = workKey(content.working, simulated, tab, content.madeAt);
    const draft: Draft = { key, ...content, savedAt: Date.now(), simulated, tab };
    if (isOpen(draft) || draft.history?.past.length || draft.history?.future.length) {
      this.#open.set(key, draft);
      this.#keep(draft);
    } else if (this.#open.delete(key)) {
      this.#note(key, true);
      this.#then(() => this.#shelf.remove(key));
    }
  };

  /**
   * The page is left, or may be: what waits for its turn is kept at once, for nothing may come back any more that ends
   * the waiting.
   */
  flush(): void {
    for (const key of this.#unsaved.peek()) {
      const draft = this.#open.get(key);
      // What may lie there unseen is not overwritten.
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
      // One that has been followed by another before its turn has come is not saved.
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

  /**
   * What the browser did not give back when it was asked for is not overwritten: it is kept as the work of a tab that
   * is closed.
   */
  async #save(draft: Draft): Promise<void> {
    const unseen = this.#seen.has(draft.key) ? undefined : await this.#load(draft.key);
    if (unseen && isEdited(unseen) && !sameWork(unseen, draft)) {
      const tab = Math.max(2, Math.floor(unseen.savedAt));
      const key = workKey(unseen.working, unseen.simulated, tab, unseen.madeAt);
      await this.#shelf.save({ ...unseen, key, tab });
    }
    await this.#shelf.save(draft);
  }

  /** One thing after another. That the browser does not keep something it says itself, see `Keeping`. */
  #then(work: () => Promise<unknown>): void {
    this.#saving = this.#saving.then(work).catch(() => {});
  }
}

function sameWork(a: Draft, b: Draft): boolean {
  return differences(a.working, b.working).length === 0 && JSON.stringify(a.texts) === JSON.stringify(b.texts);
}

/** Whether it comes to the screen again by itself. */
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
