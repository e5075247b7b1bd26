import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { type GridCell, type GridRange, rangeBetween } from '../editing/grid.js';

/** The selected cells of the table: from the one that is being edited to another corner. */
export class Selection {
  // Only this selection writes them.
  /** The focused cell; null before the first focus. */
  readonly active = signal<GridCell | null>(null);
  /** Whether the next tapped cell becomes the other corner, for pilots without a Shift key. */
  readonly picking = signal(false);
  readonly #corner = signal<GridCell | null>(null);

  readonly range: ReadonlySignal<GridRange | null> = computed(() => {
    const active = this.active.value;
    return active && rangeBetween(active, this.#corner.value ?? active);
  });
  /** Whether it is more than one cell. */
  readonly isWide: ReadonlySignal<boolean> = computed(() => {
    const range = this.range.value;
    return range !== null && (range.top !== range.bottom || range.left !== range.right);
  });
  /** The range to show; null while it is only the focused cell. */
  readonly shown: ReadonlySignal<GridRange | null> = computed(() =>
    this.isWide.value || this.picking.value ? this.range.value : null,
  );
  /** The corner that moves when the range grows or shrinks. */
  readonly corner: ReadonlySignal<GridCell | null> = computed(() => this.#corner.value ?? this.active.value);

  /** Selects only this cell. */
  enter(cell: GridCell): void {
    batch(() => {
      this.active.value = cell;
      this.#corner.value = null;
    });
  }

  /** The next tapped cell becomes the other corner. */
  pick(): void {
    this.picking.value = true;
  }

  /** Selects from the active cell to this one. */
  extendTo(cell: GridCell): void {
    if (this.active.value) this.#corner.value = cell;
  }

  /** Selects only the active cell, and waits for no other corner. */
  collapse(): void {
    batch(() => {
      this.#corner.value = null;
      this.picking.value = false;
    });
  }
}
