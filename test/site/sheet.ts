import { expect } from 'vitest';
import { en } from '../tools/en.js';
import type { AppPage } from './app-page.js';

/**
 * A setting as a pilot brings it to the field on paper: of an F1Q with three servos, every value different from
 * the new timer.
 */
export const SHEET = {
  times: ['8', '8.2', '8.7', '9,5', '11', '14.3', '20', '45.5', '1:00', '1:30', '4:00'],
  positions: [
    ['40', '42', '44', '60', '60', '62', '70', '72', '74', '90', '130'],
    ['10', '12', '14', '16', '18', '20', '22', '24', '26', '28', '0'],
    ['65', '65', '65', '66', '67', '68', '80', '80', '80', '80', '20'],
  ],
} as const;

/** Rows of the table, as their fields are named. */
export const ROWS = ['Start', ...[1, 2, 3, 4, 5, 6, 7, 8, 9].map((row) => `Function ${row}`), 'DT'];

/** The name of the field for the time of a row. */
export const timeField = (row: number): string => (row === 0 ? en.program.motorStopTime : `${ROWS[row]} time`);

/** The name of the field for a position. */
export const positionField = (row: number, servo: number): string => `${ROWS[row]}, S${servo + 1}`;

/** What a timer holds after the sheet was entered and function 4 and all later ones were moved by 1.5 s. */
export const SHIFTED = {
  times: [800, 820, 870, 950, 1250, 1580, 2150, 4700, 6150, 9150, 24000],
  positions: SHEET.positions.map((servo) => servo.map(Number)),
};

/** What the table has shown, step by step, to check undo and redo. */
export class Trail {
  readonly #app: AppPage;
  readonly #seen: Readonly<Record<string, string>>[] = [];

  constructor(app: AppPage) {
    this.#app = app;
  }

  /** Called before each step, and once more after the last one. */
  async note(): Promise<void> {
    this.#seen.push(await this.#app.entries());
  }

  /** The same steps, for a page that has replaced the one before. */
  continuedBy(app: AppPage): Trail {
    const trail = new Trail(app);
    trail.#seen.push(...this.#seen);
    return trail;
  }

  /** Undoes to the start: each undo shows the table before that step, and before the first there is none. */
  async goBack(undo: () => Promise<void>): Promise<void> {
    for (const before of this.#seen.slice(0, -1).reverse()) {
      await undo();
      await expect.poll(() => this.#app.entries()).toEqual(before);
    }
    await expect.poll(() => this.#app.undo.isDisabled(), { message: 'nothing is left to undo' }).toBe(true);
  }

  /** Redoes all steps. */
  async goForward(redo: () => Promise<void>): Promise<void> {
    for (const after of this.#seen.slice(1)) {
      await redo();
      await expect.poll(() => this.#app.entries()).toEqual(after);
    }
    await expect.poll(() => this.#app.redo.isDisabled(), { message: 'nothing is left to redo' }).toBe(true);
  }
}
