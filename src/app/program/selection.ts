import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { type GridCell, type GridRange, rangeBetween } from '../editing/grid.js';

/** Which cells of the table are meant: the one that is being edited, and those up to another corner. */
export class Selection {
  readonly #active = signal<GridCell | null>(null);
  readonly #corner = signal<GridCell | null>(null);
  readonly #picking = signal(false);

  /** The cell with the focus; null before any had it. */
  readonly active: ReadonlySignal<GridCell | null> = this.#active;

  readonly range: ReadonlySignal<GridRange | null> = computed(() => {
    const active = this.active.value;
    return active && rangeBetween(active, this.#corner.value ?? active);
  });
  /** Whether it is more than one cell. */
  readonly isWide: ReadonlySignal<boolean> = computed(() => {
    const range = this.range.value;
    return range !== null && (range.top !== range.bottom || range.left !== range.right);
  });
  /** Whether the next cell that is tapped is the other corner, for those who have no Shift. */
  readonly picking: ReadonlySignal<boolean> = this.#picking;
  /** What is shown as selected; null while it is no more than the cell with the focus. */
  readonly shown: ReadonlySignal<GridRange | null> = computed(() =>
    this.isWide.value || this.picking.value ? this.range.value : null,
  );
  /** The corner that moves when the range is extended. */
  readonly corner: ReadonlySignal<GridCell | null> = computed(() => this.#corner.value ?? this.active.value);

  /** This cell alone. */
  enter(cell: GridCell): void {
    batch(() => {
      this.#active.value = cell;
      this.#corner.value = null;
    });
  }

  /** The next cell that is tapped is the other corner. */
  pick(): void {
    this.#picking.value = true;
  }

  /** From the active cell to this one. */
  extendTo(cell: GridCell): void {
    if (this.active.value) this.#corner.value = cell;
  }

  /** The active cell alone; no other corner is waited for. */
  collapse(): void {
    batch(() => {
      this.#corner.value = null;
      this.#picking.value = false;
    });
  }
}
