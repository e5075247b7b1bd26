import type { Locator, Page } from 'playwright';
import { en } from '../tools/en.js';
import { Rig, type RigOptions } from './rig.js';

/** What a pilot does on the page, and sees there; all of it found by role and name. */
export class Pilot {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole('button', { name, exact: true });
  }

  /** A field of the table. */
  field(name: string): Locator {
    return this.page.getByRole('table', { name: en.program.tableCaption }).getByRole('textbox', { name, exact: true });
  }

  async goTo(view: 'program' | 'memories' | 'bench' | 'settings'): Promise<void> {
    await this.page.evaluate((hash) => location.assign(hash), `#${view}`);
    await this.page.locator(`.${view}-view`).waitFor();
  }

  async clickConnect(): Promise<void> {
    await this.button(en.header.connect).click();
  }

  /** Waits until the timer is connected and has been read. */
  async isConnected(): Promise<void> {
    await this.button(en.header.disconnect).waitFor();
    await this.page.locator('#app:has(.link-state.on) > main[aria-busy=false]').waitFor();
  }

  /** Waits until the page says that the port is gone. */
  async isAway(): Promise<void> {
    await this.sees(en.link.lost.title);
  }

  async sees(text: string): Promise<void> {
    await this.page.getByText(text).first().waitFor();
  }

  async type(values: Readonly<Record<string, string>>): Promise<void> {
    for (const [name, value] of Object.entries(values)) await this.field(name).fill(value);
  }

  /** What stands in the fields of these names. */
  async shown(names: readonly string[]): Promise<Record<string, string>> {
    const shown: Record<string, string> = {};
    for (const name of names) shown[name] = await this.field(name).inputValue();
    return shown;
  }

  /** Asks for the difference, which is read afresh, and says that it is safe to write. */
  async review(): Promise<void> {
    await this.button(/^Write( \d+ changes?)?…$/).click();
    await this.confirm();
  }

  /** Says that it is safe to write. */
  async confirm(): Promise<void> {
    await this.page.getByRole('dialog').getByRole('checkbox', { name: en.write.safety }).check();
  }

  /** Begins to write what was reviewed. */
  async startWriting(): Promise<void> {
    await this.page
      .getByRole('dialog')
      .getByRole('button', { name: /^(Write|Read back)/ })
      .click();
  }

  async write(): Promise<void> {
    await this.review();
    await this.startWriting();
  }

  /** Waits until nothing is being written any more; what became of it is closed, where the dialog says it. */
  async writeEnds(): Promise<string> {
    const dialog = this.page.getByRole('dialog');
    const close = dialog.getByRole('button', { name: en.close, exact: true });
    await close.or(this.page.locator('body:not(:has(dialog[open]))')).first().waitFor();
    return (await close.isVisible()) ? await this.result() : '';
  }

  /** Whether the page offers to go on with an earlier write. */
  async isOffered(): Promise<boolean> {
    return await this.page.getByRole('region', { name: en.recovery.title }).isVisible();
  }

  /** Takes the offer to finish an earlier write, and writes what is missing. */
  async finish(): Promise<void> {
    await this.button(en.recovery.finish).click();
    await this.confirm();
    await this.startWriting();
  }

  /** Waits for what the dialog says in the end, and closes it. */
  async result(): Promise<string> {
    const result = this.page.getByRole('dialog').getByRole('alert');
    const text = await result.innerText();
    await this.button(en.close).click();
    // While it is open, what is typed elsewhere goes nowhere.
    await this.page.getByRole('dialog').waitFor({ state: 'hidden' });
    return text;
  }
}

/** A pilot whose timer is connected and read. */
export async function connected(options?: RigOptions): Promise<{ rig: Rig; pilot: Pilot }> {
  const rig = await Rig.start(options);
  const pilot = new Pilot(await rig.open());
  await pilot.clickConnect();
  await pilot.isConnected();
  return { rig, pilot };
}
