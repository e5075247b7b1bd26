import type { BrowserContextOptions, Locator, Page } from 'playwright';
import { expect, inject, onTestFinished } from 'vitest';
import { newPage, newVisit } from './page.js';
import type { Workbench, WorkbenchOptions } from './workbench.js';

declare module 'vitest' {
  interface ProvidedContext {
    /** The script that puts a workbench in the place of the browser's serial ports. */
    workbench: string;
  }
}

export interface AppOptions extends BrowserContextOptions {
  /** Where the page lies. Default: at the root of a host. */
  readonly at?: 'site' | 'siteUnderPath';
  /** What is in the place of the browser's serial ports. Default: what the browser has. */
  readonly bench?: WorkbenchOptions;
  /** Runs in the page before its own scripts. */
  readonly before?: () => unknown;
  /** Nobody has been here before: the page's worker is not there yet. Default false. */
  readonly isFirstVisit?: boolean;
}

/** The table of the example and of the one reply that is known from a real timer. */
export const FIRST_POSITIONS = [15, 25, 35, 45, 55, 65, 75, 85, 95, 105, 115].map(String);

/** The page as a pilot sees it: by role and name. */
export class AppPage {
  readonly page: Page;

  /** @param page shows it, or is about to. */
  constructor(page: Page) {
    this.page = page;
  }

  static async open({ at = 'site', bench, before, isFirstVisit, ...options }: AppOptions = {}): Promise<AppPage> {
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

  /** Until the parts of the page are there, such as the list of commands: the simulated timers come last. */
  async hasParts(): Promise<void> {
    await this.page.waitForFunction(() =>
      performance.getEntriesByType('resource').some(({ name }) => name.includes('/simulated-timer-')),
    );
  }

  /** Until the page has taken the place of its picture: it has said how high rows are. */
  async #works(): Promise<void> {
    await this.page.locator('html[data-density]').waitFor();
  }

  /** Another tab with the same storage, and a bench of its own where this one has one. */
  async sibling(): Promise<AppPage> {
    const page = await this.page.context().newPage();
    await page.goto(this.page.url());
    const app = new AppPage(page);
    await app.#works();
    return app;
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole('button', { name, exact: typeof name === 'string' });
  }

  field(name: string): Locator {
    return this.page.getByRole('textbox', { name, exact: true });
  }

  /** Undo, whatever it would undo. */
  get undo(): Locator {
    return this.button(/^Undo(?! all$)/);
  }

  get redo(): Locator {
    return this.button(/^Redo/);
  }

  text(text: string | RegExp): Locator {
    return this.page.getByText(text);
  }

  get dialog(): Locator {
    return this.page.getByRole('dialog', { name: 'Write to the timer' });
  }

  get table(): Locator {
    return this.page.getByRole('table', { name: 'Time and servo positions of each function' });
  }

  /** The bar with what can be done with the program; what is said above the program has buttons of its own. */
  get actions(): Locator {
    return this.page.locator('.actions');
  }

  get firmware(): Locator {
    return this.page.getByRole('banner').getByText('firmware 536');
  }

  /** Goes to a view. The link to the line is there only for experts, so its address is taken. */
  async goTo(view: 'Program' | 'Memories' | 'Bench' | 'Library' | 'Line' | 'Settings'): Promise<void> {
    if (view === 'Line') await this.page.evaluate(() => location.assign('#line'));
    // The start has no way to the other views but that to the settings.
    else await this.page.getByRole('link', { name: view, exact: true }).click();
    await this.page.locator(`.${view.toLowerCase()}-view`).waitFor();
  }

  /** What is known of the timer at hand, in the settings. */
  async showAbout(): Promise<void> {
    await this.goTo('Settings');
    await this.text('About this timer').click();
  }

  /** The large figures are shown when one asks for them. */
  async #showFigure(name: string): Promise<void> {
    const isLarge = name === 'DT' || name === 'Motor stop';
    if (isLarge && (await this.field(name).count()) === 0) await this.showFigures();
  }

  /** Opens the large figures, with all that a phone has no other room for. */
  async showFigures(): Promise<void> {
    const figures = this.page.locator('.strip-figures');
    if ((await figures.getAttribute('aria-expanded')) === 'false') await figures.click();
  }

  async trySimulated(name: 'F1Q' | 'F1B' | 'F1E'): Promise<void> {
    await this.button(`Try a simulated ${name} timer`).click();
    await this.hasRead();
  }

  async connect(): Promise<void> {
    await this.button('Connect').click();
    await this.hasRead();
  }

  /** Waits until the wire is free and the table is there. */
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

  /** Looks at a memory by what was last read of it: nothing is sent. */
  async lookAt(name: string): Promise<void> {
    if ((await this.page.getByRole('radio', { name }).count()) === 0) await this.showFigures();
    await this.page.getByRole('radio', { name }).check({ force: true });
  }

  /** Makes a memory the one that flies next. */
  async fly(name: string): Promise<void> {
    await this.lookAt(name);
    await this.page
      .locator('.memory-look')
      .getByRole('button', { name: `Make ${name} fly next` })
      .click();
    await this.isReady();
  }

  /** Types over what stands in a field, and leaves it. */
  async type(field: string, text: string): Promise<void> {
    await this.#showFigure(field);
    await this.field(field).fill(text);
    await this.field(field).blur();
  }

  async valueOf(field: string): Promise<string> {
    await this.#showFigure(field);
    return this.field(field).inputValue();
  }

  /** What the slot of a servo shows, start to DT. */
  async positions(servo: string): Promise<string[]> {
    const entries = Object.entries(await this.entries());
    return entries.filter(([name]) => name.endsWith(`, ${servo}`)).map(([, value]) => value);
  }

  /** What stands in each field of the table, by name: times, intervals and positions. */
  async entries(): Promise<Readonly<Record<string, string>>> {
    // One question for the whole table: a journey that notes each of its steps asks it a hundred times.
    return this.table.evaluate((table) => {
      const inputs = [...table.querySelectorAll<HTMLInputElement>('input:is([type=text], :not([type]))')];
      // The tools of a row have a field of their own.
      const seen = inputs.filter((input) => !input.closest('.row-menu') && input.checkVisibility());
      return Object.fromEntries(seen.map((input) => [input.ariaLabel ?? '', input.value]));
    });
  }

  /** The reasons that are said in the table, for people who see them. */
  async reasons(): Promise<string[]> {
    await this.table.waitFor();
    return (await this.table.locator('.row-notes p').allInnerTexts()).map((text) => text.trim());
  }

  /** The text of the status line above the program, once it says this. */
  async says(sentence: string | RegExp): Promise<void> {
    // While a timer is looked for at the start, that holds the stage.
    await this.page.locator('.notices, .link-stage').getByText(sentence).first().waitFor();
  }

  async review(): Promise<void> {
    await this.button(/^Write( \d+)?…$/).click();
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

  /** From the difference to the result. */
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
    await this.line.locator('tbody').first().waitFor();
  }

  /** What the page has sent by its own log, oldest first. */
  async sent(): Promise<string[]> {
    const before = await this.page.evaluate(() => location.hash);
    await this.openLine();
    const older = this.line.getByRole('button', { name: 'Show older' });
    // They also come by themselves where their place is in sight.
    while (await older.isVisible()) await older.evaluate((button: HTMLElement) => button.click()).catch(() => {});
    const names = await this.line
      .locator('tbody tr.out .name')
      .evaluateAll((all) => all.map(({ textContent }) => textContent ?? '').reverse());
    await this.page.evaluate((hash) => location.assign(hash || '#program'), before);
    await this.line.waitFor({ state: 'hidden' });
    return names.map((name) => name.replace(/^.*\s· /, ''));
  }

  /** What the log shows of the writing. */
  async sets(): Promise<string[]> {
    return (await this.sent()).filter((name) => name.startsWith('SET'));
  }

  /** Works at the bench beside the pilot. */
  bench<T>(act: (bench: Workbench) => T): Promise<T> {
    return this.page.evaluate(`(${act.toString()})(window.workbench)`) as Promise<T>;
  }

  /**
   * Waits until what was typed has come to rest in the storage: the page keeps it when it has nothing else to do. What
   * is being written is written before each look, and what waits behind it before the next.
   */
  async kept(): Promise<void> {
    let before = '';
    await expect
      .poll(async () => {
        const now = await this.#stored();
        const isAtRest = now === before;
        before = now;
        return isAtRest && now !== '[]';
      })
      .toBe(true);
  }

  /** Puts something into the storage, as if an earlier visit had left it there. */
  async store(draft: object): Promise<void> {
    await this.page.evaluate(async (stored) => {
      const opening = indexedDB.open('sidus-timer');
      const database = await new Promise<IDBDatabase>((resolve) => {
        opening.onsuccess = () => resolve(opening.result);
      });
      const writing = database.transaction('drafts', 'readwrite');
      writing.objectStore('drafts').put(stored);
      await new Promise((resolve) => {
        writing.oncomplete = resolve;
      });
      database.close();
    }, draft);
  }

  #stored(): Promise<string> {
    return this.page.evaluate(async () => {
      // A page in which nothing is to be drawn any more may never be told that it is idle.
      await new Promise((resolve) => requestIdleCallback(resolve, { timeout: 200 }));
      const opening = indexedDB.open('sidus-timer');
      const database = await new Promise<IDBDatabase>((resolve) => {
        opening.onsuccess = () => resolve(opening.result);
      });
      // It could write, so it has to wait for whoever does.
      const reading = database.transaction('drafts', 'readwrite').objectStore('drafts').getAll();
      const drafts = await new Promise<unknown[]>((resolve) => {
        reading.onsuccess = () => resolve(reading.result);
      });
      database.close();
      return JSON.stringify(drafts);
    });
  }

  /**
   * Waits until a tab that was opened, or loaded again, has its number: what others have left it has looked at by then.
   */
  async hasNumber(): Promise<void> {
    await this.page.waitForFunction(async () => {
      const { held = [] } = await navigator.locks.query();
      const number = sessionStorage.getItem('sidus-timer/tab');
      return held.some(({ name }) => name === `sidus-timer/tab/${number}`);
    });
  }

  /** Gives the window another size, until the page has followed: it hears of it when the next picture is drawn. */
  async resize(viewport: { readonly width: number; readonly height: number }): Promise<void> {
    await this.page.setViewportSize(viewport);
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  /** Loads the page again. */
  async reload(): Promise<void> {
    await this.page.reload();
    await this.#works();
  }

  async expectNoSidewaysScrolling(): Promise<void> {
    const beyond = await this.page.evaluate(() => {
      const { scrollWidth, clientWidth } = document.documentElement;
      if (scrollWidth <= clientWidth) return [];
      const over = [...document.body.querySelectorAll('*')].filter(
        (element) => element.getBoundingClientRect().right > clientWidth,
      );
      return [`${scrollWidth - clientWidth} px`, ...over.map((element) => element.outerHTML.slice(0, 90))];
    });
    expect(beyond, 'beyond the edge').toEqual([]);
  }
}
