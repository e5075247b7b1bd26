import { type ReadonlySignal, signal } from '@preact/signals';
import { type OtherTab, OtherTabs, type TabChannel, type TakeOver } from '../browser/other-tabs.js';
import { messages, timerName } from '../messages/index.js';
import type { Session } from './session.js';

/** Another tab of this page that holds the wanted port; and giving this tab's port to another one. */
export class PortHolder {
  readonly #tab = signal<OtherTab | null>(null, { name: 'portHolder' });
  /** The tab that holds the port which could not be opened; null for none. */
  readonly tab: ReadonlySignal<OtherTab | null> = this.#tab;
  readonly #session: Session;
  readonly #others: OtherTabs;
  #since = 0;

  constructor(session: Session, channel: TabChannel | null) {
    this.#session = session;
    const { writing } = session.runner;
    session.notices.current.subscribe((notice) => {
      this.#tab.value = null;
      if (notice?.kind === 'connection' && notice.code === 'busy' && notice.portKey) void this.#find(notice.portKey);
    });
    session.connection.subscribe((connection) => {
      if (connection) this.#since = Date.now();
    });
    this.#others = new OtherTabs({
      channel,
      self: () => {
        const connection = session.connection.peek();
        const portKey = session.link.simulated.peek() ? null : (connection?.portKey ?? null);
        return { portKey, what: this.#what(), since: this.#since, writing: writing.peek() };
      },
      onReleaseAsked: async () => {
        if (writing.peek()) return false;
        await session.timer.disconnect();
        session.notices.say('taken-over');
        return true;
      },
    });
  }

  /** Asks the other tab for its port, and connects once it is released. */
  async takeOver(tab: OtherTab): Promise<TakeOver> {
    const result = await this.#others.takeOver(tab);
    if (result === 'released') void this.#session.timer.takeOver();
    return result;
  }

  async #find(portKey: string): Promise<void> {
    const [tab] = await this.#others.holders(portKey);
    const { value } = this.#session.notices.current;
    if (tab && value?.kind === 'connection' && value.code === 'busy') this.#tab.value = tab;
  }

  #what(): string {
    const working = this.#session.editor.working.peek();
    const { memoryName } = messages.peek();
    if (!working) return '';
    const name = timerName(working.identity);
    return working.memory === null ? name : `${name}, ${memoryName(working.memory)}`;
  }
}
