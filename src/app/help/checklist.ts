import { computed, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** What is looked at before each flight, what is dangerous last. `classes`: only timers of these have it. */
const ITEMS = [
  { id: 'memory' },
  { id: 'dtTime' },
  { id: 'surfaces' },
  { id: 'battery' },
  { id: 'dtSeen' },
  { id: 'radioDt' },
  { id: 'switch' },
  { id: 'propeller', classes: 'QB' },
] as const satisfies readonly { id: string; classes?: string }[];
export type ItemId = (typeof ITEMS)[number]['id'];

/** So long a tick stands for the flight that comes, in milliseconds. */
const TICK_LIFE = 20 * 60_000;
/** What a pilot can add, and how long each may be. */
const MOST_OWN = 30;
export const LONGEST_OWN = 120;

const ownSchema = v.pipe(
  v.array(v.pipe(v.string(), v.trim(), v.minLength(1), v.maxLength(LONGEST_OWN))),
  v.maxLength(MOST_OWN),
);

/** Under what a tick of something that was added is kept: no text of a pilot is an id by chance. */
export function ownKey(text: string): string {
  return `own ${text}`;
}

/**
 * What a pilot goes through before a flight. The ticks are for one flight: they are never kept, and begin afresh where
 * all was done, or where the last one was made too long ago. What a pilot has added is kept.
 */
export class Checklist {
  readonly #ticked = signal<ReadonlySet<string>>(new Set(), { name: 'ticked' });
  readonly #own = signal<readonly string[]>([...new Set(loadSetting('checklist', ownSchema) ?? [])]);
  readonly #timerClass: ReadonlySignal<string | null>;
  #tickedAt = 0;
  /** What is looked at with any timer, or with the one at hand. */
  readonly items: ReadonlySignal<readonly ItemId[]> = computed(() => {
    const timerClass = this.#timerClass.value;
    return ITEMS.filter((item) => timerClass === null || !('classes' in item) || item.classes.includes(timerClass)).map(
      ({ id }) => id,
    );
  });
  /** What the pilot has added, in the order in which that was done; no two are the same. */
  readonly own: ReadonlySignal<readonly string[]> = this.#own;
  /** By id; of what was added by its {@link ownKey}. */
  readonly ticked: ReadonlySignal<ReadonlySet<string>> = this.#ticked;
  readonly left: ReadonlySignal<number> = computed(
    () => [...this.items.value, ...this.own.value.map(ownKey)].filter((item) => !this.#ticked.value.has(item)).length,
  );
  /** Whether the pilot is in the middle of it. */
  readonly begun: ReadonlySignal<boolean> = computed(() => this.#ticked.value.size > 0 && this.left.value > 0);

  /** @param timerClass of the timer, or the program, at hand; null where there is none. */
  constructor(timerClass: ReadonlySignal<string | null>) {
    this.#timerClass = timerClass;
  }

  /** The pilot comes to it. */
  enter(): void {
    const isOld = Date.now() - this.#tickedAt > TICK_LIFE;
    if (this.#ticked.peek().size > 0 && (this.left.peek() === 0 || isOld)) this.clear();
  }

  tick(item: string, on: boolean): void {
    const ticked = new Set(this.#ticked.peek());
    if (on) ticked.add(item);
    else ticked.delete(item);
    this.#tickedAt = Date.now();
    this.#ticked.value = ticked;
  }

  clear(): void {
    this.#ticked.value = new Set();
  }

  /** @returns whether it was added: not what is empty, too long, or there already, and not one too many. */
  add(text: string): boolean {
    const own = [...this.own.peek(), text.trim()];
    if (new Set(own).size < own.length || !v.is(ownSchema, own)) return false;
    this.#keep(own);
    return true;
  }

  remove(text: string): void {
    this.tick(ownKey(text), false);
    this.#keep(this.own.peek().filter((each) => each !== text));
  }

  #keep(own: readonly string[]): void {
    this.#own.value = own;
    saveSetting('checklist', own);
  }
}
