import { computed, type ReadonlySignal, signal } from '@preact/signals';

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

/**
 * What a pilot checks before a flight. Ticks are for one flight and are never stored. They start again after the last
 * one is ticked, or when the latest tick is too old.
 */
export class Checklist {
  readonly #ticked = signal<ReadonlySet<ItemId>>(new Set(), { name: 'ticked' });
  readonly #timerClass: ReadonlySignal<string | null>;
  #tickedAt = 0;
  /** The items for any timer, and those for the class of the present one. */
  readonly items: ReadonlySignal<readonly ItemId[]> = computed(() => {
    const timerClass = this.#timerClass.value;
    return ITEMS.filter((item) => timerClass === null || !('classes' in item) || item.classes.includes(timerClass)).map(
      ({ id }) => id,
    );
  });
  readonly ticked: ReadonlySignal<ReadonlySet<ItemId>> = this.#ticked;
  readonly left: ReadonlySignal<number> = computed(
    () => this.items.value.filter((item) => !this.#ticked.value.has(item)).length,
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

  tick(item: ItemId, on: boolean): void {
    const ticked = new Set(this.#ticked.peek());
    if (on) ticked.add(item);
    else ticked.delete(item);
    this.#tickedAt = Date.now();
    this.#ticked.value = ticked;
  }

  clear(): void {
    this.#ticked.value = new Set();
  }
}
