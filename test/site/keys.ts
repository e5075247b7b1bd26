import type { Page } from 'playwright';

/** A pilot without a mouse. */
export class Keys {
  readonly #page: Page;

  constructor(page: Page) {
    this.#page = page;
  }

  press(key: string): Promise<void> {
    return this.#page.keyboard.press(key);
  }

  type(text: string): Promise<void> {
    return this.#page.keyboard.type(text);
  }

  /** The name of the element with the focus. */
  focused(): Promise<string> {
    return this.#page.evaluate(() => {
      const { activeElement: at } = document;
      const name = at?.getAttribute('aria-label') ?? at?.closest('label')?.textContent ?? at?.textContent;
      return name?.trim() ?? '';
    });
  }

  /** Presses Tab until the element with this name has the focus. */
  async tabTo(name: RegExp): Promise<void> {
    for (let i = 0; i < 200; i++) {
      await this.press('Tab');
      if (name.test(await this.focused())) return;
    }
    throw new Error(`Tab never reached ${name}`);
  }

  /** Goes to the element with this name, and activates it. */
  async enter(name: RegExp): Promise<void> {
    await this.tabTo(name);
    await this.press('Enter');
  }
}
