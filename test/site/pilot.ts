import type { Locator } from 'playwright';
import type { AppPage } from './app-page.js';

/** What a task has cost. */
export interface Cost {
  /** Clicks, or taps of a finger. */
  presses: number;
  /** Keys of a keyboard, or of the sheet of keys on a phone. */
  keys: number;
  /** Pixels that the page was scrolled by hand to reach a control. */
  scrolled: number;
}

/** Counts every act of a pilot. A control that is not visible has to be scrolled to first. */
export class Pilot {
  readonly cost: Cost = { presses: 0, keys: 0, scrolled: 0 };
  readonly #app: AppPage;
  readonly #byTouch: boolean;

  constructor(app: AppPage, byTouch: boolean) {
    this.#app = app;
    this.#byTouch = byTouch;
  }

  /** A click or tap in the middle of it. Playwright's own click would scroll without being counted. */
  async press(place: Locator): Promise<void> {
    await this.#touch(place);
    this.cost.presses++;
  }

  /** Types into a pressed field: on a phone with the keys of the sheet. */
  async type(text: string): Promise<void> {
    if (!this.#byTouch) await this.#app.page.keyboard.type(text);
    else for (const key of text) await this.#touch(this.#sheet.getByRole('button', { name: key, exact: true }));
    this.cost.keys += text.length;
  }

  async key(name: string): Promise<void> {
    await this.#app.page.keyboard.press(name);
    this.cost.keys++;
  }

  /** A key of the sheet that is not a digit. */
  async sheetKey(name: string | RegExp): Promise<void> {
    await this.#touch(this.#sheet.getByRole('button', { name, exact: true }));
    this.cost.keys++;
  }

  get #sheet(): Locator {
    return this.#app.page.locator('.edit-sheet');
  }

  async #touch(place: Locator): Promise<void> {
    const { page } = this.#app;
    await place.waitFor();
    // The page takes back the room for the keys a frame after they went, and everything above them moves.
    await page.locator('[data-sheet]:not(:has(.edit-sheet, .row-panel))').waitFor({ state: 'detached' });
    this.cost.scrolled += await place.evaluate(async (element) => {
      const middle = (): [x: number, y: number] => {
        const { left, top, width, height } = element.getBoundingClientRect();
        return [left + width / 2, top + height / 2];
      };
      const isInSight = (): boolean => {
        const there = document.elementFromPoint(...middle());
        return there !== null && (element.contains(there) || element.closest('label')?.contains(there) === true);
      };
      const places = (): number[] => {
        const found: number[] = [];
        for (let each: Element | null = element; each; each = each.parentElement) found.push(each.scrollTop);
        return found;
      };
      // Something that has just opened may not be drawn yet.
      const end = performance.now() + 500;
      while (!isInSight() && performance.now() < end) await new Promise(requestAnimationFrame);
      if (isInSight()) return 0;
      const before = places();
      element.scrollIntoView({ block: 'center' });
      return places().reduce((sum, top, at) => sum + Math.abs(top - (before[at] ?? 0)), 0);
    });
    const box = await place.boundingBox();
    if (!box) throw new Error(`${place} cannot be pressed`);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    if (this.#byTouch) await page.touchscreen.tap(x, y);
    else await page.mouse.click(x, y);
  }
}

/** “5 clicks, 7 keys, 0 px”, as it stands in the docs. */
export function costText({ presses, keys, scrolled }: Cost, byTouch: boolean): string {
  const word = byTouch ? 'tap' : 'click';
  return `${presses} ${presses === 1 ? word : `${word}s`}, ${keys} keys, ${Math.round(scrolled)} px`;
}
