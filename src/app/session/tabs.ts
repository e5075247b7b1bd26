import { signal } from '@preact/signals';
import { type OtherTab, OtherTabs, type TabChannel, type TakeOver } from '../browser/other-tabs.js';
import { messages, timerName } from '../messages/index.js';
import type { Session } from './session.js';

/** The other tabs of this program: which of them holds the port that is wanted here, and letting go for one of them. */
export class Tabs {
  /** The tab that holds the port which could not be opened. */
  readonly holder = signal<OtherTab | null>(null, { name: 'holder' });
  readonly #session: Session;
  readonly #tabs: OtherTabs;
  #since = 0;

  /** @param isWriting whether bytes are moving that must not be cut off. */
  constructor(session: Session, isWriting: () => boolean, channel: TabChannel | null) {
    this.#session = session;
    session.notices.current.subscribe((notice) => {
      this.holder.value = null;
      if (notice?.kind === 'connection' && notice.code === 'busy' && notice.portKey) void this.#find(notice.portKey);
    });
    session.connection.subscribe((connection) => {
      if (connection) this.#since = Date.now();
    });
    this.#tabs = new OtherTabs({
      channel,
      self: () => {
        const connection = session.connection.peek();
        const portKey = session.link.simulated.peek() ? null : (connection?.portKey ?? null);
        return { portKey, what: this.#what(), since: this.#since, writing: isWriting() };
      },
      onReleaseAsked: async () => {
        if (isWriting()) return false;
        await session.disconnect();
        session.notices.say('taken-over');
        return true;
      },
    });
  }

  /** Asks that tab for its port, and connects when it has let go. */
  async takeOver(tab: OtherTab): Promise<TakeOver> {
    const result = await this.#tabs.takeOver(tab);
    if (result === 'released') void this.#session.takeOver();
    return result;
  }

  async #find(portKey: string): Promise<void> {
    const [tab] = await this.#tabs.holders(portKey);
    const { value } = this.#session.notices.current;
    if (tab && value?.kind === 'connection' && value.code === 'busy') this.holder.value = tab;
  }

  #what(): string {
    const working = this.#session.editor.working.peek();
    const { memoryName } = messages.peek();
    if (!working) return '';
    const name = timerName(working.identity);
    return working.memory === null ? name : `${name}, ${memoryName(working.memory)}`;
  }
}
