import { stderr } from 'node:process';
import type { BrowserContextOptions, Locator, Page } from 'playwright';
import { expect, inject, onTestFinished } from 'vitest';
import { en } from '../tools/en.js';
import { tooWide } from '../tools/well-made.js';
import { newPage, newVisit } from './page.js';
import type { Workbench, WorkbenchOptions } from './workbench.js';

declare module 'vitest' {
  interface ProvidedContext {
    /** The script that replaces the browser's serial ports with a workbench. */
    workbench: string;
  }
}

export interface AppOptions extends BrowserContextOptions {
  /** The address of the page. Default: the root of a host. */
  readonly at?: 'site' | 'siteUnderPath';
  /** What replaces the browser's serial ports. Default: nothing, the browser's own ports stay. */
  readonly bench?: WorkbenchOptions;
  /** Runs in the page before its own scripts. */
  readonly before?: () => unknown;
  /** A first visit: the page's worker is not installed yet. Default false. */
  readonly isFirstVisit?: boolean;
  /** Whether the page moves what has changed, as it does for most pilots: a fifth of its work. Default false. */
  readonly isMoving?: boolean;
}

/** The table of the example and of the one reply that is known from a real timer. */
export const FIRST_POSITIONS = [15, 25, 35, 45, 55, 65, 75, 85, 95, 105, 115].map(String);

/** What a page that does not come has done so far, for the log. */
function stateOf(page: Page): Promise<string> {
  const told = page.evaluate(() => {
    const { readyState, hidden, body } = document;
    const worker = navigator.serviceWorker.controller?.state;
    const loaded = performance.getEntriesByType('resource').map((each) => new URL(each.name).pathname);
    const asked = [...document.querySelectorAll('link')].map((link) => `${link.rel} ${link.href}`);
    return JSON.stringify({ readyState, hidden, worker, loaded, asked, text: body.innerText.slice(0, 200) });
  });
  const silent = new Promise<string>((resolve) => setTimeout(resolve, 10_000, 'It answers nothing.'));
  return Promise.race([told, silent]).catch(String);
}

/** Whether the middle of it is in the window, and nothing covers that. */
export const isInSight = (place: Locator): Promise<boolean> =>
  place.evaluate((element) => {
    const { left, top, width, height } = element.getBoundingClientRect();
    return element.contains(document.elementFromPoint(left + width / 2, top + height / 2));
  });

type Edges = Readonly<Record<'left' | 'right' | 'top' | 'bottom' | 'width' | 'height', number>>;

/** The room of an element in the window. */
export const edgesOf = (place: Locator): Promise<Edges> =>
  place.evaluate((element) => element.getBoundingClientRect().toJSON());

/** Where a finger or a mouse meets it. */
export async function middleOf(place: Locator): Promise<{ readonly x: number; readonly y: number }> {
  const { left, right, top, bottom } = await edgesOf(place);
  return { x: (left + right) / 2, y: (top + bottom) / 2 };
}

/** On how many lines these stand. */
export const linesOf = (places: Locator): Promise<number> =>
  places.evaluateAll((all) => new Set(all.map((each) => each.getBoundingClientRect().top)).size);

/** What of it is beyond its edge, and has to be scrolled to. */
export const hiddenOf = (place: Locator): Promise<number> =>
  place.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);

/** The page as a pilot sees it: by role and name. */
export class AppPage {
  readonly page: Page;

  /** @param page shows it, or is about to. */
  constructor(page: Page) {
    this.page = page;
  }

  static async open(given: AppOptions = {}): Promise<AppPage> {
    const { at = 'site', bench, before, isFirstVisit, isMoving, ...others } = given;
    const options = { ...others, reducedMotion: isMoving ? 'no-preference' : 'reduce' } as const;
    const page = await (isFirstVisit ? newPage(options) : newVisit(options));
    const context = page.context();
    const scripts = [
      before && (await context.addInitScript(before)),
      bench &&
        (await context.addInitScript((given) => {
          window.workbenchOptions = given;
        }, bench)),
      bench && (await context.addInitScript(inject('workbench'))),
    ];
    onTestFinished(async () => {
      for (const script of scripts) await script?.dispose();
    });
    await page.goto(inject(at));
    const app = new AppPage(page);
    await app.#works();
    return app;
  }

  /** A page that has read the timer of its bench. */
  static async connected({ bench, ...others }: AppOptions = {}): Promise<AppPage> {
    const app = await AppPage.open({ bench: { granted: true, ...bench }, ...others });
    await app.connect();
    return app;
  }

  /** A page that has read a simulated timer. */
  static async simulated(options?: AppOptions): Promise<AppPage> {
    const app = await AppPage.open(options);
    await app.trySimulated('F1Q');
    return app;
  }

  /** Waits for the parts of the page, such as the list of commands. The simulated timers come last. */
  async hasParts(): Promise<void> {
    await this.page.waitForFunction(() =>
      performance.getEntriesByType('resource').some(({ name }) => name.includes('/simulated-timer-')),
    );
  }

  /**
   * Waits until the page has replaced its first picture: it then has said which view it shows. Once in some thousand
   * loads the scripts did not come, and nobody knows why. The page then offers to load it again, and so does this,
   * but only once, and the log tells what was missing.
   */
  async #works(): Promise<void> {
    const shown = this.page.locator('html[data-view]');
    try {
      await shown.waitFor({ timeout: 60_000 });
    } catch {
      stderr.write(`A page did not come, and is loaded again. ${await stateOf(this.page)}\n`);
      await this.page.reload();
      await shown.waitFor();
    }
  }

  /**
   * Another tab with the same storage, and with its own bench if this tab has one. It works, in place of this one if
   * that is still open.
   */
  async sibling(): Promise<AppPage> {
    const app = await this.waitingTab();
    await app.page.locator('html[data-view]').or(app.button(en.otherTab.takeOver)).waitFor();
    if (await app.button(en.otherTab.takeOver).isVisible()) await app.button(en.otherTab.takeOver).click();
    await app.#works();
    return app;
  }

  /** As {@link sibling}, but another tab may still be at work. */
  async waitingTab(): Promise<AppPage> {
    const page = await this.page.context().newPage();
    await page.goto(this.page.url());
    return new AppPage(page);
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole('button', { name, exact: typeof name === 'string' });
  }

  field(name: string): Locator {
    return this.page.getByRole('textbox', { name, exact: true });
  }

  /** The Undo button, whatever it undoes. */
  get undo(): Locator {
    return this.button(/^Undo(?! all$)/);
  }

  get redo(): Locator {
    return this.button(/^Redo/);
  }

  text(text: string | RegExp): Locator {
    return this.page.getByText(text);
  }

  /** That so many values differ. Write says so, too, so the whole text is looked for. */
  changes(count: number): Locator {
    return this.page.getByText(en.program.changes({ count }), { exact: true });
  }

  get dialog(): Locator {
    return this.page.getByRole('dialog', { name: en.write.title });
  }

  get table(): Locator {
    return this.page.getByRole('table', { name: en.program.tableCaption });
  }

  /** The bar with the buttons for the program. The notices above the program have their own buttons. */
  get actions(): Locator {
    return this.page.locator('.actions');
  }

  get firmware(): Locator {
    return this.page.getByRole('banner').getByText('firmware 536');
  }

  /** Goes to a view. Only experts have a link to the line, so this uses its address. */
  async goTo(view: 'Program' | 'Memories' | 'Bench' | 'Library' | 'Line' | 'Settings'): Promise<void> {
    if (view === 'Line') await this.page.evaluate(() => location.assign('#line'));
    // The start leads only to the settings, not to the other views.
    else await this.page.getByRole('link', { name: view, exact: true }).click();
    await this.page.locator(`.${view.toLowerCase()}-view`).waitFor();
  }

  /** What the settings say about the connected timer. */
  async showAbout(): Promise<void> {
    await this.goTo('Settings');
    await this.text(en.aboutTimer.title).click();
  }

  /** Opens what has no room in the strip of a phone. */
  async showFigures(): Promise<void> {
    await this.page.locator('.strip-figures').waitFor();
    const more = this.page.locator('.strip-more[aria-expanded=false]');
    if ((await more.count()) > 0) await more.click();
  }

  /** Reads all memories, in their view. */
  async readAll(): Promise<void> {
    await this.goTo('Memories');
    await this.button(en.overview.readAll).click();
    await this.text('memories were read').waitFor();
  }

  /** Says that the propeller is off, moves the servos to a function, and lets them follow. */
  async follow(slot?: string): Promise<void> {
    await this.goTo('Bench');
    await this.page.getByRole('checkbox', { name: /^The propeller/ }).check();
    if (slot) {
      await this.button(slot).click();
      await this.text(`Servos at ${slot.toLowerCase()}`).first().waitFor();
    }
    await this.page.getByRole('switch').click();
    await this.page.getByRole('switch', { checked: true }).waitFor();
  }

  async trySimulated(name: 'F1Q' | 'F1B' | 'F1E'): Promise<void> {
    await this.button(`Try a simulated ${name} timer`).click();
    await this.hasRead();
  }

  async connect(): Promise<void> {
    await this.button('Connect').click();
    await this.hasRead();
  }

  /** Waits until no job runs and the table is shown. */
  async hasRead(): Promise<void> {
    await this.table.waitFor();
    await this.isReady();
  }

  async isReady(): Promise<void> {
    await this.page.locator('#app:has(.link-state.on) > main[aria-busy=false]').waitFor();
  }

  async readAgain(): Promise<void> {
    await this.actions.waitFor();
    const button = this.page.locator('.actions, .strip-panel').getByRole('button', { name: 'Read again' });
    if ((await button.count()) === 0) await this.showFigures();
    await button.click();
    await this.isReady();
  }

  /** Shows the last reading of a memory: nothing is sent. */
  async lookAt(name: string): Promise<void> {
    if ((await this.page.getByRole('radio', { name }).count()) === 0) await this.showFigures();
    await this.page.getByRole('radio', { name }).click({ force: true });
  }

  /** Makes a memory fly next. */
  async fly(name: string): Promise<void> {
    await this.lookAt(name);
    await this.page
      .locator('.memory-look')
      .getByRole('button', { name: `Make ${name} fly next` })
      .click();
    await this.isReady();
  }

  /** Replaces the text of a field, and leaves the field. */
  async type(field: string, text: string): Promise<void> {
    await this.field(field).fill(text);
    await this.field(field).blur();
  }

  async valueOf(field: string): Promise<string> {
    return this.field(field).inputValue();
  }

  /** The shown positions of a servo, from start to DT. */
  async positions(servo: string): Promise<string[]> {
    const entries = Object.entries(await this.entries());
    return entries.filter(([name]) => name.endsWith(`, ${servo}`)).map(([, value]) => value);
  }

  /**
   * The text of each field of the table, by name: times, intervals and positions. The intervals come a frame or two
   * after the time that was typed, so it looks after the third.
   */
  async entries(): Promise<Readonly<Record<string, string>>> {
    // One call for the whole table: a test that notes each of its steps makes it a hundred times.
    return this.table.evaluate(async (table) => {
      for (let i = 0; i < 3; i++) await new Promise(requestAnimationFrame);
      const inputs = [...table.querySelectorAll<HTMLInputElement>('input:is([type=text], :not([type]))')];
      // The tools of a row have their own field.
      const seen = inputs.filter((input) => !input.closest('.row-menu') && input.checkVisibility());
      return Object.fromEntries(seen.map((input) => [input.ariaLabel ?? '', input.value]));
    });
  }

  /** The text of the status line above the program, once it says this. */
  async says(sentence: string | RegExp): Promise<void> {
    // During the search for a timer, the start shows only the search.
    await this.page.locator('.notices, .link-stage').getByText(sentence).first().waitFor();
  }

  async review(): Promise<void> {
    await this.button(/^Write( \d+ changes?)?…$/).click();
    await this.dialog.waitFor();
  }

  async tickSafety(): Promise<void> {
    await this.dialog.getByRole('checkbox', { name: 'The propeller is off' }).check();
  }

  /** The rows of the table in the dialog. */
  async difference(): Promise<string[]> {
    const rows = await this.dialog.locator('tbody tr').all();
    return Promise.all(rows.map(async (row) => (await row.locator('th, td').allInnerTexts()).join(' | ')));
  }

  /** Writes, from the dialog with the difference to the result. */
  async write(): Promise<void> {
    await this.review();
    await this.tickSafety();
    await this.dialog.getByRole('button', { name: /^(Write|Read back)/ }).click();
  }

  async result(title: string): Promise<void> {
    await this.dialog.getByRole('alert').getByText(title).waitFor();
  }

  async close(): Promise<void> {
    await this.dialog.getByRole('button', { name: 'Close' }).click();
    await this.dialog.waitFor({ state: 'hidden' });
  }

  /** The log of the line. */
  get line(): Locator {
    return this.page.locator('.line-view');
  }

  async openLine(): Promise<void> {
    await this.goTo('Line');
    await this.line.locator('.line-rows li').first().waitFor();
  }

  /** What the page has sent, from its own log, the oldest first. */
  async sent(): Promise<string[]> {
    const before = await this.page.evaluate(() => location.hash);
    await this.openLine();
    const older = this.line.getByRole('button', { name: /^Show \d+ more$/ });
    while (await older.isVisible()) await older.click();
    const names = await this.line
      .locator('.line-rows .out b')
      .evaluateAll((all) => all.map(({ textContent }) => textContent ?? '').reverse());
    await this.page.evaluate((hash) => location.assign(hash || '#program'), before);
    await this.line.waitFor({ state: 'hidden' });
    return names.map((name) => name.replace(/^.*\s· /, ''));
  }

  /** The entries of the log for writes. */
  async sets(): Promise<string[]> {
    return (await this.sent()).filter((name) => name.startsWith('SET'));
  }

  /** Changes something at the workbench while the pilot uses the page. */
  bench<T>(act: (bench: Workbench) => T): Promise<T> {
    return this.page.evaluate(`(${act.toString()})(window.workbench)`) as Promise<T>;
  }

  /**
   * Waits until everything typed is in the storage: the page stores it when it has nothing else to do. What
   * is being stored is stored before each look, and what waits after it before the next.
   */
  async kept(): Promise<void> {
    let before = '';
    await expect
      .poll(async () => {
        const now = JSON.stringify(await this.stored('drafts'));
        const isAtRest = now === before;
        before = now;
        return isAtRest && now !== '[]';
      })
      .toBe(true);
  }

  /** What is kept on a shelf of the storage. */
  stored(shelf: 'drafts' | 'unfinished'): Promise<unknown[]> {
    return this.page.evaluate(async (name) => {
      // When nothing more has to be drawn, the browser may never tell the page that it is idle.
      await new Promise((resolve) => requestIdleCallback(resolve, { timeout: 200 }));
      const opening = indexedDB.open('sidus-timer');
      const database = await new Promise<IDBDatabase>((resolve) => {
        opening.onsuccess = () => resolve(opening.result);
      });
      // This request could write, so it has to wait for all others that write.
      const reading = database.transaction(name, 'readwrite').objectStore(name).getAll();
      const all = await new Promise<unknown[]>((resolve) => {
        reading.onsuccess = () => resolve(reading.result);
      });
      database.close();
      return all;
    }, shelf);
  }

  /** Changes the size of the window and waits for the page, which notices it with the next picture. */
  async resize(viewport: { readonly width: number; readonly height: number }): Promise<void> {
    await this.page.setViewportSize(viewport);
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  /** Loads the page again. */
  async reload(): Promise<void> {
    await this.page.reload();
    await this.#works();
  }

  /** As if it were chosen in the settings: all that is on the screen stays. */
  async speak(language: string): Promise<void> {
    await this.page.evaluate((code) => {
      localStorage.setItem('sidus-timer/language', JSON.stringify(code));
      dispatchEvent(new Event('languagechange'));
    }, language);
    await this.page.locator(`html[lang=${language}]`).waitFor();
  }

  async expectNoSidewaysScrolling(): Promise<void> {
    expect(await this.page.evaluate(tooWide)).toEqual([]);
  }
}
