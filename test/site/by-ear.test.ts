import type { CDPSession } from 'playwright';
import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { PHONE } from './page.js';

/** A node of the tree that a browser gives to a screen reader. */
interface HeardNode {
  readonly ignored: boolean;
  readonly role?: { readonly value: string };
  readonly name?: { readonly value: string };
  readonly backendDOMNodeId?: number;
  readonly properties?: readonly { readonly name: string; readonly value: { readonly value?: unknown } }[];
}

/** A pilot who cannot see: has the accessibility tree, by role and name, and the keyboard. */
class Listener {
  readonly #app: AppPage;
  readonly #tools: CDPSession;

  constructor(app: AppPage, tools: CDPSession) {
    this.#app = app;
    this.#tools = tools;
  }

  static async at(app: AppPage): Promise<Listener> {
    const tools = await app.page.context().newCDPSession(app.page);
    for (const domain of ['DOM', 'Accessibility'] as const) await tools.send(`${domain}.enable`);
    return new Listener(app, tools);
  }

  /** Waits for the node with this role and name. */
  async hears(role: string, name: string | RegExp): Promise<HeardNode> {
    let found: HeardNode | undefined;
    await expect
      .poll(
        async () => {
          const all = await this.#all();
          found = all.find((node) => node.role?.value === role && isCalled(node, name));
          return found !== undefined;
        },
        { message: `${role} “${name}” is in the tree`, timeout: 60_000 },
      )
      .toBe(true);
    return found as HeardNode;
  }

  /** Goes to it, as the keys of a screen reader do. */
  async goTo(role: string, name: string | RegExp): Promise<void> {
    const { backendDOMNodeId } = await this.hears(role, name);
    await this.#tools.send('DOM.focus', { backendNodeId: backendDOMNodeId as number });
  }

  async press(role: string, name: string | RegExp, key = 'Enter'): Promise<void> {
    await this.goTo(role, name);
    await this.#app.page.keyboard.press(key);
  }

  async enter(name: string, text: string): Promise<void> {
    await this.goTo('textbox', name);
    await this.#app.page.keyboard.press('Control+a');
    await this.#app.page.keyboard.type(text);
    await this.#app.page.keyboard.press('Enter');
  }

  /** Whether a choice is selected. */
  async isChecked(role: string, name: string | RegExp): Promise<unknown> {
    const { properties = [] } = await this.hears(role, name);
    return properties.find((property) => property.name === 'checked')?.value.value;
  }

  /** Controls without a name. */
  async nameless(): Promise<string[]> {
    const controls = /^(button|link|textbox|checkbox|radio|switch|combobox|slider|dialog|table|tab|option)$/i;
    return (await this.#all())
      .filter(({ role, name }) => controls.test(role?.value ?? '') && !name?.value.trim())
      .map(({ role, backendDOMNodeId }) => `${role?.value} ${backendDOMNodeId}`);
  }

  async #all(): Promise<HeardNode[]> {
    const { nodes } = await this.#tools.send('Accessibility.getFullAXTree');
    return (nodes as HeardNode[]).filter(({ ignored }) => !ignored);
  }
}

function isCalled({ name }: HeardNode, wanted: string | RegExp): boolean {
  const called = name?.value ?? '';
  return typeof wanted === 'string' ? called === wanted : wanted.test(called);
}

test.each([
  ['a desktop', {}],
  ['a phone', PHONE],
] as const)(
  'with a screen reader alone on %s: connect, change, write, verify, memories, bench, settings',
  async (_, options) => {
    const app = await AppPage.open(options);
    const ear = await Listener.at(app);
    await ear.press('button', 'Try a simulated F1Q timer');
    await ear.hears('table', en.program.tableCaption);
    await ear.hears('status', /.*/);
    await ear.hears('StaticText', /^As in the timer, read \d\d:\d\d$/);
    expect(await ear.nameless(), 'controls of the program view without a name').toEqual([]);

    await ear.enter('DT time', '2:30');
    await ear.enter('Function 4, S2', '70');
    await ear.hears('StaticText', '2 changes');
    await ear.press('button', 'Write 2 changes…');
    await ear.hears('dialog', en.write.title);
    await ear.hears('rowheader', 'Function 4, S2');
    expect(await ear.nameless(), 'controls of the difference without a name').toEqual([]);
    await ear.press('checkbox', /^The propeller is off/, 'Space');
    expect(await ear.isChecked('checkbox', /^The propeller is off/)).toBe('true');
    await ear.press('button', 'Write 2 changes');
    await ear.hears('alert', /.*/);
    await ear.hears('StaticText', 'Verified.');
    await ear.press('button', 'Close');
    await ear.hears('StaticText', /^As in the timer, verified \d\d:\d\d$/);

    await ear.press('link', 'Memories');
    await ear.hears('heading', 'Memories');
    await ear.press('button', en.overview.readAll);
    await ear.hears('StaticText', /memories were read/);
    await ear.press('button', 'Compare with M1: M2');
    await ear.hears('heading', 'Compare');
    expect(await ear.nameless(), 'controls of the comparison without a name').toEqual([]);

    await ear.press('link', 'Bench');
    await ear.hears('heading', 'Bench');
    expect(await ear.isChecked('checkbox', /^The propeller/), 'the tick from the write still counts').toBe('true');
    await ear.press('button', 'Function 4');
    await ear.hears('StaticText', 'Servos at function 4');
    await ear.press('button', '+1: Function 4, S1');
    expect(await ear.nameless(), 'controls of the Bench view without a name').toEqual([]);

    await ear.press('link', 'Settings');
    await ear.hears('heading', 'Settings');
    await ear.press('radio', 'Dark', 'Space');
    expect(await ear.isChecked('radio', 'Dark')).toBe('true');
    expect(await ear.nameless(), 'controls of the settings without a name').toEqual([]);
  },
);
