import { AppPage } from '../site/app-page.js';
import { en } from '../tools/en.js';
import { Rig, type RigOptions } from './rig.js';

/** What a pilot does on the page, and sees there, beside what the tests of the site do. */
export class Pilot extends AppPage {
  async clickConnect(): Promise<void> {
    await this.button(en.header.connect).click();
  }

  async sees(text: string): Promise<void> {
    await this.text(text).first().waitFor();
  }

  async enter(values: Readonly<Record<string, string>>): Promise<void> {
    for (const [name, value] of Object.entries(values)) await this.field(name).fill(value);
  }

  /** What stands in the fields of these names. */
  async shown(names: readonly string[]): Promise<Record<string, string>> {
    const shown: Record<string, string> = {};
    for (const name of names) shown[name] = await this.valueOf(name);
    return shown;
  }

  /** Asks for the difference, which is read afresh, and says that it is safe to write. */
  async prepare(): Promise<void> {
    await this.review();
    await this.tickSafety();
  }

  /** Begins to write what was reviewed. */
  async startWriting(): Promise<void> {
    await this.dialog.getByRole('button', { name: /^(Write|Read back)/ }).click();
  }

  /** Waits until nothing is being written any more; what became of it is closed, where the dialog says it. */
  async writeEnds(): Promise<void> {
    const close = this.dialog.getByRole('button', { name: en.close, exact: true });
    await close.or(this.page.locator('body:not(:has(dialog[open]))')).first().waitFor();
    if (await close.isVisible()) await this.close();
  }

  /** Waits for what the dialog says in the end, and closes it. */
  async outcome(): Promise<string> {
    const text = await this.dialog.getByRole('alert').innerText();
    await this.close();
    return text;
  }
}

/** A pilot whose timer is connected and read. */
export async function connected(options?: RigOptions): Promise<{ rig: Rig; pilot: Pilot }> {
  const rig = await Rig.start(options);
  const pilot = new Pilot(await rig.open());
  await pilot.connect();
  return { rig, pilot };
}
