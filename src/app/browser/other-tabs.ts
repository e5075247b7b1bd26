import * as v from 'valibot';
import { type Clock, realClock } from '../../line/index.js';
import { service } from './services.js';

/** The part of `BroadcastChannel` that the page uses. */
export interface TabChannel {
  postMessage(message: unknown): void;
  addEventListener(type: 'message', listener: (event: { readonly data: unknown }) => void): void;
  close(): void;
}

/** What a tab says about itself. */
export interface TabState {
  /** The shared name of the port that it holds; null when it holds none. */
  readonly portKey: string | null;
  /** What is on its screen, for the pilot: “F1Q, M2”. At most 200 characters. */
  readonly what: string;
  /** Since when it holds the port, in milliseconds since 1970. */
  readonly since: number;
  /** Whether it is writing to the timer and must not be disturbed. */
  readonly writing: boolean;
}

/** Another tab of this page that holds a port. */
export interface OtherTab extends TabState {
  readonly id: string;
  readonly portKey: string;
}

/** What came of asking for a port. `gone`: the other tab did not answer in time. */
export type TakeOver = 'released' | 'writing' | 'gone';

export interface OtherTabsOptions {
  /** Null where the browser has none. Then no other tab is ever found. */
  readonly channel: TabChannel | null;
  /** What this tab says about itself now. */
  readonly self: () => TabState;
  /**
   * Another tab wants the port of this one: close it.
   * @returns whether it is closed; false when a write has begun.
   */
  readonly onReleaseAsked: () => Promise<boolean>;
  readonly clock?: Clock;
}

/** How long a tab has to say what it holds, in milliseconds. */
const ANSWER_WAIT = 150;
/** How long a tab has to close its port, in milliseconds: the last request on the line must end first. */
const RELEASE_WAIT = 3000;

// The other tab may run another version of this page, so unknown messages are skipped.
const text = v.pipe(v.string(), v.maxLength(200));
const head = { from: text, ask: v.number(), portKey: text };
const messageSchema = v.variant('kind', [
  v.object({ kind: v.literal('who'), ...head }),
  v.object({
    kind: v.literal('holds'),
    ...head,
    to: text,
    what: text,
    since: v.pipe(v.number(), v.finite()),
    writing: v.boolean(),
  }),
  v.object({ kind: v.literal('release'), ...head, to: text }),
  v.object({ kind: v.literal('answer'), ...head, to: text, result: v.picklist(['released', 'writing']) }),
]);
type Message = v.InferOutput<typeof messageSchema>;
type Question = Extract<Message, { kind: 'who' | 'release' }>;
type Reply = Exclude<Message, Question>;

/**
 * A channel between the tabs of this page; null where the browser has none.
 * @param about `tabs`: which tab holds which port; `library`: the library was changed.
 * @throws the error of the browser when it refuses.
 */
export function openTabChannel(about: 'tabs' | 'library' = 'tabs'): TabChannel | null {
  const Channel = service('BroadcastChannel');
  const channel = Channel && new Channel(`sidus-timer ${about}`);
  // A channel that cannot be listened to counts as none.
  channel?.addEventListener('message', () => {});
  return channel;
}

/** The other tabs of this page in this browser: which of them holds a port, and whether it gives the port up. */
export class OtherTabs {
  readonly #options: OtherTabsOptions;
  readonly #clock: Clock;
  // Without https there is no crypto.randomUUID, but the page must start all the same.
  readonly #id = String(crypto.getRandomValues(new Uint32Array(4)));
  readonly #waiting = new Map<number, (reply: Reply) => void>();
  #channel: TabChannel | null;
  #asked = 0;

  constructor(options: OtherTabsOptions) {
    this.#options = options;
    this.#clock = options.clock ?? realClock;
    this.#channel = options.channel;
    this.#channel?.addEventListener('message', ({ data }) => this.#hear(data));
  }

  /** The tabs that hold this port, longest first. Takes 150 ms where other tabs are possible. */
  async holders(portKey: string): Promise<OtherTab[]> {
    const found: OtherTab[] = [];
    await this.#ask({ kind: 'who', portKey }, ANSWER_WAIT, (reply) => {
      if (reply.kind !== 'holds') return undefined;
      const { from: id, what, since, writing } = reply;
      found.push({ id, portKey, what, since, writing });
      return undefined;
    });
    return found.sort((a, b) => a.since - b.since);
  }

  /** Asks a tab to close its port, and waits at most 3 s for it. */
  async takeOver({ id, portKey }: OtherTab): Promise<TakeOver> {
    const result = await this.#ask({ kind: 'release', portKey, to: id }, RELEASE_WAIT, (reply) =>
      reply.kind === 'answer' && reply.from === id ? reply.result : undefined,
    );
    return result ?? 'gone';
  }

  /** Ends it: answers nothing and asks nothing any more. */
  close(): void {
    this.#channel?.close();
    this.#channel = null;
  }

  /** Asks, and gives what `take` makes of the first reply that it accepts; undefined when none came in time. */
  async #ask<T>(
    question: { kind: 'who'; portKey: string } | { kind: 'release'; portKey: string; to: string },
    wait: number,
    take: (reply: Reply) => T | undefined,
  ): Promise<T | undefined> {
    if (!this.#channel) return undefined;
    const ask = ++this.#asked;
    const taken = await new Promise<T | undefined>((resolve) => {
      const giveUp = this.#clock.after(wait, () => resolve(undefined));
      this.#waiting.set(ask, (reply) => {
        const result = take(reply);
        if (result === undefined) return;
        giveUp();
        resolve(result);
      });
      this.#say({ ...question, from: this.#id, ask });
    });
    this.#waiting.delete(ask);
    return taken;
  }

  #hear(data: unknown): void {
    const parsed = v.safeParse(messageSchema, data);
    if (!parsed.success) return;
    const message = parsed.output;
    if (message.kind === 'who') this.#tell(message);
    else if (message.to !== this.#id) return;
    else if (message.kind === 'release') void this.#release(message);
    else this.#waiting.get(message.ask)?.(message);
  }

  #tell({ from, ask, portKey }: Question): void {
    const self = this.#options.self();
    if (self.portKey !== portKey) return;
    const { what, since, writing } = self;
    this.#say({ kind: 'holds', from: this.#id, to: from, ask, portKey, what: what.slice(0, 200), since, writing });
  }

  async #release({ from, ask, portKey }: Question): Promise<void> {
    const { portKey: held, writing } = this.#options.self();
    const released = held !== portKey || (!writing && (await this.#options.onReleaseAsked()));
    const result = released ? 'released' : 'writing';
    this.#say({ kind: 'answer', from: this.#id, to: from, ask, portKey, result });
  }

  #say(message: Message): void {
    try {
      this.#channel?.postMessage(message);
    } catch {
      // Nobody hears it, so it ends without an answer, as if there were no other tab.
    }
  }
}
