import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { differences, sameLayout, type TimerProgram } from '../../program/index.js';
import type { TabNumber } from '../browser/tab-number.js';
import { changesSince } from '../editing/content.js';
import type { EditorContent } from '../editing/editor.js';
import type { Draft, Keeper } from '../storage/index.js';
import { programKey, workKey } from './record-keys.js';

/** In place of a key, until it is known under which number this tab keeps its work. */
const EARLY = '';
/** How long a browser may take to clear a closed tab away, in milliseconds. */
const CLEARING_WAIT = 30_000;

/**
 * What a pilot works on, with its undo history, by kind of timer, memory and tab. It survives a reload or a crash where
 * the browser keeps anything; else it lasts as long as the page. The work of a closed tab goes to the next tab that
 * needs it.
 */
export class Drafts {
  readonly #shelf: Keeper<Draft>;
  readonly #tab: TabNumber;
  readonly #open = new Map<string, Draft>();
  /** The keys for which it is known what the storage held. */
  readonly #seen = new Set<string>();
  readonly #begun: Promise<void>;
  #begin: () => void = () => {};
  /** Work to keep once the number of this tab is known. */
  #early: (() => void) | null = null;
  #hasBegun = false;
  #saving: Promise<unknown> = Promise.resolve();
  /** The keys of drafts that this page has and the storage does not. */
  readonly #unsaved = signal<ReadonlySet<string>>(new Set(), { name: 'unsaved' });
  /** Whether everything that was typed would survive a reload. */
  readonly kept: ReadonlySignal<boolean> = computed(() => this.#unsaved.value.size === 0);

  constructor(shelf: Keeper<Draft>, tab: TabNumber) {
    this.#shelf = shelf;
    this.#tab = tab;
    this.#begun = new Promise((resolve) => {
      this.#begin = resolve;
    });
  }

  /**
   * The latest unwritten draft: of this tab, else of a closed one. Afterwards this tab has its number.
   * @param wanted asked once it is found, which may take time: whether there is still a place for it.
   */
  async latest(wanted: () => boolean): Promise<Draft | undefined> {
    await this.#tab.takeBefore();
    const edited = (await this.#all()).filter(isOpen);
    let found: Draft | undefined;
    for (const draft of edited) if (!found && (await this.#tab.take(draft.tab))) found = draft;
    await this.#tab.takeAny();
    for (const draft of edited) if (!found && (await this.#tab.isFree(draft.tab))) found = draft;
    const draft = found && wanted() ? this.take(found) : undefined;
    this.#hasBegun = true;
    this.#begin();
    this.#early?.();
    return draft;
  }

  /**
   * Waits a while for a tab that seems to be open and has edits: a tab that was just closed may have its number until
   * the browser has cleared it away.
   * @param wanted as in {@link latest}, which comes first.
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
    // Read again: the tab may have stored something while it was closing.
    const edited = isAny ? (await this.#all()).filter(isEdited) : [];
    // It must not cover work that this tab has begun in the meantime.
    if (this.#open.size > 0 || edited.some(({ tab }) => tab === this.#tab.value)) return undefined;
    for (const draft of edited) {
      if (await this.#tab.isFree(draft.tab)) return wanted() ? this.take(draft) : undefined;
    }
    return undefined;
  }

  /**
   * The stored work on a program like this one.
   * @param inherit another tab has given its timer to this one: takes its edits, too.
   */
  async of(program: TimerProgram, simulated: boolean, inherit: boolean): Promise<Draft | undefined> {
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

  /** All drafts that can be shown and belong to no other tab, the latest first. */
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

  /** The key under which this tab keeps its work on such a program. */
  keyOf(program: TimerProgram, simulated: boolean): string {
    return workKey(program, simulated, this.#tab.value);
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

  /** The stored, unsaved changes of a setting: of this tab, or of a closed one. */
  async ofSetting(id: string): Promise<Draft | undefined> {
    return (await this.available()).find((draft) => draft.madeAt !== undefined && draft.of?.id === id);
  }

  /** Deletes a draft for good. */
  async remove({ key }: Draft): Promise<void> {
    this.#open.delete(key);
    this.#note(key, true);
    this.#then(() => this.#shelf.remove(key));
    await this.#saving;
  }

  /**
   * A draft that was found among all comes to the screen: from now on it is the work of this tab. Its new place holds
   * no other edits.
   */
  take(draft: Draft): Draft {
    const own = this.#adopt(draft);
    this.#seen.add(own.key);
    return own;
  }

  /** Takes a draft over into this tab. An open tab that had it keeps it, too. */
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

  /** All drafts, the latest first; none where the browser does not give them. */
  async #all(): Promise<Draft[]> {
    const all = await this.#shelf.all().catch((): Draft[] => []);
    return all.sort((a, b) => b.savedAt - a.savedAt);
  }

  /** Keeps the content of the screen while it has anything to bring back or to undo; forgets it when it has not. */
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

  /** When the browser failed to give a draft, it must not be overwritten: it is kept as the work of a closed tab. */
  async #save(draft: Draft): Promise<void> {
    const unseen = this.#seen.has(draft.key) ? undefined : await this.#load(draft.key);
    if (unseen && isEdited(unseen) && !sameWork(unseen, draft)) {
      const tab = Math.max(2, Math.floor(unseen.savedAt));
      const key = workKey(unseen.working, unseen.simulated, tab, unseen.madeAt);
      await this.#shelf.save({ ...unseen, key, tab });
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
