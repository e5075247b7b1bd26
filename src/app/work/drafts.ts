import { computed, type ReadonlySignal } from '@preact/signals';
import { differences, sameLayout, type TimerProgram } from '../../program/index.js';
import { changesSince } from '../editing/content.js';
import type { EditorContent } from '../editing/editor.js';
import { Collection } from '../storage/collection.js';
import type { Draft, Keeper } from '../storage/index.js';
import { programKey, workKey } from '../timer/record-keys.js';

/**
 * What a pilot works on, with its undo history, by kind of timer and memory. It survives a reload or a crash where the
 * browser keeps anything; else it lasts as long as the page.
 */
export class Drafts {
  /** All that a pilot would miss, the latest first. */
  readonly edited: ReadonlySignal<readonly Draft[]> = computed(() => this.#all.list.value.filter(isEdited));
  /** Whether everything that was typed would survive a reload. */
  readonly kept: ReadonlySignal<boolean> = computed(() => this.#all.unsaved.value.size === 0);
  readonly #keeper: Keeper<Draft>;
  readonly #all: Collection<Draft>;
  /** The keys of the work that this page has had on the screen. */
  readonly #own = new Set<string>();

  constructor(keeper: Keeper<Draft>) {
    this.#keeper = keeper;
    this.#all = new Collection({
      inOrder: (a, b) => b.savedAt - a.savedAt,
      keeper: {
        all: () => this.#read(),
        save: async (draft) => {
          await this.#known();
          await keeper.save(draft);
        },
        remove: async (key) => {
          await this.#known();
          await keeper.remove(key);
        },
      },
    });
  }

  /**
   * The latest unwritten draft.
   * @param wanted asked once it is found, which may take time: whether there is still a place for it.
   */
  async latest(wanted: () => boolean): Promise<Draft | undefined> {
    await this.#all.load();
    const found = this.#all.list.peek().find(isOpen);
    return found && wanted() ? this.take(found) : undefined;
  }

  /** The stored work on a program like this one. */
  async of(program: TimerProgram, simulated: boolean): Promise<Draft | undefined> {
    await this.#all.load();
    const key = programKey(program, simulated);
    const isAlike = ({ madeAt, working, simulated: of }: Draft): boolean =>
      madeAt === undefined && programKey(working, of) === key;
    const found = this.#at(key) ?? this.#all.list.peek().find(isAlike);
    return found && this.take(found);
  }

  /** A program that was made here leaves the screen, and is kept: see {@link Draft.shelved}. */
  shelve(madeAt: number): void {
    const draft = this.#all.list.peek().find((each) => each.madeAt === madeAt);
    if (!draft) return;
    // Something that the library holds need not be kept twice.
    if (isEdited(draft)) void this.#all.save({ ...draft, shelved: true });
    else void this.remove(draft);
  }

  /** The stored, unsaved changes of a setting. */
  async ofSetting(id: string): Promise<Draft | undefined> {
    await this.#all.load();
    return this.edited.peek().find((draft) => draft.madeAt !== undefined && draft.of?.id === id);
  }

  /** Deletes a draft for good. */
  async remove({ key }: Draft): Promise<void> {
    await this.#all.delete(key);
  }

  /**
   * A stored draft is worked on: it gets the place of its program. Some have another one, because what was there must
   * not be overwritten, or because an earlier version kept the work of each tab apart.
   */
  take(draft: Draft): Draft {
    const own = { ...draft, key: workKey(draft.working, draft.simulated, draft.madeAt) };
    if (draft.key !== own.key) {
      // Other edits may be there.
      this.#own.delete(own.key);
      void this.#put(own).then(async (isKept) => isKept && (await this.#all.delete(draft.key)));
    }
    this.#own.add(own.key);
    return own;
  }

  /** Keeps the content of the screen while it has anything to bring back or to undo; forgets it when it has not. */
  keep(content: EditorContent & Pick<Draft, 'model' | 'apart'>, simulated: boolean): void {
    const key = workKey(content.working, simulated, content.madeAt);
    const draft: Draft = { key, ...content, savedAt: Date.now(), simulated };
    const { past = [], future = [] } = draft.history ?? {};
    if (isOpen(draft) || past.length + future.length > 0) void this.#put(draft);
    else if (this.#own.has(key) && this.#at(key)) void this.remove(draft);
  }

  /**
   * The pilot leaves the page, or may leave it: keeps at once what was waiting, because a timer may never fire again.
   */
  flush(): void {
    // Does not overwrite something that was never read.
    if (!this.#isKnown) return;
    for (const draft of this.#all.waiting.put) void this.#keeper.save(draft, true).catch(() => {});
  }

  /** Tries again to keep what the browser has not kept. */
  keepAgain(): Promise<void> {
    return this.#all.keepAgain();
  }

  get #isKnown(): boolean {
    return this.#all.loaded.peek() && !this.#all.failed.peek();
  }

  /** @throws while it is not known what the storage holds: it must not be overwritten. `Keeping` reports it. */
  async #known(): Promise<void> {
    await this.#all.load();
    if (!this.#isKnown) throw new Error('the drafts were never read');
  }

  /** What nobody has seen, and has the place of work of this page, gets another one; also if that work is gone. */
  async #read(): Promise<Draft[]> {
    const stored = await this.#keeper.all();
    const hidden = stored.filter((each) => this.#own.has(each.key) && hides(this.#at(each.key), each)).map(elsewhere);
    for (const each of hidden) await this.#keeper.save(each);
    return [...stored, ...hidden];
  }

  /** Puts work of this page in its place. @returns whether the browser has kept it. */
  #put(draft: Draft): Promise<boolean> {
    const there = this.#at(draft.key);
    const isUnseen = there && !this.#own.has(draft.key) && hides(draft, there);
    this.#own.add(draft.key);
    return this.#all.save(...(isUnseen ? [elsewhere(there)] : []), draft);
  }

  #at(key: string): Draft | undefined {
    return this.#all.list.peek().find((each) => each.key === key);
  }
}

/** Whether one draft, or nothing, in the place of the other would lose something. */
function hides(draft: Draft | undefined, other: Draft): boolean {
  return isEdited(other) && !(draft && sameWork(other, draft));
}

function elsewhere(draft: Draft): Draft {
  return { ...draft, key: `${draft.key}/${Math.floor(draft.savedAt)}` };
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
