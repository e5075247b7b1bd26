import { computed, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** What to check before each flight, the dangerous things last. `classes`: only timers of these classes have it. */
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

/** How long a tick counts for the next flight, in milliseconds. */
const TICK_LIFE = 20 * 60_000;
/** How many items a pilot can add, and how long each may be. */
const MOST_OWN = 30;
export const LONGEST_OWN = 120;

const ownSchema = v.pipe(
  v.array(v.pipe(v.string(), v.trim(), v.minLength(1), v.maxLength(LONGEST_OWN))),
  v.maxLength(MOST_OWN),
);

/** The key of a tick of an added item. The text of a pilot can never be the id of another item. */
export function ownKey(text: string): string {
  return `own ${text}`;
}

/**
 * What a pilot checks before a flight. Ticks are for one flight and are never stored. They start again after the last
 * one is ticked, or when the latest tick is too old. Items that the pilot has added are stored.
 */
export class Checklist {
  readonly #ticked = signal<ReadonlySet<string>>(new Set(), { name: 'ticked' });
  readonly #own = signal<readonly string[]>([...new Set(loadSetting('checklist', ownSchema) ?? [])]);
  readonly #timerClass: ReadonlySignal<string | null>;
  #tickedAt = 0;
  /** The items for any timer, and those for the class of the present one. */
  readonly items: ReadonlySignal<readonly ItemId[]> = computed(() => {
    const timerClass = this.#timerClass.value;
    return ITEMS.filter((item) => timerClass === null || !('classes' in item) || item.classes.includes(timerClass)).map(
      ({ id }) => id,
    );
  });
  /** The pilot's own items, oldest first. No two are equal. */
  readonly own: ReadonlySignal<readonly string[]> = this.#own;
  /** By id; for an own item by its {@link ownKey}. */
  readonly ticked: ReadonlySignal<ReadonlySet<string>> = this.#ticked;
  readonly left: ReadonlySignal<number> = computed(
    () => [...this.items.value, ...this.own.value.map(ownKey)].filter((item) => !this.#ticked.value.has(item)).length,
  );
  /** Whether the pilot has begun and not finished it. */
  readonly begun: ReadonlySignal<boolean> = computed(() => this.#ticked.value.size > 0 && this.left.value > 0);

  /** @param timerClass the class of the timer or program; null for none. */
  constructor(timerClass: ReadonlySignal<string | null>) {
    this.#timerClass = timerClass;
  }

  /** The pilot opens it. */
  enter(): void {
    const since = Date.now() - this.#tickedAt;
    // With a clock that was put back, nobody knows how long ago it was.
    const isOld = since > TICK_LIFE || since < 0;
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

  /**
   * @returns whether it was added. Refused: an empty text, one that is too long or already there, or one item too many.
   */
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
